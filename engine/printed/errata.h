#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace cookbook::printed {

/** A fault of the published recipes. The value is its number: kE01 is "E-01". */
enum class Erratum {
  kE01 = 1,  ///< Edge axes of boxes are cross products of A's axes with A's own.
  kE02 = 2,  ///< Negative components of an axis are set to zero.
  kE03 = 3,  ///< Sphere-sphere depth is taken from the normalised distance: |1 − (r_A +
             ///< r_B)|.
  kE04 = 4,  ///< Depths of spheres are halved.
  kE05 = 5,  ///< Sphere centre in a box: pushed from centre to centre, by the radius.
  kE06 = 6,  ///< Coinciding centres of a sphere and its partner do not collide.
  kE07 = 7,  ///< A box wholly inside another has no contact.
  kE08 =
      8,  ///< Contacts of boxes are where edges cross faces: an edge on a face has four.
  kE09 = 9,   ///< Contacts within 1 cm are merged, whatever the size of the boxes.
  kE26 = 26,  ///< Depth along an axis is the common length of the intervals.
};

/** Every erratum of the contact recipes, in order. */
inline constexpr std::initializer_list<Erratum> kContactErrata = {
    Erratum::kE01, Erratum::kE02, Erratum::kE03, Erratum::kE04, Erratum::kE05,
    Erratum::kE06, Erratum::kE07, Erratum::kE08, Erratum::kE09, Erratum::kE26};

/** Which errata are in force. */
class Errata {
 public:
  constexpr Errata() = default;
  constexpr Errata(std::initializer_list<Erratum> errata) {
    for (const Erratum erratum : errata) Add(erratum);
  }

  constexpr void Add(Erratum erratum) { bits_ |= Bit(erratum); }

  /** Returns the recipes as printed. */
  static constexpr Errata All() { return Errata(kContactErrata); }
  /** Returns the recipes put right. */
  static constexpr Errata None() { return {}; }

  constexpr bool Has(Erratum erratum) const { return (bits_ & Bit(erratum)) != 0; }
  constexpr bool operator==(const Errata&) const = default;

 private:
  static constexpr std::uint32_t Bit(Erratum erratum) {
    return std::uint32_t{1} << static_cast<int>(erratum);
  }
  std::uint32_t bits_ = 0;
};

/** Returns "E-04". */
std::string NameOf(Erratum erratum);

/** Returns the contact erratum of that name, or nothing. */
std::optional<Erratum> ErratumNamed(std::string_view name);

}  // namespace cookbook::printed
