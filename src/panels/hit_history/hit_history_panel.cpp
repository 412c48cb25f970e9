// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/hit_history_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QScrollBar>
#include <algorithm>

#include "models/quantity_text.h"
#include "panels/icons/themed_icon.h"
#include "ui_hit_history.h"

namespace hitscope {

namespace {

constexpr int kCellPadding = 14;  // pixels

}  // namespace

HitHistoryPanel::HitHistoryPanel(Session& session, HitHistoryModel& model, QWidget* parent)
    : QWidget(parent), m_session(session), m_model(model), m_ui(std::make_unique<Ui::HitHistory>()) {
    m_ui->setupUi(this);
    m_ui->table->setModel(&model);
    // Sizes by hand: measuring the contents of 100,000 rows would cost time with every hit.
    m_ui->table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_ui->table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 5);
    const QString widest[HitHistoryModel::ColumnCount] = {QStringLiteral("000,000"),
                                                          QStringLiteral("0000.00"),
                                                          QStringLiteral("HP sphere 10"),
                                                          QStringLiteral("-00.000, -00.000, -00.000"),
                                                          QStringLiteral("-0.000, -0.000, -0.000"),
                                                          QStringLiteral("000.00"),
                                                          QStringLiteral("000.00")};
    for (int column = 0; column < HitHistoryModel::ColumnCount; ++column) {
        const QString title = model.headerData(column, Qt::Horizontal).toString();
        m_ui->table->setColumnWidth(column,
                                    kCellPadding + std::max(fontMetrics().horizontalAdvance(widest[column]),
                                                            fontMetrics().horizontalAdvance(title)));
    }
    makeActions();
    updateSummary();

    connect(m_ui->table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &HitHistoryPanel::followSelection);
    connect(m_ui->table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &HitHistoryPanel::followSelection);
    connect(&session, &Session::hitSelected, this, &HitHistoryPanel::showSelectedHit);
    connect(&model, &QAbstractItemModel::modelReset, this, &HitHistoryPanel::showSelectedHit);
    connect(&model, &QAbstractItemModel::modelReset, this, &HitHistoryPanel::updateSummary);
    connect(&model, &QAbstractItemModel::rowsAboutToBeInserted, this, [this] {
        const QScrollBar* bar = m_ui->table->verticalScrollBar();
        m_atNewest = bar->value() == bar->maximum();
    });
    connect(&model, &QAbstractItemModel::rowsInserted, this, &HitHistoryPanel::scrollToNewest);
    connect(&model, &QAbstractItemModel::rowsInserted, this, &HitHistoryPanel::updateSummary);
    connect(&session, &Session::droppedHitsChanged, this, &HitHistoryPanel::updateSummary);
}

HitHistoryPanel::~HitHistoryPanel() = default;

void HitHistoryPanel::makeActions() {
    m_remove = new QAction(themedIcon(QStringLiteral("remove")), tr("Remove hits"), this);
    m_remove->setShortcut(QKeySequence::Delete);
    m_copy = new QAction(themedIcon(QStringLiteral("copy")), tr("Copy as CSV"), this);
    m_copy->setShortcut(QKeySequence::Copy);
    m_remove->setToolTip(tr("Remove the selected hits; the mesh becomes what the others make of it (Del)"));
    m_copy->setToolTip(tr("Copy the selected hits, or all, as comma-separated text (Ctrl+C)"));
    for (QAction* action : {m_copy, m_remove}) {
        action->setShortcutContext(Qt::WidgetShortcut);
        m_ui->table->addAction(action);
    }
    m_ui->remove->setDefaultAction(m_remove);
    m_ui->copy->setDefaultAction(m_copy);
    connect(m_remove, &QAction::triggered, this, &HitHistoryPanel::removeSelected);
    connect(m_copy, &QAction::triggered, this, &HitHistoryPanel::copySelected);
}

std::vector<int> HitHistoryPanel::selectedRows() const {
    std::vector<int> rows;
    for (const QModelIndex& index : m_ui->table->selectionModel()->selectedRows()) {
        rows.push_back(index.row());
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

void HitHistoryPanel::removeSelected() {
    const std::vector<int> rows = selectedRows();
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        m_session.removeHit(static_cast<std::size_t>(*row));
    }
}

void HitHistoryPanel::copySelected() {
    QGuiApplication::clipboard()->setText(m_model.csv(selectedRows()));
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
    updateSummary();
    m_following = false;
}

void HitHistoryPanel::showSelectedHit() {
    if (m_following) {
        return;
    }
    m_following = true;
    if (const std::optional<std::size_t> hit = m_session.selectedHit()) {
        m_ui->table->selectRow(static_cast<int>(*hit));
    } else {
        m_ui->table->clearSelection();
    }
    updateSummary();
    m_following = false;
}

void HitHistoryPanel::scrollToNewest() {
    if (m_atNewest) {
        m_ui->table->scrollToBottom();
    }
}

void HitHistoryPanel::updateSummary() {
    const std::size_t hits = static_cast<std::size_t>(m_model.rowCount());
    QString text = hits == 0   ? tr("No hits yet: click on a target")
                   : hits == 1 ? tr("1 hit")
                               : tr("%1 hits").arg(countText(hits));
    if (m_session.droppedHits() > 0) {
        text += tr(", oldest %1 not shown").arg(countText(m_session.droppedHits()));
    }
    m_ui->summary->setText(text);
    m_remove->setEnabled(m_ui->table->selectionModel()->hasSelection());
    m_copy->setEnabled(hits > 0);
}

}  // namespace hitscope
