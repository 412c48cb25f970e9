// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/mesh_statistics_model.h"

#include <QCoreApplication>

#include "models/focus_target.h"
#include "session/shown_number.h"

namespace hitscope {

namespace {

constexpr quintptr kSectionId = 0;  // internal id of a section; a row has its section's number + 1

QString translated(const char* text) {
    return QCoreApplication::translate("hitscope::StatisticsRow", text);
}

StatisticsSide sideOf(int column) {
    return column == MeshStatisticsModel::OriginalColumn   ? StatisticsSide::Original
           : column == MeshStatisticsModel::DeformedColumn ? StatisticsSide::Deformed
                                                           : StatisticsSide::Change;
}

}  // namespace

MeshStatisticsModel::MeshStatisticsModel(Session& session, QObject* parent)
    : QAbstractItemModel(parent), m_session(session), m_measuring(session) {
    const std::span<const StatisticsRow> rows = statisticsRows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (m_sections.empty() || m_sections.back().section != rows[i].section) {
            m_sections.push_back({rows[i].section, i, 0});
        }
        ++m_sections.back().count;
    }
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoon);
    connect(&m_soon, &QTimer::timeout, this, &MeshStatisticsModel::announceValues);
    connect(&m_measuring, &MeshMeasuring::measured, this, &MeshStatisticsModel::followMeasured);
    connect(&m_measuring, &MeshMeasuring::upToDateChanged, this, [this] {
        announceSoon();
        Q_EMIT headerDataChanged(Qt::Horizontal, PropertyColumn, PropertyColumn);
    });
    connect(&session, &Session::sceneReplaced, this, &MeshStatisticsModel::follow);
    connect(&session.targets(), &SessionTargets::selectedChanged, this, &MeshStatisticsModel::follow);
    connect(&session.targets(), &SessionTargets::added, this, &MeshStatisticsModel::follow);
    connect(&session.targets(), &SessionTargets::removed, this, &MeshStatisticsModel::follow);
    connect(&session.hits(), &SessionHits::appended, this, &MeshStatisticsModel::follow);
    connect(&session.hits(), &SessionHits::reset, this, &MeshStatisticsModel::follow);
    follow();
}

void MeshStatisticsModel::setShowsAll(bool all) {
    if (all != m_showsAll) {
        m_showsAll = all;
        follow();
        Q_EMIT shownTargetChanged();
    }
}

void MeshStatisticsModel::follow() {
    const Target* focus = m_showsAll ? nullptr : focusTarget(m_session);
    std::vector<TargetId> targets;
    if (m_showsAll) {
        for (const std::unique_ptr<Target>& target : m_session.targets()) {
            targets.push_back(target->id);
        }
    } else if (focus != nullptr) {
        targets.push_back(focus->id);
    }
    m_measuring.setTargets(std::move(targets), !m_showsAll);
    const TargetId id = focus != nullptr ? focus->id : TargetId{};
    if (id != m_target) {
        m_target = id;
        Q_EMIT shownTargetChanged();
    }
    if (m_measuring.measurement()) {
        announceSoon();
    } else {
        announceValues();
    }
}

void MeshStatisticsModel::announceSoon() {
    if (!m_soon.isActive()) {
        m_soon.start();
    }
}

/// Numbers come at once where there were none, or where the old ones are marked already.
void MeshStatisticsModel::followMeasured() {
    const bool isBlank = !m_hasAnnounced || !m_measuring.measurement();
    if (isBlank || !m_soon.isActive()) {
        announceValues();
    }
}

void MeshStatisticsModel::announceValues() {
    m_soon.stop();
    m_hasAnnounced = m_measuring.measurement() != nullptr;
    for (int section = 0; section < rowCount(); ++section) {
        const QModelIndex parent = index(section, 0);
        Q_EMIT dataChanged(index(0, OriginalColumn, parent),
                           index(rowCount(parent) - 1, ChangeColumn, parent));
    }
}

QModelIndex MeshStatisticsModel::find(const char* key, int column) const {
    const auto row = static_cast<std::size_t>(&statisticsRow(key) - statisticsRows().data());
    for (std::size_t s = 0; s < m_sections.size(); ++s) {
        const Section& section = m_sections[s];
        if (row >= section.first && row < section.first + static_cast<std::size_t>(section.count)) {
            return createIndex(static_cast<int>(row - section.first), column, quintptr{s + 1});
        }
    }
    return {};
}

QModelIndex MeshStatisticsModel::index(int row, int column, const QModelIndex& parent) const {
    if (!hasIndex(row, column, parent)) {
        return {};
    }
    return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : kSectionId);
}

QModelIndex MeshStatisticsModel::parent(const QModelIndex& child) const {
    if (!child.isValid() || child.internalId() == kSectionId) {
        return {};
    }
    return createIndex(static_cast<int>(child.internalId()) - 1, 0, kSectionId);
}

int MeshStatisticsModel::rowCount(const QModelIndex& parent) const {
    if (!parent.isValid()) {
        return static_cast<int>(m_sections.size());
    }
    const bool isSection = parent.internalId() == kSectionId && parent.column() == 0;
    return isSection ? m_sections[static_cast<std::size_t>(parent.row())].count : 0;
}

int MeshStatisticsModel::columnCount(const QModelIndex& /*parent*/) const {
    return ColumnCount;
}

const StatisticsRow* MeshStatisticsModel::rowAt(const QModelIndex& index) const {
    if (!index.isValid() || index.internalId() == kSectionId) {
        return nullptr;
    }
    const Section& section = m_sections[static_cast<std::size_t>(index.internalId()) - 1];
    return &statisticsRows()[section.first + static_cast<std::size_t>(index.row())];
}

QVariant MeshStatisticsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    if (role == Qt::TextAlignmentRole) {
        return section == PropertyColumn ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                         : QVariant(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case PropertyColumn:
            return m_measuring.isUpToDate() ? tr("Property") : tr("Updating…");
        case OriginalColumn:
            return tr("Original");
        case DeformedColumn:
            return tr("Deformed");
        case ChangeColumn:
            return tr("Change");
        default:
            return {};
    }
}

QVariant MeshStatisticsModel::data(const QModelIndex& index, int role) const {
    const StatisticsRow* row = rowAt(index);
    if (row == nullptr) {
        const bool isTitle = index.isValid() && index.column() == 0 && role == Qt::DisplayRole;
        return isTitle ? QVariant(sectionName(m_sections[static_cast<std::size_t>(index.row())].section))
                       : QVariant();
    }
    const std::shared_ptr<const MeshMeasurement>& measurement = m_measuring.measurement();
    switch (role) {
        case Qt::DisplayRole:
            return cellText(*row, index.column());
        case Qt::ToolTipRole:
            return cellToolTip(*row, index.column());
        case Qt::TextAlignmentRole:
            return index.column() == PropertyColumn ? QVariant(Qt::AlignLeft | Qt::AlignVCenter)
                                                    : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case ValueRole: {
            if (!measurement || index.column() == PropertyColumn) {
                return {};
            }
            const std::optional<double> value = statisticsValue(*row, *measurement, sideOf(index.column()));
            return value ? QVariant(*value) : QVariant();
        }
        case SharedRole:
            return row->sides == StatisticsRow::Sides::Same;
        case OutOfDateRole:
            return index.column() != PropertyColumn && !m_measuring.isUpToDate();
        default:
            return {};
    }
}

QString MeshStatisticsModel::cellText(const StatisticsRow& row, int column) const {
    if (column == PropertyColumn) {
        return propertyName(row);
    }
    const std::shared_ptr<const MeshMeasurement>& measurement = m_measuring.measurement();
    if (!measurement) {
        const bool isToCome = column != ChangeColumn && !m_session.targets().empty();
        return isToCome ? QStringLiteral("…") : QString();
    }
    return statisticsText(row, *measurement, sideOf(column));
}

/// What the number means, why there is none, and all its digits.
QString MeshStatisticsModel::cellToolTip(const StatisticsRow& row, int column) const {
    QString text = translated(row.meaning);
    const std::shared_ptr<const MeshMeasurement>& measurement = m_measuring.measurement();
    if (measurement) {
        if (!m_measuring.isUpToDate() && column != PropertyColumn) {
            text += u'\n' + tr("Out of date: it is being recalculated.");
        }
        const QString reason = whyNot(row, *measurement);
        const std::optional<double> value =
            column == PropertyColumn ? std::nullopt : statisticsValue(row, *measurement, sideOf(column));
        if (!reason.isEmpty()) {
            text += u'\n' + reason;
        } else if (value && row.kind == StatisticsRow::Kind::Quantity) {
            text += u'\n' + shownNumber(*value, 'g', 15) + u' ' + QString::fromUtf8(row.unit);
        }
    }
    // Rich text is broken into lines.
    return QStringLiteral("<p>%1</p>")
        .arg(text.trimmed().toHtmlEscaped().replace(u'\n', QLatin1String("<br>")));
}

}  // namespace hitscope
