#include "engine/dynamics/impacts/time_of_impact.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/dynamics/body/rigid_body.h"
#include "engine/dynamics/body/time_of_fall.h"
#include "engine/dynamics/contacts/collide_bodies.h"

namespace cookbook {
namespace {

/** Maximum number of collision queries. About three suffice, eight with rotation. A thin
 bar that turns by many radians in a step beside a thin wall takes thousands: each query
 advances by at least the time in which its tip could pass half of both thicknesses. */
constexpr int kMaxIterations = 1 << 17;

/** Gap below which bodies touch, as a fraction of the smaller radius. It is also the
 error of the position at the impact. */
constexpr double kContactTolerance = 1e-10;

/** An impact in this last fraction of the step is left to the next step. */
constexpr double kEndOfStep = 1e-9;

/** Width of a bracket, as a fraction of the step, at which the search ends. Where the
 axis of least penetration changes, the gap jumps past zero, and no time is its root. */
constexpr double kLeastBracket = 1e-12;

/** Depth to which another contact of two bodies that touch may close before it counts as
 late, as a fraction of the smaller radius; at least the speculative margin. */
constexpr double kLateDepth = 1e-3;

/** Width of the bracket, as a fraction of the step, at which the search for the time of
 such a contact ends. */
constexpr double kLateBracket = 1e-6;

/** Interval between queries, as a fraction of the step, while bodies touch without an
 impact: another contact may become one soon. */
constexpr double kSamplingInterval = 1.0 / 4;

Eigen::Vector3d PointVelocity(const RigidBody& body, const Eigen::Vector3d& p_W) {
  return body.state.v_WB + body.state.w_WB.cross(p_W - body.state.p_WB);
}

/** Returns whether a contact is an impact, or a resting contact that might tunnel. */
bool HasImpact(const Manifold& manifold, const RigidBody& A, const RigidBody& B,
               const Eigen::Vector3d& a_AB_W, const ImpactRules& rules) {
  const auto points = manifold.points();
  const double load_acceleration = LoadAccelerationBetween(A, B);
  return std::any_of(points.begin(), points.end(), [&](const ContactPoint& contact) {
    const ContactPhase phase =
        PhaseAt(contact.p_WC, manifold.n_AB_W, A, B, a_AB_W, load_acceleration, rules);
    if (phase != ContactPhase::kResting) return phase == ContactPhase::kImpacting;
    // The next step would treat it as a resting contact, but by then it may be too deep.
    const double approach_speed = manifold.n_AB_W.dot(PointVelocity(A, contact.p_WC) -
                                                      PointVelocity(B, contact.p_WC));
    return MayTunnel(A, B, rules.h * approach_speed);
  });
}

/** The bracket of a root search: a time at which two bodies are separated, and a later
 one at which they penetrate. */
struct Bracket {
  double lower = 0;      ///< Separated at this time. [s]
  double upper = 0;      ///< Penetrating at this time. [s]
  double lower_gap = 0;  ///< [m]
  double upper_gap = 0;  ///< [m]
  bool has_lower = false;
  bool has_both = false;
  int last_side = 0;  ///< +1 if `lower` was set last, −1 if `upper` was.

  void SetLower(double t, double gap) {
    lower = t;
    lower_gap = gap;
    if (has_both) ApplyIllinoisRule(1, upper_gap);
    has_lower = true;
  }

  void SetUpper(double t, double gap) {
    upper = t;
    upper_gap = gap;
    if (has_both) ApplyIllinoisRule(-1, lower_gap);
    has_both = true;
  }

  /** Returns whether the bracket is too narrow to be divided. */
  bool IsClosed(double h) const { return has_both && upper - lower <= kLeastBracket * h; }

  /** Halves the gap of the other end if the same end moves twice, so that both ends
   converge: the Illinois rule (Dowell & Jarratt, BIT 11, 1971). */
  void ApplyIllinoisRule(int side, double& other_gap) {
    if (last_side == side) other_gap /= 2;
    last_side = side;
  }

  /** Returns the root of the linear interpolation (regula falsi), the upper end if the
   bracket is closed. [s] */
  double Next(double h) const {
    if (IsClosed(h)) return upper;
    return lower + (upper - lower) * lower_gap / (lower_gap - upper_gap);
  }
};

/** Returns the support point of `body` along `n_W`; the centre of anything but a dynamic
 box. */
Eigen::Vector3d SupportPoint(const Eigen::Vector3d& n_W, const RigidBody& body) {
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr || body.is_static()) return body.state.p_WB;
  const Eigen::Vector3d n_B = body.R_WB.transpose() * n_W;
  const Eigen::Array3d sides = (n_B.array() < 0).select(-Eigen::Array3d::Ones(), 1.0);
  return body.state.p_WB + body.R_WB * (sides * box->half_extents.array()).matrix();
}

/** Two bodies at a time between their impacts, and bounds on their motion. */
struct Approach {
  const RigidBody& A;
  const RigidBody& B;
  const Eigen::Vector3d& n_AB_W;
  double acceleration;      ///< Of B relative to A, along n. [m/s²]
  double rotational_speed;  ///< Greatest speed along n due to rotation. [m/s]
  double separating_speed;  ///< Of the centres. [m/s]

  Approach(const RigidBody& a, const RigidBody& b, const Eigen::Vector3d& n_W,
           const Eigen::Vector3d& a_AB_W)
      : A(a),
        B(b),
        n_AB_W(n_W),
        acceleration(n_W.dot(a_AB_W)),
        rotational_speed(RotationalSpeed(a, n_W) + RotationalSpeed(b, n_W)),
        separating_speed(n_W.dot(b.state.v_WB - a.state.v_WB)) {}

  /** Returns the first time at which the bodies may have approached by `distance`, with
   any rotation. [s] */
  std::optional<double> TimeToApproach(double distance) const {
    return TimeOfFall(distance, separating_speed - rotational_speed, acceleration);
  }

  /** Returns the time at which the support points that face each other meet. [s] */
  std::optional<double> TimeToContact(double gap) const {
    const double facing_speed = n_AB_W.dot(PointVelocity(B, SupportPoint(-n_AB_W, B)) -
                                           PointVelocity(A, SupportPoint(n_AB_W, A)));
    return TimeOfFall(gap, facing_speed, acceleration);
  }
};

/** Returns by how much to advance the time of two bodies with a gap, negative if they
 penetrate: until the support points that face each other meet, or to the next sample if
 they do not or if the bodies touch; at least the advancement that is safe for any
 rotation, and at most that to the safe penetration. [s] */
double AdvancementTime(const Approach& approach, double gap, double h) {
  const bool touching = gap <= ContactTolerance(approach.A, approach.B);
  double least = 0;
  std::optional<double> contact_time;
  if (!touching) {
    const std::optional<double> safe_time = approach.TimeToApproach(gap);
    if (!safe_time) return h;
    if (approach.rotational_speed == 0) return *safe_time;
    least = *safe_time;
    contact_time = approach.TimeToContact(gap);
  }
  const double safe_penetration = SafePenetration(approach.A, approach.B);
  // A body that is deeper already advances by a quarter of that depth.
  const std::optional<double> deepest_time =
      approach.TimeToApproach(std::max(gap + safe_penetration, safe_penetration / 4));
  return std::max(least, std::min(contact_time.value_or(kSamplingInterval * h),
                                  deepest_time.value_or(h)));
}

}  // namespace

double ContactTolerance(const RigidBody& A, const RigidBody& B) {
  return kContactTolerance * SmallerRadius(A, B);
}

Manifold CollideAtImpact(const RigidBody& A, const RigidBody& B) {
  Manifold manifold;
  CollideSpeculative(SpeculativeMarginBetween(A, B) + ContactTolerance(A, B), A, B,
                     Eigen::Vector3d::Zero(), manifold);
  return manifold;
}

bool MayTunnel(const RigidBody& A, const RigidBody& B, double distance) {
  return distance > SafePenetration(A, B);
}

ContactPhase PhaseAt(const Eigen::Vector3d& p_W, const Eigen::Vector3d& n_AB_W,
                     const RigidBody& A, const RigidBody& B,
                     const Eigen::Vector3d& a_AB_W, double load_acceleration,
                     const ImpactRules& rules) {
  const Eigen::Vector3d& v_A = A.state.v_WB;
  const Eigen::Vector3d& v_B = B.state.v_WB;
  const Eigen::Vector3d u_A = A.state.w_WB.cross(p_W - A.state.p_WB);
  const Eigen::Vector3d u_B = B.state.w_WB.cross(p_W - B.state.p_WB);
  const double normal_velocity = n_AB_W.dot(v_B + u_B - v_A - u_A);
  const double velocity_change = rules.h * n_AB_W.dot(a_AB_W);
  const double threshold = rules.restitution_threshold_factor *
                           (rules.h * load_acceleration + std::abs(velocity_change));
  if (normal_velocity > threshold) return ContactPhase::kSeparating;
  // Most contacts rest. The 1-norm decides these without a square root.
  const double smaller = std::min(normal_velocity, velocity_change);
  // The terms, not their sum: a point of a rolling body is at rest.
  const double tolerance_bound =
      kRelativeSpeedTolerance *
      (v_A.lpNorm<1>() + u_A.lpNorm<1>() + v_B.lpNorm<1>() + u_B.lpNorm<1>());
  if (smaller < -tolerance_bound && normal_velocity >= -threshold)
    return ContactPhase::kResting;
  if (smaller >= 0) return ContactPhase::kSeparating;
  const double tolerance =
      kRelativeSpeedTolerance * (v_A.norm() + u_A.norm() + v_B.norm() + u_B.norm());
  if (normal_velocity >= -tolerance && velocity_change >= -tolerance)
    return ContactPhase::kSeparating;
  return normal_velocity < -std::max(threshold, tolerance) ? ContactPhase::kImpacting
                                                           : ContactPhase::kResting;
}

std::optional<double> TimeOfImpact(const FreeFlight& A, const FreeFlight& B, double from,
                                   const ImpactRules& rules) {
  const Eigen::Vector3d a_AB_W = B.a_W - A.a_W;
  const Eigen::Vector3d load_acceleration_AB_W =
      B.load_acceleration_W - A.load_acceleration_W;
  const double tolerance = ContactTolerance(A.start, B.start);
  const double late_depth = std::max(SpeculativeMarginBetween(A.start, B.start),
                                     kLateDepth * SmallerRadius(A.start, B.start));
  const double h = rules.h;
  double t = from;
  Bracket bracket;
  // The last time at which they touched without an impact, the gap then, and a later time
  // at which they are deeper, with an impact: another contact closes between the two.
  double touching = -1;  // < 0: none
  double touching_gap = 0;
  double late = HUGE_VAL;
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const RigidBody a = A.ShapeAt(t, rules.gyroscopic);
    const RigidBody b = B.ShapeAt(t, rules.gyroscopic);
    const Manifold manifold = CollideAtImpact(a, b);
    const double gap = manifold.separation;
    if (gap > tolerance) {
      if (t >= h) return std::nullopt;
      touching = -1;
      late = HUGE_VAL;
      bracket.SetLower(t, gap);
      t = bracket.has_both
              ? bracket.Next(h)
              : std::min(h, t + AdvancementTime({a, b, manifold.n_AB_W, a_AB_W}, gap, h));
    } else if (gap < -tolerance && bracket.has_lower && !bracket.IsClosed(h)) {
      bracket.SetUpper(t, gap);
      t = bracket.Next(h);
    } else {
      if (t >= (1 - kEndOfStep) * h) return std::nullopt;
      const bool has_impact = HasImpact(manifold, a, b, load_acceleration_AB_W, rules);
      if (has_impact && (touching < 0 || gap >= std::min(touching_gap, 0.0) - late_depth))
        return t;
      (has_impact ? late : touching) = t;
      if (!has_impact) touching_gap = gap;
      bracket = {};
      if (late == HUGE_VAL) {
        t = std::min(h, t + AdvancementTime({a, b, manifold.n_AB_W, a_AB_W}, gap, h));
      } else if (late - touching > kLateBracket * h) {
        t = std::midpoint(touching, late);
      } else {
        return late;
      }
    }
  }
  return std::nullopt;
}

}  // namespace cookbook
