// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/cut_actions.h"

#include <QAction>
#include <QMenu>
#include <QScopedValueRollback>
#include <algorithm>
#include <utility>

#include "analysis/comparison.h"
#include "models/focus_target.h"
#include "panels/cutting_plane/cutting_plane_panel.h"
#include "panels/icons/themed_icon.h"
#include "session/target.h"
#include "viewport/handles/cut_handle.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

enum : int { kSlider, kHandle };  // what slides

/// A vertex that is drawn with several normals counts once or more.
std::vector<std::uint32_t> fileVerticesOf(const RenderMesh& mesh,
                                          const std::vector<std::uint32_t>& renderVertices) {
    std::vector<std::uint32_t> vertices(renderVertices.size());
    std::transform(renderVertices.begin(), renderVertices.end(), vertices.begin(),
                   [&mesh](std::uint32_t vertex) { return mesh.fileVertices[vertex]; });
    return vertices;
}

}  // namespace

CutActions::CutActions(Session& session, Comparison& comparison, Viewport& viewport, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_comparison(comparison),
      m_viewport(viewport),
      m_sections(session),
      m_otherSections(session,
                      [&comparison](const Target& target) { return comparison.deformed(target.id); }),
      m_panel(new CuttingPlanePanel(session)),
      m_handle(new CutHandle(viewport)),
      m_on(new QAction(themedIcon(QStringLiteral("cut")), tr("&Cut"), this)) {
    m_on->setShortcut(Qt::Key_K);
    m_on->setCheckable(true);
    m_on->setIconVisibleInMenu(false);  // it would hide the check mark
    m_on->setToolTip(tr("Cutting plane: open the targets and see their section (K)"));
    connect(m_on, &QAction::triggered, this, &CutActions::setOn);
    connect(m_panel, &CuttingPlanePanel::edited, this, [this](const CuttingPlane& cut) {
        if (cut.on != m_session.settings().cut().on) {
            setOn(cut.on);
        } else if (m_sliding) {
            slide(cut, kSlider);
        } else {
            m_isPlaced = true;
            change([&cut](CuttingPlane& now) { now = cut; });
        }
    });
    connect(m_panel, &CuttingPlanePanel::normalChosen, this,
            [this](const glm::vec3& normal) { chooseNormal(normal, m_session.settings().cut().flipped); });
    connect(m_panel, &CuttingPlanePanel::fromViewWanted, this, &CutActions::cutFromView);
    connect(m_panel, &CuttingPlanePanel::resetWanted, this, &CutActions::reset);
    connect(m_panel, &CuttingPlanePanel::moving, this, [this](bool on) {
        m_sliding = on;
        endSliding();
        showPane();
    });
    connect(m_handle, &CutHandle::dragged, this, [this](float offset) {
        CuttingPlane cut = m_session.settings().cut();
        cut.offset = offset;
        slide(cut, kHandle);
    });
    connect(m_handle, &CutHandle::released, this, &CutActions::endSliding);
    connect(m_handle, &CutHandle::hovered, this, [this](bool over) {
        m_handled = over;
        showPane();
    });
    connect(&m_sections, &SceneSections::changed, this, [this] {
        m_viewport.decorations().setSection(m_sections.section() ? m_sections.section()->lines : nullptr);
        m_panel->setSection(m_sections.section());
    });
    connect(&viewport, &Viewport::optionsChanged, this, [this] {
        if (m_viewport.options().cut != m_session.settings().cut()) {
            follow();
        }
        cutTargets();  // exaggeration is changed elsewhere: lines follow it
    });
    followComparison();
    followSession();
    follow();
}

void CutActions::followSession() {
    for (const auto signal : {&SessionTargets::added, &SessionTargets::removed, &SessionTargets::changed}) {
        connect(&m_session.targets(), signal, this, [this] { m_showing.want(); });
    }
    connect(&m_session, &Session::sceneReplaced, this, &CutActions::followScene);
    connect(&m_session.settings(), &SessionSettings::cutChanged, this, [this] {
        m_isPlaced = m_isPlaced || !m_isChanging;  // undo brings it where somebody had it
        DisplayOptions display = m_viewport.options();
        display.cut = m_session.settings().cut();
        m_viewport.setOptions(display);
        show();
    });
}

void CutActions::followComparison() {
    connect(&m_otherSections, &SceneSections::changed, this, [this] {
        m_viewport.decorations().setOtherSection(m_otherSections.section() ? m_otherSections.section()->lines
                                                                           : nullptr);
    });
    connect(&m_comparison, &Comparison::otherChanged, this, &CutActions::cutTargets);
    connect(&m_comparison, &Comparison::verticesChanged, this,
            [this](TargetId id, const std::vector<std::uint32_t>& renderVertices) {
                if (const Target* target = m_session.targets().find(id)) {
                    m_otherSections.note(id, fileVerticesOf(target->deformed.render(), renderVertices));
                }
            });
}

void CutActions::cutTargets() {
    const DisplayOptions& options = m_viewport.options();
    m_sections.setCut(options.cut, options.beforeAfter.exaggeration);
    CuttingPlane other = options.cut;
    other.on = other.on && options.sideBySide && m_comparison.other();
    m_otherSections.setCut(other, options.beforeAfter.exaggeration);
}

void CutActions::change(const std::function<void(CuttingPlane&)>& edit, SessionUndo::Merge merge) {
    CuttingPlane cut = m_session.settings().cut();
    edit(cut);
    const QScopedValueRollback changing(m_isChanging, true);
    m_session.settings().setCut(cut, merge);
    show();  // a button that changed nothing may look as if it had
}

void CutActions::slide(const CuttingPlane& cut, int part) {
    m_isPlaced = true;
    change([&cut](CuttingPlane& now) { now = cut; }, m_gesture.change(part));
}

void CutActions::endSliding() {
    m_gesture.end();
    m_session.finishUndoStep();
}

/// Through the middle of what somebody is likely to look at: of several targets the middle may be between
/// them.
float CutActions::middleAlong(const glm::vec3& normal) const {
    const Target* target = focusTarget(m_session);
    return offsetRange(target != nullptr ? target->worldBounds() : m_session.targets().bounds(), normal)
        .middle();
}

CuttingPlane CutActions::switched(bool on) const {
    CuttingPlane cut = m_session.settings().cut();
    const OffsetRange range = offsetRange(m_session.targets().bounds(), cut.normal);
    cut.on = on;
    if (on && (!m_isPlaced || !range.contains(cut.offset))) {
        cut.offset = middleAlong(cut.normal);
    }
    return cut;
}

void CutActions::setOn(bool on) {
    change([this, on](CuttingPlane& cut) { cut = switched(on); });
    if (on) {
        sayOn();
    }
}

void CutActions::sayOn() {
    if (!std::exchange(m_wasOn, true)) {
        Q_EMIT switchedOn();
    }
}

CuttingPlane CutActions::along(const glm::vec3& normal, bool flipped) const {
    CuttingPlane cut = m_session.settings().cut();
    cut.normal = normal;
    cut.offset = middleAlong(normal);
    cut.flipped = flipped;
    return cut;
}

void CutActions::chooseNormal(const glm::vec3& normal, bool flipped) {
    m_isPlaced = true;
    change([&](CuttingPlane& cut) { cut = along(normal, flipped); });
}

/// One step to undo.
void CutActions::cutAlong(const glm::vec3& normal, bool flipped) {
    m_isPlaced = true;
    change([&](CuttingPlane& cut) {
        cut = along(normal, flipped);
        cut.on = true;
    });
    sayOn();
}

/// What is nearer to the eye than the middle of the target is hidden.
void CutActions::cutFromView() {
    cutAlong(-m_viewport.navigation().goal().forward(), false);
}

void CutActions::reset() {
    chooseNormal(CuttingPlane().normal, false);
}

void CutActions::followScene() {
    m_isPlaced = false;
    const QScopedValueRollback changing(m_isChanging, true);
    m_session.settings().restoreCut(switched(m_session.settings().cut().on));
    show();
}

/// Somebody else has set the viewport's options.
void CutActions::follow() {
    m_session.settings().restoreCut(m_viewport.options().cut);
    show();
}

void CutActions::show() {
    const CuttingPlane& cut = m_session.settings().cut();
    const Bounds bounds = m_session.targets().bounds();
    m_panel->setCut(cut, bounds);
    m_handle->setBounds(bounds);
    m_on->setChecked(cut.on);
    for (const auto& [action, option] : m_toggles) {
        action->setChecked(cut.*option);
    }
}

void CutActions::showPane() {
    m_viewport.decorations().setShowsCutPlane(m_handled || m_sliding);
}

QAction* CutActions::addToggle(QMenu& menu, const QString& text, bool CuttingPlane::*option) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    connect(action, &QAction::triggered, this,
            [this, option](bool on) { change([option, on](CuttingPlane& cut) { cut.*option = on; }); });
    m_toggles.emplace_back(action, option);
    return action;
}

void CutActions::fill(QMenu& menu) {
    menu.addAction(m_on);
    menu.addSeparator();
    const std::pair<QString, glm::vec3> axes[] = {{tr("Perpendicular to &X"), {1.0f, 0.0f, 0.0f}},
                                                  {tr("Perpendicular to &Y"), {0.0f, 1.0f, 0.0f}},
                                                  {tr("Perpendicular to &Z"), {0.0f, 0.0f, 1.0f}}};
    for (const auto& [name, normal] : axes) {
        connect(menu.addAction(name), &QAction::triggered, this,
                [this, along = normal] { cutAlong(along, m_session.settings().cut().flipped); });
    }
    QAction* view = menu.addAction(tr("Perpendicular to the &Line of Sight"));
    view->setShortcut(tr("Shift+K"));
    connect(view, &QAction::triggered, this, &CutActions::cutFromView);
    menu.addSeparator();
    addToggle(menu, tr("&Flip"), &CuttingPlane::flipped);
    addToggle(menu, tr("F&ill the Cut"), &CuttingPlane::fill);
    addToggle(menu, tr("Section Line of the &Original"), &CuttingPlane::originalLine);
    addToggle(menu, tr("Section Line of the &Deformed"), &CuttingPlane::deformedLine);
    show();
}

}  // namespace hitscope
