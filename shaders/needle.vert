// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Normals as needles: an instance each, of four corners.
//
// HITSCOPE_PAPER_NORMALS   defined: the paper's; else the true ones

#include "hits.glsl"
#include "change.glsl"
#include "cut.glsl"
#include "wide_line.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 3) in vec3 a_shadingNormal;

uniform mat4 u_model;
uniform mat4 u_viewProjection;
uniform float u_depthShift;  // as in wire.vert
uniform float u_length;      // metres

out float g_density;
noperspective out float g_across;

void main()
{
    vec3 position = a_position;
    vec3 normal = a_normal;
    applyHits(position, normal);
#ifndef HITSCOPE_PAPER_NORMALS
    normal = a_shadingNormal;
#endif
    position = drawnPosition(position);
    // Whole or not at all, by where it stands.
    vec4 world = u_model * vec4(position, 1.0);
    cutAway(world);
    vec4 a = u_viewProjection * world;
    vec4 b = u_viewProjection * (u_model * vec4(position + u_length * normal, 1.0));
    a.z += u_depthShift;
    b.z += u_depthShift;
    if (!clipLine(a, b)) {
        g_density = 0.0;
        g_across = 0.0;
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // outside
        return;
    }
    vec2 along;
    vec2 across;
    lineSides(a, b, along, across);
    float side = (gl_VertexID & 1) != 0 ? 1.0 : -1.0;
    bool tip = (gl_VertexID & 2) != 0;
    vec4 end = tip ? b : a;
    g_density = tip ? 1.0 : 0.53;  // which end is which
    g_across = side * u_reach;
    gl_Position = vec4(end.xy + side * across * end.w, end.zw);
}
