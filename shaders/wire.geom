// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

#include "wide_line.glsl"

in float v_density[];

out float g_density;
noperspective out float g_across;  // pixels from the line's middle

#ifdef HITSCOPE_CUT
float cutDistance;  // of the corners to come
#endif

void corner(vec4 end, vec2 shift, float across, float density)
{
#ifdef HITSCOPE_CUT
    gl_ClipDistance[0] = cutDistance;
#endif
    g_density = density;
    g_across = across;
    gl_Position = vec4(end.xy + shift * end.w, end.zw);
    EmitVertex();
}

void main()
{
    vec4 a = gl_in[0].gl_Position;
    vec4 b = gl_in[1].gl_Position;
#ifdef HITSCOPE_CUT
    float ofA = gl_in[0].gl_ClipDistance[0];
    float ofB = gl_in[1].gl_ClipDistance[0];
    if (!clipLine(a, b, ofA, ofB)) {
        return;
    }
    cutDistance = ofA;
#else
    if (!clipLine(a, b)) {
        return;
    }
#endif
    vec2 along;
    vec2 across;
    lineSides(a, b, along, across);
    corner(a, -along - across, -u_reach, v_density[0]);
    corner(a, -along + across, u_reach, v_density[0]);
#ifdef HITSCOPE_CUT
    cutDistance = ofB;
#endif
    corner(b, along - across, -u_reach, v_density[1]);
    corner(b, along + across, u_reach, v_density[1]);
}
