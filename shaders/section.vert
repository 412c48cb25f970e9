// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Lines in which a plane cuts the targets.

layout(location = 0) in vec4 a_place;  // world; metres along its line

uniform mat4 u_viewProjection;
uniform float u_depthShift;  // as in wire.vert

out float v_along;

void main()
{
    v_along = a_place.w;
    gl_Position = u_viewProjection * vec4(a_place.xyz, 1.0);
    gl_Position.z += u_depthShift;
}
