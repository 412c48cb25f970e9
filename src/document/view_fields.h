// SPDX-License-Identifier: GPL-3.0-or-later
// What of lights, display and cameras is kept in a file; for document_fields.h.
#pragma once

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

#include "document/fields.h"
#include "document/session_document.h"
#include "view/camera_text.h"

namespace hitscope {

namespace document_words {

inline constexpr std::array<std::string_view, 3> kWireframes{"off", "over", "only"};
inline constexpr std::array<std::string_view, 2> kNormals{"true", "paper"};
inline constexpr std::array<std::string_view, kSurfaceLooks> kLooks{"file", "matcap", "clay", "metal"};
inline constexpr std::array<std::string_view, 3> kGhosts{"off", "wire", "translucent"};
inline constexpr auto kColourMapWords = std::to_array<std::string_view>({"viridis", "cividis", "cool-warm"});
static_assert(kColourMapWords.size() == kColourMaps);

inline const std::array<std::string_view, kChangeQuantities>& quantities() {
    static const auto words = [] {
        std::array<std::string_view, kChangeQuantities> keys;
        for (const ChangeTraits& traits : allChangeQuantities()) {
            keys[static_cast<std::size_t>(traits.quantity)] = traits.key;
        }
        return keys;
    }();
    return words;
}

}  // namespace document_words

/// Lights are kept as they are, however a scene's size has made their numbers; only what is none is refused.
inline constexpr double kLargestFloat = 3.4e38;

template <>
struct Fields<LightTerms> {
    template <class Visit, class Terms>
    static void visit(Visit& visit, Terms& terms) {
        visit.vector("colour", terms.colour, 0.0, kLargestFloat);
        visit.number("ambient", terms.ambient, 0.0, kLargestFloat);
        visit.number("diffuse", terms.diffuse, 0.0, kLargestFloat);
        visit.number("specular", terms.specular, 0.0, kLargestFloat);
    }
};

template <>
struct Fields<Attenuation> {
    template <class Visit, class Value>
    static void visit(Visit& visit, Value& attenuation) {
        visit.number("constant", attenuation.constant, 0.0, kLargestFloat);
        visit.number("linear", attenuation.linear, 0.0, kLargestFloat);
        visit.number("quadratic", attenuation.quadratic, 0.0, kLargestFloat);
    }
};

template <>
struct Fields<DirectionalLight> {
    template <class Visit, class Light>
    static void visit(Visit& visit, Light& light) {
        visit.flag("on", light.on);
        visit.vector("direction", light.direction);
        visit.object("terms", light.terms);
    }
};

template <>
struct Fields<PointLight> {
    template <class Visit, class Light>
    static void visit(Visit& visit, Light& light) {
        visit.flag("on", light.on);
        visit.vector("position", light.position);
        visit.object("attenuation", light.attenuation);
        visit.object("terms", light.terms);
    }
};

template <>
struct Fields<SpotLight> {
    template <class Visit, class Light>
    static void visit(Visit& visit, Light& light) {
        constexpr double kMostAngle = 3.15;  // radians
        visit.flag("on", light.on);
        visit.flag("at_eye", light.atEye);
        visit.vector("position", light.position);
        visit.vector("direction", light.direction);
        visit.number("inner_angle", light.innerAngle, 0.0, kMostAngle);
        visit.number("outer_angle", light.outerAngle, 0.0, kMostAngle);
        visit.object("attenuation", light.attenuation);
        visit.object("terms", light.terms);
    }
};

template <>
struct Fields<Lights> {
    template <class Visit, class Value>
    static void visit(Visit& visit, Value& lights) {
        constexpr std::array<std::string_view, 4> kPoints{"point_1", "point_2", "point_3", "point_4"};
        visit.object("directional", lights.directional);
        for (std::size_t i = 0; i < lights.points.size(); ++i) {
            visit.object(kPoints[i], lights.points[i]);
        }
        visit.object("spot", lights.spot);
    }
};

template <>
struct Fields<QuantityStyle> {
    template <class Visit, class Style>
    static void visit(Visit& visit, Style& style) {
        visit.word("map", style.map, document_words::kColourMapWords);
        visit.flag("automatic", style.automatic);
        visit.number("low", style.fixed.low);
        visit.number("high", style.fixed.high);
        if constexpr (Visit::reads()) {
            if (!(style.fixed.low < style.fixed.high)) {
                visit.fail("low", "has to be below the high end.");
            }
        }
    }
};

template <>
struct Fields<ChangeMapOptions> {
    template <class Visit, class Options>
    static void visit(Visit& visit, Options& change) {
        visit.flag("on", change.on);
        visit.word("quantity", change.quantity, document_words::quantities());
        visit.flag("isolines", change.isolines);
        for (std::size_t i = 0; i < change.styles.size(); ++i) {
            visit.object(document_words::quantities()[i], change.styles[i]);
        }
    }
};

template <>
struct Fields<BeforeAfterOptions> {
    template <class Visit, class Options>
    static void visit(Visit& visit, Options& options) {
        visit.word("ghost", options.ghost, document_words::kGhosts);
        visit.flag("wipe", options.wipe);
        visit.number("wipe_at", options.wipeAt, 0.0, 1.0);
        visit.number("exaggeration", options.exaggeration, 1.0, static_cast<double>(kLargestExaggeration));
    }
};

template <>
struct Fields<CuttingPlane> {
    template <class Visit, class Plane>
    static void visit(Visit& visit, Plane& cut) {
        constexpr float kUnit = 1.0e-3f;  // how far from 1 a normal's length may be
        visit.flag("on", cut.on);
        visit.vector("normal", cut.normal);
        visit.number("offset", cut.offset);
        visit.flag("flipped", cut.flipped);
        visit.flag("original_line", cut.originalLine);
        visit.flag("deformed_line", cut.deformedLine);
        visit.flag("fill", cut.fill);
        if constexpr (Visit::reads()) {
            if (!(std::abs(glm::length(cut.normal) - 1.0f) < kUnit)) {
                visit.fail("normal", "has to have the length 1.");
            }
        }
    }
};

template <>
struct Fields<DisplayOptions> {
    template <class Visit, class Options>
    static void visit(Visit& visit, Options& display) {
        visit.word("wireframe", display.wireframe, document_words::kWireframes);
        visit.word("normals", display.normals, document_words::kNormals);
        visit.flag("floor", display.floor);
        visit.flag("textures", display.textures);
        visit.flag("vertex_colours", display.vertexColours);
        visit.flag("crosshair", display.crosshair);
        visit.flag("side_by_side", display.sideBySide);
        visit.flag("flat", display.flat);
        visit.flag("needles", display.needles);
        visit.flag("dots", display.dots);
        visit.flag("back_faces", display.backFaces);
        visit.flag("shadows", display.shadows);
        visit.word("material", display.look, document_words::kLooks);
        visit.flag("environment", display.environment);
        visit.object("before_after", display.beforeAfter);
        visit.object("cutting_plane", display.cut);
        visit.object("change", display.change);
    }
};

template <>
struct Fields<SavedCameras> {
    template <class Visit, class Cameras>
    static void visit(Visit& visit, Cameras& cameras) {
        visit.text("current", cameras.current);
        visit.plain("kept", "camera", cameras.kept, SessionDocument::kMostCameras);
        if constexpr (Visit::reads()) {
            check(visit, "current", cameras.current);
            for (const std::string& kept : cameras.kept) {
                check(visit, "kept", kept);
            }
        }
    }

private:
    template <class Visit>
    static void check(Visit& visit, std::string_view key, const std::string& text) {
        if (const Result<Camera> camera = parseCamera(text, Camera()); !text.empty() && !camera) {
            visit.fail(key, "has a camera that cannot be read. " + camera.error().what);
        }
    }
};

}  // namespace hitscope
