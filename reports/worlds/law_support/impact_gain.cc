#include "reports/worlds/law_support/impact_gain.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/pairs.h"
#include "reports/worlds/law_support/reach.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Returns points whose hull holds the shape. */
struct HullOf {
  std::vector<Eigen::Vector3d> operator()(const Sphere&) const { return {}; }
  std::vector<Eigen::Vector3d> operator()(const HalfSpace&) const { return {}; }
  std::vector<Eigen::Vector3d> operator()(const ConvexHull& hull) const {
    return hull.vertices;
  }
  std::vector<Eigen::Vector3d> operator()(const Box& box) const {
    return Corners(box.half_extents);
  }
  std::vector<Eigen::Vector3d> operator()(const Capsule& capsule) const {
    const double r = capsule.radius;
    return Corners({r, r, capsule.half_length + r});
  }
  std::vector<Eigen::Vector3d> operator()(const Cylinder& cylinder) const {
    return Corners({cylinder.radius, cylinder.radius, cylinder.half_length});
  }
  std::vector<Eigen::Vector3d> operator()(const Cone& cone) const {
    return Corners({cone.radius, cone.radius, cone.half_height});
  }

 private:
  /** The other four corners are opposite to these, and as far from every axis. */
  static std::vector<Eigen::Vector3d> Corners(const Eigen::Vector3d& half) {
    return {half,
            {-half.x(), half.y(), half.z()},
            {half.x(), -half.y(), half.z()},
            {half.x(), half.y(), -half.z()}};
  }
};

Eigen::Matrix3d Cross(const Eigen::Vector3d& r) {
  Eigen::Matrix3d cross;
  cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return cross;
}

/** Two bodies whose impacts may gain energy. */
struct Gaining {
  int A = 0;  ///< It moves.
  int B = 0;
  double gain = 0;  ///< MostImpactGain().
};

std::vector<Gaining> GainingPairs(const Motion& motion, const Subjects& subjects) {
  const World& world = motion.world;
  const Reach reach(motion);
  std::vector<double> eccentricities;
  for (const RigidBody& body : world.bodies) eccentricities.push_back(Eccentricity(body));
  std::vector<Gaining> gaining;
  for (const auto& [A, B] : CollidingPairs(world, subjects)) {
    const auto a = static_cast<std::size_t>(A);
    const auto b = static_cast<std::size_t>(B);
    const RigidBody& body_A = world.bodies[a];
    const RigidBody& body_B = world.bodies[b];
    if (body_A.friction * body_B.friction == 0) continue;
    const double gain = MostImpactGain(std::min(body_A.restitution, body_B.restitution),
                                       std::max(eccentricities[a], eccentricities[b]));
    if (gain > 0 && reach.MayEverTouch(A, B)) gaining.push_back({A, B, gain});
  }
  return gaining;
}

/** Follows the bodies of one pair. */
class Approach {
 public:
  Approach(const Motion& motion, const AllowedMotion& allowed)
      : world_(motion.world), allowed_(allowed), spacing_(SampleSpacing(motion.world)) {}

  /** Returns the kinetic energy of the pair's approach between samples `s` − 1 and `s`; 0
   if it cannot meet. Along the normal of its gap its surfaces close by a speed u of at
   most `speed`, and W²/2p² is at most m u²/2, with m the reduced mass. [J] */
  double Energy(const Gaining& pair, std::size_t s) const {
    const double reach = Way(pair.A, s) + Way(pair.B, s);
    const WorldState& from = allowed_.At(s - 1);
    if (AreFarApart(PlacedAt(world_, from, pair.A), PlacedAt(world_, from, pair.B),
                    reach))
      return 0;
    const Gap gap = GapBetween(world_, from, pair.A, pair.B);
    // After a first impact between the samples the bodies may move anywhere.
    if (world_.sample_every > 1)
      return gap.length <= reach ? EnergyOfAllMotion(pair, s) : 0;
    const Eigen::Vector3d closing_W = At(pair.A, s - 1).v_WB - At(pair.B, s - 1).v_WB;
    const double speed = gap.n_W.dot(closing_W) + Turning(pair.A, s) + Turning(pair.B, s);
    const bool may_meet = speed > 0 && gap.length <= speed * spacing_;
    return may_meet ? ReducedMass(pair) * speed * speed / 2 : 0;
  }

 private:
  double ReducedMass(const Gaining& pair) const {
    const RigidBody& A = Asked(pair.A);
    const RigidBody& B = Asked(pair.B);
    return B.mass > 0 ? A.mass * B.mass / (A.mass + B.mass) : A.mass;
  }

  /** Returns the kinetic energy of the pair relative to its common centre, with the loads
   of the time between the samples. [J] */
  double EnergyOfAllMotion(const Gaining& pair, std::size_t s) const {
    const double speed = (At(pair.A, s - 1).v_WB - At(pair.B, s - 1).v_WB).norm() +
                         (Load(pair.A) + Load(pair.B)) * spacing_;
    return ReducedMass(pair) * speed * speed / 2 + Spin(pair.A, s - 1) +
           Spin(pair.B, s - 1);
  }

  const RigidBody& Asked(int body) const {
    return world_.bodies[static_cast<std::size_t>(body)];
  }

  const BodyState& At(int body, std::size_t s) const {
    return allowed_.At(s).bodies[static_cast<std::size_t>(body)];
  }

  double Load(int body) const {
    return Asked(body).mass > 0 ? AccelerationOf(world_, Asked(body)).norm() : 0;
  }

  /** Returns the largest speed that spin and loads give to the surface. [m/s] */
  double Turning(int body, std::size_t s) const {
    if (Asked(body).mass == 0) return 0;
    const Shape& shape = Asked(body).placed.shape;
    const double R = std::holds_alternative<Sphere>(shape) ? 0 : BoundingRadius(shape);
    return std::max(At(body, s - 1).w_WB.norm(), At(body, s).w_WB.norm()) * R +
           Load(body) * spacing_;
  }

  /** Returns how far the surface moves between samples `s` − 1 and `s` at most. [m] */
  double Way(int body, std::size_t s) const {
    if (Asked(body).mass == 0) return 0;
    const double speed = std::max(At(body, s - 1).v_WB.norm(), At(body, s).v_WB.norm());
    return spacing_ * (speed + Turning(body, s));
  }

  double Spin(int body, std::size_t s) const {
    if (Asked(body).mass == 0) return 0;
    const BodyState& at = At(body, s);
    return at.w_WB.dot(InertiaInWorld(Asked(body), at.q_WB.normalized()) * at.w_WB) / 2;
  }

  const World& world_;
  const AllowedMotion& allowed_;
  double spacing_;
};

}  // namespace

double Eccentricity(const RigidBody& body) {
  if (body.mass == 0) return 0;
  const std::vector<Eigen::Vector3d> points = std::visit(HullOf(), body.placed.shape);
  if (points.empty()) return 0;
  const Eigen::Vector3d inertia = InertiaOf(body);
  double largest = 0;
  // It is convex in r, so a corner of the hull has the largest.
  for (const Eigen::Vector3d& r : points) {
    const Eigen::Matrix3d Y = inertia.cwiseInverse().cwiseSqrt().asDiagonal() * Cross(r);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(Y.transpose() * Y,
                                                                Eigen::EigenvaluesOnly);
    largest = std::max(largest, body.mass * solver.eigenvalues().maxCoeff());
  }
  return largest;
}

double MostImpactGain(double restitution, double eccentricity) {
  // A sphere's impact has no lever: rounding must not give it one.
  if (eccentricity == 0) return 0;
  return std::max(0.0, restitution * restitution * (1 + eccentricity) - 1);
}

std::vector<double> ImpactEnergyGain(const Motion& motion, const AllowedMotion& allowed,
                                     const Subjects& subjects) {
  const std::vector<Gaining> pairs = GainingPairs(motion, subjects);
  const Approach approach(motion, allowed);
  std::vector<double> gains(motion.trajectory.samples.size(), 0);
  for (std::size_t s = 1; s < gains.size(); ++s) {
    gains[s] = gains[s - 1];
    for (const Gaining& pair : pairs) {
      // Each step between the samples may have an impact.
      gains[s] += motion.world.sample_every * pair.gain * approach.Energy(pair, s);
    }
  }
  return gains;
}

}  // namespace touchstone
