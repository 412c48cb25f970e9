// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/change_actions.h"

#include <QActionGroup>
#include <QMenu>
#include <utility>

#include "analysis/hit_effects.h"
#include "panels/change/change_panel.h"
#include "panels/help/help_text.h"
#include "viewport/handles/wipe_handle.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr float kUsualExaggeration = 5.0f;  // what the key switches on

}  // namespace

ChangeActions::ChangeActions(Session& session, HitEffects& effects, Viewport& viewport, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_viewport(viewport),
      m_values(session),
      m_comparison(session),
      m_panel(new ChangePanel(m_values, m_comparison, session)) {
    followCounts(effects);
    viewport.setChangeValues(&m_values, &m_comparison);
    followComparison();
    const auto redraw = [this] {
        if (m_viewport.options().change.on) {
            m_viewport.followPicture();
        }
    };
    connect(&m_values, &ChangeValues::summaryChanged, &viewport, redraw);
    connect(&m_values, &ChangeValues::valuesChanged, &viewport, redraw);
    connect(m_panel, &ChangePanel::mapEdited, this, [this](const ChangeMapOptions& map) {
        change([&map](DisplayOptions& display) { display.change = map; });
    });
    connect(m_panel, &ChangePanel::beforeAfterEdited, this, [this](const BeforeAfterOptions& options) {
        change([&options](DisplayOptions& display) { display.beforeAfter = options; });
    });
    connect(m_panel, &ChangePanel::shownOrHidden, this, &ChangeActions::follow);
    connect(new WipeHandle(viewport), &WipeHandle::dragged, this,
            [this](float at) { change([at](DisplayOptions& display) { display.beforeAfter.wipeAt = at; }); });
    follow();
}

/// Numbers of hits come a moment after the vertices, and do not say of which vertices: those that moved
/// meanwhile.
void ChangeActions::followCounts(HitEffects& effects) {
    m_values.setHitCounts([&effects](TargetId target) { return effects.counts(target); });
    connect(&m_session.readBack(), &ReadBack::shadingChanged, this,
            [this](TargetId target, const std::vector<std::uint32_t>& vertices) {
                if (m_values.quantity() == ChangeQuantity::HitCount) {
                    std::set<std::uint32_t>& clusters = m_recounting[target];
                    for (const std::uint32_t vertex : vertices) {
                        clusters.insert(clusters.end(), vertex / kClusterVertices * kClusterVertices);
                    }
                }
            });
    connect(&effects, &HitEffects::countsChanged, this, [this, &effects](TargetId target) {
        if (m_values.quantity() != ChangeQuantity::HitCount) {
            return;
        }
        const std::set<std::uint32_t>& clusters = m_recounting[target];
        if (clusters.empty()) {
            m_values.touchAll(target);  // a hit that a pipeline had dropped is gone
        } else {
            m_values.touch(target, std::vector<std::uint32_t>(clusters.begin(), clusters.end()));
        }
        if (effects.isUpToDate()) {
            m_recounting.clear();
        }
    });
}

void ChangeActions::change(const std::function<void(DisplayOptions&)>& edit) {
    DisplayOptions display = m_viewport.options();
    edit(display);
    m_viewport.setOptions(display);
    follow();
}

/// The viewport's options are the truth.
void ChangeActions::follow() {
    const DisplayOptions& display = m_viewport.options();
    const bool looked = display.change.on || m_panel->isVisible();
    m_values.setQuantity(looked ? std::optional(display.change.quantity) : std::nullopt);
    m_panel->setOptions(display);
    if (m_on == nullptr) {
        return;
    }
    m_on->setChecked(display.change.on);
    m_isolines->setChecked(display.change.isolines);
    m_wipe->setChecked(display.beforeAfter.wipe);
    m_sideBySide->setChecked(display.sideBySide);
    m_exaggerate->setChecked(display.beforeAfter.exaggeration != 1.0f);
    m_quantities[static_cast<std::size_t>(display.change.quantity)]->setChecked(true);
    m_ghosts[static_cast<std::size_t>(display.beforeAfter.ghost)]->setChecked(true);
}

QAction* ChangeActions::addToggle(QMenu& menu, const QString& text, const QKeySequence& keys,
                                  std::function<void(DisplayOptions&, bool)> edit) {
    QAction* action = menu.addAction(text);
    action->setShortcut(keys);
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, run = std::move(edit)](bool on) {
        change([&run, on](DisplayOptions& display) { run(display, on); });
    });
    return action;
}

void ChangeActions::fill(QMenu& menu) {
    m_on = addToggle(menu, tr("&Colour Map"), Qt::Key_V,
                     [](DisplayOptions& display, bool on) { display.change.on = on; });
    fillQuantities(*menu.addMenu(tr("&Quantity")));
    m_isolines = addToggle(menu, tr("&Isolines"), tr("Shift+V"),
                           [](DisplayOptions& display, bool on) { display.change.isolines = on; });
    menu.addSeparator();
    fillGhosts(*menu.addMenu(tr("&Ghost of the Original")));
    m_wipe = addToggle(menu, tr("&Wipe to the Original"), Qt::Key_X,
                       [](DisplayOptions& display, bool on) { display.beforeAfter.wipe = on; });
    m_exaggerate = addToggle(menu, tr("&Exaggerate"), tr("Shift+X"), [](DisplayOptions& display, bool on) {
        display.beforeAfter.exaggeration = on ? kUsualExaggeration : 1.0f;
    });
    menu.addSeparator();
    fillPipelines(*menu.addMenu(tr("Com&pare with Pipeline")));
    m_sideBySide = menu.addAction(tr("&Side by Side"));
    m_sideBySide->setShortcut(tr("Shift+B"));
    m_sideBySide->setCheckable(true);
    connect(m_sideBySide, &QAction::triggered, this, &ChangeActions::setSideBySide);
    follow();
}

void ChangeActions::followComparison() {
    m_values.setOtherVertices([this](TargetId target) { return m_comparison.vertices(target); });
    connect(&m_comparison, &Comparison::verticesChanged, this,
            [this](TargetId target, const std::vector<std::uint32_t>& vertices) {
                if (m_values.quantity() == ChangeQuantity::Difference) {
                    m_values.touch(target, vertices);
                }
            });
    connect(&m_comparison, &Comparison::valuesChanged, &m_viewport, [this] { m_viewport.wantPicture(); });
    connect(&m_comparison, &Comparison::reportChanged, &m_viewport, [this] { m_viewport.wantPicture(); });
    connect(m_panel, &ChangePanel::otherChosen, this, &ChangeActions::chooseOther);
    connect(m_panel, &ChangePanel::sideBySideEdited, this, &ChangeActions::setSideBySide);
}

/// Off, the comparison ends with it, unless colours show the difference.
void ChangeActions::setSideBySide(bool on) {
    const ChangeMapOptions& map = m_viewport.options().change;
    if (on && !m_comparison.other()) {
        m_comparison.setOther(usualOther());
    } else if (!on && !(map.on && map.quantity == ChangeQuantity::Difference)) {
        m_comparison.setOther(std::nullopt);
    }
    change([on](DisplayOptions& display) { display.sideBySide = on; });
}

void ChangeActions::chooseOther(std::optional<PipelineKind> other) {
    m_comparison.setOther(other);
    change([&other](DisplayOptions& display) { display.sideBySide = display.sideBySide && other; });
}

/// The paper's two beside each other, where the driver has them.
PipelineKind ChangeActions::usualOther() const {
    const PipelineKind other = m_session.settings().pipeline() == PipelineKind::TransformFeedback
                                   ? PipelineKind::UniformArray
                                   : PipelineKind::TransformFeedback;
    return m_session.readBack().whyUnavailable(other).isEmpty() ? other : PipelineKind::Reference;
}

void ChangeActions::fillPipelines(QMenu& menu) {
    // What the driver offers is known when the menu opens, not when it is made.
    connect(&menu, &QMenu::aboutToShow, this, [this, &menu] {
        menu.clear();
        const auto add = [this, &menu](const QString& name, std::optional<PipelineKind> kind) {
            QAction* action = menu.addAction(name);
            action->setCheckable(true);
            action->setChecked(m_comparison.other() == kind);
            connect(action, &QAction::triggered, this, [this, kind] { chooseOther(kind); });
            return action;
        };
        add(tr("&Off"), std::nullopt);
        for (const PipelineTraits& traits : allPipelines()) {
            const QString why = m_session.readBack().whyUnavailable(traits.kind);
            enableIf(*add(QString::fromUtf8(traits.name), traits.kind), why.isEmpty(), why);
        }
    });
}

void ChangeActions::fillQuantities(QMenu& menu) {
    menu.setToolTipsVisible(true);
    auto* group = new QActionGroup(this);
    for (const ChangeTraits& traits : allChangeQuantities()) {
        QAction* action = addToggle(menu, QString::fromUtf8(traits.name), {},
                                    [quantity = traits.quantity](DisplayOptions& display, bool) {
                                        display.change.quantity = quantity;
                                        display.change.on = true;
                                    });
        action->setToolTip(QString::fromUtf8(traits.description));
        group->addAction(action);
        m_quantities.push_back(action);
    }
}

void ChangeActions::fillGhosts(QMenu& menu) {
    auto* group = new QActionGroup(this);
    const QString names[] = {tr("&Off"), tr("&Wire"), tr("&Translucent")};
    for (int mode = 0; mode < 3; ++mode) {
        QAction* action = addToggle(menu, names[mode], {}, [mode](DisplayOptions& display, bool) {
            display.beforeAfter.ghost = static_cast<GhostMode>(mode);
        });
        group->addAction(action);
        m_ghosts.push_back(action);
    }
    menu.addSeparator();
    QAction* next = menu.addAction(tr("Next &Mode"));
    next->setShortcut(Qt::Key_B);
    connect(next, &QAction::triggered, this, [this] {
        change([](DisplayOptions& display) {
            display.beforeAfter.ghost =
                static_cast<GhostMode>((static_cast<int>(display.beforeAfter.ghost) + 1) % 3);
        });
    });
}

}  // namespace hitscope
