#include "engine/dynamics/solver/free_pair_correction.h"

#include <algorithm>

#include "engine/dynamics/contacts/collide_bodies.h"

namespace cookbook {
namespace {

/** How a body moves if an impulse pushes it at a point p along a unit vector n. */
struct Lever {
  Eigen::Vector3d r_W;     ///< Of p, from the centre of mass. [m]
  Eigen::Vector3d turn_W;  ///< I⁻¹ (r × n). [1/(kg m)]
  double inverse_mass;     ///< [1/kg]
  double response;         ///< Of p along n, per impulse. [1/kg]
};

Lever LeverOf(const RigidBody& body, const Eigen::Vector3d& p_W,
              const Eigen::Vector3d& n_W) {
  const Eigen::Vector3d r_W = p_W - body.state.p_WB;
  const Eigen::Vector3d arm_W = r_W.cross(n_W);
  const Eigen::Vector3d turn_W =
      body.R_WB * body.inverse_moments.cwiseProduct(body.R_WB.transpose() * arm_W);
  return {r_W, turn_W, body.inverse_mass, body.inverse_mass + arm_W.dot(turn_W)};
}

}  // namespace

bool CorrectFreePair(const RigidBody& A, const RigidBody& B, double fraction,
                     int iterations, Velocity& moved_A, Velocity& moved_B) {
  Manifold manifold;
  CollideSpeculative(0, A, B, Eigen::Vector3d::Zero(), manifold);
  const Eigen::Vector3d& n_W = manifold.n_AB_W;
  const double slop = SlopBetween(A, B);
  bool is_deep = false;
  for (int k = 0; k < iterations; ++k) {
    for (const ContactPoint& contact : manifold.points()) {
      const double wanted = fraction * (-contact.separation - slop);
      if (wanted <= 0) continue;
      is_deep = true;
      const Lever a = LeverOf(A, contact.p_WC, n_W);
      const Lever b = LeverOf(B, contact.p_WC, n_W);
      const double apart = n_W.dot(moved_B.At(b.r_W) - moved_A.At(a.r_W));
      const double push = std::max(0.0, (wanted - apart) / (a.response + b.response));
      moved_A.v -= push * a.inverse_mass * n_W;
      moved_A.w -= push * a.turn_W;
      moved_B.v += push * b.inverse_mass * n_W;
      moved_B.w += push * b.turn_W;
    }
  }
  return is_deep;
}

}  // namespace cookbook
