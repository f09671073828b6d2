#include "reports/worlds/law_support/late_contacts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "reports/referee/referee.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

bool CanTouch(const RigidBody& A, const RigidBody& B) {
  return A.collides && B.collides && (A.mass > 0 || B.mass > 0);
}

/** Returns the velocity of a body at a point. World frame. [m/s] */
Eigen::Vector3d VelocityAt(const RigidBody& body, const Eigen::Vector3d& p_W) {
  if (body.mass == 0) return Eigen::Vector3d::Zero();
  return body.v_WB + body.w_WB.cross(p_W - body.placed.X_WB.p_WB);
}

}  // namespace

double LatenessOfFlushContacts(const World& world, double rounding) {
  std::set<std::size_t> moving;
  double approach = 0;
  double acceleration = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const RigidBody& A = world.bodies[i];
    for (std::size_t j = i + 1; j < world.bodies.size(); ++j) {
      const RigidBody& B = world.bodies[j];
      if (!CanTouch(A, B) || AreFarApart(A.placed, B.placed, rounding)) continue;
      const ContactTruth truth = ComputeContactTruth({A.placed, B.placed});
      if (truth.separation.lo > rounding || truth.separation.hi < -rounding) continue;
      const Certificate& at = truth.certificate;
      approach = std::max(approach, std::abs(at.n_AB_W.dot(VelocityAt(B, at.p_WCb) -
                                                           VelocityAt(A, at.p_WCa))));
      for (const auto& [index, body] : {std::pair(i, &A), std::pair(j, &B)}) {
        if (body->mass == 0) continue;
        moving.insert(index);
        acceleration = std::max(acceleration, AccelerationOf(world, *body).norm());
      }
    }
  }
  const double h = world.dt;
  const double falls = 2 * acceleration * h * h * static_cast<double>(moving.size());
  return kSafety * (moving.empty() ? 0 : approach * h + falls);
}

}  // namespace touchstone
