// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/start_card.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSettings>
#include <QToolButton>

#include "analysis/changed_settings.h"
#include "panels/frame_rate/flow_layout.h"
#include "panels/icons/themed_icon.h"
#include "session/session.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

QString settingsKey() {
    return QStringLiteral("window/start_card");
}

QString captionWithKey(const QString& text, const QAction& action) {
    const QKeySequence keys = action.shortcut();
    return keys.isEmpty() ? text
                          : text + QStringLiteral(" (%1)").arg(keys.toString(QKeySequence::NativeText));
}

}  // namespace

StartCard::StartCard(const Offers& offers, QWidget* parent)
    : QFrame(parent), m_toggle(new QAction(this)), m_words(new QLabel(this)) {
    setObjectName(QStringLiteral("startCard"));
    setFrameShape(QFrame::StyledPanel);
    m_toggle->setText(tr("Getting &Started"));
    m_toggle->setCheckable(true);
    connect(m_toggle, &QAction::triggered, this, &StartCard::set);

    m_words->setObjectName(QStringLiteral("startWords"));
    m_words->setWordWrap(true);
    setTool(Tool::Shoot);
    auto* close = new QToolButton(this);
    close->setObjectName(QStringLiteral("closeStartCard"));
    close->setIcon(themedIcon(QStringLiteral("close")));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close; Help > Getting Started shows this again"));
    connect(close, &QToolButton::clicked, this, &StartCard::dismiss);

    auto* buttons = new FlowLayout;
    buttons->setSpacing(4);
    addOffer(*buttons, offers.inspect, captionWithKey(tr("Inspect Vertices"), *offers.inspect),
             "startInspect");
    addOffer(*buttons, offers.exportMesh, captionWithKey(tr("Export Mesh…"), *offers.exportMesh),
             "startExport");
    addOffer(*buttons, offers.open, captionWithKey(tr("Open a Mesh…"), *offers.open), "startOpen");
    auto* samples = new QToolButton(this);
    samples->setObjectName(QStringLiteral("startSamples"));
    samples->setText(tr("Samples"));
    samples->setMenu(offers.samples);
    samples->setPopupMode(QToolButton::InstantPopup);
    samples->setToolButtonStyle(Qt::ToolButtonTextOnly);
    buttons->addWidget(samples);

    auto* column = new QVBoxLayout;
    column->addWidget(m_words);
    column->addLayout(buttons);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(10, 6, 6, 6);
    row->addLayout(column, 1);
    row->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void StartCard::follow(Viewport& viewport, const Session& session) {
    const InspectTool& tool = viewport.inspectTool();
    connect(&viewport, &Viewport::shot, this, &StartCard::shotFired);
    connect(&tool, &InspectTool::toolChanged, this, [this, &tool] { setTool(tool.tool()); });
    connect(&session, &Session::sceneReplaced, this, [this] {
        if (m_hasShot) {
            dismiss();
        }
    });
}

/// Who shoots knows how: no later start shows it.
void StartCard::shotFired() {
    if (m_toggle->isChecked() && !m_hasShot) {
        m_hasShot = true;
        ChangedSettings()->setValue(settingsKey(), false);
        setTool(m_tool);
    }
}

/// Says what a click and a drag do with this tool.
void StartCard::setTool(Tool tool) {
    m_tool = tool;
    switch (tool) {
        case Tool::Shoot:
            m_words->setText(
                m_hasShot
                    ? tr("<b>Shoot on, or inspect which vertices moved.</b> Ctrl+Z takes a hit back.")
                    : tr("<b>Click the mesh to shoot at it.</b> Drag to look around it, wheel to zoom."));
            break;
        case Tool::Inspect:
            m_words->setText(
                tr("<b>Click a vertex to see which hits moved it.</b> Drag around vertices to select those "
                   "that moved, Alt+drag to look around, wheel to zoom."));
            break;
        case Tool::Brush:
            m_words->setText(tr(
                "<b>Drag over the mesh to paint dents.</b> Drag beside it to look around, wheel to zoom."));
            break;
        case Tool::Move:
            m_words->setText(
                tr("<b>Click a target, and drag its handles to move and turn it.</b> Drag elsewhere to look "
                   "around, wheel to zoom."));
            break;
    }
}

void StartCard::addOffer(QLayout& layout, QAction* action, const QString& text, const char* name) {
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(name));
    button->setIcon(action->icon());
    button->setText(text);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    connect(button, &QToolButton::clicked, action, &QAction::trigger);
    layout.addWidget(button);
}

void StartCard::restore(const QSettings& settings) {
    const bool on = settings.value(settingsKey(), true).toBool();
    setVisible(on);
    m_toggle->setChecked(on);
}

void StartCard::set(bool on) {
    m_hasShot = false;
    setTool(m_tool);
    setVisible(on);
    m_toggle->setChecked(on);
    ChangedSettings()->setValue(settingsKey(), on);
}

void StartCard::dismiss() {
    if (m_toggle->isChecked()) {
        set(false);
    }
}

}  // namespace hitscope
