// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// HITSCOPE_DEPTHS   defined: depths are written too, for what is drawn over the picture and may be hidden by it

uniform sampler2D u_picture;
uniform float u_share;  // of the picture's colours: one over how many samples they are the sum of
#ifdef HITSCOPE_DEPTHS
uniform sampler2D u_depths;
#endif

out vec4 o_colour;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    o_colour = u_share * texelFetch(u_picture, at, 0);
#ifdef HITSCOPE_DEPTHS
    gl_FragDepth = texelFetch(u_depths, at, 0).r;
#endif
}
