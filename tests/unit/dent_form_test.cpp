// SPDX-License-Identifier: GPL-3.0-or-later
// The forms of dents: what they do to a flat grid, which is known without them, and what holds for all hits.
#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "deform/dent_form_text.h"
#include "deform/fingerprint.h"
#include "deform/reference.h"
#include "deform_support.h"
#include "dent_form_support.h"
#include "mesh/geodesic_sphere.h"
#include "support/test_program.h"

namespace hitscope::dent_form_test {

using namespace test;

namespace {

constexpr float kReach = 0.5f;
constexpr float kDepth = 0.1f;
constexpr DeformationConstants kConstants{kReach, 0.02f, kDepth};

double magnitudeAt(const DentForm& form, double distance) {
    return static_cast<double>(magnitudeOnPlane(form, kConstants, static_cast<float>(distance)));
}

/// How fast it grows towards the middle, within the last `step` metres.
double slopeAt(const DentForm& form, double distance, double step = 1.0e-3) {
    return (magnitudeAt(form, distance - step) - magnitudeAt(form, distance)) / step;
}

/// Of what is pushed below a flat grid of cells of 1 mm, cubic metres.
double volumeUnderGrid(const DentForm& form) {
    constexpr int kHalf = 510;
    constexpr float kCell = 1.0e-3f;
    Hit hit;
    hit.constants = kConstants;
    hit.form = form;
    const DentShape dent = dentShapeOf(hit);
    double volume = 0.0;
    for (int row = -kHalf; row <= kHalf; ++row) {
        for (int column = -kHalf; column <= kHalf; ++column) {
            glm::vec3 position(kCell * static_cast<float>(column), kCell * static_cast<float>(row), 0.0f);
            glm::vec3 normal(0.0f, 0.0f, 1.0f);
            deform(position, normal, dent);
            volume -= static_cast<double>(position.z) * 1.0e-6;
        }
    }
    return volume;
}

bool isNear(double actual, double expected, double tolerance) {
    if (std::abs(actual - expected) > tolerance) {
        qWarning("%.9g is not %.9g within %.3g", actual, expected, tolerance);
        return false;
    }
    return true;
}

}  // namespace

class DentFormTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void depthIsMaxMagnitude_data();
    void depthIsMaxMagnitude();
    void rims();
    void smoothIsThePapersUpToHalf();
    void craterKeepsTheVolume();
    void volumesAreThoseOfTheFormulas();
    void pressHasTheSpheresShape();
    void pressGoesHalfIn();
    void pressFadesBehindTheSphere();
    void curvePassesItsPointsAndStaysBetween();
    void curveOfALineIsLinear();
    void intoTheSurface();
    void formsWithoutEffectAreOne();
    void whatNoHitCanHave();
    void texts();
    void papersFingerprintStays();
};

void DentFormTest::depthIsMaxMagnitude_data() {
    QTest::addColumn<int>("profile");
    for (std::size_t i = 0; i < kDentProfileKeys.size(); ++i) {
        QTest::newRow(std::string(kDentProfileKeys[i]).c_str()) << static_cast<int>(i);
    }
}

void DentFormTest::depthIsMaxMagnitude() {
    QFETCH(const int, profile);
    QCOMPARE(magnitudeOnPlane(formOf(static_cast<DentProfile>(profile)), kConstants, 0.0f), kDepth);
}

/// The paper's jumps; those that are said to end smoothly have no height and no slope there; the line's slope
/// is its own.
void DentFormTest::rims() {
    const double reach = static_cast<double>(kReach);
    QVERIFY(isNear(magnitudeAt(formOf(DentProfile::Paper), reach), 0.04, 1e-8));
    for (const auto profile : {DentProfile::Smooth, DentProfile::Wendland, DentProfile::Crater}) {
        const DentForm form = formOf(profile);
        QVERIFY(isNear(magnitudeAt(form, reach), 0.0, 1e-8));
        QVERIFY(isNear(slopeAt(form, reach, 1e-4), 0.0, 2e-3));
    }
    QVERIFY(isNear(magnitudeAt(formOf(DentProfile::Linear), reach), 0.0, 1e-8));
    QVERIFY(isNear(slopeAt(formOf(DentProfile::Linear), reach), 0.2, 1e-4));
    for (const DentForm& form : {formOf(DentProfile::Smooth), pressOf(0.2f)}) {
        for (int i = 2; i < 600; ++i) {  // no step anywhere, of 1 mm or more a millimetre but in walls
            const double step = std::abs(slopeAt(form, 1e-3 * i) - slopeAt(form, 1e-3 * (i - 1)));
            QVERIFY2(step < 0.25 || std::abs(1e-3 * i - 0.2) < 0.002, qPrintable(QString::number(i)));
        }
    }
    QCOMPARE(magnitudeAt(formOf(DentProfile::Wendland), 0.501), 0.0);
}

void DentFormTest::smoothIsThePapersUpToHalf() {
    for (int i = 0; i <= 250; ++i) {
        const float r = 1e-3f * static_cast<float>(i);
        QCOMPARE(magnitudeOnPlane(formOf(DentProfile::Smooth), kConstants, r),
                 magnitudeOnPlane(formOf(DentProfile::Paper), kConstants, r));
    }
    QVERIFY(isNear(magnitudeAt(formOf(DentProfile::Smooth), 0.375), 0.5 * 0.02 / 0.375, 1e-6));
}

/// The rim stands a quarter of the depth high at R / sqrt(2), and holds what the dent has lost.
void DentFormTest::craterKeepsTheVolume() {
    const DentForm crater = formOf(DentProfile::Crater);
    QVERIFY(isNear(magnitudeAt(crater, 0.5 / std::sqrt(2.0)), -0.025, 1e-6));
    QVERIFY(isNear(magnitudeAt(crater, 0.25), 0.0, 1e-6));
    const double below = volumeUnderGrid(formOf(DentProfile::Linear));
    QVERIFY(isNear(volumeUnderGrid(crater), 0.0, 1e-4 * below));
}

void DentFormTest::volumesAreThoseOfTheFormulas() {
    constexpr double kPi = 3.14159265358979;
    const double disc = kPi * 0.25 * 0.1;  // cubic metres: pi R^2 M
    QVERIFY(isNear(volumeUnderGrid(formOf(DentProfile::Linear)), disc / 3.0, 1e-4 * disc));
    // 2 pi M R^2 times the integral of u (1 - u)^4 (4 u + 1), which is 1/14.
    QVERIFY(isNear(volumeUnderGrid(formOf(DentProfile::Wendland)), disc / 7.0, 1e-4 * disc));
    // Cap up to 0.2 m, then power / r up to the rim.
    const double paper = kPi * 0.04 * 0.1 + 2.0 * kPi * 0.02 * 0.3;
    QVERIFY(isNear(volumeUnderGrid(formOf(DentProfile::Paper)), paper, 2e-3 * paper));
}

void DentFormTest::pressHasTheSpheresShape() {
    constexpr double kRadius = 0.4;
    const DentForm press = pressOf(0.4f);
    // Below the shoulder, half of which is an eighth of the radius at most, and half of the depth.
    const double shoulder = std::min(0.125 * kRadius, 0.05);
    double previous = 1.0;
    for (double r = 0.0; r < kRadius; r += 1e-3) {
        const double sphere = 0.1 - (kRadius - std::sqrt(kRadius * kRadius - r * r));
        const double depth = magnitudeAt(press, r);
        if (sphere >= shoulder) {
            QVERIFY(isNear(depth, sphere, 1e-6));
        }
        QVERIFY(depth <= previous && depth >= 0.0);
        previous = depth;
    }
    QCOMPARE(magnitudeAt(press, kRadius), 0.0);
}

/// However large max_magnitude is; and a sphere that only touches does nothing.
void DentFormTest::pressGoesHalfIn() {
    QVERIFY(isNear(magnitudeAt(pressOf(0.05f), 0.0), 0.05, 1e-7));
    QCOMPARE(magnitudeOnPlane(pressOf(0.05f), {0.5f, 0.02f, 0.0f}, 0.0f), 0.0f);
    // A surface that is hit at a slant: the point itself goes as deep all the same.
    Hit hit;
    hit.direction = glm::normalize(glm::vec3(0.5f, 0.0f, -1.0f));
    hit.normal = {0.0f, 0.0f, 1.0f};
    hit.constants = kConstants;
    hit.form = pressOf(0.4f);
    const std::optional<Contribution> made = contributionTo(hit.point, hit);
    QVERIFY(made.has_value());
    QVERIFY(isNear(static_cast<double>(made->magnitude), 0.1, 1e-6));
    QCOMPARE(made->distance, 0.0f);
}

/// What is behind the sphere goes along with it up to 1.25 radii from its middle, then less and less, up to
/// two radii.
void DentFormTest::pressFadesBehindTheSphere() {
    constexpr float kRadius = 0.4f;
    Hit hit;
    hit.direction = {0.0f, 0.0f, -1.0f};
    hit.normal = {0.0f, 0.0f, 1.0f};
    hit.constants = kConstants;
    hit.form = pressOf(kRadius);
    const glm::vec3 middle(0.0f, 0.0f, kRadius - kDepth);
    const auto pushedAt = [&](float radii) {
        const glm::vec3 behind = middle + glm::vec3(0.0f, 0.0f, radii * kRadius);
        const std::optional<Contribution> made = contributionTo(behind, hit);
        return made ? static_cast<double>(made->magnitude) : 0.0;
    };
    const auto toFront = [](double radii) { return (1.0 + radii) * 0.4; };  // metres, all the way
    QVERIFY(isNear(pushedAt(1.2f), toFront(1.2), 1e-6));
    for (const double radii : {1.4, 1.625, 1.9}) {
        const double t = (radii - 1.25) / 0.75;
        const double share = 1.0 - t * t * (3.0 - 2.0 * t);
        QVERIFY(isNear(pushedAt(static_cast<float>(radii)), share * toFront(radii), 1e-5));
    }
    QCOMPARE(pushedAt(2.01f), 0.0);
}

void DentFormTest::curvePassesItsPointsAndStaysBetween() {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> share(-1.0f, 1.0f);
    for (int i = 0; i < 200; ++i) {
        DentForm form = formOf(DentProfile::Curve);
        std::generate(form.curve.begin(), form.curve.end(), [&] { return share(random); });
        for (std::size_t k = 0; k < kCurvePoints; ++k) {
            const double at = static_cast<double>(kReach) * static_cast<double>(k) / 7.0;
            const double ordinate = static_cast<double>(form.curve[k] * kDepth);
            QVERIFY(isNear(magnitudeAt(form, at), ordinate, 2e-6));
            if (k + 1 == kCurvePoints) {
                continue;
            }
            const auto [low, high] = std::minmax(form.curve[k], form.curve[k + 1]);
            for (int part = 1; part < 16; ++part) {
                const float r = kReach * (static_cast<float>(k) + static_cast<float>(part) / 16.0f) / 7.0f;
                const float m = magnitudeOnPlane(form, kConstants, r) / kDepth;
                QVERIFY(m >= low - 2e-6f && m <= high + 2e-6f);
            }
        }
    }
}

void DentFormTest::curveOfALineIsLinear() {
    DentForm form = formOf(DentProfile::Curve);
    for (std::size_t k = 0; k < kCurvePoints; ++k) {
        form.curve[k] = 1.0f - static_cast<float>(k) / 7.0f;
    }
    for (int i = 0; i <= 500; ++i) {
        QVERIFY(
            isNear(magnitudeAt(form, 1e-3 * i), magnitudeAt(formOf(DentProfile::Linear), 1e-3 * i), 1e-7));
    }
}

void DentFormTest::intoTheSurface() {
    Hit hit;
    hit.direction = {1.0f, 0.0f, 0.0f};
    hit.normal = {0.0f, 0.0f, 2.0f};
    hit.form.direction = DentDirection::IntoSurface;
    glm::vec3 position(0.0f);
    glm::vec3 normal(0.0f, 0.0f, 1.0f);
    QVERIFY(deform(position, normal, hit));
    QCOMPARE(position, glm::vec3(0.0f, 0.0f, -0.3f));
    hit.normal = glm::vec3(0.0f);  // not known: as the projectile flew
    position = glm::vec3(0.0f);
    QVERIFY(deform(position, normal, hit));
    QCOMPARE(position, glm::vec3(0.3f, 0.0f, 0.0f));
}

void DentFormTest::formsWithoutEffectAreOne() {
    DentForm form;
    form.radius = 3.0f;
    form.curve[2] = -1.0f;
    QVERIFY(plain(form) == DentForm());
    form.profile = DentProfile::Curve;
    QCOMPARE(plain(form).curve, form.curve);
    QCOMPARE(plain(form).radius, 0.0f);
    form.direction = DentDirection::Press;
    QVERIFY(plain(form) == pressOf(3.0f));
}

void DentFormTest::whatNoHitCanHave() {
    const auto refused = [](const DentForm& form) {
        Hit hit;
        hit.form = form;
        return !checkedHit(hit).ok();
    };
    QVERIFY(refused(pressOf(0.0f)));
    QVERIFY(refused(pressOf(std::nanf(""))));
    QVERIFY(refused(pressOf(INFINITY)));
    DentForm curve = formOf(DentProfile::Curve);
    QVERIFY(!refused(curve));
    curve.curve[3] = 1.001f;
    QVERIFY(refused(curve));
    curve.curve[3] = std::nanf("");
    QVERIFY(refused(curve));
    curve.profile = DentProfile::Linear;  // has no part in it
    QVERIFY(!refused(curve));
    QVERIFY(refused(formOf(static_cast<DentProfile>(6))));
}

void DentFormTest::texts() {
    for (const std::string_view key : kDentProfileKeys) {
        QCOMPARE(keyOf(profileNamed(key).value()), key);
    }
    for (const std::string_view key : kDentDirectionKeys) {
        QCOMPARE(keyOf(directionNamed(key).value()), key);
    }
    QVERIFY(!profileNamed("Paper") && !directionNamed(""));
    const CurveOrdinates curve{1.0f, 0.1f, -0.25f, 1.0f / 3.0f, 0.0f, -1.0f, 1e-5f, 0.0f};
    QCOMPARE(curveFrom(curveText(curve)).value(), curve);
    QCOMPARE(curveText(kUsualCurve, ' '), std::string("1 0.95 0.8 0.55 0.3 0.12 0.03 0"));
    for (const char* wrong : {"", "1,1,1,1,1,1,1", "1,1,1,1,1,1,1,1,1", "1,1,1,1,1,1,1,2",
                              "1,1,1,1,1,1,1,nan", "1,1,1,1,1,1,1,", "1;1;1;1;1;1;1;1", "1,1,1,1,1,1,1,1 "}) {
        QVERIFY2(!curveFrom(wrong), wrong);
    }
}

void DentFormTest::papersFingerprintStays() {
    Hit hit;
    hit.target = TargetId{1};
    const std::vector<TargetId> targets{hit.target};
    const auto print = [&](const DentForm& form) {
        hit.form = form;
        return hitsFingerprint(std::span(&hit, 1), targets);
    };
    QCOMPARE(fingerprintText(print({})), std::string("f9fddf41e8903eb7"));
    std::vector<std::uint64_t> all{print({})};
    for (std::size_t i = 1; i < kDentProfileKeys.size(); ++i) {
        all.push_back(print(formOf(static_cast<DentProfile>(i))));
    }
    all.push_back(print(pressOf(0.1f)));
    all.push_back(print(pressOf(0.2f)));
    DentForm curve = formOf(DentProfile::Curve);
    curve.curve[7] = 0.5f;
    all.push_back(print(curve));
    std::sort(all.begin(), all.end());
    QVERIFY(std::adjacent_find(all.begin(), all.end()) == all.end());
}

HITSCOPE_TEST(DentFormTest, QCoreApplication)

}  // namespace hitscope::dent_form_test

#include "dent_form_test.moc"
