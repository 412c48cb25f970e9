// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Adds a sample to a sum, or draws the sum.
//
// HITSCOPE_DEPTHS    defined: depths are written too, for what is drawn over the picture and may be hidden by it
// In place of the opacity, of pictures that are opaque:
// HITSCOPE_SQUARES   defined: the square of the brightness (brightness.glsl), to be summed
// HITSCOPE_COUNT     defined: 1, to be summed
// HITSCOPE_COUNTED   defined: the picture is such a sum; each pixel is divided by its count
// HITSCOPE_OPAQUE    defined: 1

#include "brightness.glsl"

uniform sampler2D u_picture;
uniform float u_share;  // of the picture's colours: one over how many samples they are the sum of
#ifdef HITSCOPE_DEPTHS
uniform sampler2D u_depths;
#endif

out vec4 o_colour;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 colour = texelFetch(u_picture, at, 0);
#ifdef HITSCOPE_COUNTED
    o_colour = vec4(colour.rgb / colour.a, 1.0);
#else
    o_colour = u_share * colour;
#endif
#ifdef HITSCOPE_SQUARES
    float bright = brightness(colour.rgb);
    o_colour.a = bright * bright;
#elif defined(HITSCOPE_COUNT) || defined(HITSCOPE_OPAQUE)
    o_colour.a = 1.0;
#endif
#ifdef HITSCOPE_DEPTHS
    gl_FragDepth = texelFetch(u_depths, at, 0).r;
#endif
}
