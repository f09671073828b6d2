#include "reports/worlds/truth/subjects.h"

#include <algorithm>
#include <cstddef>

namespace touchstone {

bool Has(const Subjects& subjects, const Anchor& anchor) {
  const std::vector<int>& indices =
      anchor.on == AnchorKind::kBody ? subjects.bodies : subjects.particles;
  return anchor.on != AnchorKind::kWorld &&
         std::find(indices.begin(), indices.end(), anchor.index) != indices.end();
}

int FirstNodeOf(const World& world, int index) {
  int first = 0;
  for (int i = 0; i < index; ++i) {
    const int n = world.cloths[static_cast<std::size_t>(i)].n;
    first += n * n;
  }
  return first;
}

}  // namespace touchstone
