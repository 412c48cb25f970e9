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

#ifdef HITSCOPE_PACKED_MAGNITUDES
#define NUMBER_OF_HIT(numbers, i) numbers[(i) >> 2][(i) & 3]
#else
#define NUMBER_OF_HIT(numbers, i) numbers[i]
#endif

#ifdef HITSCOPE_OWN_HITS_ONLY
#define FIRST_HIT u_firstHit
#define LAST_HIT u_lastHit
#define IS_OWN_HIT(i) true
#else
// Algorithm 1: every model loops over all the hits in the scene and applies those that belong to it.
#define FIRST_HIT 0
#define LAST_HIT u_hitCount
#define IS_OWN_HIT(i) ((i) >= u_firstHit && (i) < u_lastHit)
#endif

bool applyHit(int i, inout vec3 p, inout vec3 n)
{
    float magnitude = NUMBER_OF_HIT(u_hitMagnitudes, i);
    vec4 a = u_hitPoints[i];
    vec4 b = u_hitDirections[i];
    return deform(p, n, a.xyz, b.xyz, vec3(a.w, b.w, magnitude));
}

#ifdef HITSCOPE_FORMS

bool applyHitByForm(int i, inout vec3 p, inout vec3 n)
{
    float magnitude = NUMBER_OF_HIT(u_hitMagnitudes, i);
    vec4 a = u_hitPoints[i];
    vec4 b = u_hitDirections[i];
    return deformByForm(p, n, a.xyz, b.xyz, vec3(a.w, b.w, magnitude), NUMBER_OF_HIT(u_hitForms, i));
}

// Hits of the paper's form have a loop of their own: a software renderer computes all that a loop holds for each.
bool applyHits(inout vec3 p, inout vec3 n)
{
    bool reached = false;
    for (int i = FIRST_HIT; i < LAST_HIT;) {
        for (; i < LAST_HIT && isPaperForm(NUMBER_OF_HIT(u_hitForms, i)); ++i) {
            if (IS_OWN_HIT(i) && applyHit(i, p, n)) {
                reached = true;
            }
        }
        for (; i < LAST_HIT && !isPaperForm(NUMBER_OF_HIT(u_hitForms, i)); ++i) {
            if (IS_OWN_HIT(i) && applyHitByForm(i, p, n)) {
                reached = true;
            }
        }
    }
    return reached;
}

#else

bool applyHits(inout vec3 p, inout vec3 n)
{
    bool reached = false;
    for (int i = FIRST_HIT; i < LAST_HIT; ++i) {
        if (IS_OWN_HIT(i) && applyHit(i, p, n)) {
            reached = true;
        }
    }
    return reached;
}

#endif

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

int hitAt(int i)
{
    return 3 * (u_hitBase + int(texelFetch(u_hitIndices, i >> 2)[i & 3]));
}

bool applyHits(inout vec3 p, inout vec3 n)
{
    uvec4 cluster = texelFetch(u_clusters, u_clusterBase + int(a_cluster));
    int i = u_indexBase + int(cluster.z);
    int last = i + int(cluster.w);
    bool reached = false;
#ifdef HITSCOPE_FORMS
    while (i < last) {
        for (; i < last; ++i) {
            int hit = hitAt(i);
            vec4 c = texelFetch(u_hits, hit + 2);
            if (isPaperForm(c.y)) {
                break;
            }
            vec4 a = texelFetch(u_hits, hit);
            vec4 b = texelFetch(u_hits, hit + 1);
            if (deformByForm(p, n, a.xyz, b.xyz, vec3(a.w, b.w, c.x), c.y)) {
                reached = true;
            }
        }
#endif
        for (; i < last; ++i) {
            int hit = hitAt(i);
            vec4 c = texelFetch(u_hits, hit + 2);
#ifdef HITSCOPE_FORMS
            if (!isPaperForm(c.y)) {
                break;
            }
#endif
            vec4 a = texelFetch(u_hits, hit);
            vec4 b = texelFetch(u_hits, hit + 1);
            if (deform(p, n, a.xyz, b.xyz, vec3(a.w, b.w, c.x))) {
                reached = true;
            }
        }
#ifdef HITSCOPE_FORMS
    }
#endif
    return reached;
}

#else

bool applyHits(inout vec3 p, inout vec3 n)
{
    return false;
}

#endif
