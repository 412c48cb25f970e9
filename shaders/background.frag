// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

in vec2 v_ndc;
flat in vec3 v_top;
flat in vec3 v_bottom;

uniform float u_left;  // the viewport's, pixels: pictures side by side are the same

out vec4 o_colour;

void main()
{
    float height = smoothstep(-1.0, 1.0, v_ndc.y);
    vec3 colour = mix(v_bottom, v_top, height);
    colour *= 1.0 - 0.05 * dot(v_ndc, v_ndc) * 0.5;
    // Half a step of noise, or eight bits would show the gradient as bands.
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy - vec2(u_left, 0.0), vec2(0.06711056, 0.00583715))));
    o_colour = vec4(colour + (noise - 0.5) / 255.0, 1.0);
}
