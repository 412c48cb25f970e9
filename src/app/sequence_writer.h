// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QThreadPool>
#include <optional>

#include "scene/picture_sequence.h"

namespace hitscope {

class Viewport;

/// Draws a sequence of pictures beside what else the window does: one picture each time the event loop comes
/// round, written to its file on other threads.
class SequenceWriter : public QObject {
    Q_OBJECT
public:
    struct Plan {
        PictureRequest picture;
        int turntable = 0;  ///< pictures of a turntable; 0: a replay of the hits
        QString folder;     ///< exists
        QString base;       ///< of the files' names
        QString path = {};  ///< of the file, where there is one picture only: a turntable of one
    };

    /// `viewport` outlives this.
    explicit SequenceWriter(Viewport& viewport, QObject* parent = nullptr);
    ~SequenceWriter() override;

    /// Ends what was under way. Fails where the viewport cannot draw.
    [[nodiscard]] Status start(const Plan& plan);
    [[nodiscard]] const Plan& plan() const { return m_plan; }  ///< the last one
    [[nodiscard]] int count() const { return m_count; }        ///< of its pictures
    [[nodiscard]] bool isRunning() const { return m_sequence.has_value(); }
    /// Pictures already drawn are still written. ended() comes when they are.
    void cancel();

Q_SIGNALS:
    void progressed(int written, int count);
    void sampled(int drawn, int count);  ///< samples of pictures that have more than one
    /// Nothing is being written any more: all of them are, or those that were drawn when it was cancelled.
    void ended(int written);
    void failed(const hitscope::Error& error);  ///< likewise, less those that could not be drawn or written

private:
    void stepSoon();
    void step();
    void write(const Image& image);
    void took(int run, const Status& saved);
    void finish();
    void stop();

    Viewport& m_viewport;
    Plan m_plan;
    std::optional<PictureSequence> m_sequence;
    QThreadPool m_writers;
    bool m_isStepPosted = false;
    int m_run = 0;  ///< tells late answers of a run before from this one's
    int m_count = 0;
    int m_drawn = 0;
    int m_samples = 0;  ///< drawn, of all pictures
    int m_written = 0;
    int m_waiting = 0;               ///< drawn, and being written
    std::optional<Error> m_problem;  ///< of the run, which it ends
};

}  // namespace hitscope
