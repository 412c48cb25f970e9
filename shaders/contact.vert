// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A square of the floor below a target, for the light that does not get there.

uniform mat4 u_viewProjection;
uniform vec3 u_centre;
uniform vec2 u_reach;  // metres, half the sides along x and z

out vec2 v_at;  // [-1, 1]^2

void main()
{
    v_at = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    gl_Position = u_viewProjection * vec4(u_centre + vec3(u_reach.x * v_at.x, 0.0, u_reach.y * v_at.y), 1.0);
}
