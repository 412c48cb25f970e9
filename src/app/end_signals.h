// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace hitscope {

/// Turns SIGTERM, SIGINT and SIGHUP into a Qt signal, so that the program ends in order. The second one ends
/// it at once, as usual. One object at a time.
class EndSignals : public QObject {
    Q_OBJECT
public:
    explicit EndSignals(QObject* parent = nullptr);
    ~EndSignals() override;

Q_SIGNALS:
    void caught(int signal);

private:
    void read();
};

}  // namespace hitscope
