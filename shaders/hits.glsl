// SPDX-License-Identifier: GPL-3.0-or-later
// Applies hits to a vertex: those that a pipeline keeps in uniform arrays (paper, section 2.1), or a batch of
// them from buffers (section 2.2). Where a target's buffer holds its deformed vertices already there is nothing to
// do, and applyHits() does nothing.
//
// HITSCOPE_HIT_LISTS      hits come from buffers; for each cluster there is a list of those that may reach it
// HITSCOPE_UNIFORM_HITS   the number of hits the arrays hold; not defined: no arrays
// HITSCOPE_HIT_CONSTANTS  the number of different constants they can have
// HITSCOPE_OWN_HITS_ONLY  defined: the loop starts and ends with the target's own hits

#if defined(HITSCOPE_UNIFORM_HITS) || defined(HITSCOPE_HIT_LISTS)
#include "deform.glsl"
#endif

#ifdef HITSCOPE_UNIFORM_HITS

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

#elif defined(HITSCOPE_HIT_LISTS)

// What the buffers hold: src/pipeline/hit_batch.h.
uniform samplerBuffer u_hits;  // three texels a hit
uniform usamplerBuffer u_hitIndices;
uniform usamplerBuffer u_clusters;  // the batch's: first vertex, vertices, first index, indices
uniform int u_hitBase;              // where the batch's hits, its indices ...
uniform int u_indexBase;
uniform int u_clusterBase;  // ... and cluster 0 of the target, if it were there, start

layout(location = 7) in uint a_cluster;

bool applyHits(inout vec3 p, inout vec3 n)
{
    uvec4 cluster = texelFetch(u_clusters, u_clusterBase + int(a_cluster));
    int first = u_indexBase + int(cluster.z);
    int last = first + int(cluster.w);
    bool reached = false;
    for (int i = first; i < last; ++i) {
        int hit = 3 * (u_hitBase + int(texelFetch(u_hitIndices, i).x));
        vec4 a = texelFetch(u_hits, hit);
        vec4 b = texelFetch(u_hits, hit + 1);
        vec4 c = texelFetch(u_hits, hit + 2);
        if (deform(p, n, a.xyz, b.xyz, vec3(a.w, b.w, c.x))) {
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
