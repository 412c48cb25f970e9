// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/verdict_text.h"

#include <QCoreApplication>

#include "session/shown_number.h"

namespace hitscope {

namespace {

struct VerdictTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::Verdict)
};

#define HITSCOPE_TEXT(text) VerdictTexts::tr(QT_TRANSLATE_NOOP("hitscope::Verdict", text))
#define HITSCOPE_COUNT(text, count) \
    VerdictTexts::tr(QT_TRANSLATE_N_NOOP("hitscope::Verdict", text), nullptr, trCount(count))

QString notCompared(const std::string& whyNot) {
    return HITSCOPE_TEXT("not compared: %1").arg(QString::fromStdString(whyNot));
}

}  // namespace

QString verdictText(const PipelineVerdict& verdict) {
    if (!verdict.whyNot.empty()) {
        return notCompared(verdict.whyNot);
    }
    const VertexDifference& compared = verdict.compared;
    const QString vertices = shownCount(compared.vertices);
    if (verdict.isExact()) {
        return HITSCOPE_TEXT("bit-exact in %1 vertices compared").arg(vertices);
    }
    return compared.largest > 0.0f
               ? HITSCOPE_COUNT("not bit-exact: %Ln of %1 vertices {differs|differ}, by up to %2 m",
                                compared.different)
                     .arg(vertices, shownNumber(static_cast<double>(compared.largest), 'g', 2))
               : HITSCOPE_COUNT(
                     "not bit-exact: %Ln of %1 vertices {differs|differ}, in "
                     "{its normal|their normals} only",
                     compared.different)
                     .arg(vertices);
}

QString verdictText(const PickingVerdict& verdict) {
    if (!verdict.whyNot.empty()) {
        return notCompared(verdict.whyNot);
    }
    const QString pixels = shownCount(verdict.pixels);
    if (!verdict.isRight()) {
        return HITSCOPE_TEXT("wrong in %1 of %2 pixels compared").arg(shownCount(verdict.wrong), pixels);
    }
    return (verdict.byGeometry ? HITSCOPE_TEXT("right in %1 pixels compared, through a geometry shader")
                               : HITSCOPE_TEXT("right in %1 pixels compared"))
        .arg(pixels);
}

QString verdictText(const RendererVerdict& verdict, PipelineKind kind) {
    const PipelineVerdict* known = verdict.of(kind);
    return QStringLiteral("%1: %2").arg(
        QString::fromUtf8(pipelineTraits(kind).name),
        known != nullptr ? verdictText(*known) : HITSCOPE_TEXT("not compared yet"));
}

#undef HITSCOPE_COUNT
#undef HITSCOPE_TEXT

}  // namespace hitscope
