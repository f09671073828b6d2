#include "reports/worlds/truth/impact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace touchstone {
namespace {

Eigen::Matrix3d CrossMatrix(const Eigen::Vector3d& r) {
  Eigen::Matrix3d cross;
  cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return cross;
}

/** Returns the impulse of normal and friction per unit of normal impulse while the
 contact slips in the direction of `sign`. */
InPlane Slipping(double sign, double friction) {
  return {1, -sign * friction};
}

InPlane NewtonImpulse(const Eigen::Matrix2d& K, const InPlane& u, double restitution,
                      double friction) {
  const InPlane sticking = -K.inverse() * InPlane((1 + restitution) * u.x(), u.y());
  if (std::abs(sticking.y()) <= friction * sticking.x()) return sticking;
  // Takes the direction of slip that agrees better with the remaining slip.
  InPlane best = sticking;
  double best_slip = -std::numeric_limits<double>::infinity();
  for (const double sign : {-1.0, 1.0}) {
    const InPlane along = Slipping(sign, friction);
    const double response = K.row(0).dot(along);
    if (response <= 0) continue;
    const InPlane J = along * (-(1 + restitution) * u.x() / response);
    const double slip = sign * (u.y() + K.row(1).dot(J));
    if (slip > best_slip) {
      best_slip = slip;
      best = J;
    }
  }
  return best;
}

InPlane PoissonImpulse(const Eigen::Matrix2d& K, const InPlane& start, double restitution,
                       double friction) {
  InPlane u = start;
  InPlane J = InPlane::Zero();
  // J_n at the end of restitution; known once compression ends.
  double end = std::numeric_limits<double>::infinity();
  double sign = u.y() > 0 ? 1 : -1;
  // Ratio J_t/J_n that keeps a tangent at rest; it sticks if friction can supply that.
  const double hold = -K(0, 1) / K(1, 1);
  bool slips = u.y() != 0;
  InPlane along(1, hold);
  const auto start_from_rest = [&] {
    slips = std::abs(hold) > friction;
    sign = K(0, 1) > 0 ? 1 : -1;
    along = slips ? Slipping(sign, friction) : InPlane(1, hold);
  };
  if (slips) {
    along = Slipping(sign, friction);
  } else {
    start_from_rest();
  }
  // At most three events: slip stops, compression ends, restitution ends.
  for (int piece = 0; piece < 4; ++piece) {
    const InPlane rate = K * along;
    double until = end - J.x();
    bool compressed = false;
    bool stops = false;
    if (std::isinf(end) && rate.x() > 0) {
      until = -u.x() / rate.x();
      compressed = true;
    }
    if (slips && u.y() != 0 && u.y() * rate.y() < 0 && -u.y() / rate.y() < until) {
      until = -u.y() / rate.y();
      compressed = false;
      stops = true;
    }
    J += along * until;
    u += rate * until;
    if (stops) {
      u.y() = 0;
      start_from_rest();
    } else if (compressed) {
      end = (1 + restitution) * J.x();
    } else {
      break;
    }
  }
  return J;
}

}  // namespace

Eigen::Vector3d Striker::VelocityAt(const Eigen::Vector3d& p_W) const {
  return v_WB + w_WB.cross(p_W - p_WB);
}

void Striker::Strike(const Eigen::Vector3d& J_W, const Eigen::Vector3d& p_W) {
  v_WB += inverse_mass * J_W;
  w_WB += inverse_inertia_W * (p_W - p_WB).cross(J_W);
}

Eigen::Matrix3d ImpulseResponse(const Striker& body, const Eigen::Vector3d& p_W) {
  const Eigen::Matrix3d r = CrossMatrix(p_W - body.p_WB);
  return body.inverse_mass * Eigen::Matrix3d::Identity() - r * body.inverse_inertia_W * r;
}

Eigen::Vector3d CentralImpulse(const Eigen::Matrix3d& K, const Eigen::Vector3d& u_W,
                               const Eigen::Vector3d& n_W, double restitution,
                               double friction, const PlacedCone& cone) {
  const double u_n = u_W.dot(n_W);
  if (u_n >= 0) return Eigen::Vector3d::Zero();
  const double J_n = -(1 + restitution) * u_n / n_W.dot(K * n_W);
  const Eigen::Vector3d t_W = cone.frame.col(0);
  const Eigen::Vector3d stick_W = -(u_W - u_n * n_W) / t_W.dot(K * t_W);
  return J_n * n_W + cone.frame * NearestInCone(cone.cone,
                                                cone.frame.transpose() * stick_W,
                                                friction * J_n);
}

InPlane PlanarImpulse(ImpactRule rule, const Eigen::Matrix2d& K, const InPlane& u,
                      double restitution, double friction) {
  return rule == ImpactRule::kNewton ? NewtonImpulse(K, u, restitution, friction)
                                     : PoissonImpulse(K, u, restitution, friction);
}

}  // namespace touchstone
