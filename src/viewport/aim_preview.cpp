// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/aim_preview.h"

#include <QChildEvent>
#include <QEvent>
#include <QLabel>
#include <QMouseEvent>
#include <algorithm>
#include <memory>

#include "deform/dent_preview.h"
#include "deform/dent_shape.h"
#include "session/paced_advance.h"
#include "session/shown_number.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kBeside = 18;  // pixels from the cursor to the label

/// "2.500", "0.381", "0.00381": at least three digits that count.
QString depthText(double metres) {
    constexpr double kThreeDecimals = 0.1;  // metres: below, three decimals would say too little
    return metres >= kThreeDecimals ? shownNumber(metres, 'f', 3) : shownNumber(metres, 'g', 3);
}

}  // namespace

AimPreview::AimPreview(Session& session, Viewport& viewport)
    : QObject(&viewport), m_session(session), m_viewport(viewport), m_label(new QLabel(&viewport)) {
    m_label->setObjectName(QStringLiteral("aimPreview"));
    m_label->setTextFormat(Qt::PlainText);
    m_label->setFrameShape(QFrame::StyledPanel);
    m_label->setAutoFillBackground(true);
    m_label->setContentsMargins(5, 1, 5, 1);
    m_label->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_label->hide();
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest);
    m_rest.setTimerType(Qt::PreciseTimer);  // never early, as coarse ones may be
    viewport.setMouseTracking(true);
    viewport.installEventFilter(this);
    for (QWidget* child : viewport.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        child->installEventFilter(this);
    }
    connect(&m_rest, &QTimer::timeout, this, &AimPreview::show);
    connect(&viewport.navigation(), &Navigation::cameraChanged, this, &AimPreview::wait);
    connect(&viewport, &Viewport::optionsChanged, this, &AimPreview::wait);
    connect(&session.readBack(), &ReadBack::meshChanged, this, &AimPreview::wait);
    // The next picture shows it, before what has moved is read back.
    connect(&session.hits(), &SessionHits::appended, this, &AimPreview::wait);
    connect(&session.hits(), &SessionHits::reset, this, &AimPreview::wait);
    connect(&session.hits(), &SessionHits::shownChanged, this, &AimPreview::wait);
    connect(&session.targets(), &SessionTargets::added, this, &AimPreview::wait);
    connect(&session.targets(), &SessionTargets::removed, this, &AimPreview::wait);
    connect(&session.targets(), &SessionTargets::changed, this, &AimPreview::wait);
    connect(&session, &Session::sceneReplaced, this, &AimPreview::wait);
    connect(&session.settings(), &SessionSettings::constantsChanged, this, &AimPreview::wait);
    connect(&session.settings(), &SessionSettings::projectileChanged, this, &AimPreview::wait);
    connect(&session.settings(), &SessionSettings::flightModeChanged, this, &AimPreview::wait);
}

void AimPreview::setEnabled(bool on) {
    m_enabled = on;
    wait();
}

void AimPreview::setClicksShoot(bool on) {
    m_clicksShoot = on;
    wait();
}

bool AimPreview::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &m_viewport) {
        if (event->type() == QEvent::Enter) {  // onto a handle or a button, whose moves do not come here
            m_isOver = false;
            clear();
        }
        return QObject::eventFilter(watched, event);
    }
    switch (event->type()) {
        case QEvent::MouseMove: {
            const auto* move = static_cast<const QMouseEvent*>(event);
            m_at = move->position();
            m_isOver = move->buttons() == Qt::NoButton;
            wait();
            break;
        }
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::Leave:
            m_isOver = false;
            clear();
            break;
        case QEvent::MouseButtonRelease: {
            const auto* release = static_cast<const QMouseEvent*>(event);
            m_isOver = release->buttons() == Qt::NoButton;
            wait();
            break;
        }
        case QEvent::ChildAdded:
            if (QObject* child = static_cast<const QChildEvent*>(event)->child(); child->isWidgetType()) {
                child->installEventFilter(this);
            }
            break;
        default:
            break;
    }
    return QObject::eventFilter(watched, event);
}

void AimPreview::clear() {
    m_rest.stop();
    m_label->hide();
    m_viewport.decorations().setGhost(nullptr);
}

void AimPreview::wait() {
    clear();
    if (m_enabled && m_clicksShoot && m_isOver) {
        m_rest.start();
    }
}

void AimPreview::show() {
    if (!m_session.simulation().updateColliders(timeLimit())) {
        m_rest.start();
        return;
    }
    const ScheduledShot shot = m_viewport.aiming().shotAt(m_viewport.navigation().rayAt(m_at));
    const std::optional<Hit> hit = m_session.simulation().predictedHit(shot);
    const Target* target = hit ? m_session.targets().find(hit->target) : nullptr;
    const HitReach sphere = hit ? reachOf(*hit) : HitReach{};
    m_aim = target != nullptr ? std::optional(Aim{target->id, hit->point, sphere.radius}) : std::nullopt;
    Q_EMIT shown();
    if (target == nullptr) {
        return;
    }
    const RenderMesh& mesh = target->deformed.render();
    const std::vector<VertexRange> reach =
        clustersNear(mesh, clusterBoxes(*target), sphere.centre, sphere.radius);
    if (vertexCount(reach) > kMostVertices) {
        showText(tr("Too many vertices in reach to count"));
        return;
    }
    const std::vector<std::uint32_t> near =
        m_session.simulation().physics().trianglesNear(target->id, sphere.centre, sphere.radius);
    const DentPreview preview = previewDent(mesh, target->deformed.vertices(), reach, near, *hit);
    auto ghost = std::make_shared<std::vector<glm::vec3>>();
    ghost->reserve(preview.dent.size());
    for (const glm::vec3& corner : preview.dent) {
        ghost->push_back(target->transform.toWorld(corner));
    }
    m_viewport.decorations().setGhost(std::move(ghost));
    const std::size_t count = preview.affectedVertices;
    QString text = tr("Next shot: %Ln {vertex|vertices}, %1 m deep", nullptr, trCount(count))
                       .arg(depthText(static_cast<double>(preview.depth)));
    if (hit->constants.maxMagnitude <= 0.0f) {
        text += tr("\nThe max magnitude is 0: a hit moves nothing");
    } else if (count < kFewVertices) {
        text += tr("\nFew vertices for a dent: Ctrl+R refines the mesh here");
    }
    showText(text);
}

void AimPreview::showText(const QString& text) {
    m_label->setText(text);
    m_label->resize(m_label->sizeHint());
    // Beside the cursor, on the side where there is room.
    QPoint at = m_at.toPoint() + QPoint(kBeside, kBeside);
    if (at.x() + m_label->width() > m_viewport.width()) {
        at.setX(static_cast<int>(m_at.x()) - kBeside - m_label->width());
    }
    if (at.y() + m_label->height() > m_viewport.height()) {
        at.setY(static_cast<int>(m_at.y()) - kBeside - m_label->height());
    }
    m_label->move(at);
    m_label->show();
}

/// Of all clusters, as the vertices are now; worked out again only after they have moved.
std::span<const Bounds> AimPreview::clusterBoxes(const Target& target) {
    const std::span<const DynamicVertex> vertices = target.deformed.vertices();
    if (m_boxesOf != target.id || m_boxesRevision != target.deformed.revision()) {
        m_boxesOf = target.id;
        m_boxesRevision = target.deformed.revision();
        m_boxes.clear();
        for (const Cluster& cluster : target.deformed.render().clusters) {
            Bounds box;
            for (const DynamicVertex& vertex : vertices.subspan(cluster.first, cluster.count)) {
                box.add(vertex.position);
            }
            m_boxes.push_back(box);
        }
    }
    return m_boxes;
}

}  // namespace hitscope
