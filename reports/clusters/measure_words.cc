#include "reports/clusters/measure_words.h"

#include <array>

namespace touchstone {

std::string_view FaultInWords(MeasureKind measure) {
  // In the order of MeasureKind.
  constexpr std::array<std::string_view, kMeasureKinds> kFaults = {
      "reports a hit where there is none, or none where there is one",
      "states a wrong distance or depth",
      "states a depth that its own normal contradicts",
      "pushes along a direction that is not the shortest",
      "gives nearest points that are not the nearest",
      "places contacts off the surfaces",
      "places contacts outside the contact patch",
      "leaves part of the contact patch without contacts",
      "gives too few or repeated contacts",
      "states contacts deeper than the bodies overlap",
      "states contacts with a wrong depth",
      "gives witness points that contradict its distance",
      "gives one manifold several normals",
      "answers differently when the bodies are swapped",
      "answers differently when the scene is moved",
      "answers differently when the scene is scaled",
      "answers differently when the axes of a box are renamed",
      "jumps when a body moves by next to nothing",
      "gives no usable answer",
      "moves a body to the wrong place",
      "turns a body the wrong way",
      "gives a body a wrong velocity",
      "gives a body a wrong spin",
      "makes or loses momentum",
      "makes or loses angular momentum",
      "makes or loses energy",
      "reports impulses that do not add up to the change of momentum",
      "reports impulses that do not add up to the change of angular momentum",
      "moves a body otherwise than at its velocity",
      "turns a body otherwise than at its spin",
      "reports contacts that are not on the bodies",
      "lets bodies sink into each other",
      "lets a body pass through another",
      "moves a body that should rest",
      "bounces a body too high or too low",
      "applies the wrong friction",
      "applies more friction than Coulomb's cone allows",
      "lets a joint stretch",
      "applies a wrong force",
      "lets an event come too early or too late",
      "does not converge at the order of its scheme",
      "converges to a wrong motion",
      "does not repeat itself",
      "amplifies a rounding of the start",
      "moves differently when the world is turned",
      "moves differently when the world is translated",
      "moves differently when the world is mirrored",
      "moves differently when the bodies are listed in another order",
      "moves differently when all masses are scaled"};
  static_assert(!kFaults.back().empty());
  return kFaults[static_cast<std::size_t>(measure)];
}

}  // namespace touchstone
