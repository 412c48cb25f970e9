// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>

#include "session/session.h"

namespace hitscope {

/// The steps of a session that can be undone and made again, in the order made. Row 0 is the state before the
/// first of them; row n the state after the n-th. What the session is at is the row current().
class UndoModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role : int {
        DoneRole = Qt::UserRole,  ///< bool: it is in force, not undone
    };

    /// `session` outlives the model.
    explicit UndoModel(const Session& session, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

    [[nodiscard]] int current() const { return m_done; }
    /// How many steps there are and what they take, in a sentence.
    [[nodiscard]] QString summary() const;

Q_SIGNALS:
    void currentChanged(int row);

private:
    void follow();

    const Session& m_session;
    int m_rows = 1;
    int m_done = 0;
    std::size_t m_forgotten = 0;
};

}  // namespace hitscope
