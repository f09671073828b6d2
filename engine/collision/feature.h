#pragma once

#include "engine/collision/manifold.h"

namespace cookbook {

/** A face of a box: its axis 0…2, and its side, 0 (negative) or 1 (positive). */
struct BoxFace {
  int axis;
  int side;
};

/** An edge of the incident or the reference face. Each face has four: on the negative
 (+0) or positive (+1) side of its next axis, (axis + 1) mod 3, and on the negative (+2)
 or positive (+3) side of the axis after that. Edges of the incident face are numbered
 from 0, edges of the reference face from 4. */
using FaceEdge = int;

/** Returns the identity of a contact of two faces, at the point where two of their edges
 meet. The order of the edges does not matter. `reference_is_B` says whether the reference
 face is B's. */
constexpr FeatureId FaceContactId(bool reference_is_B, BoxFace reference,
                                  BoxFace incident, FaceEdge p, FaceEdge q) {
  const int low = p < q ? p : q;
  const int high = p < q ? q : p;
  int id = 1;
  id = id << 1 | static_cast<int>(reference_is_B);
  id = id << 3 | (reference.axis << 1 | reference.side);
  id = id << 3 | (incident.axis << 1 | incident.side);
  id = id << 3 | low;
  id = id << 3 | high;
  return static_cast<FeatureId>(id);
}

/** Returns the part of a contact's identity that depends on its two edges. Added to the
 part of the two faces, FaceContactId(…, 0, 0), it makes the whole. */
constexpr int EdgesId(FaceEdge p, FaceEdge q) {
  return static_cast<int>(FaceContactId(false, {0, 0}, {0, 0}, p, q) -
                          FaceContactId(false, {0, 0}, {0, 0}, 0, 0));
}

/** Returns the identity of the contact of a sphere with the feature of a box that is
 nearest to its centre. `x`, `y`, `z` are −1 or +1 along an axis on whose negative or
 positive side the feature lies, and 0 along the others. One non-zero number means a face,
 two an edge, three a vertex. */
constexpr FeatureId SphereContactId(int x, int y, int z) {
  return static_cast<FeatureId>((x + 1) * 9 + (y + 1) * 3 + (z + 1) + 1);
}

}  // namespace cookbook
