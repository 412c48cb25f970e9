// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/scene/scene_panel.h"

#include <QAction>
#include <QHeaderView>
#include <QItemSelection>
#include <QMenu>
#include <algorithm>

#include "models/quantity_text.h"
#include "panels/fields/context_menu.h"
#include "panels/fields/select_only.h"
#include "panels/help/help_text.h"
#include "panels/icons/themed_icon.h"
#include "panels/scene/add_primitive_dialog.h"
#include "panels/scene/physics_fields.h"
#include "panels/scene/scene_delegate.h"
#include "panels/scene/transform_fields.h"
#include "session/primitive_target.h"
#include "session/shown_number.h"
#include "ui_scene.h"

namespace hitscope {

namespace {

constexpr int kCellPadding = 14;  // pixels

QString withKey(const QString& text, const QKeySequence& key) {
    return QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText));
}

}  // namespace

ScenePanel::ScenePanel(Session& session, SceneModel& model, QWidget* parent)
    : QWidget(parent), m_session(session), m_model(model), m_ui(std::make_unique<Ui::Scene>()) {
    m_ui->setupUi(this);
    setUpTable();
    makeAddMenu();
    makeActions();
    new TransformFields(session,
                        {{m_ui->positionX, m_ui->positionY, m_ui->positionZ},
                         {m_ui->rotationX, m_ui->rotationY, m_ui->rotationZ}},
                        *m_ui->whose, this);
    new PhysicsFields(session, *m_ui->dynamic, {m_ui->mass, m_ui->friction, m_ui->restitution},
                      *m_ui->trouble, this);
    const QItemSelectionModel* selection = m_ui->table->selectionModel();
    connect(selection, &QItemSelectionModel::selectionChanged, this, &ScenePanel::followSelection);
    connect(selection, &QItemSelectionModel::currentChanged, this, &ScenePanel::followSelection);
    connect(&session.targets(), &SessionTargets::selectedChanged, this, &ScenePanel::showSelectedTarget);
    connect(&model, &QAbstractItemModel::modelReset, this, &ScenePanel::showSelectedTarget);
    const auto updateSoon = [this] { m_updating.want(); };
    connect(&model, &QAbstractItemModel::rowsInserted, this, updateSoon);
    connect(&model, &QAbstractItemModel::rowsRemoved, this, updateSoon);
    connect(&model, &QAbstractItemModel::dataChanged, this, updateSoon);
    showSelectedTarget();
}

/// A name being edited is written now: later it would find the panel half gone.
ScenePanel::~ScenePanel() {
    m_ui->table->setModel(nullptr);
}

void ScenePanel::setUpTable() {
    QTableView& table = *m_ui->table;
    showActionsAsMenu(table);
    table.setModel(&m_model);
    table.setItemDelegate(new SceneDelegate(&table));
    table.setDragDropMode(QAbstractItemView::DragOnly);  // to other programs, as a file
    table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table.verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 5);
    QHeaderView& columns = *table.horizontalHeader();
    columns.setMinimumSectionSize(fontMetrics().height() + kCellPadding);
    columns.setSectionResizeMode(QHeaderView::Fixed);
    columns.setSectionResizeMode(SceneModel::NameColumn, QHeaderView::Stretch);
    table.setColumnWidth(SceneModel::VisibleColumn, fontMetrics().height() + kCellPadding);
    for (const int column : {SceneModel::VerticesColumn, SceneModel::HitsColumn}) {
        const QString title = m_model.headerData(column, Qt::Horizontal).toString();
        const QString widest =
            column == SceneModel::HitsColumn ? QStringLiteral("000,000") : QStringLiteral("0,000,000");
        table.setColumnWidth(column, kCellPadding + std::max(fontMetrics().horizontalAdvance(widest),
                                                             fontMetrics().horizontalAdvance(title)));
    }
}

void ScenePanel::makeAddMenu() {
    m_addMenu = new QMenu(tr("&Add Target"), this);
    for (const PrimitiveTraits& traits : allPrimitives()) {
        m_addMenu->addAction(tr("%1…").arg(primitiveName(traits.kind)), this,
                             [this, kind = traits.kind] { addPrimitive(kind); });
    }
    m_addMenu->addSeparator();
    m_addMenu->addAction(tr("Utah Teapot"), this, [this] {
        Q_EMIT targetWanted(tr("Utah teapot"), [] {
            TargetPlan plan = planBuiltIn(BuiltInMesh::Teapot);
            plan.name = tr("Utah teapot");
            return plan;
        });
    });
    m_addMenu->addAction(tr("From File…"), this, &ScenePanel::filesWanted);
    m_ui->add->setMenu(m_addMenu);
    m_ui->add->setIcon(themedIcon(QStringLiteral("add")));
}

QAction* ScenePanel::makeAction(const QString& name, const QString& text, const QKeySequence& key,
                                void (ScenePanel::*act)()) {
    auto* action = new QAction(text, this);
    action->setObjectName(name);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    m_ui->table->addAction(action);
    connect(action, &QAction::triggered, this, act);
    return action;
}

void ScenePanel::makeActions() {
    m_rename =
        makeAction(QStringLiteral("renameTarget"), tr("Rename"), Qt::Key_F2, &ScenePanel::renameCurrent);
    m_toggle =
        makeAction(QStringLiteral("toggleTargets"), tr("Hide"), Qt::Key_Space, &ScenePanel::toggleSelected);
    m_duplicate = makeAction(QStringLiteral("duplicateTargets"), tr("Duplicate"), Qt::CTRL | Qt::Key_D,
                             &ScenePanel::duplicateSelected);
    m_reset = makeAction(QStringLiteral("resetTargets"), tr("Reset Shape"), {}, &ScenePanel::resetSelected);
    m_remove = makeAction(QStringLiteral("removeTargets"), tr("Remove"), QKeySequence::Delete,
                          &ScenePanel::removeSelected);
    m_selectAll = makeAction(QStringLiteral("selectAllTargets"), tr("Select All"), QKeySequence::SelectAll,
                             &ScenePanel::selectAll);
    m_duplicate->setIcon(themedIcon(QStringLiteral("copy")));
    m_reset->setIcon(themedIcon(QStringLiteral("reset")));
    m_remove->setIcon(themedIcon(QStringLiteral("remove")));
    m_duplicate->setToolTip(
        withKey(tr("Duplicate the selected targets, dents included"), m_duplicate->shortcut()));
    m_reset->setToolTip(tr("Back to the original shape: removes the selected targets' hits"));
    m_remove->setToolTip(withKey(tr("Remove the selected targets and their hits"), m_remove->shortcut()));
    m_ui->duplicate->setDefaultAction(m_duplicate);
    m_ui->reset->setDefaultAction(m_reset);
    m_ui->remove->setDefaultAction(m_remove);
}

QList<QAction*> ScenePanel::targetActions() const {
    return {m_selectAll, m_duplicate, m_remove};
}

std::vector<TargetId> ScenePanel::selectedTargets() const {
    std::vector<int> rows;
    for (const QModelIndex& index : m_ui->table->selectionModel()->selectedRows()) {
        rows.push_back(index.row());
    }
    std::sort(rows.begin(), rows.end());
    std::vector<TargetId> targets;
    targets.reserve(rows.size());
    for (const int row : rows) {
        targets.push_back(m_model.targetAt(row));
    }
    return targets;
}

bool ScenePanel::isAnyVisible(const std::vector<TargetId>& targets) const {
    return std::any_of(targets.begin(), targets.end(), [this](TargetId id) {
        const Target* target = m_session.targets().find(id);
        return target != nullptr && target->visible;
    });
}

// Doing

void ScenePanel::addPrimitive(PrimitiveKind kind) {
    AddPrimitiveDialog dialog(kind, usualPrimitiveSize(m_session), window());
    if (dialog.exec() == QDialog::Accepted) {
        const Primitive primitive = dialog.primitive();
        Q_EMIT targetWanted(primitiveName(primitive.kind), [primitive] { return planPrimitive(primitive); });
    }
}

void ScenePanel::selectAll() {
    std::vector<TargetId> all;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        all.push_back(target->id);
    }
    if (!all.empty()) {
        const TargetId selected = m_session.targets().selected();
        m_session.targets().select(selected ? selected : all.front(), all);
    }
}

void ScenePanel::duplicateSelected() {
    const std::vector<TargetId> targets = selectedTargets();
    const QString what = nameOf(targets);
    m_session.targets().duplicate(targets);
    m_updating.now();
    Q_EMIT said(
        (targets.size() == 1 ? tr("Duplicated %1, with its hits.") : tr("Duplicated %1, with their hits."))
            .arg(what));
}

/// For messages.
QString ScenePanel::nameOf(const std::vector<TargetId>& targets) const {
    const Target* only = targets.size() == 1 ? m_session.targets().find(targets.front()) : nullptr;
    return only != nullptr ? tr("“%1”").arg(only->name) : tr("%Ln targets", nullptr, trCount(targets.size()));
}

/// The cursor stays at the place, so that the arrow keys go on from there.
void ScenePanel::removeSelected() {
    const std::vector<TargetId> targets = selectedTargets();
    if (targets.empty()) {
        return;
    }
    const int first = m_model.rowOf(targets.front());
    const QString what = nameOf(targets);
    m_session.targets().remove(targets);
    m_updating.now();
    Q_EMIT said((targets.size() == 1 ? tr("Removed %1. Undo brings it back, with its hits.")
                                     : tr("Removed %1. Undo brings them back, with their hits."))
                    .arg(what));
    const int next = std::min(first, m_model.rowCount() - 1);
    m_ui->table->selectionModel()->setCurrentIndex(m_model.index(next, SceneModel::NameColumn),
                                                   QItemSelectionModel::NoUpdate);
}

void ScenePanel::resetSelected() {
    m_session.targets().reset(selectedTargets());
    m_updating.now();
}

void ScenePanel::toggleSelected() {
    const std::vector<TargetId> targets = selectedTargets();
    m_session.targets().setVisible(targets, !isAnyVisible(targets));
    m_updating.now();
}

void ScenePanel::renameCurrent() {
    const int row = m_ui->table->currentIndex().row();
    if (row >= 0) {
        m_ui->table->edit(m_model.index(row, SceneModel::NameColumn));
    }
}

// Following

void ScenePanel::followSelection() {
    if (m_following) {
        return;
    }
    m_following = true;
    const QModelIndex current = m_ui->table->selectionModel()->currentIndex();
    const bool chosen = m_ui->table->selectionModel()->isSelected(current);
    const std::vector<TargetId> targets = selectedTargets();
    m_session.targets().select(chosen ? m_model.targetAt(current.row()) : TargetId{}, targets);
    m_following = false;
    updateActions();
}

/// Neighbours as one range: with many ranges each look at the selection takes long.
QItemSelection ScenePanel::rowsOfSelected() const {
    const auto isOne = [this](int row) { return m_session.targets().isSelected(m_model.targetAt(row)); };
    QItemSelection selection;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        if (!isOne(row)) {
            continue;
        }
        const int first = row;
        while (row + 1 < m_model.rowCount() && isOne(row + 1)) {
            ++row;
        }
        selection.append(QItemSelectionRange(m_model.index(first, SceneModel::NameColumn),
                                             m_model.index(row, SceneModel::NameColumn)));
    }
    return selection;
}

void ScenePanel::showSelectedTarget() {
    if (m_following) {
        return;
    }
    m_following = true;
    const int row = m_model.rowOf(m_session.targets().selected());
    if (row < 0) {
        m_ui->table->clearSelection();
    } else if (m_ui->table->currentIndex().row() != row ||
               selectedTargets() != m_session.targets().allSelected()) {
        const QModelIndex current = m_model.index(row, SceneModel::NameColumn);
        selectOnly(*m_ui->table, current);
        m_ui->table->selectionModel()->select(rowsOfSelected(),
                                              QItemSelectionModel::Select | QItemSelectionModel::Rows);
        m_ui->table->scrollTo(current);
    }
    m_following = false;
    updateActions();
}

void ScenePanel::updateActions() {
    const std::vector<TargetId> targets = selectedTargets();
    const bool some = !targets.empty();
    for (QAction* action : {m_rename, m_toggle, m_duplicate, m_remove}) {
        enableIf(*action, some, tr("Select a target first."));
    }
    enableIf(*m_selectAll, m_model.rowCount() > 0, tr("There are no targets."));
    m_toggle->setText(!some || isAnyVisible(targets) ? tr("Hide") : tr("Show"));
    const bool isAnyHit = std::any_of(targets.begin(), targets.end(), [this](TargetId id) {
        const QModelIndex hits = m_model.index(m_model.rowOf(id), SceneModel::HitsColumn);
        return hits.data(SceneModel::RawValueRole).toULongLong() > 0;
    });
    enableIf(*m_reset, isAnyHit, some ? tr("It has no hits.") : tr("Select a target first."));
    const int count = m_model.rowCount();
    const auto selected = static_cast<int>(targets.size());
    m_ui->summary->setText(count == 0 ? tr("No targets yet")
                           : selected > 1
                               ? tr("%L1 of %Ln {target|targets} selected", nullptr, count).arg(selected)
                               : tr("%Ln {target|targets}", nullptr, count));
}

}  // namespace hitscope
