// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core

in vec2 v_at;

uniform float u_strength;  // [0, 1]

out vec4 o_colour;

void main()
{
    float away = length(v_at);
    float shade = 1.0 - smoothstep(0.0, 1.0, away);
    o_colour = vec4(0.0, 0.0, 0.0, u_strength * shade * shade);
}
