#pragma once

#include "engine/collision/manifold.h"

namespace cookbook {

/** A face of a box: axis 0…2 and side, 0 for the negative and 1 for the positive one. */
struct BoxFace {
  int axis;
  int side;
};

/** The bounds of a clipped face. An incident or reference face has four edges: the one on
 the negative (+0) or positive (+1) side of its next axis (axis + 1) mod 3, or (+2, +3) of
 the one after that. Edges of the incident face are numbered from 0, of the reference face
 from 4. */
using FaceEdge = int;

/** Returns the identity of a contact of two faces: the meeting of two of their edges. The
 order of the edges does not matter. `reference_is_B` tells whose face clips. */
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

/** Returns what the two edges that meet add to the identity of a contact: where the faces
 are known, the edges are looked up. */
constexpr int EdgesId(FaceEdge p, FaceEdge q) {
  return static_cast<int>(FaceContactId(false, {0, 0}, {0, 0}, p, q) -
                          FaceContactId(false, {0, 0}, {0, 0}, 0, 0));
}

/** Returns the identity of the contact of a sphere with the part of a box that is nearest
 to its centre: `x`, `y`, `z` are −1 or +1 along the axes on which that part is on the
 box's side, and 0 along the others (one non-zero: a face, two: an edge, three: a vertex).
 */
constexpr FeatureId SphereContactId(int x, int y, int z) {
  return static_cast<FeatureId>((x + 1) * 9 + (y + 1) * 3 + (z + 1) + 1);
}

}  // namespace cookbook
