// SPDX-License-Identifier: GPL-3.0-or-later
// The deformation function (paper, Algorithm 3 and equations 1-4), twin of src/deform/deform.cpp: the same
// operations in the same order, each rounded to float. The function jumps at its rim, so that one bit decides
// whether a vertex moves: `precise` forbids the compiler to contract or reorder.

#if __VERSION__ >= 400 || defined(GL_ARB_gpu_shader5)
#define PRECISE precise
#else
#define PRECISE
#endif

// Moves position p and turns unit normal n if p is within max_distance of the hit at h with unit direction d.
// constants: max_distance (m), power (m^2), max_magnitude (m). Returns whether it is.
bool deform(inout vec3 p, inout vec3 n, vec3 h, vec3 d, vec3 constants)
{
    PRECISE float dx = p.x - h.x;
    PRECISE float dy = p.y - h.y;
    PRECISE float dz = p.z - h.z;
    PRECISE float xx = dx * dx;
    PRECISE float yy = dy * dy;
    PRECISE float zz = dz * dz;
    PRECISE float xy = xx + yy;
    PRECISE float r2 = xy + zz;
    PRECISE float reach2 = constants.x * constants.x;
    if (!(r2 <= reach2)) {
        return false;
    }
    PRECISE float r = sqrt(r2);
    PRECISE float ratio = constants.y / r;
    // Equation 4; at r = 0 the ratio is infinite and the cap applies.
    PRECISE float m = r2 == 0.0 ? constants.z : min(ratio, constants.z);
    PRECISE vec3 v = d * m;
    PRECISE vec3 moved = p + v;
    p = moved;

    PRECISE vec3 s = n + v;
    PRECISE vec3 ss = s * s;
    PRECISE float ssxy = ss.x + ss.y;
    PRECISE float len2 = ssxy + ss.z;
    // Where the sum is (nearly) zero there is no direction to turn to.
    if (len2 > 1e-12) {
        PRECISE float len = sqrt(len2);
        PRECISE vec3 turned = vec3(s.x / len, s.y / len, s.z / len);
        n = turned;
    }
    return true;
}
