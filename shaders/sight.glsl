// SPDX-License-Identifier: GPL-3.0-or-later
// The line of sight.
//
// HITSCOPE_ORTHOGRAPHIC   defined: the camera is, and all lines of sight are parallel

#ifdef HITSCOPE_ORTHOGRAPHIC
uniform vec3 u_lookAlong;  // unit, the way the camera looks
#endif

// On to a place, which is metres from the eye. Not of unit length.
vec3 sightTo(vec3 place)
{
#ifdef HITSCOPE_ORTHOGRAPHIC
    return u_lookAlong;
#else
    return place;
#endif
}
