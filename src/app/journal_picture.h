// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace hitscope {

class SessionJournal;
class Viewport;

/// Puts what the viewport shows into the journal, small, so that a person who is asked whether to recover a
/// session sees which it is. Waits for a moment without frames, since it waits for the GPU.
class JournalPicture : public QObject {
    Q_OBJECT
public:
    static constexpr int kStill = 1'500;        ///< milliseconds without a frame
    static constexpr int kLeastApart = 30'000;  ///< milliseconds from one picture to the next
    static constexpr int kWidth = 192;          ///< pixels

    /// Both outlive this.
    JournalPicture(Viewport& viewport, SessionJournal& journal, QObject* parent = nullptr);

    /// Takes one now, if there is a journal and something has been drawn.
    void take();

private:
    void wait();

    Viewport& m_viewport;
    SessionJournal& m_journal;
    QTimer m_still;
    QElapsedTimer m_sinceLast;  ///< invalid: there is none of this journal
};

}  // namespace hitscope
