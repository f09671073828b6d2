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
  kE10 = 10,  ///< A linear impulse is added to the velocity, not divided by the mass.
  kE11 = 11,  ///< Velocities lose a fiftieth per step, whatever the step.
  kE12 = 12,  ///< Impulses are shared among contacts, and restitution is given per sweep.
  kE13 = 13,  ///< Spheres do not turn.
  kE14 = 14,  ///< The inertia tensor is not turned with the body.
  kE15 = 15,  ///< Orientation is three Euler angles, to which ω dt is added.
  kE16 = 16,  ///< No gyroscopic term.
  kE17 = 17,  ///< Spring damping takes the length of the relative velocity.
  kE18 = 18,  ///< The force of a spring is applied as an impulse, without dt.
  kE19 = 19,  ///< Particles keep a share of their velocity per step, whatever the step.
  kE20 = 20,  ///< The x and z of a cloth's place are multiplied by its spacing.
  kE21 = 21,  ///< A cloth of fewer than 3 × 3 writes past the end of its particles.
  kE22 = 22,  ///< Joints correct positions half and half, velocities not at all.
  kE23 = 23,  ///< Friction takes the velocity from before the normal impulse.
  kE24 = 24,  ///< Projection out of contact moves, but does not turn.
  kE25 = 25,  ///< No friction of less than 0.005 N s.
  kE26 = 26,  ///< Depth along an axis is the common length of the intervals.
};

/** Every erratum of the contact recipes, in order. */
inline constexpr std::initializer_list<Erratum> kContactErrata = {
    Erratum::kE01, Erratum::kE02, Erratum::kE03, Erratum::kE04, Erratum::kE05,
    Erratum::kE06, Erratum::kE07, Erratum::kE08, Erratum::kE09, Erratum::kE26};

/** Every erratum of the recipes of motion, in order. */
inline constexpr std::initializer_list<Erratum> kMotionErrata = {
    Erratum::kE10, Erratum::kE11, Erratum::kE12, Erratum::kE13,
    Erratum::kE14, Erratum::kE15, Erratum::kE16, Erratum::kE17,
    Erratum::kE18, Erratum::kE19, Erratum::kE20, Erratum::kE21,
    Erratum::kE22, Erratum::kE23, Erratum::kE24, Erratum::kE25};

/** Which errata are in force. */
class Errata {
 public:
  constexpr Errata() = default;
  constexpr Errata(std::initializer_list<Erratum> errata) {
    for (const Erratum erratum : errata) Add(erratum);
  }

  constexpr void Add(Erratum erratum) { bits_ |= Bit(erratum); }

  /** Returns the recipes as printed. */
  static constexpr Errata All() {
    Errata all(kContactErrata);
    for (const Erratum erratum : kMotionErrata) all.Add(erratum);
    return all;
  }
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

/** Returns the erratum of that name, or nothing. */
std::optional<Erratum> ErratumNamed(std::string_view name);

}  // namespace cookbook::printed
