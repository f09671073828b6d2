#pragma once

#include <span>

#include "oracles/oracle.h"

namespace touchstone {

/** Returns what MuJoCo's collision functions can do of a pair. */
Capability MujocoCapability(ShapeKind a, ShapeKind b);

/** Answers by MuJoCo's table of collision functions, mjCOLLISIONFUNC, with margin 0:
 what mj_collision() calls for a pair that is near.

 What the translation hides:
 - geoms are those of one model, resized and moved for each question;
 - the functions want the geom of the lesser type first: swapped, and the normal with it;
 - contact.frame starts with the normal, from the first geom to the second;
 - contact.dist is negative when penetrating, contact.pos midway: as here;
 - a half-space is a plane, whose normal is z: as here;
 - the answer's normal and separation are those of the deepest contact.

 MuJoCo keeps the vertices of meshes in single precision and moves them to their principal
 axes: it would answer about another hull. It has no cones. */
void AnswerByMujoco(const OracleInfo& info, std::span<const ContactQuery> queries,
                    std::span<ContactAnswer> answers);

/** Adds to `info` the capabilities above, and what is set. */
void DescribeMujocoContacts(OracleInfo& info);

}  // namespace touchstone
