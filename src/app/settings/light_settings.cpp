// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/light_settings.h"

#include <QSettings>
#include <cmath>

namespace hitscope {

namespace {

constexpr float kMostStrength = 10.0f;
constexpr float kFarthest = 1000.0f;  // in extents of the scene

struct Reader {
    const QSettings& settings;

    void operator()(const QString& key, bool& value) const { value = settings.value(key, value).toBool(); }
    void operator()(const QString& key, float& value, float lowest, float highest) const {
        bool isNumber = false;
        const float read = settings.value(key).toFloat(&isNumber);
        if (isNumber && read >= lowest && read <= highest) {
            value = read;
        }
    }
    void operator()(const QString& key, glm::vec3& value, float lowest, float highest) const {
        const QStringList parts = settings.value(key).toStringList();
        if (parts.size() != 3) {
            return;
        }
        glm::vec3 read;
        for (int i = 0; i < 3; ++i) {
            bool isNumber = false;
            read[i] = parts[i].toFloat(&isNumber);
            if (!isNumber || !(read[i] >= lowest && read[i] <= highest)) {
                return;
            }
        }
        value = read;
    }
};

struct Writer {
    QSettings& settings;

    static QString number(float value) { return QString::number(static_cast<double>(value), 'g', 9); }
    void operator()(const QString& key, bool value) const { settings.setValue(key, value); }
    void operator()(const QString& key, float value, float /*lowest*/, float /*highest*/) const {
        settings.setValue(key, number(value));
    }
    void operator()(const QString& key, const glm::vec3& value, float /*lowest*/, float /*highest*/) const {
        settings.setValue(key, QStringList{number(value.x), number(value.y), number(value.z)});
    }
};

template <class Visit, class Terms>
void visitTerms(const Visit& visit, const QString& light, Terms& terms) {
    visit(light + QStringLiteral("/colour"), terms.colour, 0.0f, 1.0f);
    visit(light + QStringLiteral("/ambient"), terms.ambient, 0.0f, kMostStrength);
    visit(light + QStringLiteral("/diffuse"), terms.diffuse, 0.0f, kMostStrength);
    visit(light + QStringLiteral("/specular"), terms.specular, 0.0f, kMostStrength);
}

template <class Visit, class Light>
void visitPlaced(const Visit& visit, const QString& name, Light& light) {
    visit(name + QStringLiteral("/on"), light.on);
    visitTerms(visit, name, light.terms);
    visit(name + QStringLiteral("/position"), light.position, -kFarthest, kFarthest);
    visit(name + QStringLiteral("/constant"), light.attenuation.constant, 0.001f, 1000.0f);
    visit(name + QStringLiteral("/linear"), light.attenuation.linear, 0.0f, 1.0e6f);
    visit(name + QStringLiteral("/quadratic"), light.attenuation.quadratic, 0.0f, 1.0e6f);
}

/// One list of what there is, for reading and for writing.
template <class Visit, class AllLights>
void visitLights(const Visit& visit, AllLights& lights) {
    const QString directional = QStringLiteral("lights/directional");
    visit(directional + QStringLiteral("/on"), lights.directional.on);
    visit(directional + QStringLiteral("/direction"), lights.directional.direction, -kFarthest, kFarthest);
    visitTerms(visit, directional, lights.directional.terms);
    for (std::size_t i = 0; i < lights.points.size(); ++i) {
        visitPlaced(visit, QStringLiteral("lights/point%1").arg(i + 1), lights.points[i]);
    }
    const QString spot = QStringLiteral("lights/spot");
    visitPlaced(visit, spot, lights.spot);
    visit(spot + QStringLiteral("/atEye"), lights.spot.atEye);
    visit(spot + QStringLiteral("/direction"), lights.spot.direction, -kFarthest, kFarthest);
    visit(spot + QStringLiteral("/innerAngle"), lights.spot.innerAngle, 0.0f, 1.6f);
    visit(spot + QStringLiteral("/outerAngle"), lights.spot.outerAngle, 0.0f, 1.6f);
}

}  // namespace

void loadLights(const QSettings& settings, Session& session) {
    Lights lights = moved(session.settings().lights(), session.settings().lightSpace(), LightSpace{});
    visitLights(Reader{settings}, lights);
    session.settings().restoreLights(moved(lights, LightSpace{}, session.settings().lightSpace()));
}

void saveLights(QSettings& settings, const Session& session) {
    const Lights lights = moved(session.settings().lights(), session.settings().lightSpace(), LightSpace{});
    visitLights(Writer{settings}, lights);
}

}  // namespace hitscope
