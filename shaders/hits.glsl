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
// HITSCOPE_FORMS          defined: hits may have another form than the paper's; of uniform arrays, how many curves
//                         they hold

#if defined(HITSCOPE_UNIFORM_HITS) || defined(HITSCOPE_HIT_LISTS)
#include "deform.glsl"
#endif

#ifdef HITSCOPE_UNIFORM_HITS

// Nine numbers a hit (src/pipeline/hit_arrays.h), and one for its form. Software renderers fetch each for every vertex, and all four of a
// vector of which one is wanted: where the driver packs floats, they are an array of floats.
#ifdef HITSCOPE_HITS_IN_BLOCK
layout(std140) uniform HitArrays {
    vec4 u_hitPoints[HITSCOPE_UNIFORM_HITS];      // and max_distance
    vec4 u_hitDirections[HITSCOPE_UNIFORM_HITS];  // and power
    vec4 u_hitMagnitudes[(HITSCOPE_UNIFORM_HITS + 3) / 4];
#ifdef HITSCOPE_FORMS
    vec4 u_hitForms[(HITSCOPE_UNIFORM_HITS + 3) / 4];
    vec4 u_hitCurves[4 * HITSCOPE_FORMS];
#endif
};
#else
uniform vec4 u_hitPoints[HITSCOPE_UNIFORM_HITS];
uniform vec4 u_hitDirections[HITSCOPE_UNIFORM_HITS];
#ifdef HITSCOPE_PACKED_MAGNITUDES
uniform vec4 u_hitMagnitudes[(HITSCOPE_UNIFORM_HITS + 3) / 4];
#else
uniform float u_hitMagnitudes[HITSCOPE_UNIFORM_HITS];
#endif
#ifdef HITSCOPE_FORMS
#ifdef HITSCOPE_PACKED_MAGNITUDES
uniform vec4 u_hitForms[(HITSCOPE_UNIFORM_HITS + 3) / 4];
#else
uniform float u_hitForms[HITSCOPE_UNIFORM_HITS];
#endif
uniform vec4 u_hitCurves[4 * HITSCOPE_FORMS];
#endif
#endif
uniform int u_hitCount;  // hits in the arrays
uniform int u_firstHit;  // this target's are [u_firstHit, u_lastHit)
uniform int u_lastHit;

#ifdef HITSCOPE_FORMS
vec4 curveTerms(int curve, int pair)
{
    return u_hitCurves[4 * curve + pair];
}
#endif

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
#ifdef HITSCOPE_FORMS
#ifdef HITSCOPE_PACKED_MAGNITUDES
        float form = u_hitForms[i >> 2][i & 3];
#else
        float form = u_hitForms[i];
#endif
        if (deformBy(p, n, a.xyz, b.xyz, vec3(a.w, b.w, magnitude), form)) {
#else
        if (deform(p, n, a.xyz, b.xyz, vec3(a.w, b.w, magnitude))) {
#endif
            reached = true;
        }
    }
    return reached;
}

#elif defined(HITSCOPE_HIT_LISTS)

// What the buffers hold: src/pipeline/hit_batch.h.
uniform samplerBuffer u_hits;  // three texels a hit, six a curve
uniform usamplerBuffer u_hitIndices;  // four a texel
uniform usamplerBuffer u_clusters;  // the batch's: first vertex, vertices, first index, indices
uniform int u_hitBase;              // where the batch's hits, its indices ...
uniform int u_indexBase;
uniform int u_clusterBase;  // ... and cluster 0 of the target, if it were there, start

layout(location = 7) in uint a_cluster;

#ifdef HITSCOPE_FORMS
vec4 curveTerms(int curve, int pair)
{
    return texelFetch(u_hits, 3 * (u_hitBase + curve) + pair);
}
#endif

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
#ifdef HITSCOPE_FORMS
        if (deformBy(p, n, a.xyz, b.xyz, vec3(a.w, b.w, c.x), c.y)) {
#else
        if (deform(p, n, a.xyz, b.xyz, vec3(a.w, b.w, c.x))) {
#endif
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
