#include "reports/shrink/reductions.h"

#include <array>

namespace touchstone {

std::span<const Reduction> Reductions() {
  static constexpr std::array kReductions = {
      Reduction{"fewer parts", FewerParts},
      Reduction{"fewer steps", FewerSteps},
      Reduction{"simpler shapes", SimplerShapes},
      Reduction{"fewer vertices", FewerVertices},
      Reduction{"common frame", CommonFrame},
      Reduction{"plain rotations", PlainRotations},
      Reduction{"unit scale", UnitScale},
      Reduction{"short numbers", ShortNumbers},
      Reduction{"equal sizes", EqualSizes},
  };
  return kReductions;
}

}  // namespace touchstone
