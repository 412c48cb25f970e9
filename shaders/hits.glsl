// SPDX-License-Identifier: GPL-3.0-or-later
// Applies the hits that a pipeline keeps in uniform arrays (paper, section 2.1). With pipelines that keep the
// deformed vertices in the buffer there is nothing to do, and applyHits() does nothing.
//
// HITSCOPE_UNIFORM_HITS   the number of hits the arrays hold; not defined: no arrays
// HITSCOPE_HIT_CONSTANTS  the number of different constants they can have
// HITSCOPE_OWN_HITS_ONLY  defined: the loop starts and ends with the target's own hits

#ifdef HITSCOPE_UNIFORM_HITS

#include "deform.glsl"

uniform vec3 u_hitPoints[HITSCOPE_UNIFORM_HITS];
uniform vec3 u_hitDirections[HITSCOPE_UNIFORM_HITS];
// Constants are kept per hit, but few hits differ in them: a palette and, four to a word, an index for each hit.
uniform vec3 u_hitConstants[HITSCOPE_HIT_CONSTANTS];
uniform uint u_hitConstantsIndex[(HITSCOPE_UNIFORM_HITS + 3) / 4];
uniform int u_hitCount;  // hits in the arrays
uniform int u_firstHit;  // this target's are [u_firstHit, u_lastHit)
uniform int u_lastHit;

bool applyHits(inout vec3 p, inout vec3 n)
{
    bool reached = false;
#ifdef HITSCOPE_OWN_HITS_ONLY
    for (int i = u_firstHit; i < u_lastHit; ++i) {
#else
    // Algorithm 1: every model loops over all the hits in the scene and applies those that belong to it.
    for (int i = 0; i < u_hitCount; ++i) {
        if (i < u_firstHit || i >= u_lastHit) {
            continue;
        }
#endif
        uint index = (u_hitConstantsIndex[i >> 2] >> (8u * (uint(i) & 3u))) & 0xffu;
        if (deform(p, n, u_hitPoints[i], u_hitDirections[i], u_hitConstants[index])) {
            reached = true;
        }
    }
    return reached;
}

#else

bool applyHits(inout vec3 p, inout vec3 n)
{
    return false;
}

#endif
