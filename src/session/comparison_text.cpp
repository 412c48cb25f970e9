// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/comparison_text.h"

#include <QCoreApplication>

#include "session/shown_number.h"

namespace hitscope {

QString comparisonText(const Comparison& comparison) {
    const auto tr = [](const char* words) {
        return QCoreApplication::translate("hitscope::Comparison", words);
    };
    if (!comparison.other()) {
        return {};
    }
    if (!comparison.failure().isEmpty()) {
        return comparison.failure();
    }
    const Comparison::Report& report = comparison.report();
    QString text = report.largest == 0.0
                       ? tr(QT_TRANSLATE_NOOP("hitscope::Comparison",
                                              "A and B agree: largest difference 0 m, RMS 0 m, %1 vertices"))
                             .arg(shownCount(report.vertices))
                       : tr(QT_TRANSLATE_NOOP("hitscope::Comparison",
                                              "A and B differ: by %1 m at most, RMS %2 m, %3 vertices"))
                             .arg(shownNumber(report.largest, 'g', 4),
                                  shownNumber(report.rootMeanSquare, 'g', 4), shownCount(report.vertices));
    if (report.droppedHits > 0) {
        text += tr(QT_TRANSLATE_NOOP("hitscope::Comparison", "; B has dropped %1 hits"))
                    .arg(shownCount(report.droppedHits));
    }
    return text;
}

}  // namespace hitscope
