// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/go_to_vertex.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "models/focus_target.h"
#include "models/quantity_text.h"
#include "session/session.h"
#include "viewport/inspect_tool.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr float kFacing = 0.3f;         // cosine: a surface seen flatter than that is turned to the camera
constexpr float kHighestPitch = 1.4f;   // radians: up stays up
constexpr float kOfExtent = 0.6f;       // of the target's extent: how far the camera stands at most
constexpr float kBeforeOther = 0.7f;    // of the way to what would stand between
constexpr float kOffSurface = 1.0e-3f;  // of the target's extent

/// Before that point of a surface, as near as the target wants it and nothing in between.
Camera cameraBefore(const Session& session, const Target& target, std::uint32_t vertex, Camera camera) {
    const glm::vec3 point = target.transform.toWorld(target.deformed.positions()[vertex]);
    const std::uint32_t drawn = target.deformed.render().renderVerticesOf(vertex).front();
    const float extent = target.extent();
    // Zero for one that no face uses.
    const glm::vec3 normal = target.transform.directionToWorld(target.trueNormals.normals()[drawn]);
    float yaw = camera.yaw();
    float pitch = camera.pitch();
    if (glm::length(normal) > 0.0f && glm::dot(normal, -camera.forward()) < kFacing) {
        yaw = std::atan2(normal.x, normal.z);
        pitch = std::clamp(std::asin(std::clamp(normal.y, -1.0f, 1.0f)), -kHighestPitch, kHighestPitch);
    }
    float distance = std::min(camera.distance(), kOfExtent * extent);
    camera.setPivot(point, yaw, pitch, distance);
    const glm::vec3 from =
        point + normal * (kOffSurface * extent) - camera.forward() * (kOffSurface * extent);
    if (const auto other =
            session.simulation().physics().castRay(from, -camera.forward(), camera.distance())) {
        distance = kBeforeOther * glm::distance(other->point, point);
        camera.setPivot(point, yaw, pitch, distance);
    }
    return camera;
}

}  // namespace

GoToVertexDialog::GoToVertexDialog(const Session& session, QWidget* parent)
    : QDialog(parent), m_session(session) {
    setWindowTitle(tr("Go to Vertex"));
    auto* form = new QFormLayout(this);
    m_targets = new QComboBox(this);
    m_targets->setObjectName(QStringLiteral("target"));
    const Target* focus = focusTarget(session);
    for (const std::unique_ptr<Target>& target : session.targets()) {
        m_targets->addItem(target->name, target->id.value);
        if (target.get() == focus) {
            m_targets->setCurrentIndex(m_targets->count() - 1);
        }
    }
    if (m_targets->count() > 1) {
        form->addRow(tr("&Target"), m_targets);
    } else {
        m_targets->hide();
    }
    m_number = new QLineEdit(this);
    m_number->setObjectName(QStringLiteral("number"));
    form->addRow(tr("&Vertex number"), m_number);
    m_range = new QLabel(this);
    m_range->setObjectName(QStringLiteral("range"));
    m_range->setTextFormat(Qt::PlainText);  // it may name the target
    form->addRow(QString(), m_range);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &GoToVertexDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_targets, &QComboBox::currentIndexChanged, this, &GoToVertexDialog::followTarget);
    connect(m_number, &QLineEdit::textChanged, this, &GoToVertexDialog::followTarget);
    followTarget();
    m_number->setFocus();
}

TargetId GoToVertexDialog::target() const {
    return TargetId{m_targets->currentData().toUInt()};
}

void GoToVertexDialog::followTarget() {
    const Target* shown = m_session.targets().find(target());
    m_range->setText(shown == nullptr
                         ? tr("There is no target.")
                         : tr("1 to %1").arg(countText(shown->deformed.original().positions.size())));
}

std::optional<VertexRef> GoToVertexDialog::vertex() const {
    const Target* shown = m_session.targets().find(target());
    QString digits = m_number->text().simplified().remove(QLatin1Char(' '));
    digits.remove(QLocale().groupSeparator());
    digits.remove(QLatin1Char(','));
    bool isNumber = false;
    const qulonglong number = digits.toULongLong(&isNumber);
    if (shown == nullptr || !isNumber || number == 0 ||
        number > shown->deformed.original().positions.size()) {
        return std::nullopt;
    }
    return VertexRef{shown->id, static_cast<std::uint32_t>(number - 1)};
}

void GoToVertexDialog::accept() {
    if (const auto found = vertex()) {
        Q_EMIT chosen(*found);
        QDialog::accept();
        return;
    }
    const Target* shown = m_session.targets().find(target());
    if (shown != nullptr) {
        const QString range = countText(shown->deformed.original().positions.size());
        m_range->setText(m_number->text().trimmed().isEmpty()
                             ? tr("Type a number from 1 to %1.").arg(range)
                             : tr("%1 has no vertex “%2”: its numbers go from 1 to %3.")
                                   .arg(shown->name, m_number->text().trimmed(), range));
    }
    m_number->selectAll();
    m_number->setFocus();
}

GoToVertex::GoToVertex(Session& session, Viewport& viewport, QWidget* parent)
    : QObject(parent), m_session(session), m_viewport(viewport), m_parent(parent) {}

void GoToVertex::fill(QMenu& menu) {
    QAction* action = menu.addAction(tr("&Go to Vertex…"));
    action->setShortcut(tr("Ctrl+G"));
    connect(action, &QAction::triggered, this, &GoToVertex::ask);
}

void GoToVertex::ask() {
    auto* dialog = new GoToVertexDialog(m_session, m_parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &GoToVertexDialog::chosen, this, &GoToVertex::go);
    dialog->open();
}

void GoToVertex::go(const VertexRef& vertex) {
    const Target* target = m_session.targets().find(vertex.target);
    if (target == nullptr || vertex.vertex >= target->deformed.positions().size()) {
        return;
    }
    selectTargetOf(m_session, vertex);
    m_session.selection().setPicked(vertex);
    m_session.selection().select(vertex.target, {vertex.vertex}, VertexSelection::Combine::Replace);
    Navigation& navigation = m_viewport.navigation();
    m_session.simulation().updateColliders();  // what is in the way is asked of them
    navigation.setCamera(cameraBefore(m_session, *target, vertex.vertex, navigation.goal()));
    Q_EMIT arrived();
}

}  // namespace hitscope
