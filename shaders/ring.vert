// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A square that faces the eye, around a sphere's outline.

uniform mat4 u_viewProjection;
uniform vec3 u_centre;
uniform vec3 u_right;   // metres: half the square's sides, in the world
uniform vec3 u_up;

out vec2 v_at;

void main()
{
    v_at = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    gl_Position = u_viewProjection * vec4(u_centre + v_at.x * u_right + v_at.y * u_up, 1.0);
}
