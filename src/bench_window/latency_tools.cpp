// SPDX-License-Identifier: GPL-3.0-or-later
// The aim preview, exports, and scattered hits.
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <utility>

#include "app/dialogs/scatter_dialog.h"
#include "bench_window/latency_exports.h"
#include "bench_window/latency_run.h"
#include "viewport/aim_preview.h"
#include "viewport/viewport.h"

namespace hitscope::bench {

namespace {

constexpr double kMillisecond = 1.0e-3;  // seconds

}  // namespace

void LatencyRun::aims() {
    auto* preview = m_window.viewport().findChild<AimPreview*>();
    // On a large mesh it says no more than that there are too many vertices in reach.
    auto* label = m_window.viewport().findChild<QLabel*>(QStringLiteral("aimPreview"));
    if (preview == nullptr || label == nullptr) {
        return;
    }
    label->installEventFilter(&m_window);  // it may be drawn without the viewport
    for (const bool isRefined : {false, true}) {
        m_window.setRefines(isRefined);
        if (isRefined && !m_window.wait(QStringLiteral("the refined picture"), [this] {
                const PictureRefiner& refiner = m_window.viewport().pictures().refiner();
                return refiner.wasShown() || !refiner.whyNot().isEmpty();
            })) {
            return;
        }
        aimsOver(*preview, *label, isRefined);
    }
    m_window.setRefines(false);
}

void LatencyRun::aimsOver(AimPreview& preview, const QLabel& label, bool isRefined) {
    Row picture{isRefined ? QStringLiteral("aim preview, over a refined picture")
                          : QStringLiteral("aim preview, rest to picture")};
    int round = 0;
    m_window.moveTo(0.5, 0.5);
    repeat([&] {
        bool isShown = false;
        QObject listener;
        QObject::connect(&preview, &AimPreview::shown, &listener, [&] { isShown = true; });
        const auto shown = m_window.untilShown(
            QStringLiteral("the aim preview"), [&] { m_window.moveTo(0.5 + 0.01 * (++round % 4), 0.48); },
            [&] { return isShown || label.isVisible(); });
        if (!shown) {
            return false;
        }
        picture.add(shown->seen.seconds - kMillisecond * AimPreview::kRest, shown->seen.blocked,
                    shown->seen.processor);
        return true;
    });
    take(picture);
}

void LatencyRun::scatter() {
    if (m_repeats.scattered == 0 || !m_window.settle() || !m_window.choose(QStringLiteral("Scatter Hits"))) {
        return;
    }
    auto* dialog = m_window.window().findChild<ScatterDialog*>();
    auto* count = dialog != nullptr ? dialog->findChild<QSpinBox*>(QStringLiteral("count")) : nullptr;
    auto* apply = dialog != nullptr ? dialog->findChild<QPushButton*>(QStringLiteral("apply")) : nullptr;
    if (count == nullptr || apply == nullptr) {
        return;
    }
    const auto wanted = static_cast<std::size_t>(m_repeats.scattered);
    const auto isPlanned = [&] {
        const HitPlanner::Plan* plan = dialog->planner().current();
        return plan != nullptr && plan->hits.size() == wanted;
    };
    Row preview{QStringLiteral("scatter, previewed")};
    Row applied{QStringLiteral("scatter, applied")};
    Row undone{QStringLiteral("scatter, undone")};
    Row redone{QStringLiteral("scatter, redone")};
    if (const auto shown = m_window.untilShown(
            QStringLiteral("the preview of scattered hits"), [&] { count->setValue(m_repeats.scattered); },
            isPlanned)) {
        preview.add(*shown);
    }
    m_window.settle();
    if (const auto shown = m_window.untilShown(
            QStringLiteral("the picture of scattered hits"),
            [&] { QTest::mouseClick(apply, Qt::LeftButton); },
            [&] { return hits() == wanted && isAllApplied(); })) {
        applied.add(*shown);
    }
    m_window.window().activateWindow();
    m_window.wait(QStringLiteral("the window's turn after the dialog"),
                  [&] { return m_window.window().isActiveWindow(); });
    m_window.settle();
    if (isGood() && stepBack(false, undone)) {
        stepBack(true, redone);
    }
    for (Row* row : {&preview, &applied, &undone, &redone}) {
        take(std::move(*row));
    }
}

void LatencyRun::exports() {
    for (Row& row : exportLatency(m_window)) {
        take(std::move(row));
    }
}

}  // namespace hitscope::bench
