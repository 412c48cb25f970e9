// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/undo_model.h"

#include <QLocale>
#include <algorithm>
#include <utility>

#include "models/undo_text.h"
#include "session/shown_number.h"

namespace hitscope {

UndoModel::UndoModel(const Session& session, QObject* parent)
    : QAbstractListModel(parent), m_session(session) {
    connect(&session, &Session::undoChanged, this, &UndoModel::follow);
    follow();
}

int UndoModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : m_rows;
}

QVariant UndoModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const int row = index.row();
    switch (role) {
        case Qt::DisplayRole:
            if (row == 0) {
                return m_forgotten == 0 ? tr("Start") : tr("Start; older steps are forgotten");
            }
            return undoText(m_session.steps(), static_cast<std::size_t>(row) - 1);
        case Qt::ToolTipRole:
            return row <= m_done ? tr("Click to undo what comes after it") : tr("Click to redo up to here");
        case DoneRole:
            return row <= m_done;
        default:
            return {};
    }
}

QString UndoModel::summary() const {
    const SessionUndo& steps = m_session.steps();
    const QLocale locale;
    QString text = tr("%Ln {step|steps}, %1", nullptr, trCount(steps.size()))
                       .arg(locale.formattedDataSize(static_cast<qint64>(steps.bytes())));
    if (steps.forgotten() > 0) {
        text += tr("; the oldest are forgotten beyond %1")
                    .arg(locale.formattedDataSize(static_cast<qint64>(SessionUndo::kMostBytes)));
    }
    return text;
}

/// A step at the end comes, goes or is another; only those from there on are looked at again.
void UndoModel::follow() {
    const SessionUndo& steps = m_session.steps();
    const int rows = static_cast<int>(steps.size()) + 1;
    const int done = static_cast<int>(steps.done());
    const bool areOthers = steps.forgotten() != m_forgotten || rows == 1;
    if (areOthers) {
        beginResetModel();
    } else if (rows > m_rows) {
        beginInsertRows({}, m_rows, rows - 1);
    } else if (rows < m_rows) {
        beginRemoveRows({}, rows, m_rows - 1);
    }
    const int before = std::exchange(m_rows, rows);
    const int first = std::min(std::exchange(m_done, done), done);
    m_forgotten = steps.forgotten();
    if (areOthers) {
        endResetModel();
    } else if (rows > before) {
        endInsertRows();
    } else if (rows < before) {
        endRemoveRows();
    }
    if (!areOthers) {
        Q_EMIT dataChanged(index(std::min(first, rows - 1)), index(rows - 1));
    }
    Q_EMIT currentChanged(m_done);
}

}  // namespace hitscope
