// SPDX-License-Identifier: GPL-3.0-or-later
// What of a SessionDocument is kept in a file: names, order and ranges, said once for reading and writing.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deform/fingerprint.h"
#include "document/document_section.h"
#include "document/document_words.h"
#include "document/fields.h"
#include "document/form_fields.h"
#include "document/mesh_step_fields.h"
#include "document/session_document.h"
#include "document/view_fields.h"
#include "session/primitive_target.h"

namespace hitscope {

/// Members that ParameterDescriptors tell of.
template <class Visit, class Settings, class Parameters>
void visitParameters(Visit& visit, Settings& settings, const Parameters& parameters) {
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        auto value = static_cast<float>(parameterValue(settings, i));
        visit.number(parameters[i].key, value, parameters[i].minimum, parameters[i].maximum);
        if constexpr (Visit::reads()) {
            setParameterValue(settings, i, static_cast<double>(value));
        }
    }
}

template <>
struct Fields<SceneSettings> {
    template <class Visit, class Scene>
    static void visit(Visit& visit, Scene& scene) {
        visit.text("name", scene.name);
        visit.number("floor_height", scene.floorHeight);
        visit.vector("lights_about", scene.lightSpace.centre);
        visit.number("lights_extent", scene.lightSpace.extent, 0.0, kLargestFloat);
        visit.number("cover_texture", scene.coverTexture, 0.0, SceneSettings::kLargestCover);
    }
};

template <>
struct Fields<SavedSource> {
    template <class Visit, class Source>
    static void visit(Visit& visit, Source& source) {
        using document_words::SourceKind;
        auto kind = static_cast<SourceKind>(source.mesh.index());
        visit.require("kind");
        visit.word("kind", kind, document_words::kSourceKinds);
        if constexpr (Visit::reads()) {
            source.mesh = kind == SourceKind::Primitive ? TargetSource(Primitive())
                          : kind == SourceKind::BuiltIn ? TargetSource(BuiltInMesh())
                          : kind == SourceKind::File    ? TargetSource(MeshFile())
                                                        : TargetSource();
        }
        std::visit([&](auto& mesh) { from(visit, mesh, source); }, source.mesh);
    }

private:
    template <class Visit, class Mesh, class Source>
    static void from(Visit& visit, Mesh& mesh, Source& source) {
        using Kind = std::remove_const_t<Mesh>;
        if constexpr (std::is_same_v<Kind, Primitive>) {
            visit.require("shape");
            visit.word("shape", mesh.kind, document_words::kPrimitives);
            const PrimitiveTraits& traits = traitsOf(mesh.kind);
            visit.number("resolution", mesh.resolution, traits.least, traits.most);
            visit.number("size", mesh.size, Primitive::kLeastSize, Primitive::kMostSize);
        } else if constexpr (std::is_same_v<Kind, BuiltInMesh>) {
            visit.require("mesh");
            visit.word("mesh", mesh, document_words::kBuiltInMeshes);
        } else if constexpr (std::is_same_v<Kind, MeshFile>) {
            visit.require("path");
            visit.text("path", mesh.path);
            visit.text("relative_path", source.relativePath);
            visit.number("size", mesh.size);
            visit.text("sha256", mesh.sha256);
            if constexpr (Visit::reads()) {
                if (!mesh.sha256.empty() && !document_words::isHex(mesh.sha256, 64)) {
                    visit.fail("sha256", "has to be 64 hexadecimal digits in lower case.");
                }
            }
        }
    }
};

template <>
struct Fields<Placement> {
    template <class Visit, class Value>
    static void visit(Visit& visit, Value& placement) {
        visit.vector("centre", placement.centre);
        visit.number("scale", placement.scale, std::numeric_limits<double>::denorm_min(),
                     std::numeric_limits<double>::max());
    }
};

template <>
struct Fields<LocatedTexture> {
    template <class Visit, class Texture>
    static void visit(Visit& visit, Texture& texture) {
        visit.text("name", texture.name);
        visit.text("path", texture.path);
        visit.text("relative_path", texture.relativePath);
    }
};

template <>
struct Fields<TargetPhysics> {
    template <class Visit, class Physics>
    static void visit(Visit& visit, Physics& physics) {
        visit.flag("dynamic", physics.isDynamic);
        visitParameters(visit, physics, targetParameters());
    }
};

template <>
struct Fields<SavedTarget> {
    template <class Visit, class Target>
    static void visit(Visit& visit, Target& target) {
        visit.require("id");
        visit.require("source");
        visit.number("id", target.id.value, 1.0, SessionDocument::kMostId);
        visit.text("name", target.name);
        visit.object("source", target.source);
        visit.object("placement", target.placement);
        if (Visit::reads() || !target.steps.empty()) {
            visit.list("mesh_steps", "mesh step", target.steps, kMostMeshSteps);
        }
        visit.rows("textures", "texture", target.textures, SessionDocument::kMostTextures);
        visit.vector("position", target.transform.position);
        visit.rotation("rotation", target.transform.rotation);
        visit.flag("visible", target.visible);
        visit.object("physics", target.physics);
    }
};

template <>
struct Fields<ConstantsSetting> {
    template <class Visit, class Setting>
    static void visit(Visit& visit, Setting& setting) {
        visitParameters(visit, setting.constants, deformationParameters());
        visit.flag("relative", setting.relative);
        visitForm(visit, setting.form);
    }
};

template <>
struct Fields<ProjectileSettings> {
    template <class Visit, class Settings>
    static void visit(Visit& visit, Settings& settings) {
        visitParameters(visit, settings, projectileParameters());
        visit.flag("bounces_count", settings.bouncesCount);
        visit.flag("power_follows_impulse", settings.powerFollowsImpulse);
        visit.vector("colour", settings.colour, 0.0, 1.0);
        visit.flag("passes_others", settings.passesOthers);
    }
};

template <>
struct Fields<SimulationSettings> {
    template <class Visit, class Settings>
    static void visit(Visit& visit, Settings& settings) {
        visit.word("pipeline", settings.pipeline, document_words::pipelines());
        visit.word("flight", settings.flight, document_words::flightModes());
        visit.number("physics_step", settings.physicsStep, stepParameter().minimum, stepParameter().maximum);
        visit.number("time_scale", settings.timeScale, timeScaleParameter().minimum,
                     timeScaleParameter().maximum);
        visit.flag("paused", settings.paused);
        visit.number("time", settings.time, 0.0, SimulationSettings::kLongest);
    }
};

template <>
struct Fields<VertexRef> {
    template <class Visit, class Vertex>
    static void visit(Visit& visit, Vertex& vertex) {
        visit.require("target");
        visit.require("vertex");
        visit.number("target", vertex.target.value);
        visit.number("vertex", vertex.vertex);
    }
};

template <>
struct Fields<SavedSelection::Vertices> {
    template <class Visit, class Vertices>
    static void visit(Visit& visit, Vertices& selected) {
        visit.require("target");
        visit.number("target", selected.target.value);
        visit.plain("vertices", "vertex", selected.vertices, std::numeric_limits<std::uint32_t>::max());
        if constexpr (Visit::reads()) {
            const auto& v = selected.vertices;
            if (std::adjacent_find(v.begin(), v.end(), std::greater_equal<>()) != v.end()) {
                visit.fail("vertices", "has to have each number once, in ascending order.");
            }
        }
    }
};

template <>
struct Fields<SavedSelection> {
    template <class Visit, class Selection>
    static void visit(Visit& visit, Selection& selection) {
        visit.number("target", selection.target.value);
        visit.optional("hit", selection.hit);
        visit.optional("shown_hits", selection.shown);
        visit.optionalObject("picked", selection.picked);
        visit.rows("vertices", "target", selection.vertices, SessionDocument::kMostTargets);
    }
};

template <>
struct Fields<SavedPositions> {
    template <class Visit, class Positions>
    static void visit(Visit& visit, Positions& positions) {
        constexpr std::size_t kDigits = 16;
        std::string text = fingerprintText(positions.fingerprint);
        visit.require("target");
        visit.require("fingerprint");
        visit.number("target", positions.target.value);
        visit.text("fingerprint", text);
        if constexpr (Visit::reads()) {
            if (!document_words::isHex(text, kDigits)) {
                visit.fail("fingerprint", "has to be 16 hexadecimal digits in lower case.");
                return;
            }
            std::from_chars(text.data(), text.data() + text.size(), positions.fingerprint, 16);
        }
    }
};

template <>
struct Fields<Hit> {
    template <class Visit, class AnyHit>
    static void visit(Visit& visit, AnyHit& hit) {
        visit.require("target");
        visit.require("point");
        visit.require("direction");
        visit.number("target", hit.target.value);
        visit.vector("point", hit.point);
        visit.vector("direction", hit.direction);
        visit.number("max_distance", hit.constants.maxDistance);
        visit.number("power", hit.constants.power);
        visit.number("max_magnitude", hit.constants.maxMagnitude);
        visit.number("time", hit.time);
        visit.number("speed", hit.speed);
        visit.number("impulse", hit.impulse);
        if (Visit::reads() || !document_words::isPlainZero(hit.normal)) {
            visit.vector("normal", hit.normal);
        }
        if (Visit::reads() || hit.triangle != kNoIndex) {
            visit.number("triangle", hit.triangle);
        }
        pipeline(visit, hit.pipeline);
        if (Visit::reads() || !document_words::isPlainZero(hit.flight)) {
            visit.vector("flight", hit.flight);
        }
        visitForm(visit, hit.form);
        group(visit, hit.group);
        if (Visit::reads() || !hit.enabled) {
            visit.flag("enabled", hit.enabled);
        }
        if constexpr (Visit::reads()) {
            check(visit, hit);
        }
    }

private:
    template <class Visit>
    static void check(Visit& visit, Hit& hit) {
        if (!visit.ok()) {
            return;
        }
        if (const Result<Hit> checked = checkedHit(hit)) {
            hit = checked.value();
        } else {
            visit.fail({}, "cannot be used. " + checked.error().what);
        }
    }

    template <class Visit, class Group>
    static void group(Visit& visit, Group& group) {
        std::string text = groupText(group);
        if constexpr (Visit::reads()) {
            visit.text("group", text);
            const std::optional<HitGroup> known = groupOf(text);
            group = known.value_or(HitGroup());
            if (!known && !text.empty()) {
                visit.fail("group", "has to be group, mirror, scatter or stroke, and a number from 1.");
            }
        } else if (!text.empty()) {
            visit.text("group", text);
        }
    }

    /// By name where it is one of ours; a number that means nothing here stays one.
    template <class Visit, class Number>
    static void pipeline(Visit& visit, Number& number) {
        if constexpr (Visit::reads()) {
            if (visit.isNumber("pipeline")) {
                visit.number("pipeline", number);
            } else {
                visit.word("pipeline", number, document_words::pipelines());
            }
        } else if (number < document_words::pipelines().size()) {
            visit.word("pipeline", number, document_words::pipelines());
        } else if (number != kUnknownPipeline) {
            visit.number("pipeline", number);
        }
    }
};

template <class Visit, class Document>
void visitSection(Visit& visit, Document& document, Section section) {
    const std::string_view key = kSections[static_cast<std::size_t>(section)];
    switch (section) {
        case Section::Scene:
            return visit.object(key, document.scene);
        case Section::Targets:
            return visit.list(key, "target", document.targets, SessionDocument::kMostTargets);
        case Section::Constants:
            return visit.object(key, document.constants);
        case Section::Projectile:
            return visit.object(key, document.projectile);
        case Section::Simulation:
            return visit.object(key, document.simulation);
        case Section::Lights:
            return visit.object(key, document.lights);
        case Section::Cameras:
            return visit.object(key, document.cameras);
        case Section::Display:
            return visit.object(key, document.display);
        case Section::Selection:
            return visit.object(key, document.selection);
        case Section::Positions:
            return visit.rows(key, "position", document.positions, SessionDocument::kMostTargets);
        case Section::Hits:
            return visit.rows(key, "hit", document.hits, SessionDocument::kMostHits);
    }
}

template <class Visit, class Document>
void visitDocument(Visit& visit, Document& document) {
    for (std::size_t i = 0; i < kSections.size(); ++i) {
        visitSection(visit, document, static_cast<Section>(i));
    }
}

}  // namespace hitscope
