// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "session/session.h"

namespace hitscope {

/// How full the active pipeline is: "412 of 600 hits in the uniform array". Hidden while the pipeline keeps
/// any number of hits; of a warning colour once it is full, since from then on each hit drops another.
///
/// Not a QProgressBar, which repaints at once: the session may speak in the middle of drawing a frame.
class CapacityMeter : public QWidget {
    Q_OBJECT
public:
    explicit CapacityMeter(QWidget* parent = nullptr);
    void follow(const Session& session);  ///< `session` outlives the meter

    [[nodiscard]] QString text() const { return m_text; }
    [[nodiscard]] bool isFull() const { return m_used >= m_capacity; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void read(const Session& session);

    QString m_text;
    int m_used = 0;
    int m_capacity = 1;
};

}  // namespace hitscope
