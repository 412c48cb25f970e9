// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/scene_presets.h"

#include <QCoreApplication>
#include <QStringList>
#include <array>

#include "session/primitive_target.h"

namespace hitscope {

namespace {

constexpr float kGridSpacing = 15.0f;  // metres
constexpr int kGridColumns = 4;

QString counted(int count, const char* what) {
    return QStringLiteral("%1 %2").arg(count).arg(
        QCoreApplication::translate("PaperRow", what, nullptr, count));
}

RigidTransform gridCell(int index) {
    const int column = index % kGridColumns;
    const int row = index / kGridColumns;
    const float middle = 0.5f * static_cast<float>(kGridColumns - 1);
    RigidTransform where;
    where.position = {(static_cast<float>(column) - middle) * kGridSpacing, kPaperHalfExtent,
                      (static_cast<float>(row) - middle) * kGridSpacing};
    return where;
}

}  // namespace

QString PaperRow::label() const {
    QStringList parts;
    const auto add = [&parts](int count, const char* one, const char* many) {
        if (count > 0) {
            parts << counted(count, count == 1 ? one : many);
        }
    };
    add(lowPolyCubes, QT_TRANSLATE_NOOP("PaperRow", "low-poly cube"),
        QT_TRANSLATE_NOOP("PaperRow", "low-poly cubes"));
    add(highPolyCubes, QT_TRANSLATE_NOOP("PaperRow", "high-poly cube"),
        QT_TRANSLATE_NOOP("PaperRow", "high-poly cubes"));
    add(lowPolySpheres, QT_TRANSLATE_NOOP("PaperRow", "low-poly sphere"),
        QT_TRANSLATE_NOOP("PaperRow", "low-poly spheres"));
    add(highPolySpheres, QT_TRANSLATE_NOOP("PaperRow", "high-poly sphere"),
        QT_TRANSLATE_NOOP("PaperRow", "high-poly spheres"));
    return parts.join(QStringLiteral(", "));
}

std::span<const PaperRow> paperRows() {
    static constexpr std::array<PaperRow, 9> kRows = {{{3, 3, 0, 10},
                                                       {3, 3, 5, 5},
                                                       {3, 3, 10, 0},
                                                       {6, 0, 0, 10},
                                                       {6, 0, 5, 5},
                                                       {6, 0, 10, 0},
                                                       {0, 6, 0, 10},
                                                       {0, 6, 5, 5},
                                                       {0, 6, 10, 0}}};
    return kRows;
}

std::vector<TargetPlan> planPaperRow(const PaperRow& row) {
    std::vector<TargetPlan> plans;
    const auto add = [&plans](int count, const QString& name, BuiltInMesh mesh) {
        if (count == 0) {
            return;
        }
        TargetPlan plan = planBuiltIn(mesh);
        for (int i = 1; i <= count; ++i) {
            plan.name = QStringLiteral("%1 %2").arg(name).arg(i);
            plan.transform = gridCell(static_cast<int>(plans.size()));
            plans.push_back(plan);
        }
    };
    add(row.lowPolyCubes, QStringLiteral("Low-poly cube"), BuiltInMesh::LowPolyCube);
    add(row.highPolyCubes, QStringLiteral("High-poly cube"), BuiltInMesh::HighPolyCube);
    add(row.lowPolySpheres, QStringLiteral("Low-poly sphere"), BuiltInMesh::LowPolySphere);
    add(row.highPolySpheres, QStringLiteral("High-poly sphere"), BuiltInMesh::HighPolySphere);
    return plans;
}

}  // namespace hitscope
