#pragma once

#include <span>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns the capability of MuJoCo's collision functions for a pair. */
Capability MujocoCapability(ShapeKind a, ShapeKind b);

/** Answers `queries` with MuJoCo's table of collision functions, mjCOLLISIONFUNC, and
 margin 0: mj_collision() calls these functions for a pair that is near.

 The translation does the following:
 - the two geoms are those of one model, resized and moved for each question;
 - the functions require the geom of the lesser type first: the geoms are swapped if
   necessary, and the normal is then negated;
 - contact.frame starts with the normal, from the first geom to the second: unchanged;
 - contact.dist is negative when penetrating, contact.pos is midway: unchanged;
 - a half-space is a plane whose normal is z: unchanged;
 - the answer's normal and separation are those of the deepest contact.

 Hulls are unsupported: MuJoCo stores the vertices of meshes in single precision and moves
 them to their principal axes, so it would answer for a different hull. Cones do not
 exist in MuJoCo. */
void AnswerByMujoco(const OracleInfo& info, std::span<const ContactQuery> queries,
                    std::span<ContactAnswer> answers);

/** Adds the capabilities above and the settings to `info`. */
void DescribeMujocoContacts(OracleInfo& info);

}  // namespace touchstone
