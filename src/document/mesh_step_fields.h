// SPDX-License-Identifier: GPL-3.0-or-later
// What of the steps that made a target's mesh is kept in a file; for document_fields.h.
#pragma once

#include <array>
#include <limits>
#include <string_view>
#include <type_traits>
#include <variant>

#include "document/fields.h"
#include "document/session_document.h"
#include "session/mesh_steps/mesh_step.h"

namespace hitscope {

namespace document_words {

/// By the index of MeshStep's alternatives.
enum class StepKind : std::uint8_t { Refine, Simplify, Smooth, ApplyHits, OnlyObject };
inline constexpr std::array<std::string_view, 5> kStepKinds{"refine", "simplify", "smooth", "apply-hits",
                                                            "only-object"};
inline constexpr std::array<std::string_view, 3> kRefineMethods{"midpoint", "longest-edge", "butterfly"};
inline constexpr std::array<std::string_view, 3> kRegionKinds{"whole", "vertices", "balls"};

}  // namespace document_words

template <>
struct Fields<RegionBall> {
    template <class Visit, class Ball>
    static void visit(Visit& visit, Ball& ball) {
        visit.require("centre");
        visit.require("radius");
        visit.vector("centre", ball.centre);
        visit.number("radius", ball.radius, 0.0, std::numeric_limits<float>::max());
    }
};

template <>
struct Fields<MeshRegion> {
    template <class Visit, class Region>
    static void visit(Visit& visit, Region& region) {
        visit.word("kind", region.kind, document_words::kRegionKinds);
        if (Visit::reads() || region.kind == MeshRegion::Kind::Vertices) {
            visit.plain("vertices", "vertex", region.vertices, std::numeric_limits<std::uint32_t>::max());
        }
        if (Visit::reads() || region.kind == MeshRegion::Kind::Balls) {
            visit.rows("balls", "ball", region.balls, SessionDocument::kMostHits);
        }
    }
};

template <>
struct Fields<MeshStep> {
    template <class Visit, class Step>
    static void visit(Visit& visit, Step& step) {
        using document_words::StepKind;
        auto kind = static_cast<StepKind>(step.index());
        visit.require("kind");
        visit.word("kind", kind, document_words::kStepKinds);
        if constexpr (Visit::reads()) {
            step = kind == StepKind::Refine      ? MeshStep(RefineOptions())
                   : kind == StepKind::Simplify  ? MeshStep(SimplifyOptions())
                   : kind == StepKind::Smooth    ? MeshStep(SmoothOptions())
                   : kind == StepKind::ApplyHits ? MeshStep(MergedHits())
                                                 : MeshStep(OnlyObject());
        }
        std::visit([&visit](auto& what) { take(visit, what); }, step);
    }

private:
    template <class Visit, class What>
    static void take(Visit& visit, What& what) {
        using Kind = std::remove_const_t<What>;
        if constexpr (std::is_same_v<Kind, MergedHits>) {
            visit.rows("hits", "hit", what.hits, SessionDocument::kMostHits);
        } else if constexpr (std::is_same_v<Kind, OnlyObject>) {
            visit.require("object");
            visit.number("object", what.index, 0.0, std::numeric_limits<std::uint32_t>::max() - 1.0);
        } else if constexpr (std::is_same_v<Kind, RefineOptions>) {
            visit.require("edge_length");
            visit.word("method", what.method, document_words::kRefineMethods);
            visit.number("edge_length", what.edgeLength, std::numeric_limits<float>::min(),
                         std::numeric_limits<float>::max());
            visit.flag("keep_quads", what.keepQuads);
        } else if constexpr (std::is_same_v<Kind, SimplifyOptions>) {
            visit.number("share", what.share, std::numeric_limits<float>::min(),
                         1.0 - std::numeric_limits<float>::epsilon());
        } else {
            visit.number("passes", what.passes, 1.0, SmoothOptions::kMostPasses);
            visit.flag("keep_borders", what.keepBorders);
        }
        if constexpr (requires { what.region; }) {
            visit.object("region", what.region);
        }
    }
};

}  // namespace hitscope
