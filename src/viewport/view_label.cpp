// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_label.h"

#include <QCoreApplication>
#include <QPainter>
#include <QtMath>

namespace hitscope {

namespace {

constexpr int kFieldOfViewStays = 1500;  // milliseconds
constexpr int kMargin = 8;               // logical pixels, to the view's corner
constexpr int kPadding = 5;              // logical pixels, around the text
constexpr float kOpacity = 0.7f;         // of what is behind the text

struct ViewLabelTexts {
    Q_DECLARE_TR_FUNCTIONS(hitscope::ViewLabel)
};

}  // namespace

QString standardViewName(StandardView view) {
    switch (view) {
        case StandardView::Front:
            return ViewLabelTexts::tr("Front");
        case StandardView::Back:
            return ViewLabelTexts::tr("Back");
        case StandardView::Right:
            return ViewLabelTexts::tr("Right");
        case StandardView::Left:
            return ViewLabelTexts::tr("Left");
        case StandardView::Top:
            return ViewLabelTexts::tr("Top");
        case StandardView::Bottom:
            break;
    }
    return ViewLabelTexts::tr("Bottom");
}

QString viewText(const Camera& camera) {
    const std::optional<StandardView> view = standardViewOf(camera);
    if (camera.isOrthographic()) {
        return view ? ViewLabelTexts::tr("%1, orthographic").arg(standardViewName(*view))
                    : ViewLabelTexts::tr("Orthographic");
    }
    return view ? ViewLabelTexts::tr("%1, perspective").arg(standardViewName(*view))
                : ViewLabelTexts::tr("Perspective");
}

ViewLabel::ViewLabel(const Navigation& navigation, QWidget* over) : QLabel(over), m_navigation(navigation) {
    setObjectName(QStringLiteral("viewLabel"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setTextFormat(Qt::PlainText);
    setMargin(kPadding);
    move(kMargin, kMargin);
    m_fieldOfViewStays.setSingleShot(true);
    m_fieldOfViewStays.setInterval(kFieldOfViewStays);
    connect(&navigation, &Navigation::cameraChanged, this, &ViewLabel::follow);
    connect(&navigation, &Navigation::fieldOfViewChanged, this, [this] {
        m_fieldOfViewStays.start();
        follow();
    });
    connect(&m_fieldOfViewStays, &QTimer::timeout, this, &ViewLabel::follow);
    follow();
}

void ViewLabel::follow() {
    QString said = viewText(m_navigation.camera());
    if (m_fieldOfViewStays.isActive()) {
        said += ViewLabelTexts::tr(", %1° field of view")
                    .arg(qRound(qRadiansToDegrees(static_cast<double>(m_navigation.camera().fieldOfView()))));
    }
    if (!m_navigation.isSceneInSight()) {
        said += ViewLabelTexts::tr(". The scene is out of view: Home frames it");
    }
    if (said != text()) {
        setText(said);
        adjustSize();
    }
}

void ViewLabel::paintEvent(QPaintEvent* event) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QColor behind = palette().color(QPalette::Window);
    behind.setAlphaF(kOpacity);
    painter.setPen(Qt::NoPen);
    painter.setBrush(behind);
    painter.drawRoundedRect(rect(), kPadding, kPadding);
    painter.end();
    QLabel::paintEvent(event);
}

}  // namespace hitscope
