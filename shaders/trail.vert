// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Ribbons behind projectiles, made to face the eye.

layout(location = 0) in vec3 a_position;  // world
layout(location = 1) in vec4 a_colour;    // sRGB, opacity

uniform mat4 u_viewProjection;

out vec4 v_colour;

void main()
{
    v_colour = a_colour;
    gl_Position = u_viewProjection * vec4(a_position, 1.0);
}
