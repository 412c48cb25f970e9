// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/hit_columns.h"

#include <QAction>
#include <QCoreApplication>
#include <QHeaderView>
#include <QMenu>
#include <QStyle>
#include <QTableView>
#include <algorithm>

#include "models/hit_history_model.h"
#include "panels/help/help_text.h"

namespace hitscope {

namespace {

constexpr int kCellPadding = 14;  // pixels
constexpr int kSortMark = 14;     // pixels

struct Column {
    const char* widest;  ///< that it usually holds
    bool isShown;        ///< at first
};
/// In the order of HitHistoryModel::Column.
constexpr Column kColumns[HitHistoryModel::ColumnCount] = {{"000,000", true},
                                                           {"0000.00", true},
                                                           {"High-poly sphere 10", true},
                                                           {"-00.000, -00.000, -00.000", true},
                                                           {"-0.000, -0.000, -0.000", false},
                                                           {"000.00", true},
                                                           {"000.00", false},
                                                           {"000,000", true},
                                                           {"0.000105", true},
                                                           {"00.000", true},
                                                           {"00.000", false},
                                                           {"Transform feedback", false},
                                                           {"0.50000", false},
                                                           {"0.050000", false},
                                                           {"0.30000", false},
                                                           {"-00.000, -00.000, -00.000", false},
                                                           {"-0.000, -0.000, -0.000", false},
                                                           {"0,000,000", false},
                                                           {"Scatter 100", true}};

void reset(QTableView& table) {
    QHeaderView& header = *table.horizontalHeader();
    const QFontMetrics metrics = table.fontMetrics();
    for (int column = 0; column < HitHistoryModel::ColumnCount; ++column) {
        const QString title = table.model()->headerData(column, Qt::Horizontal).toString();
        int width =
            kCellPadding + std::max(metrics.horizontalAdvance(QLatin1StringView(kColumns[column].widest)),
                                    metrics.horizontalAdvance(title) + kSortMark);
        if (column == HitHistoryModel::NumberColumn) {
            width += table.style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, &table);
        }
        header.moveSection(header.visualIndex(column), column);
        header.setSectionHidden(column, !kColumns[column].isShown);
        header.resizeSection(column, width);
    }
    // What a hit did stands in view without scrolling.
    constexpr int kBehindTarget = HitHistoryModel::TargetColumn + 1;
    header.moveSection(header.visualIndex(HitHistoryModel::GreatestColumn), kBehindTarget);
    header.moveSection(header.visualIndex(HitHistoryModel::AffectedColumn), kBehindTarget);
}

void showMenu(QTableView& table, const QPoint& at) {
    QHeaderView& header = *table.horizontalHeader();
    QMenu menu(&table);
    menu.setObjectName(QStringLiteral("hitColumns"));
    for (int column = 0; column < HitHistoryModel::ColumnCount; ++column) {
        QAction* action = menu.addAction(table.model()->headerData(column, Qt::Horizontal).toString());
        action->setToolTip(table.model()->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString());
        action->setCheckable(true);
        action->setChecked(!header.isSectionHidden(column));
        // It has the check boxes, and without any column there would be no header to bring one back from.
        enableIf(*action, column != HitHistoryModel::NumberColumn,
                 QHeaderView::tr("The number is always shown."));
        QObject::connect(action, &QAction::toggled, &header,
                         [&header, column](bool on) { header.setSectionHidden(column, !on); });
    }
    menu.setToolTipsVisible(true);
    menu.addSeparator();
    QObject::connect(
        menu.addAction(QCoreApplication::translate("hitscope::HitHistoryPanel", "Reset Columns")),
        &QAction::triggered, &table, [&table] { reset(table); });
    menu.exec(header.mapToGlobal(at));
}

}  // namespace

void setUpHitColumns(QTableView& table) {
    table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 5);
    QHeaderView& header = *table.horizontalHeader();
    header.setSectionsMovable(true);
    header.setContextMenuPolicy(Qt::CustomContextMenu);
    QObject::connect(&header, &QHeaderView::customContextMenuRequested, &table,
                     [&table](const QPoint& at) { showMenu(table, at); });
    reset(table);
}

}  // namespace hitscope
