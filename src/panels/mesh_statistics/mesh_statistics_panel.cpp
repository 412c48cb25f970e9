// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/mesh_statistics/mesh_statistics_panel.h"

#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>

#include "ui_mesh_statistics.h"

namespace hitscope {

namespace {

/// Titles of sections in bold on a tinted row.
class SectionDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        if (index.data(MeshStatisticsModel::HeadingRole).toBool()) {
            option->font.setBold(true);
            option->backgroundBrush = option->palette.alternateBase();
        }
    }
};

}  // namespace

MeshStatisticsPanel::MeshStatisticsPanel(Session& session, MeshStatisticsModel& model, QWidget* parent)
    : QWidget(parent), m_session(session), m_model(model), m_ui(std::make_unique<Ui::MeshStatistics>()) {
    m_ui->setupUi(this);
    m_ui->table->setModel(&model);
    m_ui->table->setItemDelegate(new SectionDelegate(m_ui->table));
    QHeaderView* columns = m_ui->table->horizontalHeader();
    columns->setSectionResizeMode(QHeaderView::Stretch);
    columns->setSectionResizeMode(MeshStatisticsModel::PropertyColumn, QHeaderView::ResizeToContents);
    columns->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_ui->table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 5);
    mergeSharedCells();
    listTargets();

    connect(&model, &QAbstractItemModel::modelReset, this, &MeshStatisticsPanel::mergeSharedCells);
    connect(&model, &MeshStatisticsModel::shownTargetChanged, this, &MeshStatisticsPanel::showTarget);
    connect(&session, &Session::sceneReplaced, this, &MeshStatisticsPanel::listTargets);
    connect(&session, &Session::targetAdded, this, &MeshStatisticsPanel::listTargets);
    connect(&session, &Session::targetRemoved, this, &MeshStatisticsPanel::listTargets);
    connect(&session, &Session::targetChanged, this, &MeshStatisticsPanel::listTargets);
    connect(m_ui->target, &QComboBox::activated, this,
            [this](int index) { m_session.selectTarget(TargetId{m_ui->target->itemData(index).toUInt()}); });
}

MeshStatisticsPanel::~MeshStatisticsPanel() = default;

void MeshStatisticsPanel::listTargets() {
    m_ui->target->clear();
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        m_ui->target->addItem(target->name, target->id.value);
    }
    showTarget();
}

void MeshStatisticsPanel::showTarget() {
    m_ui->target->setCurrentIndex(m_ui->target->findData(m_model.shownTarget().value));
}

void MeshStatisticsPanel::mergeSharedCells() {
    m_ui->table->clearSpans();
    for (int row = 0; row < m_model.rowCount(); ++row) {
        const QModelIndex index = m_model.index(row, MeshStatisticsModel::PropertyColumn);
        if (index.data(MeshStatisticsModel::HeadingRole).toBool()) {
            m_ui->table->setSpan(row, MeshStatisticsModel::PropertyColumn, 1,
                                 MeshStatisticsModel::ColumnCount);
        } else if (index.data(MeshStatisticsModel::SharedRole).toBool()) {
            m_ui->table->setSpan(row, MeshStatisticsModel::OriginalColumn, 1, 2);
        }
    }
}

}  // namespace hitscope
