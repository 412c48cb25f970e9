// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProgressBar>

#include "session/session.h"

namespace hitscope {

/// How full the active pipeline is: "412 of 600 hits in the uniform array". Hidden while the pipeline keeps
/// any number of hits; of a warning colour once it is full, since from then on each hit drops another.
class CapacityMeter : public QProgressBar {
    Q_OBJECT
public:
    explicit CapacityMeter(QWidget* parent = nullptr);
    void follow(const Session& session);  ///< `session` outlives the meter

    [[nodiscard]] bool isFull() const { return isVisibleTo(parentWidget()) && value() == maximum(); }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void read(const Session& session);
    void colour();
};

}  // namespace hitscope
