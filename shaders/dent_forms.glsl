// SPDX-License-Identifier: GPL-3.0-or-later
// The forms of dents beside the paper's; twin of the same part of src/deform/deform.cpp, as deform.glsl is. Numbers of a
// hit are those of DentShape (src/deform/dent_shape.h).

// DentKind
const int kSmooth = 1;
const int kWendland = 2;
const int kLinear = 3;
const int kCrater = 4;
const int kCurve = 5;
const int kPress = 6;

// Who includes this has it: ordinate and slope of two neighbouring points, pair 0 to 3, of a curve.
vec4 curveTerms(int curve, int pair);

// The share that is left at t, [0, 1], of the way to the rim.
float fadedOut(float t)
{
    PRECISE float left = 1.0 - (t * t) * (3.0 - (t + t));
    return left;
}

float smoothMagnitude(float r, float reach, float power, float cap)
{
    PRECISE float m = cap;
    if (r > 0.0) {
        PRECISE float ratio = exactDivide(power, r);
        m = min(ratio, cap);
    }
    PRECISE float halfReach = 0.5 * reach;
    if (r > halfReach) {
        PRECISE float beyond = r - halfReach;
        PRECISE float t = min(exactDivide(beyond, halfReach), 1.0);
        m = m * fadedOut(t);
    }
    return m;
}

float curveMagnitude(float u, float cap, int curve)
{
    PRECISE float x = u * 7.0;
    int i = min(int(x), 6);
    PRECISE float t = x - float(i);
    vec4 here = curveTerms(curve, i >> 1);
    vec4 next = curveTerms(curve, (i + 1) >> 1);
    bool isEven = (i & 1) == 0;
    float y0 = isEven ? here.x : here.z;
    float d0 = isEven ? here.y : here.w;
    float y1 = isEven ? next.z : next.x;
    float d1 = isEven ? next.w : next.y;
    PRECISE float span = y1 - y0;
    PRECISE float c2 = (3.0 * span - (d0 + d0)) - d1;
    PRECISE float c3 = (d0 + d1) - (span + span);
    PRECISE float m = cap * (y0 + t * (d0 + t * (c2 + t * c3)));
    return m;
}

float pressMagnitude(vec3 q, float r2, vec3 d, float reach, float radius, float width)
{
    PRECISE float a = (q.x * d.x + q.y * d.y) + q.z * d.z;
    PRECISE vec3 l = q - d * a;
    PRECISE float b2 = (l.x * l.x + l.y * l.y) + l.z * l.z;
    PRECISE float edge = radius * 0.9230769;
    PRECISE float front = 0.0;
    if (b2 <= edge * edge) {
        PRECISE float x = radius * radius - b2;
        front = exactSqrt(x);
    } else {
        PRECISE float b = exactSqrt(b2);
        front = radius * 0.3846154 - 2.4 * (b - edge);
    }
    PRECISE float g = front - a;
    if (!(g > -width) || !(width > 0.0)) {
        return 0.0;
    }
    PRECISE float m = g;
    if (g < width) {
        PRECISE float t = g + width;
        PRECISE float share = exactDivide(t, width + width);
        m = (0.5 * t) * share;
    }
    PRECISE float whole = radius * 1.25;
    if (r2 > whole * whole) {
        PRECISE float beyond = exactSqrt(r2) - whole;
        PRECISE float t = min(exactDivide(beyond, reach - whole), 1.0);
        m = m * fadedOut(t);
    }
    return m;
}

float magnitudeOf(int kind, int curve, vec3 q, float r2, vec3 d, vec3 constants)
{
    float reach = constants.x;
    float cap = constants.z;
    if (kind == kPress) {
        return pressMagnitude(q, r2, d, reach, constants.y, cap);
    }
    if (kind == kCrater) {
        PRECISE float s = 0.0;
        if (r2 >= 1e-22) {
            PRECISE float reach2 = reach * reach;
            s = min(exactDivide(r2, reach2), 1.0);
        }
        PRECISE float k = 1.0 - s;
        PRECISE float m = cap * ((k * k) * (1.0 - 4.0 * s));
        return m;
    }
    PRECISE float r = 0.0;
    if (r2 >= 1e-22) {
        r = exactSqrt(r2);
    }
    if (kind == kSmooth) {
        return smoothMagnitude(r, reach, constants.y, cap);
    }
    PRECISE float u = min(exactDivide(r, reach), 1.0);
    if (kind == kCurve) {
        return curveMagnitude(u, cap, curve);
    }
    PRECISE float k = 1.0 - u;
    PRECISE float m = cap * k;
    if (kind == kWendland) {
        m = cap * (((k * k) * (k * k)) * (4.0 * u + 1.0));
    }
    return m;
}

// code: the kind, and 8 times the place of the curve.
bool isPaperForm(float code)
{
    return (int(code) & 7) == 0;
}

// As deform(), of a hit of another form.
bool deformByForm(inout vec3 p, inout vec3 n, vec3 h, vec3 d, vec3 constants, float code)
{
    int kind = int(code) & 7;
    PRECISE vec3 q = p - h;
    PRECISE float r2 = (q.x * q.x + q.y * q.y) + q.z * q.z;
    PRECISE float reach2 = constants.x * constants.x;
    if (!(r2 <= reach2)) {
        return false;
    }
    PRECISE float m = magnitudeOf(kind, int(code) >> 3, q, r2, d, constants);
    if (!(abs(m) >= 1e-15)) {
        return false;
    }
    PRECISE vec3 v = d * m;
    push(p, n, v);
    return true;
}
