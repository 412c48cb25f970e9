// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Deforms vertices and hands them back through transform feedback (paper, section 2.2); nothing is drawn.

#include "hits.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

out vec3 capturedPosition;
out vec3 capturedNormal;

void main()
{
    vec3 position = a_position;
    vec3 normal = a_normal;
    applyHits(position, normal);
    capturedPosition = position;
    capturedNormal = normal;
    gl_Position = vec4(position, 1.0);
}
