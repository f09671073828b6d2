#pragma once

#include <array>
#include <vector>

#include "scenarios/shape.h"

namespace touchstone {

/** A triangle of a hull's boundary. */
struct Facet {
  std::array<std::size_t, 3> vertices;  ///< Indices, ascending.
  Eigen::Vector3d n_B;                  ///< Unit, outward.
};

/** Returns the facets of a hull in general position (no four vertices in a plane). It
 tries all triples, which is fast enough for the dozen vertices of a generated hull.
 @pre At least four vertices. */
std::vector<Facet> FacetsOf(const ConvexHull& hull);

}  // namespace touchstone
