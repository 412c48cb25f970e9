// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/flight_chooser.h"

#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QMenu>
#include <QSettings>

#include "analysis/changed_settings.h"

namespace hitscope {

namespace {

const QString kFlightKey = QStringLiteral("shooting/flight");

QString text(std::string_view part) {
    return QString::fromUtf8(part.data(), static_cast<qsizetype>(part.size()));
}

/// Rich text, which is broken into lines.
QString flightToolTip(const FlightModeTraits& traits) {
    return QStringLiteral("<p>%1</p>").arg(text(traits.description).toHtmlEscaped());
}

}  // namespace

QComboBox* makeFlightBox(Session& session, QWidget* parent) {
    auto* box = new QComboBox(parent);
    for (const FlightModeTraits& traits : allFlightModes()) {
        box->addItem(text(traits.name));
        box->setItemData(box->count() - 1, flightToolTip(traits), Qt::ToolTipRole);
    }
    const auto follow = [&session, box] {
        const FlightModeTraits& traits =
            allFlightModes()[static_cast<std::size_t>(session.settings().flightMode())];
        box->setCurrentIndex(static_cast<int>(session.settings().flightMode()));
        box->setToolTip(QStringLiteral("<p>%1</p>").arg(FlightChooser::tr("How shots fly")) +
                        flightToolTip(traits));
    };
    QObject::connect(box, &QComboBox::activated, &session, [&session](int index) {
        session.settings().setFlightMode(static_cast<FlightMode>(index));
    });
    QObject::connect(&session.settings(), &SessionSettings::flightModeChanged, box, follow);
    follow();
    return box;
}

FlightChooser::FlightChooser(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_actions(new QActionGroup(this)) {
    const QString kept = QSettings().value(kFlightKey).toString();
    for (const FlightModeTraits& traits : allFlightModes()) {
        if (text(traits.key) == kept) {
            session.settings().restoreProjectile(session.settings().projectile(), traits.mode);
        }
    }
    connect(&session.settings(), &SessionSettings::flightModeChanged, this, [this] {
        ChangedSettings()->setValue(
            kFlightKey,
            text(allFlightModes()[static_cast<std::size_t>(m_session.settings().flightMode())].key));
        follow();
    });
}

void FlightChooser::fill(QMenu& menu) {
    QMenu& modes = *menu.addMenu(tr("&Flight"));
    modes.setToolTipsVisible(true);
    for (const FlightModeTraits& traits : allFlightModes()) {
        QAction* action = modes.addAction(text(traits.name));
        action->setObjectName(QStringLiteral("flight/") + text(traits.key));
        action->setCheckable(true);
        action->setToolTip(flightToolTip(traits));
        connect(action, &QAction::triggered, this,
                [this, mode = traits.mode] { m_session.settings().setFlightMode(mode); });
        m_actions->addAction(action);
    }
    follow();
}

QComboBox* FlightChooser::makeBox(QWidget* parent) {
    m_box = makeFlightBox(m_session, parent);
    m_box->setObjectName(QStringLiteral("flight"));
    connect(m_box, &QComboBox::activated, this, &FlightChooser::chosenInBox);
    return m_box;
}

void FlightChooser::follow() {
    const QList<QAction*> actions = m_actions->actions();
    if (!actions.isEmpty()) {
        actions[static_cast<int>(m_session.settings().flightMode())]->setChecked(true);
    }
}

}  // namespace hitscope
