#include "reports/worlds/law_support/sphere_meeting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/cone_models.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/impact_errors.h"
#include "reports/worlds/law_support/prediction.h"
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

void Advance(Striker& striker, const Eigen::Vector3d& a_W, double t) {
  striker.p_WB += striker.v_WB * t + a_W * (t * t / 2);
  striker.v_WB += a_W * t;
}

double ApproachOf(const BothSides& sides, const Eigen::Vector3d& n_W) {
  return -n_W.dot(sides.B.v_WB - sides.A.v_WB);
}

BothSides Is(const Motion& motion, std::size_t s, const SphereMeeting& meeting) {
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

/** An impact of two bodies with friction by one cone, and the errors of engines. */
class Impact {
 public:
  Impact(const Motion& motion, const SphereMeeting& meeting, const PlacedCone& cone)
      : motion_(motion),
        meeting_(meeting),
        cone_(cone),
        circle_(ConesOn(meeting.NormalAt(meeting.time)).front()),
        n_W_(meeting.NormalAt(meeting.time)) {
    const BothSides before = Circular(meeting.time, meeting.time, 0);
    const SphereMeeting::Side& A = meeting.A;
    const SphereMeeting::Side& B = meeting.B;
    approach_ = ApproachOf(before, n_W_);
    speed_ = (before.A.v_WB - before.B.v_WB).norm() + A.start.v_WB.norm() +
             B.start.v_WB.norm() + A.start.w_WB.norm() * A.radius +
             B.start.w_WB.norm() * B.radius;
  }

  /** Returns the prediction of one of the two sides until `until`. */
  Prediction Predict(const SphereMeeting::Side& side, Striker BothSides::*of,
                     double until) const {
    const RigidBody& body = motion_.world.bodies[static_cast<std::size_t>(side.body)];
    return {body.name, StateOfBody(side.body),
            [this, &side, of, until](std::size_t s) -> PredictedState {
              const double t = motion_.trajectory.times[s];
              if (t > until) return {};
              const Striker truth = SidesAt(meeting_, t, meeting_.time, 0, cone_).*of;
              const ImpactErrors errors = ErrorsAt(t, of);
              const double gravity = GravityAt(t);
              const double h = motion_.world.dt;
              // The response of the spin to a change of the velocity. [1/m]
              const double turns = side.size / side.radius;
              const double lag = (gravity + side.a_W.norm() * h / 2) * t;
              return {
                  .position = {{truth.p_WB,
                                {.scheme = errors.position + lag,
                                 .solved = speed_ * t,
                                 .computed = truth.p_WB.norm()}}},
                  .velocity = {{truth.v_WB,
                                {.scheme = errors.velocity + gravity, .solved = speed_}}},
                  .spin = {{truth.w_WB,
                            {.scheme = errors.spin + gravity * turns,
                             .solved = speed_ * turns + truth.w_WB.norm()}}}};
            }};
  }

  /** Judges the restitution of the normal velocity. */
  Worst Restitution(double until, const std::string& because) const {
    Worst restitution(MeasureKind::kRestitution, because);
    const auto named = [&](const SphereMeeting::Side& side) {
      return CitedName{motion_.world.bodies[static_cast<std::size_t>(side.body)].name};
    };
    for (std::size_t s = 0; s < motion_.trajectory.samples.size(); ++s) {
      const double t = motion_.trajectory.times[s];
      if (t > until) break;
      if (t <= meeting_.time + kLatestImpact * motion_.world.dt) continue;
      const double since =
          n_W_.dot(meeting_.B.a_W - meeting_.A.a_W) * (t - meeting_.time);
      const double e = -(ApproachOf(Is(motion_, s, meeting_), n_W_) + since) / approach_;
      const Allowed allowed = {
          .scheme = (ApproachErrorAt(t) + 2 * GravityAt(t)) / approach_,
          .solved = speed_ / approach_};
      restitution.Take(
          std::abs(e - meeting_.restitution),
          ToleranceOf(allowed, motion_.oracle, StepsBefore(motion_, s)), [&] {
            return Citing(
                "{} has {} and {} separate at {:.6g} m/s after {:.6g} s; they met at "
                "{:.6g} m/s: e = {:.6g}, and the bodies' e is {:.6g}",
                motion_.oracle.name, named(meeting_.A), named(meeting_.B), e * approach_,
                CitedTime{t}, approach_, e, meeting_.restitution);
          });
    }
    return restitution;
  }

 private:
  BothSides Circular(double t, double impact, double inset) const {
    return SidesAt(meeting_, t, impact, inset, circle_);
  }

  /** Returns the largest errors of deviating impacts. They are those of the circle: each
   deviation by another cone is as far from the truth by that cone. */
  ImpactErrors ErrorsAt(double t, Striker BothSides::*of) const {
    const BothSides truth = Circular(t, meeting_.time, 0);
    ImpactErrors errors;
    ForDeviatingImpacts(meeting_.time, motion_.world.dt,
                        [&](double impact, double inset) {
                          errors.Include(Circular(t, impact, inset).*of, truth.*of);
                        });
    return errors;
  }

  double ApproachErrorAt(double t) const {
    const double truth = ApproachOf(Circular(t, meeting_.time, 0), n_W_);
    double error = 0;
    ForDeviatingImpacts(
        meeting_.time, motion_.world.dt, [&](double impact, double inset) {
          const BothSides other = Circular(t, impact, inset);
          error = std::max(error, std::abs(ApproachOf(other, n_W_) - truth));
        });
    return error;
  }

  /** Returns the velocity that an engine may add in the step of the impact, at rest or
   reflected. [m/s] */
  double GravityAt(double t) const {
    const double h = motion_.world.dt;
    if (t < meeting_.time - h) return 0;
    return (meeting_.B.a_W - meeting_.A.a_W).norm() * h * (1 + meeting_.restitution) *
           (1 + meeting_.friction);
  }

  const Motion& motion_;
  const SphereMeeting& meeting_;
  PlacedCone cone_;
  PlacedCone circle_;
  Eigen::Vector3d n_W_;
  double approach_ = 0;  ///< Speed of approach at the impact. [m/s]
  double speed_ = 0;     ///< The largest terms of a velocity. [m/s]
};

std::vector<Worst> JudgeBy(const PlacedCone& cone, const Motion& motion,
                           const SphereMeeting& meeting, double until) {
  const AllowedWords allowed = {
      .scheme =
          "the change by an impact up to a step early or late and inside the "
          "spheres, and by gravity in a step",
      .solved = "the velocity"};
  const Impact impact(motion, meeting, cone);
  std::vector<Prediction> sides = {impact.Predict(meeting.B, &BothSides::B, until)};
  if (meeting.A.radius > 0)
    sides.insert(sides.begin(), impact.Predict(meeting.A, &BothSides::A, until));
  std::vector<Worst> found =
      JudgePredictions(motion,
                       {.position = {allowed, "after the impact it is at"},
                        .velocity = {allowed, "after the impact it moves at"},
                        .spin = {allowed, "after the impact it spins at"}},
                       sides);
  found.push_back(impact.Restitution(until, allowed.Because(motion.oracle)));
  return found;
}

}  // namespace

Eigen::Vector3d SphereMeeting::NormalAt(double t) const {
  if (n_AB_W) return *n_AB_W;
  return (FlownTo(B, t).p_WB - FlownTo(A, t).p_WB).normalized();
}

BothSides SidesAt(const SphereMeeting& meeting, double t, double impact, double inset,
                  const PlacedCone& cone) {
  if (t <= impact) return {FlownTo(meeting.A, t), FlownTo(meeting.B, t)};
  BothSides sides{FlownTo(meeting.A, impact), FlownTo(meeting.B, impact)};
  const Eigen::Vector3d n_W = meeting.NormalAt(impact);
  // Both spheres reach too far by `overlap`; the plane of a half-space does not move.
  const double overlap =
      meeting.n_AB_W
          ? n_W.dot(meeting.B.radius * n_W - sides.B.p_WB + sides.A.p_WB)
          : meeting.A.radius + meeting.B.radius - (sides.B.p_WB - sides.A.p_WB).norm();
  const double inside = inset * std::max(0.0, overlap);
  const Eigen::Vector3d p_B_W = sides.B.p_WB - (meeting.B.radius - inside) * n_W;
  const Eigen::Vector3d p_A_W =
      meeting.n_AB_W ? sides.A.p_WB
                     : Eigen::Vector3d(sides.A.p_WB + (meeting.A.radius - inside) * n_W);
  const Eigen::Matrix3d K =
      ImpulseResponse(sides.A, p_A_W) + ImpulseResponse(sides.B, p_B_W);
  const Eigen::Vector3d J_W =
      CentralImpulse(K, sides.B.VelocityAt(p_B_W) - sides.A.VelocityAt(p_A_W), n_W,
                     meeting.restitution, meeting.friction, cone);
  sides.A.Strike(-J_W, p_A_W);
  sides.B.Strike(J_W, p_B_W);
  Advance(sides.A, meeting.A.a_W, t - impact);
  Advance(sides.B, meeting.B.a_W, t - impact);
  return sides;
}

double Outcome::EnergyRatio() const {
  // Without the factor ½, which cancels. A static side has no energy.
  const auto energy = [](const BothSides& sides) {
    double sum = 0;
    for (const Striker& is : {sides.A, sides.B}) {
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
  const auto at = [&](double t) { return SidesAt(meeting, t, meeting.time, 0, circle); };
  return {at(meeting.time), at(JustAfter(meeting.time))};
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
  SphereMeeting rougher = meeting;
  rougher.friction *= kRough;
  const std::vector<PlacedCone> cones = ConesOn(meeting.NormalAt(meeting.time));
  return JudgedByCone(
      cones,
      [&](const PlacedCone& cone) { return JudgeBy(cone, motion, meeting, until); },
      [&] { return JudgeBy(cones.front(), motion, rougher, until); });
}

}  // namespace touchstone
