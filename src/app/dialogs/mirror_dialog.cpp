// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/mirror_dialog.h"

#include <QComboBox>
#include <QFormLayout>
#include <glm/geometric.hpp>
#include <map>

#include "deform/mirrored_hits.h"
#include "models/quantity_text.h"
#include "panels/help/help_text.h"
#include "session/hit_editing.h"
#include "session/shown_number.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

enum : int { kSelectedHits, kAllHits };  // m_hits
enum : int { kCutPlane = 3 };            // m_plane; the axes before it
enum : int { kCentre, kOrigin };         // m_through

}  // namespace

MirrorDialog::MirrorDialog(Session& session, Viewport& viewport, HitEditing& editing, QWidget* parent)
    : PlanDialog(session, viewport, tr("Mirror Hits"), tr("&Mirror"), parent),
      m_editing(editing),
      m_hits(new QComboBox(this)),
      m_plane(new QComboBox(this)),
      m_through(new QComboBox(this)) {
    setObjectName(QStringLiteral("mirrorDialog"));
    m_hits->setObjectName(QStringLiteral("hits"));
    m_plane->setObjectName(QStringLiteral("plane"));
    m_through->setObjectName(QStringLiteral("through"));
    m_hits->addItems({tr("The selected ones"), tr("All")});
    m_plane->addItems({tr("X"), tr("Y"), tr("Z")});
    m_plane->setToolTip(tr("Across the plane at right angles to this axis of each target"));
    m_through->addItems({tr("The target's centre"), tr("The target's origin")});
    fields().addRow(tr("&Hits"), m_hits);
    fields().addRow(tr("A&xis"), m_plane);
    fields().addRow(tr("&Through"), m_through);
    showPlanes();
    for (QComboBox* box : {m_hits, m_plane, m_through}) {
        connect(box, &QComboBox::currentIndexChanged, this, [this] {
            showPlanes();
            replan();
        });
    }
    connect(&editing, &HitEditing::rowsChanged, this, &MirrorDialog::replan);
    connect(&session.hits(), &SessionHits::appended, this, &MirrorDialog::replan);
    connect(&session.hits(), &SessionHits::reset, this, &MirrorDialog::replan);
    connect(&session.settings(), &SessionSettings::cutChanged, this, [this] {
        showPlanes();
        replan();
    });
}

void MirrorDialog::showEvent(QShowEvent* event) {
    if (m_editing.rows().empty()) {
        m_hits->setCurrentIndex(kAllHits);
    }
    PlanDialog::showEvent(event);
}

/// The cutting plane is among them while there is one.
void MirrorDialog::showPlanes() {
    const bool isCut = session().settings().cut().on;
    if (isCut && m_plane->count() == kCutPlane) {
        m_plane->addItem(tr("Cutting plane"));
    } else if (!isCut && m_plane->count() > kCutPlane) {
        m_plane->removeItem(kCutPlane);
    }
    enableIf(*m_through, m_plane->currentIndex() != kCutPlane, tr("The cutting plane is where it is."));
}

Plane MirrorDialog::planeOn(const Target& target) const {
    if (m_plane->currentIndex() == kCutPlane) {
        const Plane world = session().settings().cut().plane();
        const glm::vec3 normal = target.transform.directionToLocal(world.normal);
        return {normal, glm::dot(normal, target.transform.toLocal(world.normal * world.offset))};
    }
    const int axis = std::max(0, m_plane->currentIndex());
    const Bounds& box = target.deformed.render().bounds;
    Plane plane{glm::vec3(0.0f), 0.0f};
    plane.normal[axis] = 1.0f;
    plane.offset = m_through->currentIndex() == kCentre ? 0.5f * box.min[axis] + 0.5f * box.max[axis] : 0.0f;
    return plane;
}

std::vector<Hit> MirrorDialog::chosen() const {
    const std::span<const Hit> all = session().hits().history().hits();
    if (m_hits->currentIndex() == kAllHits) {
        return {all.begin(), all.end()};
    }
    std::vector<Hit> hits;
    for (const std::size_t row : m_editing.rows()) {
        if (row < all.size()) {
            hits.push_back(all[row]);
        }
    }
    return hits;
}

void MirrorDialog::replan() {
    if (!isVisible()) {
        return;
    }
    const std::vector<Hit> hits = chosen();
    std::vector<Hit> images;
    images.reserve(hits.size());
    std::map<TargetId, Plane> planes;
    for (const Hit& hit : hits) {
        const Target* target = session().targets().find(hit.target);
        if (target == nullptr) {
            continue;
        }
        const auto [plane, isNew] = planes.try_emplace(hit.target);
        plane->second = isNew ? planeOn(*target) : plane->second;
        const std::vector<Hit> image = mirroredHits({&hit, 1}, plane->second);
        images.insert(images.end(), image.begin(), image.end());
    }
    m_own = hits.size() - images.size();
    planner().plan(std::move(images));
}

QString MirrorDialog::summary(const HitPlanner::Plan& plan) const {
    QString text = tr("New hits: %1.").arg(countText(plan.hits.size()));
    if (m_own > 0) {
        text += u' ' + tr("%Ln {lies|lie} in the plane and {is left as it is|are left as they are}.", nullptr,
                          trCount(m_own));
    }
    return text;
}

}  // namespace hitscope
