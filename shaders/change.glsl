// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be seen of a vertex's change: its value for a colour map, and a place that exaggerates it.
//
// HITSCOPE_CHANGE_MAP    defined: v_change is the quantity's value (twin of src/deform/change_quantity.cpp)
// HITSCOPE_EXAGGERATED   defined: vertices are drawn as if they had moved u_exaggeration times as far
// HITSCOPE_GHOST         defined: vertices are drawn where they were

#if defined(HITSCOPE_CHANGE_MAP) || defined(HITSCOPE_EXAGGERATED) || defined(HITSCOPE_GHOST)
layout(location = 4) in vec3 a_original;
#endif

#if defined(HITSCOPE_GHOST)
vec3 drawnPosition(vec3 position)
{
    return a_original;
}
#elif defined(HITSCOPE_EXAGGERATED)
uniform float u_exaggeration;

vec3 drawnPosition(vec3 position)
{
    return a_original + u_exaggeration * (position - a_original);
}
#else
vec3 drawnPosition(vec3 position)
{
    return position;
}
#endif

#ifdef HITSCOPE_CHANGE_MAP
layout(location = 5) in vec3 a_originalNormal;
layout(location = 6) in float a_changeValue;

uniform int u_changeQuantity;  // ChangeQuantity

out float v_change;

// Degrees; exact near 0 too, where a cosine is not.
float angleBetween(vec3 a, vec3 b)
{
    return degrees(atan(length(cross(a, b)), dot(a, b)));
}

float changeOf(vec3 position, vec3 normal, vec3 trueNormal)
{
    vec3 moved = position - a_original;
    switch (u_changeQuantity) {
        case 0: return length(moved);
        case 1: return dot(moved, a_originalNormal);
        case 2: return moved.x;
        case 3: return moved.y;
        case 4: return moved.z;
        case 5: return angleBetween(a_originalNormal, normal);
        case 6: return angleBetween(trueNormal, normal);
    }
    return a_changeValue;
}
#endif
