#pragma once

#include <span>
#include <vector>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/contacts/contact_cache.h"

namespace cookbook {

/** Removes the contacts with seams, so that a body moves over static boxes that fit
 together as over one of them.

 A ball that rolls on one box meets the edge of the next before its face, and a box that
 slides meets its side. Alone the next box has such a contact, but the union of both has
 no edge there: where a point is on the surface of two solids, the normals of their union
 are at most those that both have. So a contact is one with a seam if each of its points
 is also a point of another static box that the body touches, and the normal is none of
 that box there. The first box must be nowhere above the plane of the other contact, which
 then keeps the body out of it, too. A wall on a floor is above the floor. */
class Seams {
 public:
  /** Clears those of `cache`, which was updated for `bodies`. */
  void RemoveContacts(std::span<const RigidBody> bodies, ContactCache& cache);

 private:
  // The contact pairs of each dynamic body with static boxes, as linked lists.
  std::vector<int> last_;      ///< Indexed by body; −1: none.
  std::vector<int> previous_;  ///< Indexed by contact pair; −1: none.
  std::vector<std::size_t> found_;
};

}  // namespace cookbook
