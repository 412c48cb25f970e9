// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <vector>

#include "bench_window/driven_window.h"

namespace hitscope::bench {

/// One row of the report of bench latency.
struct Row {
    QString measured;
    std::vector<double> seconds{};
    std::vector<double> blocked{};
    std::vector<double> processor{};           ///< seconds of all threads
    std::vector<DrivenWindow::Moment> full{};  ///< of those with fewer triangles, when all were there

    void add(double taken, double waited, double spent) {
        seconds.push_back(taken);
        blocked.push_back(waited);
        processor.push_back(spent);
    }
    void add(const DrivenWindow::Moment& moment) { add(moment.seconds, moment.blocked, moment.processor); }
    void add(const DrivenWindow::Taken& taken) {
        add(taken.seen);
        full.push_back(taken.full);
    }
    [[nodiscard]] QJsonObject json() const {
        QJsonArray times;
        QJsonArray waits;
        QJsonArray spent;
        for (std::size_t i = 0; i < seconds.size(); ++i) {
            times.append(seconds[i]);
            waits.append(blocked[i]);
            spent.append(processor[i]);
        }
        return {{QStringLiteral("measured"), measured},
                {QStringLiteral("seconds"), times},
                {QStringLiteral("blocked"), waits},
                {QStringLiteral("processor"), spent}};
    }
};

}  // namespace hitscope::bench
