// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A square in the middle of the picture.

uniform vec2 u_reach;   // normalized device coordinates: half its sides
uniform float u_pixels;  // half a side in pixels

out vec2 v_pixel;  // from the middle

void main()
{
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    v_pixel = u_pixels * corner;
    gl_Position = vec4(u_reach * corner, 0.0, 1.0);
}
