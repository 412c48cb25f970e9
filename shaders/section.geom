// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

#include "wide_line.glsl"

in float v_along[];

out float g_along;
noperspective out float g_across;  // pixels from the line's middle

void corner(vec4 end, vec2 shift, float across, float along)
{
    g_along = along;
    g_across = across;
    gl_Position = vec4(end.xy + shift * end.w, end.zw);
    EmitVertex();
}

void main()
{
    vec4 a = gl_in[0].gl_Position;
    vec4 b = gl_in[1].gl_Position;
    float fromA = v_along[0];
    float fromB = v_along[1];
    if (!clipLine(a, b, fromA, fromB)) {
        return;
    }
    vec2 along;
    vec2 across;
    lineSides(a, b, along, across);
    corner(a, -along - across, -u_reach, fromA);
    corner(a, -along + across, u_reach, fromA);
    corner(b, along - across, -u_reach, fromB);
    corner(b, along + across, u_reach, fromB);
}
