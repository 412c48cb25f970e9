// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/hit_history_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QItemSelection>
#include <QScrollBar>
#include <algorithm>

#include "deform/dent_shape.h"
#include "models/quantity_text.h"
#include "panels/fields/context_menu.h"
#include "panels/fields/select_only.h"
#include "panels/help/help_text.h"
#include "panels/hit_history/hit_columns.h"
#include "panels/hit_history/hit_delegate.h"
#include "panels/hit_history/hit_filter_bar.h"
#include "panels/hit_history/time_scrubber.h"
#include "panels/icons/themed_icon.h"
#include "session/shown_number.h"
#include "ui_hit_history.h"

namespace hitscope {

namespace {

/// Around a hit that is looked at, in reaches of the hit.
constexpr float kSurroundings = 2.5f;

QString withKey(const QString& text, const QKeySequence& key) {
    return QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText));
}

}  // namespace

HitHistoryPanel::HitHistoryPanel(Session& session, HitHistoryModel& model, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_model(model),
      m_list(session, model),
      m_ui(std::make_unique<Ui::HitHistory>()) {
    m_ui->setupUi(this);
    m_filterBar = new HitFilterBar(session, m_list, this);
    m_ui->layout->insertWidget(0, m_filterBar);
    m_ui->buttons->insertWidget(0, new TimeScrubber(session, this), 1);
    setUpTable();
    makeActions();
    m_ui->meter->follow(session);
    updateSummary();
    updateActions();
    connectAll();
}

HitHistoryPanel::~HitHistoryPanel() = default;

void HitHistoryPanel::setUpTable() {
    QTableView& table = *m_ui->table;
    table.setModel(&m_list);
    table.setItemDelegate(new HitDelegate(&table));
    setUpHitColumns(table);
    showActionsAsMenu(table);
    table.horizontalHeader()->setSortIndicator(HitHistoryModel::NumberColumn, Qt::AscendingOrder);
    table.horizontalHeader()->setSortIndicatorClearable(true);
    table.setSortingEnabled(true);
}

QByteArray HitHistoryPanel::columns() const {
    return m_ui->table->horizontalHeader()->saveState();
}

/// The rows are in the history's order all the same.
void HitHistoryPanel::setColumns(const QByteArray& columns) {
    QHeaderView& header = *m_ui->table->horizontalHeader();
    if (header.restoreState(columns)) {
        header.setSectionHidden(HitHistoryModel::NumberColumn, false);
        m_ui->table->sortByColumn(HitHistoryModel::NumberColumn, Qt::AscendingOrder);
    }
}

void HitHistoryPanel::addHitActions(const QList<QAction*>& actions) {
    auto* separator = new QAction(this);
    separator->setSeparator(true);
    m_ui->table->addAction(separator);
    m_ui->table->addActions(actions);
}

void HitHistoryPanel::connectAll() {
    const QItemSelectionModel* selection = m_ui->table->selectionModel();
    connect(selection, &QItemSelectionModel::selectionChanged, this, &HitHistoryPanel::followSelection);
    connect(selection, &QItemSelectionModel::currentChanged, this, &HitHistoryPanel::followSelection);
    connect(&m_session.hits(), &SessionHits::selectedChanged, this, &HitHistoryPanel::showSelectedHit);
    connect(&m_list, &QAbstractItemModel::modelReset, this, &HitHistoryPanel::showSelectedHit);
    connect(&m_list, &HitList::listed, this, &HitHistoryPanel::updateActions);
    connect(&m_session.hits(), &SessionHits::shownChanged, this, &HitHistoryPanel::updateSummary);
    connect(m_ui->table, &QAbstractItemView::doubleClicked, this, &HitHistoryPanel::activate);
    connect(m_filterBar, &HitFilterBar::opened, this, [this](bool isOpen) {
        m_filter->setChecked(isOpen);
        updateSummary();
        if (!isOpen) {
            m_ui->table->setFocus();
        }
    });
    connect(&m_list, &HitList::listed, this, &HitHistoryPanel::updateSummary);
    connect(&m_list, &QAbstractItemModel::rowsAboutToBeInserted, this, [this] {
        const QScrollBar* bar = m_ui->table->verticalScrollBar();
        m_atNewest = bar->value() == bar->maximum();
    });
    connect(&m_list, &QAbstractItemModel::rowsInserted, this, &HitHistoryPanel::scrollToNewest);
    connect(&m_session.hits(), &SessionHits::appended, this, &HitHistoryPanel::updateSummary);
    connect(&m_session.readBack(), &ReadBack::capacityChanged, this, &HitHistoryPanel::updateSummary);
    connect(&m_session.hits(), &SessionHits::reset, this, [this] {
        updateSummary();
        updateActions();
    });
}

QAction* HitHistoryPanel::makeAction(const QString& text, const QKeySequence& key,
                                     void (HitHistoryPanel::*act)()) {
    auto* action = new QAction(text, this);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    m_ui->table->addAction(action);
    connect(action, &QAction::triggered, this, act);
    return action;
}

void HitHistoryPanel::makeActions() {
    const auto addSeparator = [this] {
        auto* separator = new QAction(this);
        separator->setSeparator(true);
        m_ui->table->addAction(separator);
    };
    m_toggle = makeAction(tr("Disable"), Qt::Key_Space, &HitHistoryPanel::toggleSelected);
    m_toggle->setObjectName(QStringLiteral("toggleHits"));
    addSeparator();
    m_up = makeAction(tr("Move Up"), Qt::ALT | Qt::Key_Up, &HitHistoryPanel::moveSelectedUp);
    m_down = makeAction(tr("Move Down"), Qt::ALT | Qt::Key_Down, &HitHistoryPanel::moveSelectedDown);
    addSeparator();
    m_fly = makeAction(tr("Fly There"), Qt::Key_Return, &HitHistoryPanel::flyToCurrent);
    m_edit = makeAction(tr("Edit"), Qt::Key_F2, &HitHistoryPanel::editWanted);
    m_selectTargets = makeAction(tr("Select All on This Target"), {}, &HitHistoryPanel::selectTargetsHits);
    m_selectGroup = makeAction(tr("Select Group"), {}, &HitHistoryPanel::selectGroup);
    m_selectGroup->setObjectName(QStringLiteral("selectGroup"));
    m_group = makeAction(tr("Group"), {}, &HitHistoryPanel::groupSelected);
    m_group->setObjectName(QStringLiteral("groupHits"));
    m_ungroup = makeAction(tr("Ungroup"), {}, &HitHistoryPanel::ungroupSelected);
    m_ungroup->setObjectName(QStringLiteral("ungroupHits"));
    m_copy = makeAction(tr("Copy as CSV"), QKeySequence::Copy, &HitHistoryPanel::copySelected);
    addSeparator();
    m_remove = makeAction(tr("Remove"), QKeySequence::Delete, &HitHistoryPanel::removeSelected);
    m_remove->setIcon(themedIcon(QStringLiteral("remove")));
    m_copy->setIcon(themedIcon(QStringLiteral("copy")));
    m_remove->setToolTip(
        withKey(tr("Remove the selected hits; the mesh is rebuilt from the others"), m_remove->shortcut()));
    m_copy->setToolTip(
        withKey(tr("Copy the selected hits, or all, as comma-separated text"), m_copy->shortcut()));
    m_filter = new QAction(themedIcon(QStringLiteral("filter")), tr("Filter"), this);
    m_filter->setCheckable(true);
    m_filter->setShortcut(QKeySequence::Find);
    m_filter->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    m_filter->setToolTip(withKey(tr("List only some of the hits"), m_filter->shortcut()));
    addAction(m_filter);
    connect(m_filter, &QAction::triggered, this, &HitHistoryPanel::toggleFilter);
    m_ui->filter->setDefaultAction(m_filter);
    m_ui->remove->setDefaultAction(m_remove);
    m_ui->copy->setDefaultAction(m_copy);
}

std::vector<std::size_t> HitHistoryPanel::selectedRows() const {
    std::vector<std::size_t> rows;
    for (const QItemSelectionRange& range : m_ui->table->selectionModel()->selection()) {
        for (int row = range.top(); row <= range.bottom(); ++row) {
            rows.push_back(static_cast<std::size_t>(m_list.mapToSource(m_list.index(row, 0)).row()));
        }
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

std::optional<std::size_t> HitHistoryPanel::currentHit() const {
    const QModelIndex current = m_list.mapToSource(m_ui->table->currentIndex());
    const auto hit = static_cast<std::size_t>(current.row());
    return current.isValid() && hit < m_session.hits().history().size() ? std::optional(hit) : std::nullopt;
}

bool HitHistoryPanel::isAnyEnabled(const std::vector<std::size_t>& rows) const {
    const std::span<const Hit> hits = m_session.hits().history().hits();
    return std::any_of(rows.begin(), rows.end(),
                       [hits](std::size_t row) { return row < hits.size() && hits[row].enabled; });
}

void HitHistoryPanel::toggleSelected() {
    const std::vector<std::size_t> rows = selectedRows();
    m_session.hits().setEnabled(rows, !isAnyEnabled(rows));
}

void HitHistoryPanel::moveSelectedUp() {
    m_session.hits().moveUp(selectedRows());
    m_ui->table->scrollTo(m_ui->table->currentIndex());
}

void HitHistoryPanel::moveSelectedDown() {
    m_session.hits().moveDown(selectedRows());
    m_ui->table->scrollTo(m_ui->table->currentIndex());
}

/// The cursor stays at the place, so that the arrow keys go on from there.
void HitHistoryPanel::removeSelected() {
    const std::vector<std::size_t> rows = selectedRows();
    if (rows.empty()) {
        return;
    }
    const int place = m_list.mapFromSource(m_model.index(static_cast<int>(rows.front()), 0)).row();
    m_ui->table->clearSelection();  // following it row by row into nothing would cost time
    m_session.hits().remove(rows);
    const int next = std::min(place, m_list.rowCount() - 1);
    m_ui->table->selectionModel()->setCurrentIndex(m_list.index(next, 0), QItemSelectionModel::NoUpdate);
}

void HitHistoryPanel::copySelected() {
    QGuiApplication::clipboard()->setText(m_model.csv(selectedRows()));
}

void HitHistoryPanel::flyToCurrent() {
    const std::optional<std::size_t> index = currentHit();
    const Target* target =
        index ? m_session.targets().find(m_session.hits().history().hits()[*index].target) : nullptr;
    if (target != nullptr) {
        const Hit& hit = m_session.hits().history().hits()[*index];
        const glm::vec3 point = target->transform.toWorld(hit.point);
        const float reach = kSurroundings * reachOf(hit).radius;
        Bounds part;
        part.add(point - reach);
        part.add(point + reach);
        Q_EMIT flyWanted(part);
    }
}

void HitHistoryPanel::toggleFilter() {
    if (m_filterBar->isHidden()) {
        m_filterBar->open();
    } else {
        m_filterBar->close();
    }
}

void HitHistoryPanel::selectHits(const std::function<bool(const Hit&)>& isWanted) {
    const std::span<const Hit> hits = m_session.hits().history().hits();
    QItemSelection selection;
    const auto isOne = [&](int row) {
        return isWanted(hits[static_cast<std::size_t>(m_list.mapToSource(m_list.index(row, 0)).row())]);
    };
    for (int row = 0; row < m_list.rowCount(); ++row) {
        if (!isOne(row)) {
            continue;
        }
        const int first = row;
        while (row + 1 < m_list.rowCount() && isOne(row + 1)) {
            ++row;
        }
        selection.append({m_list.index(first, 0), m_list.index(row, HitHistoryModel::ColumnCount - 1)});
    }
    m_ui->table->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
}

void HitHistoryPanel::selectTargetsHits() {
    if (const std::optional<std::size_t> current = currentHit()) {
        const TargetId target = m_session.hits().history().hits()[*current].target;
        selectHits([target](const Hit& hit) { return hit.target == target; });
    }
}

void HitHistoryPanel::selectGroup() {
    const std::optional<std::size_t> current = currentHit();
    const HitGroup group = current ? m_session.hits().history().hits()[*current].group : HitGroup();
    if (group) {
        selectHits([group](const Hit& hit) { return hit.group == group; });
    }
}

void HitHistoryPanel::groupSelected() {
    m_session.hits().group(selectedRows());
}

void HitHistoryPanel::ungroupSelected() {
    m_session.hits().ungroup(selectedRows());
}

void HitHistoryPanel::activate(const QModelIndex& index) {
    const std::optional<std::size_t> hit = currentHit();
    if (index.column() == HitHistoryModel::GroupColumn && hit &&
        m_session.hits().history().hits()[*hit].group) {
        selectGroup();
    } else {
        flyToCurrent();
    }
}

void HitHistoryPanel::followSelection() {
    if (m_following) {
        return;
    }
    m_following = true;
    const std::optional<std::size_t> hit = currentHit();
    if (hit && m_ui->table->selectionModel()->isSelected(m_ui->table->currentIndex())) {
        m_session.targets().select(
            m_session.hits().history().hits()[*hit].target);  // the statistics are about it
        m_session.hits().select(hit);
    } else {
        m_session.hits().select(std::nullopt);
    }
    updateActions();
    m_following = false;
}

void HitHistoryPanel::showSelectedHit() {
    if (m_following) {
        return;
    }
    m_following = true;
    const std::optional<std::size_t> hit = m_session.hits().selected();
    const QModelIndex current = m_ui->table->currentIndex();
    const QModelIndex row =
        hit ? m_list.mapFromSource(m_model.index(static_cast<int>(*hit), 0)) : QModelIndex();
    if (!row.isValid()) {
        m_ui->table->clearSelection();
    } else if (current.row() != row.row() || !m_ui->table->selectionModel()->isSelected(current)) {
        selectOnly(*m_ui->table, row);
    }  // else it has moved, and the selection with it
    updateActions();
    m_following = false;
}

void HitHistoryPanel::scrollToNewest() {
    if (m_atNewest) {
        m_ui->table->scrollToBottom();
    }
}

void HitHistoryPanel::updateSummary() {
    const std::size_t hits = m_session.hits().history().size();
    QString text =
        hits == 0 ? tr("No hits yet: click on a target") : tr("%Ln {hit|hits}", nullptr, trCount(hits));
    if (!m_session.hits().showsAll()) {
        text = tr("After hit %1 of %2").arg(countText(m_session.hits().shown().size()), countText(hits));
    } else if (!m_list.filter().isAll()) {
        text = tr("%1 of %2 listed")
                   .arg(countText(static_cast<std::size_t>(m_list.rowCount())), countText(hits));
    }
    if (m_session.hits().disabled() > 0) {
        text += tr(", %1 disabled").arg(countText(m_session.hits().disabled()));
    }
    if (m_session.readBack().droppedHits() > 0) {
        text += tr(", %1 dropped").arg(countText(m_session.readBack().droppedHits()));
    }
    m_ui->summary->setText(text);
    m_ui->table->setEmptyText(hits == 0 || m_list.filter().isAll() ? QString()
                                                                   : tr("No hit matches the filter."));
    enableIf(*m_copy, hits > 0, tr("There are no hits yet."));
}

void HitHistoryPanel::updateActions() {
    const std::vector<std::size_t> rows = selectedRows();
    const bool some = !rows.empty();
    const QString none = tr("Select hits in the list first.");
    enableIf(*m_toggle, some, none);
    m_toggle->setText(!some || isAnyEnabled(rows) ? tr("Disable") : tr("Enable"));
    // Also at the ends: a key that is not taken would move the cursor.
    const QString unordered = some ? tr("Sort the list by number to move hits.") : none;
    enableIf(*m_up, some && m_list.isInOrder(), unordered);
    enableIf(*m_down, some && m_list.isInOrder(), unordered);
    enableIf(*m_edit, some, none);
    enableIf(*m_fly, some, none);
    enableIf(*m_selectTargets, some, none);
    enableIf(*m_remove, some, none);
    const std::span<const Hit> hits = m_session.hits().history().hits();
    const bool isGrouped = std::any_of(
        rows.begin(), rows.end(), [hits](std::size_t row) { return row < hits.size() && hits[row].group; });
    const QString notGrouped = some ? tr("The selected hits are of no group.") : none;
    enableIf(*m_selectGroup, isGrouped, notGrouped);
    enableIf(*m_ungroup, isGrouped, notGrouped);
    enableIf(*m_group, rows.size() > 1, tr("Select several hits in the list first."));
    Q_EMIT rowsSelected(rows);
}

}  // namespace hitscope
