// SPDX-License-Identifier: GPL-3.0-or-later
// The terms of the paper's equations 12 and 14.

// Equation 12, its numerator and denominator divided by the constant factor; factors: linear, quadratic.
float weakened(vec2 factors, float d)
{
    return max(1.0 + (factors.x + factors.y * d) * d, 1.0e-4);
}
float attenuation(vec2 factors, float d)
{
    return 1.0 / weakened(factors, d);
}

// Equation 14, with cosines for angles: one inside the inner cone, zero outside the outer. cone: the outer cosine,
// and one over how much larger the inner one is.
float withinCone(vec2 cone, float cosine)
{
    return clamp((cosine - cone.x) * cone.y, 0.0, 1.0);
}
