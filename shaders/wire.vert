// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// The edges of the targets' polygons.
//
// HITSCOPE_GHOST   defined: as they were, and only what has moved (change.glsl)

#include "hits.glsl"
#include "change.glsl"
#include "cut.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform mat4 u_model;
uniform mat4 u_viewProjection;
uniform float u_depthShift;  // what moves clip.z by a fraction of the distance: lines lie before their faces
uniform vec3 u_fade;         // pixels of edges from which on lines fade in, pixels of those in full, the least opacity
uniform float u_edgePixels;  // length of a usual edge in pixels, one metre from the eye

out float v_density;

void main()
{
    vec3 position = a_position;
    vec3 normal = a_normal;
    applyHits(position, normal);

    vec4 world = u_model * vec4(drawnPosition(position), 1.0);
    cutAway(world);
    vec4 clip = u_viewProjection * world;
    // Edges a pixel or two long would fill the surface with one colour; they fade instead.
    v_density = mix(u_fade.z, 1.0, smoothstep(u_fade.x, u_fade.y, u_edgePixels / max(clip.w, 1.0e-6)));
#ifdef HITSCOPE_CUT_FILLED
    v_density *= seenFromOutside(world.xyz, mat3(u_model) * normal);
#endif
#ifdef HITSCOPE_GHOST
    v_density *= position == a_original ? 0.0 : 1.0;
#endif
    clip.z += u_depthShift;
    gl_Position = clip;
}
