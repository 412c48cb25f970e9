// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractListModel>

#include "models/light_rows.h"
#include "session/session.h"

namespace hitscope {

/// The session's lights, a LightRow each: a name, a check mark where the light is on, its colour.
class LightsModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role { ColourRole = Qt::UserRole };  ///< "#rrggbb"

    /// `session` outlives the model.
    explicit LightsModel(Session& session, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    Session& m_session;
};

}  // namespace hitscope
