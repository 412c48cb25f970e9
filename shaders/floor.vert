// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A square of the floor's plane around a centre.

uniform mat4 u_viewProjection;
uniform vec3 u_centre;
uniform float u_reach;  // metres, half the square's side

out vec3 v_position;

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    v_position = u_centre + u_reach * vec3(corner.x, 0.0, corner.y);
    gl_Position = u_viewProjection * vec4(v_position, 1.0);
}
