// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/hit_history_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QItemSelection>
#include <QScrollBar>
#include <algorithm>

#include "models/quantity_text.h"
#include "panels/hit_history/hit_delegate.h"
#include "panels/icons/themed_icon.h"
#include "ui_hit_history.h"

namespace hitscope {

namespace {

constexpr int kCellPadding = 14;  // pixels

QString withKey(const QString& text, const QKeySequence& key) {
    return QStringLiteral("%1 (%2)").arg(text, key.toString(QKeySequence::NativeText));
}

}  // namespace

HitHistoryPanel::HitHistoryPanel(Session& session, HitHistoryModel& model, QWidget* parent)
    : QWidget(parent), m_session(session), m_model(model), m_ui(std::make_unique<Ui::HitHistory>()) {
    m_ui->setupUi(this);
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
    table.setModel(&m_model);
    table.setItemDelegate(new HitDelegate(&table));
    // Sizes by hand: measuring the contents of 100,000 rows would cost time with every hit.
    table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table.verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 5);
    const QString widest[HitHistoryModel::ColumnCount] = {QStringLiteral("000,000"),
                                                          QStringLiteral("0000.00"),
                                                          QStringLiteral("HP sphere 10"),
                                                          QStringLiteral("-00.000, -00.000, -00.000"),
                                                          QStringLiteral("-0.000, -0.000, -0.000"),
                                                          QStringLiteral("000.00"),
                                                          QStringLiteral("000.00")};
    for (int column = 0; column < HitHistoryModel::ColumnCount; ++column) {
        const QString title = m_model.headerData(column, Qt::Horizontal).toString();
        int width = kCellPadding + std::max(fontMetrics().horizontalAdvance(widest[column]),
                                            fontMetrics().horizontalAdvance(title));
        if (column == HitHistoryModel::NumberColumn) {
            width += style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, &table);
        }
        table.setColumnWidth(column, width);
    }
}

void HitHistoryPanel::connectAll() {
    const QItemSelectionModel* selection = m_ui->table->selectionModel();
    connect(selection, &QItemSelectionModel::selectionChanged, this, &HitHistoryPanel::followSelection);
    connect(selection, &QItemSelectionModel::currentChanged, this, &HitHistoryPanel::followSelection);
    connect(&m_session, &Session::hitSelected, this, &HitHistoryPanel::showSelectedHit);
    connect(&m_model, &QAbstractItemModel::modelReset, this, &HitHistoryPanel::showSelectedHit);
    connect(&m_model, &QAbstractItemModel::rowsAboutToBeInserted, this, [this] {
        const QScrollBar* bar = m_ui->table->verticalScrollBar();
        m_atNewest = bar->value() == bar->maximum();
    });
    connect(&m_model, &QAbstractItemModel::rowsInserted, this, &HitHistoryPanel::scrollToNewest);
    connect(&m_session, &Session::hitsAppended, this, &HitHistoryPanel::updateSummary);
    connect(&m_session, &Session::capacityChanged, this, &HitHistoryPanel::updateSummary);
    connect(&m_session, &Session::historyReset, this, [this] {
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
    m_selectTargets = makeAction(tr("Select All on This Target"), {}, &HitHistoryPanel::selectTargetsHits);
    m_copy = makeAction(tr("Copy as CSV"), QKeySequence::Copy, &HitHistoryPanel::copySelected);
    addSeparator();
    m_remove = makeAction(tr("Remove"), QKeySequence::Delete, &HitHistoryPanel::removeSelected);
    m_remove->setIcon(themedIcon(QStringLiteral("remove")));
    m_copy->setIcon(themedIcon(QStringLiteral("copy")));
    m_remove->setToolTip(withKey(tr("Remove the selected hits; the mesh becomes what the others make of it"),
                                 m_remove->shortcut()));
    m_copy->setToolTip(
        withKey(tr("Copy the selected hits, or all, as comma-separated text"), m_copy->shortcut()));
    m_ui->remove->setDefaultAction(m_remove);
    m_ui->copy->setDefaultAction(m_copy);
}

std::vector<std::size_t> HitHistoryPanel::selectedRows() const {
    std::vector<std::size_t> rows;
    for (const QItemSelectionRange& range : m_ui->table->selectionModel()->selection()) {
        for (int row = range.top(); row <= range.bottom(); ++row) {
            rows.push_back(static_cast<std::size_t>(row));
        }
    }
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

bool HitHistoryPanel::isAnyEnabled(const std::vector<std::size_t>& rows) const {
    const std::span<const Hit> hits = m_session.history().hits();
    return std::any_of(rows.begin(), rows.end(),
                       [hits](std::size_t row) { return row < hits.size() && hits[row].enabled; });
}

void HitHistoryPanel::toggleSelected() {
    const std::vector<std::size_t> rows = selectedRows();
    m_session.setHitsEnabled(rows, !isAnyEnabled(rows));
}

void HitHistoryPanel::moveSelectedUp() {
    const std::vector<std::size_t> rows = selectedRows();
    if (!rows.empty() && rows.front() > 0) {
        moveSelected(rows.front() - 1);
    }
}

void HitHistoryPanel::moveSelectedDown() {
    const std::vector<std::size_t> rows = selectedRows();
    if (!rows.empty() && rows.back() + 1 < m_session.history().size()) {
        moveSelected(rows.back() + 2);
    }
}

void HitHistoryPanel::moveSelected(std::size_t to) {
    m_session.moveHits(selectedRows(), to);
    m_ui->table->scrollTo(m_ui->table->currentIndex());
}

/// The cursor stays at the place, so that the arrow keys go on from there.
void HitHistoryPanel::removeSelected() {
    const std::vector<std::size_t> rows = selectedRows();
    if (rows.empty()) {
        return;
    }
    m_ui->table->clearSelection();  // following it row by row into nothing would cost time
    m_session.removeHits(rows);
    const int next = std::min(static_cast<int>(rows.front()), m_model.rowCount() - 1);
    m_ui->table->selectionModel()->setCurrentIndex(m_model.index(next, 0), QItemSelectionModel::NoUpdate);
}

void HitHistoryPanel::copySelected() {
    const std::vector<std::size_t> rows = selectedRows();
    const std::vector<int> numbers(rows.begin(), rows.end());
    QGuiApplication::clipboard()->setText(m_model.csv(numbers));
}

void HitHistoryPanel::selectTargetsHits() {
    const std::span<const Hit> hits = m_session.history().hits();
    const auto current = static_cast<std::size_t>(m_ui->table->currentIndex().row());
    if (current >= hits.size()) {
        return;
    }
    QItemSelection selection;
    const auto isOnIt = [&](std::size_t row) { return hits[row].target == hits[current].target; };
    for (std::size_t row = 0; row < hits.size(); ++row) {
        if (!isOnIt(row)) {
            continue;
        }
        const std::size_t first = row;
        while (row + 1 < hits.size() && isOnIt(row + 1)) {
            ++row;
        }
        selection.append({m_model.index(static_cast<int>(first), 0),
                          m_model.index(static_cast<int>(row), HitHistoryModel::ColumnCount - 1)});
    }
    m_ui->table->selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
}

void HitHistoryPanel::followSelection() {
    if (m_following) {
        return;
    }
    m_following = true;
    const QModelIndex current = m_ui->table->selectionModel()->currentIndex();
    const bool chosen = m_ui->table->selectionModel()->isSelected(current) &&
                        static_cast<std::size_t>(current.row()) < m_session.history().size();
    if (chosen) {
        const std::size_t hit = static_cast<std::size_t>(current.row());
        m_session.selectTarget(m_session.history().hits()[hit].target);  // the statistics are about it
        m_session.selectHit(hit);
    } else {
        m_session.selectHit(std::nullopt);
    }
    updateActions();
    m_following = false;
}

void HitHistoryPanel::showSelectedHit() {
    if (m_following) {
        return;
    }
    m_following = true;
    const std::optional<std::size_t> hit = m_session.selectedHit();
    const QModelIndex current = m_ui->table->currentIndex();
    if (!hit) {
        m_ui->table->clearSelection();
    } else if (current.row() != static_cast<int>(*hit) ||
               !m_ui->table->selectionModel()->isSelected(current)) {
        m_ui->table->selectRow(static_cast<int>(*hit));
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
    const std::size_t hits = m_session.history().size();
    QString text = hits == 0   ? tr("No hits yet: click on a target")
                   : hits == 1 ? tr("1 hit")
                               : tr("%1 hits").arg(countText(hits));
    if (m_session.disabledHits() > 0) {
        text += tr(", %1 disabled").arg(countText(m_session.disabledHits()));
    }
    if (m_session.droppedHits() > 0) {
        text += tr(", %1 dropped").arg(countText(m_session.droppedHits()));
    }
    m_ui->summary->setText(text);
    m_copy->setEnabled(hits > 0);
}

void HitHistoryPanel::updateActions() {
    const std::vector<std::size_t> rows = selectedRows();
    const bool some = !rows.empty();
    const std::size_t hits = m_session.history().size();
    m_toggle->setEnabled(some);
    m_toggle->setText(!some || isAnyEnabled(rows) ? tr("Disable") : tr("Enable"));
    m_up->setEnabled(some && rows.front() > 0);
    m_down->setEnabled(some && rows.back() + 1 < hits);
    m_selectTargets->setEnabled(some);
    m_remove->setEnabled(some);
}

}  // namespace hitscope
