// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// Which triangle of which target a pixel shows, or which vertex where they are drawn as points. One draw call has
// all of a target's, so that the number of the primitive is that of the triangle or vertex.
//
// HITSCOPE_CUT_FILLED   defined: where the cutting plane closes a body there is none to be seen
// HITSCOPE_HANDED_ON    defined: pick.geom tells the number

#ifdef HITSCOPE_HANDED_ON
in vec3 g_position;
flat in int g_primitive;
#define v_position g_position
#define PRIMITIVE g_primitive
#else
in vec3 v_position;  // from the eye
#define PRIMITIVE uint(gl_PrimitiveID)
#endif

#ifdef HITSCOPE_CUT_FILLED
#include "cut_fill.glsl"
#endif

uniform uint u_target;

out uvec2 o_element;

void main()
{
    o_element = uvec2(u_target, PRIMITIVE);
#ifdef HITSCOPE_CUT_FILLED
    if (isFilling()) {
        o_element = uvec2(0u, 1u);
    }
#endif
}
