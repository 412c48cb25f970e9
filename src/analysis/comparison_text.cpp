// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/comparison_text.h"

#include <QCoreApplication>

#include "session/shown_number.h"

namespace hitscope {

QString comparisonText(const Comparison& comparison) {
    const auto tr = [](const char* words, std::size_t count) {
        return QCoreApplication::translate("hitscope::Comparison", words, nullptr, trCount(count));
    };
    if (!comparison.other()) {
        return {};
    }
    if (!comparison.failure().isEmpty()) {
        return comparison.failure();
    }
    const Comparison::Report& report = comparison.report();
    QString text;
    if (report.vertices == 0) {
        text = tr(QT_TRANSLATE_N_NOOP("hitscope::Comparison", "A and B are equal: no vertex has moved"), 0);
    } else if (report.largest == 0.0) {
        text = tr(QT_TRANSLATE_N_NOOP("hitscope::Comparison",
                                      "A and B are equal in {the only moved vertex|all %Ln moved vertices}"),
                  report.vertices);
    } else {
        text = tr(QT_TRANSLATE_N_NOOP("hitscope::Comparison",
                                      "A and B differ by up to %1 m (RMS %2 m over "
                                      "%Ln moved {vertex|vertices})"),
                  report.vertices)
                   .arg(shownNumber(report.largest, 'g', 4), shownNumber(report.rootMeanSquare, 'g', 4));
    }
    if (report.droppedByFirst > 0) {
        text += tr(QT_TRANSLATE_N_NOOP("hitscope::Comparison", "; A has dropped %Ln {hit|hits}"),
                   report.droppedByFirst);
    }
    if (report.droppedHits > 0) {
        text += tr(QT_TRANSLATE_N_NOOP("hitscope::Comparison", "; B has dropped %Ln {hit|hits}"),
                   report.droppedHits);
    }
    if (comparison.showsCountsOfFirst()) {
        text += tr(QT_TRANSLATE_N_NOOP("hitscope::Comparison", "; the colours count the hits of A"), 0);
    }
    return text;
}

}  // namespace hitscope
