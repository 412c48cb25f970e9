// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// One triangle that covers the picture, as far away as can be.

uniform vec3 u_top;     // sRGB
uniform vec3 u_bottom;  // sRGB

out vec2 v_ndc;
flat out vec3 v_top;
flat out vec3 v_bottom;

void main()
{
    v_ndc = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    v_top = u_top;
    v_bottom = u_bottom;
    gl_Position = vec4(v_ndc, 1.0, 1.0);
}
