#include "engine/printed/errata.h"

#include <array>

namespace cookbook::printed {
namespace {

/** The descriptions of the errata, in order of their numbers. */
constexpr std::array<std::string_view, 30> kFaults = {
    "edge axes of boxes are cross products of A's axes with A's own",
    "negative components of an axis are set to zero",
    "sphere-sphere depth is taken from the normalised distance: |1 − (r_A + r_B)|",
    "depths of spheres are halved",
    "sphere centre in a box: pushed from centre to centre, by the radius",
    "coinciding centres of a sphere and its partner do not collide",
    "a box wholly inside another has no contact",
    "contacts of boxes are where edges cross faces: an edge on a face has four",
    "contacts within 1 cm are merged, whatever the size of the boxes",
    "a linear impulse is added to the velocity, not divided by the mass",
    "velocities lose a fiftieth per step, whatever the step",
    "impulses are shared among contacts, and restitution is given per sweep",
    "spheres do not turn",
    "the inertia tensor is not turned with the body",
    "orientation is three Euler angles, to which ω dt is added",
    "no gyroscopic term",
    "spring damping takes the length of the relative velocity",
    "the force of a spring is applied as an impulse, without dt",
    "particles keep a share of their velocity per step, whatever the step",
    "the x and z of a cloth's place are multiplied by its spacing",
    "a cloth of fewer than 3 × 3 writes past the end of its particles",
    "joints correct positions half and half, velocities not at all",
    "friction takes the velocity from before the normal impulse",
    "projection out of contact moves, but does not turn",
    "no friction of less than 0.005 N s",
    "depth along an axis is the common length of the intervals",
    "clipping allows for no rounding, which takes contacts of flush boxes",
    "boxes that touch with depth zero are apart",
    "an edge axis is skipped if its squared length is below 0.001",
    "a squared distance within the float epsilon counts as zero",
};

}  // namespace

std::string NameOf(Erratum erratum) {
  const int number = static_cast<int>(erratum);
  return (number < 10 ? "E-0" : "E-") + std::to_string(number);
}

std::string_view FaultOf(Erratum erratum) {
  return kFaults[static_cast<std::size_t>(erratum) - 1];
}

std::optional<Erratum> ErratumNamed(std::string_view name) {
  for (const auto& errata : {kContactErrata, kMotionErrata}) {
    for (const Erratum erratum : errata) {
      if (NameOf(erratum) == name) return erratum;
    }
  }
  return std::nullopt;
}

}  // namespace cookbook::printed
