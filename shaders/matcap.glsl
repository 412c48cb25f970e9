// SPDX-License-Identifier: GPL-3.0-or-later
// The colour of a lit ball where its normal is the surface's, as seen from the eye: whatever the lights, the shape is seen.

uniform sampler2D u_matcap;
uniform vec3 u_up;  // unit, the picture's

vec3 matcapLight(Surface s)
{
    vec3 toEye = -normalize(sightTo(s.position));
    vec3 right = normalize(cross(u_up, toEye));
    vec3 up = cross(toEye, right);
    vec2 at = vec2(dot(s.normal, right), -dot(s.normal, up));
    return texture(u_matcap, 0.5 + 0.49 * at).rgb;
}
