#include <algorithm>
#include <cstddef>

#include "reports/shrink/reductions.h"

namespace touchstone {

void FewerVertices(const Question& question, const Candidates& take) {
  const std::vector<const Body*> bodies = BodiesOf(question);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto* const hull = std::get_if<ConvexHull>(&bodies[i]->shape);
    if (hull == nullptr) continue;
    // Blocks of halving length: delta debugging (Zeller and Hildebrandt, Simplifying and
    // isolating failure-inducing input, IEEE TSE 28 (2002)).
    const std::size_t count = hull->vertices.size();
    for (std::size_t block = (count + 1) / 2; count > 1 && block > 0; block /= 2) {
      for (std::size_t begin = 0; begin < count; begin += block) {
        Question fewer = question;
        auto& vertices = std::get<ConvexHull>(BodiesOf(fewer)[i]->shape).vertices;
        const auto first = vertices.begin() + static_cast<std::ptrdiff_t>(begin);
        const std::size_t length = std::min(block, count - begin);
        vertices.erase(first, first + static_cast<std::ptrdiff_t>(length));
        if (!vertices.empty()) take(std::move(fewer));
      }
    }
  }
}

}  // namespace touchstone
