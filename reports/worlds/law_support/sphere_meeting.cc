#include "reports/worlds/law_support/sphere_meeting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "reports/worlds/law_support/at_sample.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/impact_errors.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

Striker FlownTo(const SphereMeeting::Side& side, double t) {
  Striker flown = side.start;
  flown.p_WB += side.start.v_WB * t + side.a_W * (t * t / 2);
  flown.v_WB += side.a_W * t;
  return flown;
}

void Fly(Striker& striker, const Eigen::Vector3d& a_W, double t) {
  striker.p_WB += striker.v_WB * t + a_W * (t * t / 2);
  striker.v_WB += a_W * t;
}

/** Returns the impacts of engines that are early or late. */
std::vector<Met> Deviations(const SphereMeeting& meeting, double t, double h,
                            const PlacedCone& cone) {
  std::vector<Met> deviations;
  constexpr int kPhases = 4;
  for (int phase = -kPhases; phase <= kPhases; ++phase) {
    const double late =
        phase == kPhases ? kLatestImpact : static_cast<double>(phase) / kPhases;
    const double impact = std::max(0.0, meeting.time + late * h);
    for (const double inset : {0.0, 0.5, 1.0})
      deviations.push_back(MetAt(meeting, t, impact, inset, cone));
  }
  return deviations;
}

double ApproachOf(const Met& met, const Eigen::Vector3d& n_W) {
  return -n_W.dot(met.B.v_WB - met.A.v_WB);
}

Met Is(const Motion& motion, std::size_t s, const SphereMeeting& meeting) {
  const auto at = [&](const SphereMeeting::Side& side) {
    const BodyState& state =
        motion.trajectory.samples[s].bodies[static_cast<std::size_t>(side.body)];
    Striker striker = side.start;
    striker.p_WB = state.p_WB;
    striker.v_WB = state.v_WB;
    striker.w_WB = state.w_WB;
    return striker;
  };
  return {at(meeting.A), at(meeting.B)};
}

/** Checks the state of one side with its tolerances. */
class SideJudge {
 public:
  SideJudge(const Motion& motion, Worst& velocity, Worst& spin, Worst& position)
      : motion_(motion), velocity_(velocity), spin_(spin), position_(position) {}

  void Take(const SphereMeeting::Side& side, std::size_t s, const Striker& is,
            const Striker& truth, const std::vector<Striker>& deviations, double gravity,
            double speed) {
    const double t = motion_.trajectory.times[s];
    const double h = motion_.world.dt;
    const double rounding = RoundingOf(motion_.oracle, StepsBefore(motion_, s));
    const double share = kSolverResidual + rounding;
    ImpactErrors errors;
    for (const Striker& other : deviations) errors.Include(other, truth);
    const AtSample at{motion_, s,
                      motion_.world.bodies[static_cast<std::size_t>(side.body)].name};
    at.Compare(velocity_, is.v_WB, truth.v_WB,
               kSafety * (errors.velocity + gravity) + share * speed,
               "after the impact it moves at");
    at.Compare(spin_, is.w_WB, truth.w_WB,
               kSafety * (errors.spin + gravity * side.size / side.radius) +
                   share * (speed * side.size / side.radius + truth.w_WB.norm()),
               "after the impact it spins at");
    at.Compare(position_, is.p_WB, truth.p_WB,
               kSafety * (errors.position + (gravity + side.a_W.norm() * h / 2) * t) +
                   share * speed * t + rounding * truth.p_WB.norm(),
               "after the impact it is at");
  }

 private:
  const Motion& motion_;
  Worst& velocity_;
  Worst& spin_;
  Worst& position_;
};

std::vector<Worst> JudgeBy(const PlacedCone& cone, const Motion& motion,
                           const SphereMeeting& meeting, double until) {
  const double h = motion.world.dt;
  const PlacedCone circle = ConesOn(meeting.NormalAt(meeting.time)).front();
  const std::string because =
      "1.5 × the change by an impact up to a step early or late and inside the spheres, "
      "and by gravity in a step; 1e-5 of the velocity for the solver, and 64 roundings "
      "per step";
  Worst velocity(MeasureKind::kVelocityError, because);
  Worst spin(MeasureKind::kSpinError, because);
  Worst position(MeasureKind::kPositionError, because);
  Worst restitution(MeasureKind::kRestitution, because);
  SideJudge judge(motion, velocity, spin, position);
  const Met before = MetAt(meeting, meeting.time, meeting.time, 0, circle);
  const Met start = {meeting.A.start, meeting.B.start};
  const double speed = (before.A.v_WB - before.B.v_WB).norm() + start.A.v_WB.norm() +
                       start.B.v_WB.norm() + start.A.w_WB.norm() * meeting.A.radius +
                       start.B.w_WB.norm() * meeting.B.radius;
  const double a = (meeting.B.a_W - meeting.A.a_W).norm();
  const Eigen::Vector3d n_W = meeting.NormalAt(meeting.time);
  const double V = ApproachOf(before, n_W);
  const auto named = [&](const SphereMeeting::Side& side) {
    return CitedName{motion.world.bodies[static_cast<std::size_t>(side.body)].name};
  };
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    if (t > until) break;
    const Met is = Is(motion, s, meeting);
    const Met truth = MetAt(meeting, t, meeting.time, 0, cone);
    const Met by_circle = MetAt(meeting, t, meeting.time, 0, circle);
    // Velocity that an engine may add in the step of the impact, at rest or reflected.
    const double gravity =
        t < meeting.time - h ? 0
                             : a * h * (1 + meeting.restitution) * (1 + meeting.friction);
    std::vector<Striker> A;
    std::vector<Striker> B;
    double d_approach = 0;
    for (const Met& other : Deviations(meeting, t, h, circle)) {
      // Each deviation is as far from the truth by `cone` as from the one by the circle.
      const auto moved = [](Striker by, const Striker& from, const Striker& to) {
        by.p_WB += to.p_WB - from.p_WB;
        by.v_WB += to.v_WB - from.v_WB;
        by.w_WB += to.w_WB - from.w_WB;
        return by;
      };
      A.push_back(moved(other.A, by_circle.A, truth.A));
      B.push_back(moved(other.B, by_circle.B, truth.B));
      d_approach =
          std::max(d_approach, std::abs(ApproachOf(other, n_W) - ApproachOf(truth, n_W)));
    }
    if (meeting.A.radius > 0) judge.Take(meeting.A, s, is.A, truth.A, A, gravity, speed);
    judge.Take(meeting.B, s, is.B, truth.B, B, gravity, speed);
    if (t <= meeting.time + kLatestImpact * h) continue;
    const double since = n_W.dot(meeting.B.a_W - meeting.A.a_W) * (t - meeting.time);
    const double e = -(ApproachOf(is, n_W) + since) / V;
    restitution.Take(
        std::abs(e - meeting.restitution),
        kSafety * (d_approach + 2 * gravity) / V +
            (kSolverResidual + RoundingOf(motion.oracle, StepsBefore(motion, s))) *
                speed / V,
        [&] {
          return Citing(
              "{} has {} and {} separate at {:.6g} m/s after {:.6g} s; they met at "
              "{:.6g} m/s: e = {:.6g}, and the bodies' e is {:.6g}",
              motion.oracle.name, named(meeting.A), named(meeting.B), e * V, CitedTime{t},
              V, e, meeting.restitution);
        });
  }
  return {position, velocity, spin, restitution};
}

}  // namespace

Eigen::Vector3d SphereMeeting::NormalAt(double t) const {
  if (n_AB_W) return *n_AB_W;
  return (FlownTo(B, t).p_WB - FlownTo(A, t).p_WB).normalized();
}

Met MetAt(const SphereMeeting& meeting, double t, double impact, double inset,
          const PlacedCone& cone) {
  if (t <= impact) return {FlownTo(meeting.A, t), FlownTo(meeting.B, t)};
  Met met{FlownTo(meeting.A, impact), FlownTo(meeting.B, impact)};
  const Eigen::Vector3d n_W = meeting.NormalAt(impact);
  // Both spheres reach too far by `overlap`; the plane of a half-space does not move.
  const double overlap =
      meeting.n_AB_W
          ? n_W.dot(meeting.B.radius * n_W - met.B.p_WB + met.A.p_WB)
          : meeting.A.radius + meeting.B.radius - (met.B.p_WB - met.A.p_WB).norm();
  const double inside = inset * std::max(0.0, overlap);
  const Eigen::Vector3d p_B_W = met.B.p_WB - (meeting.B.radius - inside) * n_W;
  const Eigen::Vector3d p_A_W =
      meeting.n_AB_W ? met.A.p_WB
                     : Eigen::Vector3d(met.A.p_WB + (meeting.A.radius - inside) * n_W);
  const Eigen::Matrix3d K = ImpulseResponse(met.A, p_A_W) + ImpulseResponse(met.B, p_B_W);
  const Eigen::Vector3d J_W =
      CentralImpulse(K, met.B.VelocityAt(p_B_W) - met.A.VelocityAt(p_A_W), n_W,
                     meeting.restitution, meeting.friction, cone);
  met.A.Strike(-J_W, p_A_W);
  met.B.Strike(J_W, p_B_W);
  Fly(met.A, meeting.A.a_W, t - impact);
  Fly(met.B, meeting.B.a_W, t - impact);
  return met;
}

double Outcome::EnergyRatio() const {
  // Without the factor ½, which cancels. A static side has no energy.
  const auto energy = [](const Met& met) {
    double sum = 0;
    for (const Striker& is : {met.A, met.B}) {
      if (is.inverse_mass == 0) continue;
      sum += is.v_WB.squaredNorm() / is.inverse_mass +
             is.w_WB.squaredNorm() / is.inverse_inertia_W(0, 0);
    }
    return sum;
  };
  return energy(after) / energy(before);
}

Outcome OutcomeOf(const SphereMeeting& meeting) {
  const PlacedCone circle = ConesOn(meeting.NormalAt(meeting.time)).front();
  const auto at = [&](double t) { return MetAt(meeting, t, meeting.time, 0, circle); };
  return {at(meeting.time), at(std::nextafter(meeting.time, 1e300))};
}

double TouchTime(const SphereMeeting::Side& A, const SphereMeeting::Side& B) {
  // Solves |p + u t| = r, with equal accelerations.
  const Eigen::Vector3d p_W = B.start.p_WB - A.start.p_WB;
  const Eigen::Vector3d u_W = B.start.v_WB - A.start.v_WB;
  const double r = A.radius + B.radius;
  const double pu = p_W.dot(u_W);
  const double uu = u_W.squaredNorm();
  const double root = pu * pu - uu * (p_W.squaredNorm() - r * r);
  if (pu >= 0 || root < 0) return std::numeric_limits<double>::quiet_NaN();
  // Written so that nothing cancels: the product of both roots over the later one.
  return (p_W.squaredNorm() - r * r) / (-pu + std::sqrt(root));
}

SphereMeeting::Side SideOf(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  const double r = RadiusOf(body);
  const double inertia = InertiaOf(body).x();
  return {index,
          r,
          {1 / body.mass, Eigen::Matrix3d::Identity() / inertia, body.placed.X_WB.p_WB,
           body.v_WB, body.w_WB},
          AccelerationOf(world, body),
          1 + body.mass * r * r / inertia};
}

std::string WhyNoFreeSphere(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  if (!std::holds_alternative<Sphere>(body.placed.shape) || !body.collides)
    return "is no sphere that collides";
  if (!IsEvenSphere(body)) return "is a sphere with unequal moments of inertia";
  if (IsHeld(world, AnchorKind::kBody, index) || IsPushed(world, index))
    return "is held or pushed";
  return "";
}

std::vector<LawFinding> JudgeMeeting(const Motion& motion, const SphereMeeting& meeting,
                                     double until) {
  const std::vector<PlacedCone> cones = ConesOn(meeting.NormalAt(meeting.time));
  const std::vector<Worst> by_circle = JudgeBy(cones.front(), motion, meeting, until);
  std::string_view recognised;
  for (std::size_t i = 1; i < cones.size() && AnyBeyond(by_circle); ++i) {
    if (AnyBeyond(JudgeBy(cones[i], motion, meeting, until))) continue;
    // A contact that does not slip shows no cone.
    SphereMeeting rougher = meeting;
    rougher.friction *= kRough;
    if (AnyBeyond(JudgeBy(cones.front(), motion, rougher, until)))
      recognised = NameOf(cones[i].cone);
    break;
  }
  return FindingsOf(by_circle, recognised);
}

}  // namespace touchstone
