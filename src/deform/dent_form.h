// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace hitscope {

/// How far a vertex moves by its distance r from the hit point, up to R = max_distance. M is max_magnitude;
/// only the first two use power.
enum class DentProfile : std::uint8_t {
    Paper,     ///< min(power / r, M): the paper's function, which ends in a step of power / R
    Smooth,    ///< the paper's up to R / 2, from there brought to zero at R with a continuous slope
    Wendland,  ///< M (1 - u)^4 (4 u + 1), u = r / R: Wendland's C2 kernel of compact support
    Linear,    ///< M (1 - u)
    Crater,    ///< M (1 - u^2)^2 (1 - 4 u^2): a raised rim; on a flat surface the volume stays
    Curve      ///< M times a monotone cubic through the eight ordinates of DentForm::curve
};

/// Which way vertices move.
enum class DentDirection : std::uint8_t {
    Projectile,   ///< the hit's direction (the paper's)
    IntoSurface,  ///< against the surface's normal at the hit; the hit's direction where that is not known
    Press         ///< the hit's direction, out of the projectile's sphere: the dent has its shape
};

inline constexpr std::size_t kCurvePoints = 8;
/// Shares of max_magnitude at r = 0, R / 7, ... R; [-1, 1], negative ones raise.
using CurveOrdinates = std::array<float, kCurvePoints>;
/// A smooth bell, to begin with.
inline constexpr CurveOrdinates kUsualCurve{1.0f, 0.95f, 0.8f, 0.55f, 0.3f, 0.12f, 0.03f, 0.0f};

/// The form of a hit's dent. The usual one is the paper's.
struct DentForm {
    CurveOrdinates curve = kUsualCurve;  ///< of DentProfile::Curve
    /// Metres, local frame: of the sphere of DentDirection::Press, which takes the place of the profile.
    float radius = 0.0f;
    DentProfile profile = DentProfile::Paper;
    DentDirection direction = DentDirection::Projectile;

    bool operator==(const DentForm&) const = default;

    /// The paper's own function, with the projectile's direction.
    [[nodiscard]] bool isPaper() const {
        return profile == DentProfile::Paper && direction == DentDirection::Projectile;
    }
    /// Likewise, whichever way vertices move.
    [[nodiscard]] bool hasPaperFunction() const { return profile == DentProfile::Paper && !presses(); }
    [[nodiscard]] bool presses() const { return direction == DentDirection::Press; }
    /// Which constants have a part in it.
    [[nodiscard]] bool usesDistance() const { return !presses(); }
    [[nodiscard]] bool usesPower() const {
        return !presses() && (profile == DentProfile::Paper || profile == DentProfile::Smooth);
    }
};

/// Metres: what the radius of a hit that presses may be.
inline constexpr float kLeastPressRadius = 1.0e-9f;
inline constexpr float kMostPressRadius = 1.0e9f;

/// Their names in files and on the command line, by their number.
inline constexpr std::array<std::string_view, 6> kDentProfileKeys{"paper",  "smooth", "wendland",
                                                                  "linear", "crater", "curve"};
inline constexpr std::array<std::string_view, 3> kDentDirectionKeys{"projectile", "surface", "press"};

/// The form with nothing in it that has no effect: equal forms make equal dents. With numbers so small that
/// deforming with them would give denormal ones as 0.
[[nodiscard]] DentForm plain(const DentForm& form);

/// Why no hit can have this form; empty: it can. A sentence.
[[nodiscard]] std::string_view faultOf(const DentForm& form);

/// Of the monotone cubic through equidistant ordinates: at each of them the ordinate and the slope, which is
/// per interval. As Fritsch and Butland have it (SIAM J. Sci. Stat. Comput. 5, 1984), with the ends of
/// PCHIP: between two neighbours the cubic leaves neither. Only sums, products and quotients, each rounded to
/// float.
using CurveTerms = std::array<float, 2 * kCurvePoints>;
[[nodiscard]] CurveTerms termsOf(const CurveOrdinates& ordinates);

}  // namespace hitscope
