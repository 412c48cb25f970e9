// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/mesh_statistics/mesh_statistics_panel.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QMenu>
#include <QStyledItemDelegate>

#include "models/quantity_text.h"
#include "models/statistics_report.h"
#include "panels/icons/themed_icon.h"
#include "panels/mesh_statistics/displacement_histogram.h"
#include "session/vertex_selection.h"
#include "ui_mesh_statistics.h"

namespace hitscope {

namespace {

constexpr quint32 kAllTargets = 0;  // no target has this id

/// Titles of sections in bold on a tinted row; what no hit changes, and numbers that are out of date, in a
/// fainter ink.
class SectionDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        if (!index.parent().isValid()) {
            option->font.setBold(true);
            option->backgroundBrush = option->palette.alternateBase();
        } else if (index.data(MeshStatisticsModel::OutOfDateRole).toBool()) {
            setInk(*option, 0.4f);
        } else if (index.column() == MeshStatisticsModel::DeformedColumn &&
                   index.data(MeshStatisticsModel::SharedRole).toBool()) {
            setInk(*option, 0.55f);
        }
    }

private:
    static void setInk(QStyleOptionViewItem& option, float opacity) {
        QColor faint = option.palette.color(QPalette::Text);
        faint.setAlphaF(opacity);
        option.palette.setColor(QPalette::Text, faint);
    }
};

}  // namespace

MeshStatisticsPanel::MeshStatisticsPanel(Session& session, MeshStatisticsModel& model, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_model(model),
      m_measuring(&model.measuring()),
      m_health(session, model.measuring()),
      m_ui(std::make_unique<Ui::MeshStatistics>()) {
    m_ui->setupUi(this);
    makeNumbers();
    makeHealth();
    makeCopyMenu();
    m_histogram = std::make_unique<DisplacementHistogram>(
        session, model.measuring(),
        DisplacementHistogram::Widgets{*m_ui->histogram, *m_ui->between, *m_ui->selectRange,
                                       *m_ui->wholeRange});
    m_list.now();
    model.measuring().setActive(false);
    followTargets();
}

MeshStatisticsPanel::~MeshStatisticsPanel() = default;

void MeshStatisticsPanel::followTargets() {
    connect(&m_model, &MeshStatisticsModel::shownTargetChanged, this, &MeshStatisticsPanel::showTarget);
    connect(&m_session, &Session::sceneReplaced, this, [this] { m_list.now(); });
    for (const auto signal : {&SessionTargets::added, &SessionTargets::removed, &SessionTargets::renamed}) {
        connect(&m_session.targets(), signal, this, [this] { m_list.want(); });
    }
    connect(m_ui->target, &QComboBox::activated, this, &MeshStatisticsPanel::chooseTarget);
}

void MeshStatisticsPanel::makeNumbers() {
    QTreeView& numbers = *m_ui->numbers;
    numbers.setModel(&m_model);
    numbers.setItemDelegate(new SectionDelegate(&numbers));
    numbers.expandAll();
    for (int section = 0; section < m_model.rowCount(); ++section) {
        numbers.setFirstColumnSpanned(section, {}, true);
    }
    fitColumns();
}

QByteArray MeshStatisticsPanel::saveState() const {
    QByteArray state;
    for (int section = 0; section < m_model.rowCount(); ++section) {
        state += m_ui->numbers->isExpanded(m_model.index(section, 0)) ? '1' : '0';
    }
    return state;
}

void MeshStatisticsPanel::restoreState(const QByteArray& state) {
    if (state.size() != m_model.rowCount()) {
        return;
    }
    for (int section = 0; section < m_model.rowCount(); ++section) {
        m_ui->numbers->setExpanded(m_model.index(section, 0), state[section] == '1');
    }
}

/// All texts of a column, titles and words in place of numbers included, have the room they need; what is
/// left goes to the names.
void MeshStatisticsPanel::fitColumns() {
    QHeaderView& header = *m_ui->numbers->header();
    header.setStretchLastSection(false);
    header.setMinimumSectionSize(fontMetrics().averageCharWidth() * 6);
    header.setSectionResizeMode(MeshStatisticsModel::PropertyColumn, QHeaderView::Stretch);
    constexpr int kPadding = 7;
    int width = m_ui->numbers->indentation() + 2 * kPadding + widestName() + 2 * m_ui->numbers->frameWidth() +
                style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    const auto fix = [&](int column, const QString& widest) {
        const QString title = m_model.headerData(column, Qt::Horizontal).toString();
        const int section = kPadding + std::max(fontMetrics().horizontalAdvance(widest),
                                                fontMetrics().horizontalAdvance(title));
        header.setSectionResizeMode(column, QHeaderView::Fixed);
        header.resizeSection(column, section);
        width += section;
    };
    fix(MeshStatisticsModel::OriginalColumn, QStringLiteral("00.000000"));
    fix(MeshStatisticsModel::DeformedColumn, QStringLiteral("00.000000"));
    fix(MeshStatisticsModel::ChangeColumn, QStringLiteral("+0.00000"));
    m_ui->numbers->setMinimumWidth(width);
}

/// Pixels.
int MeshStatisticsPanel::widestName() const {
    int widest = 0;
    for (int section = 0; section < m_model.rowCount(); ++section) {
        const QModelIndex parent = m_model.index(section, 0);
        for (int row = 0; row < m_model.rowCount(parent); ++row) {
            const QString name =
                m_model.index(row, MeshStatisticsModel::PropertyColumn, parent).data().toString();
            widest = std::max(widest, fontMetrics().horizontalAdvance(name));
        }
    }
    return widest;
}

void MeshStatisticsPanel::makeHealth() {
    QTableView& harms = *m_ui->harms;
    harms.setModel(&m_health);
    QHeaderView& header = *harms.horizontalHeader();
    header.setSectionResizeMode(QHeaderView::ResizeToContents);
    header.setSectionResizeMode(MeshHealthModel::HarmColumn, QHeaderView::Stretch);
    harms.verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 5);
    m_ui->stretchLimit->setValue(static_cast<double>(m_model.measuring().stretchLimit()));
    connect(m_ui->stretchLimit, &QDoubleSpinBox::valueChanged, this,
            [this](double limit) { m_model.measuring().setStretchLimit(static_cast<float>(limit)); });
    connect(&m_health, &MeshHealthModel::foundChanged, this, &MeshStatisticsPanel::showFound);
    connect(&m_model.measuring(), &MeshMeasuring::upToDateChanged, this, &MeshStatisticsPanel::showFound);
    connect(harms.selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) { selectHarm(current); });
    connect(&harms, &QTableView::clicked, this, &MeshStatisticsPanel::selectHarm);
    connect(&harms, &QTableView::activated, this, &MeshStatisticsPanel::lookAtHarm);
    showFound();
}

void MeshStatisticsPanel::makeCopyMenu() {
    m_ui->copy->setIcon(themedIcon(QStringLiteral("copy")));
    auto* menu = new QMenu(m_ui->copy);
    const auto add = [this, menu](const QString& text, auto report) {
        QAction* action = menu->addAction(text);
        connect(action, &QAction::triggered, this, [this, report] {
            m_copyWhenReady = [report](const MeshMeasurement& measurement) {
                QGuiApplication::clipboard()->setText(report(measurement));
            };
            copyIfReady();
        });
    };
    add(tr("Copy as &Text"), [this](const MeshMeasurement& all) { return statisticsAsText(title(), all); });
    add(tr("Copy as &CSV"), [](const MeshMeasurement& all) { return statisticsAsCsv(all); });
    add(tr("Copy as &Markdown"),
        [this](const MeshMeasurement& all) { return statisticsAsMarkdown(title(), all); });
    m_ui->copy->setMenu(menu);
    connect(&m_model.measuring(), &MeshMeasuring::measured, this, &MeshStatisticsPanel::copyIfReady);
}

/// What is to be copied are the numbers of now: those that are out of date are waited for.
void MeshStatisticsPanel::copyIfReady() {
    const MeshMeasuring& measuring = m_model.measuring();
    if (m_copyWhenReady && measuring.isUpToDate() && measuring.measurement()) {
        std::exchange(m_copyWhenReady, nullptr)(*measuring.measurement());
    }
    m_ui->copy->setText(m_copyWhenReady ? tr("Copying…") : tr("Copy"));
}

QString MeshStatisticsPanel::title() const {
    const Target* target = m_session.targets().find(m_model.shownTarget());
    return m_model.showsAll() ? tr("All targets") : target != nullptr ? target->name : QString();
}

void MeshStatisticsPanel::listTargets() {
    m_ui->target->clear();
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        m_ui->target->addItem(target->name, target->id.value);
    }
    if (m_session.targets().size() > 1) {
        m_ui->target->insertSeparator(m_ui->target->count());
        m_ui->target->addItem(tr("All targets"), kAllTargets);
    } else if (m_model.showsAll()) {
        m_model.setShowsAll(false);
    }
    showTarget();
}

/// While the targets are to be listed this is left to that: the box may not have it yet.
void MeshStatisticsPanel::showTarget() {
    if (m_list.isDue()) {
        return;
    }
    const quint32 shown = m_model.showsAll() ? kAllTargets : m_model.shownTarget().value;
    m_ui->target->setCurrentIndex(m_ui->target->findData(shown));
}

void MeshStatisticsPanel::chooseTarget(int index) {
    const quint32 chosen = m_ui->target->itemData(index).toUInt();
    m_model.setShowsAll(chosen == kAllTargets);
    if (chosen != kAllTargets) {
        m_session.targets().select(TargetId{chosen});
    }
}

void MeshStatisticsPanel::showFound() {
    const auto listed = static_cast<std::size_t>(m_health.rowCount());
    const std::size_t found = m_health.found();
    const QString text =
        !m_model.measuring().isUpToDate() ? tr("Updating…")
        : found == 0                      ? tr("No face is flipped, degenerated or stretched by a hit.")
        : found > listed ? tr("%1 changes; the first %2 are listed.").arg(countText(found), countText(listed))
                         : tr("Changes for the worse: %1").arg(countText(found));
    m_ui->found->setText(text);
    m_ui->tabs->setTabText(m_ui->tabs->indexOf(m_ui->healthPage),
                           found == 0 ? tr("Health") : tr("Health (%1)").arg(countText(found)));
}

void MeshStatisticsPanel::selectHarm(const QModelIndex& index) {
    if (!index.isValid()) {
        return;
    }
    const HarmRow row = m_health.harmAt(index.row());
    const Target* target = m_session.targets().find(row.target);
    if (target != nullptr) {
        const std::span<const std::uint32_t> face = target->deformed.original().face(row.harm.face);
        m_session.selection().select(row.target, {face.begin(), face.end()},
                                     VertexSelection::Combine::Replace);
    }
}

void MeshStatisticsPanel::lookAtHarm(const QModelIndex& index) {
    if (!index.isValid()) {
        return;
    }
    const HarmRow row = m_health.harmAt(index.row());
    const Target* target = m_session.targets().find(row.target);
    if (target == nullptr) {
        return;
    }
    if (row.hit) {
        m_session.hits().select(*row.hit);
    }
    // The face and as much around it as shows where it is.
    constexpr float kAround = 0.05f;  // of the target's extent
    const float around = kAround * target->extent();
    Bounds bounds;
    for (const std::uint32_t vertex : target->deformed.original().face(row.harm.face)) {
        const glm::vec3 place = target->transform.toWorld(target->deformed.positions()[vertex]);
        bounds.add(place - glm::vec3(around));
        bounds.add(place + glm::vec3(around));
    }
    Q_EMIT lookWanted(bounds);
}

void MeshStatisticsPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_model.measuring().setActive(true);
}

void MeshStatisticsPanel::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    // A window that is destroyed while it is open hides its panels last, when what it showed is gone.
    if (m_measuring) {
        m_measuring->setActive(false);
    }
}

}  // namespace hitscope
