// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/vertex_changes/vertex_changes_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QPointer>
#include <algorithm>
#include <span>

#include "models/dragged_file.h"
#include "models/plain_text.h"
#include "models/quantity_text.h"
#include "panels/fields/context_menu.h"
#include "panels/fields/drag_out.h"
#include "panels/fields/save_name.h"
#include "panels/help/help_text.h"
#include "panels/icons/themed_icon.h"
#include "ui_vertex_changes.h"

namespace hitscope {

namespace {

constexpr int kColumnPadding = 14;  // pixels

/// Sizes by hand: measuring the contents of a million rows would take seconds.
void sizeColumns(QTableView& table, std::span<const QString> widest) {
    table.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 5);
    const QFontMetrics metrics = table.horizontalHeader()->fontMetrics();
    const int arrow = table.isSortingEnabled() ? kColumnPadding : 0;  // of the column sorted by
    for (int column = 0; column < static_cast<int>(widest.size()); ++column) {
        const QString title = table.model()->headerData(column, Qt::Horizontal).toString();
        table.setColumnWidth(
            column,
            kColumnPadding + std::max(metrics.horizontalAdvance(widest[static_cast<std::size_t>(column)]),
                                      metrics.horizontalAdvance(title) + arrow));
    }
}

}  // namespace

VertexChangesPanel::VertexChangesPanel(Session& session, VertexChangesModel& changes,
                                       AttributionModel& attribution, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_changes(changes),
      m_attribution(attribution),
      m_ui(std::make_unique<Ui::VertexChanges>()) {
    m_ui->setupUi(this);
    setUpTables();
    setUpFilter();
    makeActions();
    connectAll();
    updateSummary();
    updateAttribution();
}

VertexChangesPanel::~VertexChangesPanel() = default;

void VertexChangesPanel::setUpTables() {
    QTableView& table = *m_ui->table;
    showActionsAsMenu(table);
    table.setModel(&m_changes);
    table.setSortingEnabled(true);
    table.sortByColumn(VertexChangesModel::LengthColumn, Qt::DescendingOrder);
    const QString vector = QStringLiteral("-00.000, -00.000, -00.000");
    sizeColumns(table, std::array{QStringLiteral("0,000,000"), vector, vector,
                                  QStringLiteral("-0.000, -0.000, -0.000"), QStringLiteral("0.000000"),
                                  QStringLiteral("000.0"), QStringLiteral("00,000")});
    // What one looks for first needs no scrolling in a narrow dock.
    table.horizontalHeader()->moveSection(VertexChangesModel::LengthColumn, 1);
    table.horizontalHeader()->moveSection(
        table.horizontalHeader()->visualIndex(VertexChangesModel::HitsColumn), 2);
    m_ui->attribution->setModel(&m_attribution);
    sizeColumns(*m_ui->attribution,
                std::array{QStringLiteral("000,000"), QStringLiteral("0.000000"), QStringLiteral("0.000000"),
                           QStringLiteral("capped"), QStringLiteral("-0.000, -0.000, -0.000"), vector});
    m_ui->attribution->horizontalHeader()->moveSection(AttributionModel::DisplacementColumn, 1);
}

void VertexChangesPanel::setUpFilter() {
    m_ui->filter->addItem(tr("All changed"), static_cast<int>(VertexChangesModel::Filter::AllChanged));
    m_ui->filter->addItem(tr("Selected"), static_cast<int>(VertexChangesModel::Filter::Selected));
    m_ui->filter->addItem(tr("By selected hit"),
                          static_cast<int>(VertexChangesModel::Filter::MovedBySelectedHit));
    connect(m_ui->filter, &QComboBox::currentIndexChanged, this, [this] {
        m_changes.setFilter(static_cast<VertexChangesModel::Filter>(m_ui->filter->currentData().toInt()));
        updateSummary();
    });
    connect(m_ui->least, &NumberBox::edited, &m_changes, &VertexChangesModel::setLeastDisplacement);
    const auto followSize = [this] {
        // A hundredth of the scene is a fair dent.
        m_ui->least->setStepsWithin(static_cast<double>(m_session.targets().bounds().diagonal()) / 100.0);
    };
    connect(&m_session, &Session::sceneReplaced, this, followSize);
    followSize();
}

void VertexChangesPanel::makeActions() {
    m_copy = new QAction(themedIcon(QStringLiteral("copy")), tr("Copy as CSV"), this);
    m_copy->setShortcut(QKeySequence::Copy);
    m_copy->setShortcutContext(Qt::WidgetShortcut);
    m_copy->setToolTip(
        tr("Copy the selected rows, or all, as comma-separated text; up to %1 of them (Ctrl+C)")
            .arg(countText(kMostCopied)));
    m_save = new QAction(themedIcon(QStringLiteral("export")), tr("Save as CSV…"), this);
    m_save->setToolTip(
        tr("Save all rows, in this order, as a file of comma-separated text; drag the button out "
           "of the window for one of the selected rows, or all"));
    m_ui->table->addActions({m_copy, m_save});
    m_ui->copy->setDefaultAction(m_copy);
    m_ui->save->setDefaultAction(m_save);
    new DragOut(*m_ui->save, [this] { return dragged(); });
    connect(m_copy, &QAction::triggered, this, &VertexChangesPanel::copy);
    connect(m_save, &QAction::triggered, this, &VertexChangesPanel::save);
}

void VertexChangesPanel::connectAll() {
    connect(m_ui->table, &VertexTable::rowsChosen, this, &VertexChangesPanel::choose);
    connect(m_ui->table, &VertexTable::noneChosen, &m_session.selection(), &VertexSelection::clear);
    connect(m_ui->table, &VertexTable::rowHovered, this, &VertexChangesPanel::hover);
    connect(m_ui->table, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
        if (const Target* target = m_changes.target()) {
            Q_EMIT vertexWanted({target->id, m_changes.vertexAt(index.row())});
        }
    });
    connect(m_ui->attribution, &QTableView::activated, this, &VertexChangesPanel::chooseHit);
    connect(&m_session.selection(), &VertexSelection::pickedChanged, this, &VertexChangesPanel::showPicked);
    connect(&m_session.selection(), &VertexSelection::selectionChanged, this,
            &VertexChangesPanel::updateSummary);
    connect(&m_changes, &VertexChangesModel::targetChanged, this, &VertexChangesPanel::updateSummary);
    connect(&m_changes, &VertexChangesModel::rowsFollowed, this, &VertexChangesPanel::updateSummary);
    connect(&m_changes, &VertexChangesModel::saved, this,
            [this](const QString&, const std::optional<Error>& error) {
                if (error) {
                    Q_EMIT failed(*error);
                }
            });
    connect(&m_attribution, &AttributionModel::summaryChanged, this, &VertexChangesPanel::updateAttribution);
}

void VertexChangesPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_ui->splitter->setOrientation(width() > 2 * height() ? Qt::Horizontal : Qt::Vertical);
}

// Table to session

void VertexChangesPanel::choose(int first, int last, int at, VertexSelection::Combine combine) {
    const Target* target = m_changes.target();
    if (target == nullptr) {
        return;
    }
    m_choosing = true;
    std::vector<std::uint32_t> vertices;
    vertices.reserve(static_cast<std::size_t>(last - first + 1));
    for (int row = first; row <= last; ++row) {
        vertices.push_back(m_changes.vertexAt(row));
    }
    if (at >= 0 && combine != VertexSelection::Combine::Remove) {
        m_session.selection().setPicked(VertexRef{target->id, m_changes.vertexAt(at)});
    }
    m_session.selection().select(target->id, std::move(vertices), combine);
    m_choosing = false;
}

void VertexChangesPanel::hover(std::optional<int> row) {
    const Target* target = m_changes.target();
    m_session.selection().setHovered(row && target != nullptr && *row < m_changes.rowCount()
                                         ? std::optional(VertexRef{target->id, m_changes.vertexAt(*row)})
                                         : std::nullopt);
}

void VertexChangesPanel::chooseHit(const QModelIndex& index) {
    m_session.hits().select(static_cast<std::size_t>(index.data(AttributionModel::HitRole).toULongLong()));
}

// Session to table

void VertexChangesPanel::showPicked() {
    const auto& picked = m_session.selection().picked();
    const Target* target = m_changes.target();
    if (m_choosing || !picked || target == nullptr || picked->target != target->id) {
        return;
    }
    if (const int row = m_changes.rowOf(picked->vertex); row >= 0) {
        m_ui->table->setCurrentIndex(m_changes.index(row, VertexChangesModel::NumberColumn));
        m_ui->table->scrollTo(m_ui->table->currentIndex());
    }
}

void VertexChangesPanel::updateSummary() {
    const Target* target = m_changes.target();
    const int rows = m_changes.rowCount();
    const bool needsHit =
        m_changes.filter() == VertexChangesModel::Filter::MovedBySelectedHit && !m_session.hits().selected();
    QString text;
    if (needsHit) {
        text = tr("Select a hit in the hit history");
    } else if (target != nullptr) {
        const std::size_t selected = m_session.selection().vertices(target->id).size();
        const QString listed = countText(static_cast<std::size_t>(rows));
        text = selected > 0 ? tr("%1 listed, %2 selected").arg(listed, countText(selected))
                            : tr("%Ln {vertex|vertices}", nullptr, rows);
    }
    m_ui->summary->setText(text);
    m_ui->summary->setToolTip(target != nullptr ? asPlainText(tr("Of %1").arg(target->name)) : QString());
    enableIf(*m_copy, rows > 0, tr("No vertex is listed."));
    enableIf(*m_save, rows > 0, tr("No vertex is listed."));
}

void VertexChangesPanel::updateAttribution() {
    const auto& vertex = m_attribution.vertex();
    const Target* target = vertex ? m_session.targets().find(vertex->target) : nullptr;
    m_ui->attributionTitle->setText(
        target == nullptr
            ? tr("Which hits moved it: pick a vertex here, or right-click it in the viewport")
            : tr("Hits that moved vertex %1 of %2").arg(vertexNumberText(vertex->vertex), target->name));
    m_ui->attributionSum->setText(m_attribution.summary());
    m_ui->attributionSum->setVisible(target != nullptr);
}

// Out

std::vector<std::uint32_t> VertexChangesPanel::copied() const {
    std::vector<std::uint32_t> all;
    std::vector<std::uint32_t> selected;
    const Target* target = m_changes.target();
    for (int row = 0; target != nullptr && row < m_changes.rowCount(); ++row) {
        const std::uint32_t vertex = m_changes.vertexAt(row);
        all.push_back(vertex);
        if (m_session.selection().isSelected({target->id, vertex})) {
            selected.push_back(vertex);
        }
    }
    return selected.empty() ? all : selected;
}

void VertexChangesPanel::copy() {
    std::vector<std::uint32_t> vertices = copied();
    if (vertices.size() > kMostCopied) {
        Q_EMIT failed(Error{"These are more rows than the clipboard is for.", "",
                            "Save them as a CSV file, or select up to 100,000 of them."});
        return;
    }
    QGuiApplication::clipboard()->setText(QString::fromLatin1(csv(m_changes.table(std::move(vertices)))));
}

/// Written when it is dropped, as the rows are then.
QMimeData* VertexChangesPanel::dragged() const {
    const auto write = [panel = QPointer(this)](const QString& path) {
        const VertexChangesPanel* const alive = panel.data();
        return alive != nullptr && saveCsv(alive->m_changes.table(alive->copied()), path).ok();
    };
    return new DraggedFile(QStringLiteral("vertex_changes.csv"), write);
}

void VertexChangesPanel::save() {
    const QString path = askSaveName(this, {.title = tr("Save Vertex Changes"),
                                            .suggested = QStringLiteral("vertex_changes.csv"),
                                            .filters = {tr("Comma-separated text (*.csv)")},
                                            .suffixes = {QStringLiteral("csv")}});
    if (!path.isEmpty()) {
        m_changes.saveCsv(path);
    }
}

}  // namespace hitscope
