#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/each_subject.h"
#include "reports/worlds/law_support/impact_errors.h"
#include "reports/worlds/law_support/landing.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/law_support/scheme_drift.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/impact.h"
#include "reports/worlds/truth/mechanics.h"
#include "reports/worlds/truth/torque_free_rotation.h"

namespace touchstone {
namespace {

/** Largest difference of heights that count as equal, over the size of the box; poses
 have nine digits. [-] */
constexpr double kEven = 1e-9;

/** Least height of the other corners, in distances covered per step at the impact speed.
 [-] */
constexpr double kClear = 3;

using Corners = Eigen::Matrix<double, 3, 8>;

Corners CornersOf(const RigidBody& body, const Eigen::Matrix3d& R_WB) {
  const Eigen::Vector3d half = std::get<Box>(body.placed.shape).half_extents;
  Corners r_W;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                               corner & 4 ? 1 : -1);
    r_W.col(corner) = R_WB * sign.cwiseProduct(half);
  }
  return r_W;
}

/** A box that lands on a corner or an edge. */
struct Fall {
  Landing landing;
  Striker start;
  Eigen::Vector3d a_W;
  Eigen::Vector3d r_W;  ///< From the centre to the corner, or to the edge's midpoint.
  double time;          ///< Time of impact. [s]
  double speed;         ///< |u_n| at the impact. [m/s]
  int lowest;           ///< Number of lowest corners.
  double clearance;     ///< Height of the next corner above the lowest. [m]
  Eigen::Vector3d t_W;  ///< The tangent of the plane of motion, for friction.

  /** Returns the impulse of the impact at `p_W` by `rule`; zero if the point is
   separating. */
  Eigen::Vector3d Impulse(ImpactRule rule, const Striker& at,
                          const Eigen::Vector3d& p_W) const {
    const Eigen::Matrix3d K = ImpulseResponse(at, p_W);
    const Eigen::Vector3d u_W = at.VelocityAt(p_W);
    const Eigen::Vector3d& n_W = landing.n_W;
    const double u_n = n_W.dot(u_W);
    if (u_n >= 0) return Eigen::Vector3d::Zero();
    if (landing.friction == 0)
      return -(1 + landing.restitution) * u_n / n_W.dot(K * n_W) * n_W;
    Eigen::Matrix<double, 3, 2> plane;
    plane << n_W, t_W;
    return plane * PlanarImpulse(rule, plane.transpose() * K * plane,
                                 plane.transpose() * u_W, landing.restitution,
                                 landing.friction);
  }

  /** Returns the box after `t`, with its orientation kept, for an impact at time `impact`
   [s] at a point that lies `inset` [-] of the penetration depth inside the box. */
  Striker At(double t, double impact, double inset, ImpactRule rule) const {
    Striker at = start;
    const double until = std::min(t, impact);
    at.p_WB += start.v_WB * until + a_W * (until * until / 2);
    at.v_WB += a_W * until;
    if (t <= impact) return at;
    const double depth = -landing.n_W.dot(at.p_WB + r_W - landing.p_WC) - landing.gap;
    const Eigen::Vector3d p_W =
        at.p_WB + r_W + inset * std::max(0.0, depth) * landing.n_W;
    at.Strike(Impulse(rule, at, p_W), p_W);
    at.p_WB += at.v_WB * (t - impact) + a_W * ((t - impact) * (t - impact) / 2);
    at.v_WB += a_W * (t - impact);
    return at;
  }

  /** Returns the box just after the impact. */
  Striker After(ImpactRule rule) const { return At(JustAfter(time), time, 0, rule); }
};

Fall FallOf(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const Eigen::Matrix3d& R = body.placed.X_WB.R_WB;
  Fall fall;
  fall.landing = *LandingOf(world, index);
  fall.start = {1 / body.mass,
                R * InertiaOf(body).cwiseInverse().asDiagonal() * R.transpose(),
                body.placed.X_WB.p_WB, body.v_WB, body.w_WB};
  fall.a_W = AccelerationOf(world, body);
  const Eigen::Vector3d& n_W = fall.landing.n_W;
  const Corners r_W = CornersOf(body, R);
  const Eigen::Matrix<double, 1, 8> heights = n_W.transpose() * r_W;
  const double even = kEven * BoundingRadius(body.placed.shape);
  fall.r_W.setZero();
  fall.lowest = 0;
  fall.clearance = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 8; ++corner) {
    const double higher = heights[corner] - heights.minCoeff();
    if (higher > even) {
      fall.clearance = std::min(fall.clearance, higher);
      continue;
    }
    ++fall.lowest;
    fall.r_W += r_W.col(corner);
  }
  fall.r_W /= fall.lowest;
  // Tangent across the edge. It is not taken from the arm, since the arm has no part
  // along the plane if the centre is right above the edge. For a corner it is that part
  // of the arm.
  int along = 0;
  (R.transpose() * fall.r_W).cwiseAbs().minCoeff(&along);
  fall.t_W = fall.lowest == 1 ? (fall.r_W - n_W.dot(fall.r_W) * n_W).normalized()
                              : R.col(along).cross(n_W).normalized();
  const Arrival arrival = ArrivalAt(fall.landing, body.v_WB, fall.a_W);
  fall.time = arrival.time;
  fall.speed = arrival.speed;
  return fall;
}

/** Returns the time at which the same or another corner comes down next, less the steps
 by which an engine may be early. Searched step by step. [s] */
double NextImpact(const World& world, int index, const Fall& fall, ImpactRule rule) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const Striker after = fall.After(rule);
  const TorqueFreeRotation turning(
      InertiaOf(body),
      {Eigen::Quaterniond(body.placed.X_WB.R_WB).normalized(), after.w_WB});
  std::vector<double> times;
  for (double t = 0; t <= world.steps * world.dt - fall.time; t += world.dt)
    times.push_back(t);
  const std::vector<Rotation> turned = turning.At(times);
  const Eigen::Vector3d& n_W = fall.landing.n_W;
  const Eigen::Vector3d on_plane_W =
      fall.landing.p_WC - fall.landing.gap * fall.landing.n_W;
  const double below = -kEven * BoundingRadius(body.placed.shape);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const Eigen::Vector3d p_W =
        fall.At(fall.time + times[i], fall.time, 0, rule).p_WB - on_plane_W;
    const Corners r_W = CornersOf(body, turned[i].q_WB.toRotationMatrix());
    if ((n_W.transpose() * (r_W.colwise() + p_W)).minCoeff() < below)
      return fall.time + times[i] - kClear * world.dt;
  }
  return std::numeric_limits<double>::infinity();
}

/** Whether an impulse in the plane of the normal and the arm keeps the box moving in that
 plane. */
bool HalvesTheBox(const Fall& fall) {
  const Eigen::Vector3d across_W = fall.t_W.cross(fall.landing.n_W);
  const Eigen::Vector3d turn_W = fall.start.inverse_inertia_W * across_W;
  return across_W.norm() > 0.5 && turn_W.cross(across_W).norm() <= kEven * turn_W.norm();
}

std::string WhyNot(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  if (!std::holds_alternative<Box>(body.placed.shape)) return "is no box";
  const std::optional<Landing> landing = LandingOf(world, index);
  if (!landing) return "faces no static half-space or box";
  if (!body.w_WB.isZero(0)) return "spins at the start";
  if (IsHeld(world, AnchorKind::kBody, index) || IsPushed(world, index))
    return "is held or pushed";
  if (landing->gap < -kEven * BoundingRadius(body.placed.shape))
    return "starts inside the ground";
  const Fall fall = FallOf(world, index);
  // Written so that a box that never arrives is refused.
  if (!(fall.time >= 0 && fall.time <= world.steps * world.dt && fall.speed > 0))
    return "does not reach the ground";
  if (fall.lowest > 2) return "lands flat";
  if (fall.clearance <= kClear * fall.speed * world.dt)
    return "lands with another corner less than three steps of motion higher";
  if (landing->friction > 0) {
    if (fall.lowest == 1 && !HalvesTheBox(fall))
      return "lands on one corner with friction and turns out of its plane";
    const Eigen::Vector3d edge_W = fall.t_W.cross(landing->n_W);
    const double v = body.v_WB.norm() + fall.a_W.norm() * fall.time;
    if (std::abs(edge_W.dot(body.v_WB + fall.a_W * fall.time)) > kEven * v)
      return "moves out of the plane in which it turns";
  }
  if (NextImpact(world, index, fall, ImpactRule::kNewton) <= fall.time)
    return "hits the ground again within three steps";
  return "";
}

ExpectedNumbers NumbersOfBody(const World& world, int index) {
  const Fall fall = FallOf(world, index);
  const Striker before = fall.At(fall.time, fall.time, 0, ImpactRule::kNewton);
  const Striker after = fall.After(ImpactRule::kNewton);
  return {
      {"expected_speed", after.v_WB.norm()},
      {"expected_spin", after.w_WB.norm()},
      {"expected_impulse", (after.v_WB - before.v_WB).norm() / fall.start.inverse_mass}};
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return FaultsOfOneBody(
      world, claim, "one box",
      {.why_not = WhyNot,
       .expected = "a box that flies without spin and hits a static half-space or box "
                   "with an edge or a corner (with friction: in a plane)",
       .numbers = NumbersOfBody});
}

std::vector<Worst> JudgeBy(ImpactRule rule, const Motion& motion, int index) {
  const World& world = motion.world;
  const double h = world.dt;
  const auto i = static_cast<std::size_t>(index);
  const RigidBody& body = world.bodies[i];
  const Fall fall = FallOf(world, index);
  const double until = NextImpact(world, index, fall, rule);
  const std::vector<double> lost =
      GyroscopicMomentumDrift(motion, AllowedMotion(motion), {{index}, {}, {}});
  const double least_inertia = InertiaOf(body).minCoeff();
  const double lever = body.mass * fall.r_W.norm() / least_inertia;  // [1/m]
  const double a = fall.a_W.norm();
  const double speed = body.v_WB.norm() + a * fall.time;
  const auto predict = [&](std::size_t s) -> PredictedState {
    const double t = motion.trajectory.times[s];
    if (t > until) return {};
    const Striker truth = fall.At(t, fall.time, 0, rule);
    ImpactErrors errors;
    ForDeviatingImpacts(fall.time, h, [&](double impact, double inset) {
      errors.Include(fall.At(t, impact, inset, rule), truth);
    });
    const double gravity = t < fall.time - h ? 0
                                             : a * h * (1 + fall.landing.restitution) *
                                                   (1 + fall.landing.friction);
    // Before the impact the inverse inertia is that of the start; the spin of the truth
    // is that at the impact.
    const BodyState& is = motion.trajectory.samples[s].bodies[i];
    const Eigen::Vector3d L_W = fall.start.inverse_inertia_W.inverse() * truth.w_WB;
    const Eigen::Matrix3d inverse_inertia_W = InertiaInWorld(body, is.q_WB).inverse();
    const Eigen::Vector3d w_W = inverse_inertia_W * L_W;
    // Semi-implicit Euler rotates the box with the spin of its previous orientation.
    const double behind = h * (inverse_inertia_W * L_W.cross(w_W)).norm();
    return {.position = {{truth.p_WB,
                          {.scheme = errors.position + (gravity + a * h / 2) * t,
                           .solved = speed * t,
                           .computed = truth.p_WB.norm()}}},
            .velocity = {{truth.v_WB,
                          {.scheme = errors.velocity + gravity, .solved = speed}}},
            .spin = {{w_W,
                      {.scheme = errors.spin + gravity * lever + lost[s] / least_inertia +
                                 behind,
                       .solved = speed * lever + w_W.norm()}}}};
  };
  const AllowedWords allowed = {
      .scheme =
          "the change by an impact up to a step early or late and inside the box, "
          "and by gravity and rotation in a step",
      .solved = "the velocity"};
  return JudgePredictions(
      motion,
      {.position = {allowed, "after the impact it is at"},
       .velocity = {allowed, "after the impact it moves at"},
       .spin =
           {allowed,
            "in this orientation the angular momentum after the impact is a spin of"}},
      {{body.name, StateOfBody(index), predict}});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const int index = SubjectsOf(motion.world, claim).bodies.front();
  const std::vector<Worst> by_newton = JudgeBy(ImpactRule::kNewton, motion, index);
  const bool by_poisson =
      AnyBeyond(by_newton) && !AnyBeyond(JudgeBy(ImpactRule::kPoisson, motion, index));
  return FindingsOf(by_newton, by_poisson ? "Poisson's restitution" : "");
}

constexpr std::array<std::string_view, 3> kNumbers = {"expected_impulse",
                                                      "expected_speed", "expected_spin"};

}  // namespace

/** A box that flies without spin hits a static plane with a corner or an edge. [m/s],
 [rad/s], [m]

 Corner without friction: J = −(1 + e) u_n/(1/m + (r × n)·I⁻¹ (r × n)) along n. Edge that
 moves across its own direction, with friction: the motion stays in a plane, where K_nt
 couples normal and tangent, and the impact rules differ (truth/impact.h). The truth is
 Newton's restitution with Coulomb's law on the remaining slip, since that is what a
 world's `restitution` and `friction` mean. Poisson's rule, with friction acting all
 through the impact, is recognised. A corner with friction has no closed form, unless the
 box moves in one plane.

 Judged until another corner comes down. Tolerance of velocity and position: the
 deviations of an impact up to a step early or late, with its contact point inside the
 box, × 1.5, as in law_support/sphere_meeting.h. Spin: |ω − I⁻¹ L*|, where L* is the
 angular momentum after the impact, which stays constant. First-order schemes lose h ∫ of
 the rates in law_support/scheme_drift.h. 1e-5 of the velocity for the solver, 64
 roundings per step.

 About: one box whose other corners are higher by more than three steps of motion.
 Numbers: expected_speed, expected_spin (magnitudes, after the impact), expected_impulse
 (its magnitude). */
constinit const Law kCornerImpact = {
    .name = "corner_impact",
    .documentation =
        "A box without spin hits a static plane with an edge, or with a corner in a "
        "plane or "
        "without friction.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
