// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

#include "sight.glsl"

in vec3 v_position;
in vec3 v_corner;

uniform vec3 u_eye;
uniform vec3 u_colour;  // sRGB
uniform float u_fill;   // opacity of a surface that faces the eye; grazing ones are twice as opaque
uniform float u_line;   // opacity of the edges
uniform float u_width;  // pixels

out vec4 o_colour;

void main()
{
    vec3 normal = cross(dFdx(v_position), dFdy(v_position));
    vec3 sight = sightTo(v_position - u_eye);
    float facing = abs(dot(normal, sight)) / max(length(normal) * length(sight), 1.0e-20);
    vec3 pixels = v_corner / max(fwidth(v_corner), vec3(1.0e-9));
    float edge = 1.0 - smoothstep(0.5 * u_width - 0.5, 0.5 * u_width + 0.5, min(pixels.x, min(pixels.y, pixels.z)));
    // Where triangles are a pixel or two large, edges would be all there is.
    edge *= smoothstep(0.15, 0.6, 1.0 - max(fwidth(v_corner.x), max(fwidth(v_corner.y), fwidth(v_corner.z))));
    o_colour = vec4(u_colour, mix(u_fill * (2.0 - facing), u_line, edge));
}
