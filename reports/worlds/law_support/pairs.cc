#include "reports/worlds/law_support/pairs.h"

#include <algorithm>

namespace touchstone {

bool Collide(const World& world, int A, int B) {
  const RigidBody& body_A = world.bodies[static_cast<std::size_t>(A)];
  const RigidBody& body_B = world.bodies[static_cast<std::size_t>(B)];
  return A != B && body_A.collides && body_B.collides &&
         !(std::holds_alternative<HalfSpace>(body_A.placed.shape) &&
           std::holds_alternative<HalfSpace>(body_B.placed.shape));
}

std::vector<std::pair<int, int>> CollidingPairs(const World& world,
                                                const Subjects& subjects) {
  std::vector<bool> is_subject(world.bodies.size(), false);
  for (const int index : subjects.bodies)
    is_subject[static_cast<std::size_t>(index)] = true;
  std::vector<std::pair<int, int>> pairs;
  for (const int A : subjects.bodies) {
    for (int B = 0; B < static_cast<int>(world.bodies.size()); ++B) {
      if (Collide(world, A, B) && !(is_subject[static_cast<std::size_t>(B)] && B < A))
        pairs.emplace_back(A, B);
    }
  }
  return pairs;
}

std::vector<std::pair<int, int>> CollidingPairs(const World& world, const Claim& claim) {
  std::vector<std::pair<int, int>> pairs =
      CollidingPairs(world, SubjectsOf(world, claim));
  const auto is_claimed = [&](int body) {
    return std::find(claim.claimed.begin(), claim.claimed.end(),
                     world.bodies[static_cast<std::size_t>(body)].name) !=
           claim.claimed.end();
  };
  std::erase_if(pairs, [&](const std::pair<int, int>& pair) {
    return is_claimed(pair.first) || is_claimed(pair.second);
  });
  return pairs;
}

}  // namespace touchstone
