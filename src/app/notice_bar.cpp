// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/notice_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <utility>

#include "panels/icons/themed_icon.h"

namespace hitscope {

NoticeBar::NoticeBar(QWidget* parent)
    : QFrame(parent), m_text(new QLabel(this)), m_offer(new QPushButton(this)) {
    setFrameShape(QFrame::StyledPanel);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton(this);
    close->setIcon(themedIcon(QStringLiteral("close")));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close this notice"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_offer, 0, Qt::AlignTop);
    layout->addWidget(close, 0, Qt::AlignTop);
    connect(close, &QToolButton::clicked, this, &NoticeBar::clear);
    connect(m_offer, &QPushButton::clicked, this, [this] {
        const std::function<void()> act = std::exchange(m_act, {});
        clear();
        if (act) {
            act();
        }
    });
    hide();
}

int NoticeBar::say(const QString& text, const QString& offer, std::function<void()> act) {
    m_text->setText(text);
    m_offer->setText(offer);
    m_offer->setVisible(!offer.isEmpty());
    m_act = std::move(act);
    show();
    return ++m_notice;
}

void NoticeBar::clear() {
    m_act = {};
    m_text->clear();
    hide();
}

QString NoticeBar::text() const {
    return m_text->text();
}

}  // namespace hitscope
