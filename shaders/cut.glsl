// SPDX-License-Identifier: GPL-3.0-or-later
// What a cutting plane hides is clipped.
//
// HITSCOPE_CUT          defined: there is one
// HITSCOPE_CUT_FILLED   defined: it closes what it opens, and hides what lies on the inside

#ifdef HITSCOPE_CUT_FILLED
uniform vec4 u_sight;  // the way the camera looks, and 1; perspective: the eye, and 0

// 0 where a vertex of that normal is seen from within, if at all.
float seenFromOutside(vec3 world, vec3 normal)
{
    vec3 sight = u_sight.w > 0.0 ? u_sight.xyz : world - u_sight.xyz;
    return dot(normal, sight) < 0.0 ? 1.0 : 0.0;
}
#endif

#ifdef HITSCOPE_CUT
uniform vec4 u_cut;  // dot(u_cut, (p, 1)): metres that p lies within what is shown, world

void cutAway(vec4 world)
{
    gl_ClipDistance[0] = dot(u_cut, world);
}
#else
void cutAway(vec4 world)
{
}
#endif
