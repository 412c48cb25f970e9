// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/repeat_actions.h"

#include <QAction>
#include <QMenu>
#include <QSettings>

#include "app/dialogs/brush_dialog.h"
#include "app/dialogs/mirror_dialog.h"
#include "app/dialogs/scatter_dialog.h"
#include "models/quantity_text.h"
#include "viewport/brush_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

QString brushKey(const char* name) {
    return QStringLiteral("brush/") + QLatin1String(name);
}

void raise(QDialog& dialog) {
    dialog.show();
    dialog.raise();
    dialog.activateWindow();
}

}  // namespace

RepeatActions::RepeatActions(Session& session, Viewport& viewport, HitEditing& editing, QWidget& window)
    : QObject(&window), m_session(session), m_viewport(viewport), m_editing(editing), m_window(window) {
    load(QSettings());
    const BrushTool& brush = viewport.brushTool();
    connect(&brush, &BrushTool::settingsChanged, this, [this, &brush] {
        const auto percent = [](double part) {
            return countText(static_cast<std::size_t>(part * 100.0 + 0.5));
        };
        Q_EMIT said(tr("Brush: size %1 %, strength %2 %")
                        .arg(percent(brush.settings().size), percent(brush.settings().strength)));
    });
    connect(&brush, &BrushTool::strokeEnded, this, [this](std::size_t hits) {
        if (hits == 0) {
            Q_EMIT said(tr("Brush stroke cancelled"));
        } else {
            Q_EMIT said(tr("Hits in the brush stroke: %1").arg(countText(hits)));
        }
    });
    connect(&brush, &BrushTool::refused, this, &RepeatActions::failed);
}

void RepeatActions::load(const QSettings& settings) {
    BrushSettings brush;
    brush.size = settings.value(brushKey("size"), brush.size).toDouble();
    brush.strength = settings.value(brushKey("strength"), brush.strength).toDouble();
    brush.spacing = settings.value(brushKey("spacing"), brush.spacing).toDouble();
    brush.spacingMetres = settings.value(brushKey("spacingMetres"), brush.spacingMetres).toDouble();
    brush.isInward = settings.value(brushKey("inward"), brush.isInward).toBool();
    m_viewport.brushTool().setSettings(brush);
}

void RepeatActions::save(QSettings& settings) const {
    const BrushSettings& brush = m_viewport.brushTool().settings();
    settings.setValue(brushKey("size"), brush.size);
    settings.setValue(brushKey("strength"), brush.strength);
    settings.setValue(brushKey("spacing"), brush.spacing);
    settings.setValue(brushKey("spacingMetres"), brush.spacingMetres);
    settings.setValue(brushKey("inward"), brush.isInward);
}

void RepeatActions::fill(QMenu& menu) {
    QAction* scatter = menu.addAction(tr("Sca&tter Hits…"), this, &RepeatActions::showScatter);
    scatter->setToolTip(tr("Spread many hits evenly over a target or its selected vertices"));
    QAction* mirror = menu.addAction(tr("&Mirror Hits…"), this, &RepeatActions::showMirror);
    mirror->setToolTip(tr("Repeat the selected hits, or all, on the other side of a plane"));
    QAction* brush = menu.addAction(tr("Brush Settin&gs…"), this, &RepeatActions::showBrush);
    brush->setToolTip(tr("Size, strength and spacing of the Brush tool"));
}

void RepeatActions::open(PlanDialog* dialog) {
    connect(dialog, &PlanDialog::made, this, &RepeatActions::said, Qt::UniqueConnection);
    connect(dialog, &PlanDialog::failed, this, &RepeatActions::failed, Qt::UniqueConnection);
    raise(*dialog);
}

void RepeatActions::showScatter() {
    auto* dialog = m_window.findChild<ScatterDialog*>();
    open(dialog != nullptr ? dialog : new ScatterDialog(m_session, m_viewport, &m_window));
}

void RepeatActions::showMirror() {
    auto* dialog = m_window.findChild<MirrorDialog*>();
    open(dialog != nullptr ? dialog : new MirrorDialog(m_session, m_viewport, m_editing, &m_window));
}

void RepeatActions::showBrush() {
    auto* dialog = m_window.findChild<BrushDialog*>();
    raise(dialog != nullptr ? *dialog : *new BrushDialog(m_viewport.brushTool(), &m_window));
}

}  // namespace hitscope
