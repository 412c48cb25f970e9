// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/inspect_actions.h"

#include <QActionGroup>
#include <QMenu>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>
#include <vector>

#include "panels/help/help_text.h"
#include "panels/icons/themed_icon.h"
#include "session/vertex_selection.h"
#include "viewport/inspect_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr QLatin1String kLassoKey("inspect/lasso");
constexpr QLatin1String kHiddenKey("inspect/selectsHidden");

}  // namespace

InspectActions::InspectActions(Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_viewport(viewport),
      m_tool(viewport.inspectTool()),
      m_tools(new QActionGroup(this)),
      m_outlines(new QActionGroup(this)) {
    m_shoot = addTool(tr("&Shoot"), tr("Shoot: a click shoots, a drag moves the view (I)"),
                      QStringLiteral("tool_shoot"));
    m_inspect = addTool(tr("&Inspect"),
                        tr("Inspect: point at vertices, click to pick one, drag to select changed ones (I)"),
                        QStringLiteral("tool_inspect"));
    m_brush =
        addTool(tr("&Brush"), tr("Brush: a drag over a target paints hits; [ and ] change the size (R)"),
                QStringLiteral("tool_brush"));
    m_brush->setShortcut(Qt::Key_R);
    m_move = addTool(tr("&Move"), tr("Move: a click selects a target, its handles move and turn it (M)"),
                     QStringLiteral("tool_move"));
    m_move->setShortcut(Qt::Key_M);
    m_toggle = new QAction(tr("Switch &Tool"), this);
    m_toggle->setShortcut(Qt::Key_I);
    m_rectangle = new QAction(tr("Select in a &Rectangle"), m_outlines);
    m_lasso = new QAction(tr("Select with a &Lasso"), m_outlines);
    m_rectangle->setCheckable(true);
    m_lasso->setCheckable(true);
    m_hidden = new QAction(tr("Select &Hidden Vertices Too"), this);
    m_hidden->setCheckable(true);
    m_all = new QAction(tr("Select &All Changed Vertices"), this);
    m_none = new QAction(tr("&Clear Vertex Selection"), this);
    load(QSettings());

    connect(m_shoot, &QAction::triggered, this, [this] { m_tool.setTool(Tool::Shoot); });
    connect(m_inspect, &QAction::triggered, this, [this] { m_tool.setTool(Tool::Inspect); });
    connect(m_brush, &QAction::triggered, this, [this] {
        m_tool.setTool(Tool::Brush);
        m_viewport.setFocus();  // which its further keys are for
    });
    connect(m_move, &QAction::triggered, this, [this] {
        m_tool.setTool(Tool::Move);
        m_viewport.setFocus();
    });
    connect(m_toggle, &QAction::triggered, this,
            [this] { m_tool.setTool(m_tool.tool() == Tool::Inspect ? Tool::Shoot : Tool::Inspect); });
    connect(m_outlines, &QActionGroup::triggered, this, [this](const QAction* chosen) {
        m_tool.setOutline(chosen == m_lasso ? Outline::Lasso : Outline::Rectangle);
        m_tool.setTool(Tool::Inspect);  // where it is of use
    });
    connect(m_hidden, &QAction::toggled, this, [this](bool on) { m_tool.setSelectsHidden(on); });
    connect(m_all, &QAction::triggered, this, &InspectActions::selectAllChanged);
    connect(m_none, &QAction::triggered, this, [this] { m_session.selection().clear(); });
    connect(&m_tool, &InspectTool::toolChanged, this, &InspectActions::follow);
    connect(&session.selection(), &VertexSelection::selectionChanged, this, &InspectActions::follow);
    follow();
}

QAction* InspectActions::addTool(const QString& text, const QString& toolTip, const QString& icon) {
    auto* action = new QAction(themedIcon(icon), text, m_tools);
    action->setToolTip(toolTip);
    action->setCheckable(true);
    action->setIconVisibleInMenu(false);  // it would hide the mark of what is chosen
    return action;
}

void InspectActions::load(const QSettings& settings) {
    const bool lasso = settings.value(kLassoKey, false).toBool();
    (lasso ? m_lasso : m_rectangle)->setChecked(true);
    m_tool.setOutline(lasso ? Outline::Lasso : Outline::Rectangle);
    m_hidden->setChecked(settings.value(kHiddenKey, false).toBool());
    m_tool.setSelectsHidden(m_hidden->isChecked());
}

void InspectActions::save(QSettings& settings) const {
    settings.setValue(kLassoKey, m_lasso->isChecked());
    settings.setValue(kHiddenKey, m_hidden->isChecked());
}

void InspectActions::fill(QMenu& menu) {
    menu.addAction(m_shoot);
    menu.addAction(m_inspect);
    menu.addAction(m_brush);
    menu.addAction(m_move);
    menu.addAction(m_toggle);
    menu.addSeparator();
    menu.addAction(m_rectangle);
    menu.addAction(m_lasso);
    menu.addAction(m_hidden);
    menu.addSeparator();
    menu.addAction(m_all);
    menu.addAction(m_none);
}

void InspectActions::fill(QToolBar& bar) {
    bar.addAction(m_shoot);
    bar.addAction(m_inspect);
    bar.addAction(m_brush);
    bar.addAction(m_move);
    auto* how = new QMenu(&bar);
    how->addActions({m_rectangle, m_lasso, m_hidden});
    auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(m_inspect));
    button->setMenu(how);
    button->setPopupMode(QToolButton::MenuButtonPopup);
}

/// Of the selected target, or of all.
void InspectActions::selectAllChanged() {
    VertexSelection& selection = m_session.selection();
    const TargetId only = m_session.targets().selected();
    auto combine = VertexSelection::Combine::Replace;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        if (only && target->id != only) {
            continue;
        }
        std::vector<std::uint32_t> vertices;
        for (const std::uint32_t vertex : target->deformed.onceChanged()) {
            if (target->deformed.isChanged(vertex)) {
                vertices.push_back(vertex);
            }
        }
        selection.select(target->id, std::move(vertices), combine);
        combine = VertexSelection::Combine::Add;
    }
}

void InspectActions::follow() {
    QAction* tools[] = {m_shoot, m_inspect, m_brush, m_move};
    tools[static_cast<std::size_t>(m_tool.tool())]->setChecked(true);
    enableIf(*m_none, m_session.selection().count() > 0 || m_session.selection().picked(),
             tr("No vertex is selected."));
}

}  // namespace hitscope
