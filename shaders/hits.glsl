// SPDX-License-Identifier: GPL-3.0-or-later
// Applies hits to a vertex: those that a pipeline keeps in uniform arrays (paper, section 2.1), or a batch of
// them from buffers (section 2.2). Where a target's buffer holds its deformed vertices already there is nothing to
// do, and applyHits() does nothing.
//
// HITSCOPE_HIT_LISTS      hits come from buffers; for each cluster there is a list of those that may reach it
// HITSCOPE_UNIFORM_HITS   the number of hits the arrays hold; not defined: no arrays
// HITSCOPE_PACKED_MAGNITUDES  defined: four numbers of the third array stand in a vector
// HITSCOPE_HITS_IN_BLOCK  defined: the arrays are a uniform block
// HITSCOPE_OWN_HITS_ONLY  defined: the loop starts and ends with the target's own hits

#if defined(HITSCOPE_UNIFORM_HITS) || defined(HITSCOPE_HIT_LISTS)
#include "deform.glsl"
#endif

#ifdef HITSCOPE_UNIFORM_HITS

// Nine numbers a hit (src/pipeline/hit_arrays.h). Software renderers fetch each for every vertex, and all four of a
// vector of which one is wanted: where the driver packs floats, they are an array of floats.
#ifdef HITSCOPE_HITS_IN_BLOCK
layout(std140) uniform HitArrays {
    vec4 u_hitPoints[HITSCOPE_UNIFORM_HITS];      // and max_distance
    vec4 u_hitDirections[HITSCOPE_UNIFORM_HITS];  // and power
    vec4 u_hitMagnitudes[(HITSCOPE_UNIFORM_HITS + 3) / 4];
};
#else
uniform vec4 u_hitPoints[HITSCOPE_UNIFORM_HITS];
uniform vec4 u_hitDirections[HITSCOPE_UNIFORM_HITS];
#ifdef HITSCOPE_PACKED_MAGNITUDES
uniform vec4 u_hitMagnitudes[(HITSCOPE_UNIFORM_HITS + 3) / 4];
#else
uniform float u_hitMagnitudes[HITSCOPE_UNIFORM_HITS];
#endif
#endif
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
#ifdef HITSCOPE_PACKED_MAGNITUDES
        float magnitude = u_hitMagnitudes[i >> 2][i & 3];
#else
        float magnitude = u_hitMagnitudes[i];
#endif
        vec4 a = u_hitPoints[i];
        vec4 b = u_hitDirections[i];
        if (deform(p, n, a.xyz, b.xyz, vec3(a.w, b.w, magnitude))) {
            reached = true;
        }
    }
    return reached;
}

#elif defined(HITSCOPE_HIT_LISTS)

// What the buffers hold: src/pipeline/hit_batch.h.
uniform samplerBuffer u_hits;  // three texels a hit
uniform usamplerBuffer u_hitIndices;  // four a texel
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
        int hit = 3 * (u_hitBase + int(texelFetch(u_hitIndices, i >> 2)[i & 3]));
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
