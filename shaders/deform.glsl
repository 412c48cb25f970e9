// SPDX-License-Identifier: GPL-3.0-or-later
// The deformation function (paper, Algorithm 3 and equations 1-4), twin of src/deform/deform.cpp: the same
// operations in the same order, each rounded to float. The function jumps at its rim, so that one bit decides
// whether a vertex moves: `precise` forbids the compiler to contract or reorder.

#if __VERSION__ >= 400 || defined(GL_ARB_gpu_shader5)
#define PRECISE precise
#else
#define PRECISE
#endif

// C++ has correctly rounded division and square root; OpenGL allows 2.5 units in the last place for a division and
// more for a root. HITSCOPE_EXACT_BY_FMA makes both correctly rounded on renderers whose fma is fused: the native
// result is corrected by its residual to less than one unit of the true one, and then the nearer of two neighbours is
// taken. All residuals that decide are exact for the numbers deform() has: none of them is denormal. Which variant a
// renderer needs is measured (src/pipeline/exactness.h).
#if defined(HITSCOPE_EXACT_BY_FMA) && (__VERSION__ >= 400 || defined(GL_ARB_gpu_shader5))

float exactDivide(float a, float b)  // b > 0
{
    PRECISE float top = abs(a);
    PRECISE float inverse = 1.0 / b;
    PRECISE float guess = top * inverse;
    PRECISE float error = fma(-b, guess, top);
    PRECISE float q = fma(error, inverse, guess);
    // The quotient lies between q and one of its neighbours, never halfway; the smaller residual is the nearer.
    PRECISE float rest = fma(-b, q, top);
    PRECISE float other = intBitsToFloat(floatBitsToInt(q) + (rest < 0.0 ? -1 : 1));
    PRECISE float otherRest = fma(-b, other, top);
    PRECISE float nearest = abs(otherRest) < abs(rest) ? other : q;
    return a > 0.0 ? nearest : a < 0.0 ? -nearest : a;
}

float exactSqrt(float x)  // x > 0
{
    PRECISE float guess = sqrt(x);
    PRECISE float error = fma(-guess, guess, x);
    PRECISE float slope = 0.5 / guess;
    PRECISE float root = fma(error, slope, guess);
    // Tuckerman's test: root is the rounded one just when below * root < x <= above * root.
    PRECISE float below = intBitsToFloat(floatBitsToInt(root) - 1);
    PRECISE float above = intBitsToFloat(floatBitsToInt(root) + 1);
    PRECISE float restBelow = fma(-below, root, x);
    PRECISE float restAbove = fma(-above, root, x);
    return restBelow <= 0.0 ? below : restAbove > 0.0 ? above : root;
}

#else

float exactDivide(float a, float b)
{
    PRECISE float q = a / b;
    return q;
}

float exactSqrt(float x)
{
    PRECISE float root = sqrt(x);
    return root;
}

#endif

// A component of a turned normal; see deform.cpp for the zero.
float turnedComponent(float s, float len)
{
    return abs(s) < 1e-20 ? 0.0 : exactDivide(s, len);
}

// Moves position p by v and turns unit normal n by it.
void push(inout vec3 p, inout vec3 n, vec3 v)
{
    PRECISE vec3 moved = p + v;
    p = moved;

    PRECISE vec3 s = n + v;
    PRECISE vec3 ss = s * s;
    PRECISE float ssxy = ss.x + ss.y;
    PRECISE float len2 = ssxy + ss.z;
    // Where the sum is (nearly) zero there is no direction to turn to.
    if (len2 > 1e-12) {
        PRECISE float len = exactSqrt(len2);
        PRECISE vec3 turned =
            vec3(turnedComponent(s.x, len), turnedComponent(s.y, len), turnedComponent(s.z, len));
        n = turned;
    }
}

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
    // Equation 4; at r = 0 the ratio is infinite and the cap applies. See deform.cpp for the 1e-22.
    PRECISE float m = constants.z;
    if (r2 >= 1e-22) {
        PRECISE float r = exactSqrt(r2);
        PRECISE float ratio = exactDivide(constants.y, r);
        m = min(ratio, constants.z);
    }
    PRECISE vec3 v = d * m;
    push(p, n, v);
    return true;
}

// HITSCOPE_FORMS  defined: hits may have another form than the paper's
#ifdef HITSCOPE_FORMS
#include "dent_forms.glsl"
#endif
