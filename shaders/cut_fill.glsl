// SPDX-License-Identifier: GPL-3.0-or-later
// A cutting plane closes what it opens, as if targets were solid. In programs that have v_position, from the eye.

uniform vec4 u_cutFromEye;  // as u_cut (cut.glsl), of places from the eye
uniform vec4 u_sight;       // orthographic: the way the camera looks, and 1; perspective: the eye, and 0

// Where one sees a closed surface from behind through the plane, the line of sight is within the body as it crosses the
// plane: there a solid one would be cut. The fragment stays where the surface is, so that nearer ones hide it.
bool isFilling()
{
    if (gl_FrontFacing) {
        return false;
    }
    vec3 sight = u_sight.w > 0.0 ? u_sight.xyz : v_position;
    float back = (dot(u_cutFromEye.xyz, v_position) + u_cutFromEye.w) / dot(u_cutFromEye.xyz, sight);
    return back > 0.0 && (u_sight.w > 0.0 || back < 1.0);
}
