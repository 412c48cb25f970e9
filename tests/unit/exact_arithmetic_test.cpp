// SPDX-License-Identifier: GPL-3.0-or-later
// exactDivide() and exactSqrt() of shaders/deform.glsl, modelled with std::fma on a processor whose own
// division and root are off by some units in the last place, as graphics processors' are: the result must be
// the correctly rounded one all the same.
#include <QTest>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "support/test_program.h"

namespace hitscope::exact_arithmetic_test {

namespace {

float stepped(float x, int units) {
    return std::bit_cast<float>(std::bit_cast<std::int32_t>(x) + units);
}

/// Operations as a graphics processor might have them: so many units in the last place off.
struct Native {
    int divisionOff = 0;
    int rootOff = 0;
    /// The processor has no denormal numbers.
    bool flushes = false;

    [[nodiscard]] float flushed(float x) const {
        return flushes && std::abs(x) < std::numeric_limits<float>::min() ? std::copysign(0.0f, x) : x;
    }
    [[nodiscard]] float divide(float a, float b) const { return flushed(stepped(a / b, divisionOff)); }
    [[nodiscard]] float root(float x) const { return stepped(std::sqrt(x), rootOff); }
    [[nodiscard]] float fma(float a, float b, float c) const {
        return flushed(std::fma(flushed(a), flushed(b), flushed(c)));
    }
};

float exactDivide(const Native& native, float a, float b) {
    const float top = std::abs(a);
    const float inverse = native.divide(1.0f, b);
    const float guess = native.flushed(top * inverse);
    const float error = native.fma(-b, guess, top);
    const float q = native.fma(error, inverse, guess);
    const float rest = native.fma(-b, q, top);
    const float other = stepped(q, rest < 0.0f ? -1 : 1);
    const float otherRest = native.fma(-b, other, top);
    const float nearest = std::abs(otherRest) < std::abs(rest) ? other : q;
    return a > 0.0f ? nearest : a < 0.0f ? -nearest : a;
}

float exactSqrt(const Native& native, float x) {
    const float guess = native.root(x);
    const float error = native.fma(-guess, guess, x);
    const float slope = native.divide(0.5f, guess);
    const float root = native.fma(error, slope, guess);
    const float below = stepped(root, -1);
    const float above = stepped(root, 1);
    const float restBelow = native.fma(-below, root, x);
    const float restAbove = native.fma(-above, root, x);
    return restBelow <= 0.0f ? below : restAbove > 0.0f ? above : root;
}

bool same(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

class Random {
public:
    explicit Random(unsigned seed) : m_random(seed) {}
    int below(int end) { return static_cast<int>(m_random() % static_cast<unsigned>(end)); }
    /// Every float between two positive ones, all exponents alike.
    float between(float least, float most) {
        const auto first = std::bit_cast<std::uint32_t>(least);
        const auto last = std::bit_cast<std::uint32_t>(most);
        return std::bit_cast<float>(first + static_cast<std::uint32_t>(m_random() % (last - first + 1)));
    }
    Native native() { return {below(7) - 3, below(7) - 3, below(2) == 0}; }

private:
    std::mt19937 m_random;
};

// The ranges of deform(): r2 from 1e-22 (below, the cap applies) to a reach of 100 m, and len2.
constexpr float kLeastSquare = 1e-22f;
constexpr float kMostSquare = 1e6f;
constexpr float kMostNumber = 200.0f;

constexpr std::uint32_t kMantissas = 1u << 23;

}  // namespace

class ExactArithmeticTest : public QObject {
    Q_OBJECT

private:
    /// Fails with the numbers in the message.
    static bool divides(const Native& native, float a, float b) {
        const float quotient = exactDivide(native, a, b);
        if (!same(quotient, a / b)) {
            qWarning("%a / %a: %a instead of %a, native off by %d", double{a}, double{b}, double{quotient},
                     double{a / b}, native.divisionOff);
            return false;
        }
        return true;
    }
    static bool takesRoot(const Native& native, float x) {
        const float root = exactSqrt(native, x);
        if (!same(root, std::sqrt(x))) {
            qWarning("root of %a: %a instead of %a, native off by %d and %d", double{x}, double{root},
                     double{std::sqrt(x)}, native.divisionOff, native.rootOff);
            return false;
        }
        return true;
    }

private Q_SLOTS:
    void powerOverDistance() {
        Random random(1);
        for (int i = 0; i < 2'000'000; ++i) {
            const float r = std::sqrt(random.between(kLeastSquare, kMostSquare));
            QVERIFY(divides(random.native(), random.between(1e-15f, 100.0f), r));
        }
    }

    void normalOverLength() {
        Random random(2);
        for (int i = 0; i < 2'000'000; ++i) {
            const float s = random.between(1e-20f, kMostNumber);
            QVERIFY(
                divides(random.native(), random.below(2) == 0 ? s : -s, random.between(1e-6f, kMostNumber)));
        }
    }

    /// All mantissas as divisor, and as dividend of the divisor that is known to defeat Newton's iteration.
    void everyMantissaDivides() {
        Random random(3);
        const float mostOnes = std::nextafter(2.0f, 0.0f);
        for (std::uint32_t i = 0; i < kMantissas; ++i) {
            const float x = std::bit_cast<float>(std::bit_cast<std::uint32_t>(1.0f) + i);
            QVERIFY(divides(random.native(), random.between(1.0f, 4.0f), x));
            QVERIFY(divides(random.native(), x, mostOnes));
        }
    }

    /// Quotients that lie as close to the middle between two numbers as they can: the dividend is the number
    /// nearest to the divisor times such a middle.
    void quotientsNearTheMiddle() {
        Random random(4);
        for (int i = 0; i < 2'000'000; ++i) {
            const float b = random.between(1.0f, 2.0f);
            const float q = random.between(1.0f, 2.0f);
            const double middle = (double{q} + double{std::nextafter(q, 4.0f)}) / 2.0;
            QVERIFY(divides(random.native(), static_cast<float>(middle * double{b}), b));
        }
    }

    void exactQuotientsAndZeros() {
        Random random(5);
        for (int i = 0; i < 100'000; ++i) {
            const auto whole = static_cast<float>(1 + random.below(4095));
            const auto other = static_cast<float>(1 + random.below(4095));
            QVERIFY(divides(random.native(), whole * other, other));
            QVERIFY(divides(random.native(), whole, whole));
            QVERIFY(divides(random.native(), 0.0f, whole));
            QVERIFY(divides(random.native(), -0.0f, whole));
        }
    }

    void distances() {
        Random random(6);
        for (int i = 0; i < 4'000'000; ++i) {
            QVERIFY(takesRoot(random.native(), random.between(kLeastSquare, kMostSquare)));
        }
    }

    void everyMantissaHasARoot() {
        Random random(7);
        for (std::uint32_t i = 0; i < 2 * kMantissas; ++i) {
            QVERIFY(takesRoot(random.native(), std::bit_cast<float>(std::bit_cast<std::uint32_t>(1.0f) + i)));
        }
    }

    void exactRootsAndTheirNeighbours() {
        for (int off = -3; off <= 3; ++off) {
            for (int whole = 1; whole < 4096; ++whole) {
                for (const float scale : {0x1p-60f, 0x1p-20f, 1.0f}) {
                    const float square = static_cast<float>(whole * whole) * scale;
                    for (int step = -2; step <= 2; ++step) {
                        QVERIFY(takesRoot({off, off, true}, stepped(square, step)));
                        QVERIFY(takesRoot({-off, off, false}, stepped(square, step)));
                    }
                }
            }
        }
    }
};

HITSCOPE_TEST(ExactArithmeticTest, QCoreApplication)

}  // namespace hitscope::exact_arithmetic_test

#include "exact_arithmetic_test.moc"
