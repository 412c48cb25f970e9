// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/paper_figures.h"

#include <QStringList>
#include <array>
#include <utility>

#include "cli/bench/report.h"

namespace hitscope::bench {

namespace {

std::pair<double, double> rangeOf(const char* figure) {
    const QStringList ends = QString::fromLatin1(figure).split(QLatin1Char('-'));
    return {ends.first().toDouble(), ends.last().toDouble()};
}

}  // namespace

std::span<const PaperFigures> paperTable1() {
    static constexpr std::array<PaperFigures, 9> kTable{{{"15", "60"},
                                                         {"20", "90"},
                                                         {"45", "170"},
                                                         {"20", "70"},
                                                         {"30", "120"},
                                                         {"120", "200-350"},
                                                         {"10", "50"},
                                                         {"15", "70"},
                                                         {"30", "110"}}};
    return kTable;
}

std::span<const PaperFigures> paperTable2() {
    static constexpr std::array<PaperFigures, 9> kTable{{{"170-270", "180-550"},
                                                         {"140-300", "180-740"},
                                                         {"160-320", "200-780"},
                                                         {"110-290", "120-630"},
                                                         {"130-310", "150-700"},
                                                         {"140-340", "150-760"},
                                                         {"130-260", "130-560"},
                                                         {"130-310", "140-630"},
                                                         {"140-310", "160-700"}}};
    return kTable;
}

QString paperRatio(const char* rate, const char* over) {
    const auto [low, high] = rangeOf(rate);
    const auto [overLow, overHigh] = rangeOf(over);
    const QString least = shortNumber(low / overHigh);
    const QString most = shortNumber(high / overLow);
    return QLatin1Char('x') + (least == most ? least : least + QLatin1Char('-') + most);
}

}  // namespace hitscope::bench
