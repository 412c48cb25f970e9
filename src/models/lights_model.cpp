// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/lights_model.h"

namespace hitscope {

LightsModel::LightsModel(Session& session, QObject* parent) : QAbstractListModel(parent), m_session(session) {
    connect(&session.settings(), &SessionSettings::lightsChanged, this,
            [this] { Q_EMIT dataChanged(index(0), index(LightRowCount - 1)); });
}

int LightsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int{LightRowCount};
}

QVariant LightsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    Lights lights = m_session.settings().lights();
    const int row = index.row();
    switch (role) {
        case Qt::DisplayRole:
            return row == DirectionalRow ? tr("Directional")
                   : row == SpotRow      ? tr("Spotlight")
                                         : tr("Point %1").arg(row - FirstPointRow + 1);
        case Qt::ToolTipRole:
            return row == DirectionalRow ? tr("One light from far away, equations 8 to 11 of the paper")
                   : row == SpotRow      ? tr("A cone of light with a smooth edge, equation 14")
                                         : tr("Fades with the distance, equations 12 and 13");
        case Qt::CheckStateRole:
            return lightOn(lights, row) ? Qt::Checked : Qt::Unchecked;
        case ColourRole:
            return colourName(lightTerms(lights, row).colour);
        default:
            return {};
    }
}

bool LightsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::CheckStateRole || !checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return false;
    }
    Lights lights = m_session.settings().lights();
    lightOn(lights, index.row()) = value.toInt() == Qt::Checked;
    m_session.settings().setLights(lights);
    return true;
}

Qt::ItemFlags LightsModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags base = QAbstractListModel::flags(index);
    return index.isValid() ? base | Qt::ItemIsUserCheckable | Qt::ItemNeverHasChildren : base;
}

}  // namespace hitscope
