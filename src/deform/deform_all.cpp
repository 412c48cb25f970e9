// SPDX-License-Identifier: GPL-3.0-or-later
#include "deform/deform_all.h"

#include "deform/deform.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace hitscope {
namespace {

#ifdef __SSE2__

static_assert(sizeof(DynamicVertex) == 6 * sizeof(float), "three floats of a position, three of a normal");

/// Four floats; the operators are those of the processor, each rounded as a float's own.
struct Four {
    __m128 v;
    Four(__m128 four) : v(four) {}
    Four(float one) : v(_mm_set1_ps(one)) {}
};
Four operator+(Four a, Four b) {
    return _mm_add_ps(a.v, b.v);
}
Four operator-(Four a, Four b) {
    return _mm_sub_ps(a.v, b.v);
}
Four operator*(Four a, Four b) {
    return _mm_mul_ps(a.v, b.v);
}
Four operator/(Four a, Four b) {
    return _mm_div_ps(a.v, b.v);
}
// All bits set where it is true; false of a NaN.
Four operator<(Four a, Four b) {
    return _mm_cmplt_ps(a.v, b.v);
}
Four operator<=(Four a, Four b) {
    return _mm_cmple_ps(a.v, b.v);
}
Four operator&(Four a, Four b) {
    return _mm_and_ps(a.v, b.v);
}
Four chosen(Four which, Four yes, Four no) {
    return _mm_or_ps(_mm_and_ps(which.v, yes.v), _mm_andnot_ps(which.v, no.v));
}
Four root(Four a) {
    return _mm_sqrt_ps(a.v);
}

/// Three components of four vectors.
struct FourVectors {
    Four x;
    Four y;
    Four z;
};

struct FourVertices {
    FourVectors position;
    FourVectors normal;
};

FourVertices taken(const DynamicVertex* vertices) {
    const auto* const f = reinterpret_cast<const float*>(vertices);
    // Each row: position and the normal's x; then columns.
    __m128 px = _mm_loadu_ps(f);
    __m128 py = _mm_loadu_ps(f + 6);
    __m128 pz = _mm_loadu_ps(f + 12);
    __m128 nx = _mm_loadu_ps(f + 18);
    _MM_TRANSPOSE4_PS(px, py, pz, nx);
    // Pairs of the normal's y and z.
    const auto pairs = [f](int first, int second) {
        const __m128 low = _mm_loadl_pi(_mm_setzero_ps(), reinterpret_cast<const __m64*>(f + first));
        return _mm_loadh_pi(low, reinterpret_cast<const __m64*>(f + second));
    };
    const __m128 a = pairs(4, 10);
    const __m128 b = pairs(16, 22);
    return {{px, py, pz}, {nx, _mm_shuffle_ps(a, b, 0x88), _mm_shuffle_ps(a, b, 0xdd)}};
}

void put(const FourVertices& four, DynamicVertex* vertices) {
    auto* const f = reinterpret_cast<float*>(vertices);
    __m128 first = four.position.x.v;
    __m128 second = four.position.y.v;
    __m128 third = four.position.z.v;
    __m128 fourth = four.normal.x.v;
    _MM_TRANSPOSE4_PS(first, second, third, fourth);
    _mm_storeu_ps(f, first);
    _mm_storeu_ps(f + 6, second);
    _mm_storeu_ps(f + 12, third);
    _mm_storeu_ps(f + 18, fourth);
    const __m128 low = _mm_unpacklo_ps(four.normal.y.v, four.normal.z.v);
    const __m128 high = _mm_unpackhi_ps(four.normal.y.v, four.normal.z.v);
    _mm_storel_pi(reinterpret_cast<__m64*>(f + 4), low);
    _mm_storeh_pi(reinterpret_cast<__m64*>(f + 10), low);
    _mm_storel_pi(reinterpret_cast<__m64*>(f + 16), high);
    _mm_storeh_pi(reinterpret_cast<__m64*>(f + 22), high);
}

Four squareOf(const FourVectors& v) {
    return (v.x * v.x + v.y * v.y) + v.z * v.z;
}

// The operations of deform.cpp in their order, for the paper's form.
void deformFour(DynamicVertex* vertices, const DentShape& dent) {
    FourVertices four = taken(vertices);
    FourVectors& p = four.position;
    FourVectors& n = four.normal;
    const Four r2 = squareOf({p.x - dent.point.x, p.y - dent.point.y, p.z - dent.point.z});
    const Four isReached = r2 <= Four(dent.reach * dent.reach);
    if (_mm_movemask_ps(isReached.v) == 0) {
        return;
    }
    const Four cap = dent.magnitude;
    const Four ratio = Four(dent.power) / root(r2);
    const Four m = chosen((Four(kNoDistance2) <= r2) & (ratio < cap), ratio, cap);
    const FourVectors v{Four(dent.direction.x) * m, Four(dent.direction.y) * m, Four(dent.direction.z) * m};
    p = {chosen(isReached, p.x + v.x, p.x), chosen(isReached, p.y + v.y, p.y),
         chosen(isReached, p.z + v.z, p.z)};
    const FourVectors s{n.x + v.x, n.y + v.y, n.z + v.z};
    const Four len2 = squareOf(s);
    const Four length = root(len2);
    const Four isTurned = isReached & (Four(kNoLength2) < len2);
    const auto turned = [&](Four sum, Four before) {
        const Four size = _mm_andnot_ps(_mm_set1_ps(-0.0f), sum.v);
        const Four is = chosen(size < Four(kNoComponent), Four(0.0f), sum / length);
        return chosen(isTurned, is, before);
    };
    n = {turned(s.x, n.x), turned(s.y, n.y), turned(s.z, n.z)};
    put(four, vertices);
}

#endif

}  // namespace

void deformAll(std::span<DynamicVertex> vertices, const DentShape& dent) {
    std::size_t i = 0;
#ifdef __SSE2__
    if (dent.kind == DentKind::Paper) {
        for (; i + 4 <= vertices.size(); i += 4) {
            deformFour(&vertices[i], dent);
        }
    }
#endif
    for (DynamicVertex& vertex : vertices.subspan(i)) {
        deform(vertex.position, vertex.normal, dent);
    }
}

}  // namespace hitscope
