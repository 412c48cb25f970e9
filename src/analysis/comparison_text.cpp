// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/comparison_text.h"

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
    const QString vertices = shownCount(report.vertices);
    QString text;
    if (report.vertices == 0) {
        text = tr(QT_TRANSLATE_NOOP("hitscope::Comparison", "A and B are equal: no vertex has moved"));
    } else if (report.largest == 0.0) {
        text = tr(QT_TRANSLATE_NOOP("hitscope::Comparison", "A and B are equal in all %1 moved vertices"))
                   .arg(vertices);
    } else {
        text = tr(QT_TRANSLATE_NOOP("hitscope::Comparison",
                                    "A and B differ by up to %1 m (RMS %2 m over %3 moved vertices)"))
                   .arg(shownNumber(report.largest, 'g', 4), shownNumber(report.rootMeanSquare, 'g', 4),
                        vertices);
    }
    if (report.droppedByFirst > 0) {
        text += tr(QT_TRANSLATE_NOOP("hitscope::Comparison", "; A has dropped %1 hits"))
                    .arg(shownCount(report.droppedByFirst));
    }
    if (report.droppedHits > 0) {
        text += tr(QT_TRANSLATE_NOOP("hitscope::Comparison", "; B has dropped %1 hits"))
                    .arg(shownCount(report.droppedHits));
    }
    if (comparison.showsCountsOfFirst()) {
        text += tr(QT_TRANSLATE_NOOP("hitscope::Comparison", "; the colours count the hits of A"));
    }
    return text;
}

}  // namespace hitscope
