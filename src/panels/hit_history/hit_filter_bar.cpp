// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/hit_history/hit_filter_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>

namespace hitscope {

namespace {

constexpr int kShortestText = 80;  // pixels
constexpr int kTargetLetters = 10;

}  // namespace

HitFilterBar::HitFilterBar(Session& session, HitList& list, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_list(list),
      m_text(new QLineEdit(this)),
      m_target(new QComboBox(this)),
      m_enabled(new QCheckBox(tr("&Enabled only"), this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_target);
    layout->addWidget(m_enabled);
    m_text->setObjectName(QStringLiteral("filterText"));
    m_text->setPlaceholderText(tr("Number, target, pipeline or group"));
    m_text->setClearButtonEnabled(true);
    m_text->setMinimumWidth(kShortestText);
    m_target->setObjectName(QStringLiteral("filterTarget"));
    m_target->setToolTip(tr("List the hits on this target"));
    m_target->setMinimumContentsLength(kTargetLetters);
    m_target->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_enabled->setObjectName(QStringLiteral("filterEnabled"));
    m_enabled->setToolTip(tr("Leave out hits that are disabled"));
    for (const auto signal : {&SessionTargets::added, &SessionTargets::removed, &SessionTargets::renamed}) {
        connect(&session.targets(), signal, this, [this] { m_listing.want(); });
    }
    connect(&session, &Session::sceneReplaced, this, [this] { m_listing.now(); });
    connect(m_text, &QLineEdit::textChanged, this, &HitFilterBar::apply);
    connect(m_target, &QComboBox::currentIndexChanged, this, &HitFilterBar::apply);
    connect(m_enabled, &QCheckBox::toggled, this, &HitFilterBar::apply);
    m_listing.now();
    hide();
}

void HitFilterBar::listTargets() {
    {
        const QSignalBlocker blocker(m_target);
        const QVariant chosen = m_target->currentData();
        m_target->clear();
        m_target->addItem(tr("All targets"), 0u);
        for (const std::unique_ptr<Target>& target : m_session.targets()) {
            m_target->addItem(target->name, target->id.value);
        }
        m_target->setCurrentIndex(std::max(0, m_target->findData(chosen)));
    }
    apply();
}

void HitFilterBar::apply() {
    if (isHidden()) {
        m_list.setFilter({});
        return;
    }
    m_list.setFilter(
        {m_text->text().trimmed(), TargetId{m_target->currentData().toUInt()}, m_enabled->isChecked()});
}

void HitFilterBar::open() {
    m_listing.now();
    show();
    m_text->setFocus();
    m_text->selectAll();
    apply();
    Q_EMIT opened(true);
}

void HitFilterBar::close() {
    hide();
    apply();
    Q_EMIT opened(false);
}

void HitFilterBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        close();
    } else {
        QWidget::keyPressEvent(event);
    }
}

}  // namespace hitscope
