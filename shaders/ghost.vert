// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Triangles, three vertices each, that are not there yet.

layout(location = 0) in vec3 a_position;  // world

uniform mat4 u_viewProjection;

out vec3 v_position;
out vec3 v_corner;

void main()
{
    v_position = a_position;
    int corner = gl_VertexID % 3;
    v_corner = vec3(corner == 0, corner == 1, corner == 2);
    gl_Position = u_viewProjection * vec4(a_position, 1.0);
}
