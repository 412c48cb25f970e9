// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Vertices as dots, where they are far enough apart.

#include "hits.glsl"
#include "change.glsl"
#include "cut.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform mat4 u_model;
uniform mat4 u_viewProjection;
uniform float u_depthShift;  // as in wire.vert
uniform float u_edgePixels;
uniform float u_pixels;      // across a dot
uniform vec2 u_apart;        // pixels a usual edge has where dots start to show, and where they show in full

out float v_density;

void main()
{
    vec3 position = a_position;
    vec3 normal = a_normal;
    applyHits(position, normal);
    vec4 world = u_model * vec4(drawnPosition(position), 1.0);
    cutAway(world);
    vec4 clip = u_viewProjection * world;
    v_density = smoothstep(u_apart.x, u_apart.y, u_edgePixels / max(clip.w, 1.0e-6));
#ifdef HITSCOPE_CUT_FILLED
    v_density *= seenFromOutside(world.xyz, mat3(u_model) * normal);
#endif
    clip.z += u_depthShift;
    gl_Position = v_density > 0.0 ? clip : vec4(0.0, 0.0, 2.0, 1.0);
    gl_PointSize = u_pixels + 2.0;
}
