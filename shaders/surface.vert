// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Targets (paper, equations 5 and 6; model matrices are rigid, so their own rotation turns normals).
//
// HITSCOPE_PAPER_NORMALS   defined: they shade; else the true normals do
// HITSCOPE_COLOURS         defined: vertices have colours of their own

#include "hits.glsl"
#include "change.glsl"
#include "cut.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_texcoord;
layout(location = 3) in vec3 a_shadingNormal;
#ifdef HITSCOPE_COLOURS
layout(location = 8) in vec3 a_colour;  // linear
#endif

uniform mat4 u_model;
uniform mat4 u_viewProjection;
uniform vec3 u_eye;
#ifdef HITSCOPE_SHADOWS
uniform mat4 u_shadowMatrix;  // from the world to the shadow map's texture coordinates and depth
uniform float u_shadowTexel;  // metres
#endif

out vec3 v_position;  // from the eye
out vec3 v_normal;
#ifdef HITSCOPE_TEXCOORDS
out vec2 v_texcoord;
#endif
#ifdef HITSCOPE_COLOURS
out vec3 v_colour;
#endif

#ifdef HITSCOPE_SHADOWS
out vec3 v_shadow;
#endif

// The wireframe and the depth-only pass must land on the very same depths.
invariant gl_Position;

void main()
{
    // Hits live in the target's local frame: they come before the model matrix.
    vec3 position = a_position;
    vec3 normal = a_normal;
    applyHits(position, normal);

#ifdef HITSCOPE_CHANGE_MAP
    v_change = changeOf(position, normal, a_shadingNormal);
#endif
    vec4 world = u_model * vec4(drawnPosition(position), 1.0);
    v_position = world.xyz - u_eye;
#ifdef HITSCOPE_PAPER_NORMALS
    v_normal = mat3(u_model) * normal;
#else
    v_normal = mat3(u_model) * a_shadingNormal;
#endif
#ifdef HITSCOPE_TEXCOORDS
    v_texcoord = a_texcoord;
#endif
#ifdef HITSCOPE_COLOURS
    v_colour = a_colour;
#endif
#ifdef HITSCOPE_SHADOWS
    // From a little above the surface, or its own depths, a texel wide, would shadow it.
    v_shadow = (u_shadowMatrix * vec4(world.xyz + 2.5 * u_shadowTexel * v_normal, 1.0)).xyz;
#endif
    cutAway(world);
    gl_Position = u_viewProjection * world;
}
