// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Dots on vertices.

#include "hits.glsl"
#include "change.glsl"
#include "cut.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform mat4 u_model;
uniform mat4 u_viewProjection;
uniform float u_size;        // pixels
uniform float u_depthShift;  // what moves clip.z by a fraction of the distance: dots lie before their faces

void main()
{
    vec3 position = a_position;
    vec3 normal = a_normal;
    applyHits(position, normal);

    vec4 world = u_model * vec4(drawnPosition(position), 1.0);
    cutAway(world);
    gl_Position = u_viewProjection * world;
    gl_Position.z += u_depthShift;
    gl_PointSize = u_size;
}
