// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// A wireframe whose edges are a pixel or less: what its lines (wire.vert, wire.frag) cover of a pixel, all together.

#include "sight.glsl"

in vec3 v_position;  // from the eye
in vec3 v_normal;

uniform vec4 u_colour;       // sRGB, opacity
uniform float u_edgePixels;  // length of a usual edge in pixels, one metre from the eye

out vec4 o_colour;  // premultiplied by its opacity

void main()
{
    float facing = abs(dot(normalize(v_normal), normalize(sightTo(v_position))));
    float edge = u_edgePixels * gl_FragCoord.w;
    float density = mix(0.15, 1.0, smoothstep(0.5, 9.0, edge));  // as in wire.vert
    // Squares have two edges each; seen at an angle they lie closer.
    float lines = 2.0 / (max(edge, 0.6) * max(facing, 0.25));
    float cover = 1.0 - pow(1.0 - density * u_colour.a, lines);
    o_colour = vec4(u_colour.rgb * cover, cover);
}
