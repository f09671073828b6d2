#include <algorithm>
#include <array>
#include <string_view>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/scheme_drift.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  const std::vector<int> bodies = SubjectsOf(world, claim).bodies;
  for (const int i : bodies) {
    if (IsPushed(world, i) && !IsHeld(world, AnchorKind::kBody, i)) continue;
    const std::string& name = world.bodies[static_cast<std::size_t>(i)].name;
    faults.push_back(
        FaultAbout(claim, name, "has no push or is held", "a free body with a push"));
  }
  if (!faults.empty()) return faults;
  const RigidBody& body = world.bodies[static_cast<std::size_t>(bodies.front())];
  const Push& push =
      *PushesBetween(world, bodies.front(), 0, world.steps * world.dt).front();
  const Eigen::Vector3d J_B = body.placed.X_WB.R_WB.transpose() * push.J_W;
  return FaultsOfNumbers(claim,
                         {{"expected_speed_gain", push.J_W.norm() / body.mass},
                          // In the body's frame at the start, so valid only if it does
                          // not turn before the push.
                          {"expected_spin_gain",
                           push.p_BoP.cross(J_B).cwiseQuotient(InertiaOf(body)).norm()}});
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  Worst momentum(MeasureKind::kMomentumDrift, "64 roundings per step", Grants::kRounding);
  Worst spin(MeasureKind::kAngularMomentumDrift,
             "1.5 × the loss by the gyroscopic term, h ω × (ω × L) Δt; |ω| Δt |r| |J| if "
             "the push falls between samples; and 64 roundings per step");
  const AllowedMotion allowed(motion);
  for (std::size_t s = 1; s < trajectory.samples.size(); ++s) {
    const double from = trajectory.times[s - 1];
    const double to = trajectory.times[s];
    for (const int index : SubjectsOf(world, claim).bodies) {
      const auto i = static_cast<std::size_t>(index);
      const RigidBody& body = world.bodies[i];
      const std::vector<const Push*> pushes = PushesBetween(world, index, from, to);
      if (pushes.empty()) continue;
      const BodyState& before = trajectory.samples[s - 1].bodies[i];
      const BodyState& after = trajectory.samples[s].bodies[i];
      const Eigen::Vector3d loads_W = ImpulseOfLoads(motion, index, s);
      const Eigen::Vector3d L_before = InertiaInWorld(body, before.q_WB) * before.w_WB;
      const Eigen::Vector3d L_after = InertiaInWorld(body, after.q_WB) * after.w_WB;
      Eigen::Vector3d P_W = body.mass * before.v_WB + loads_W;
      Eigen::Vector3d L_W = L_before;
      double size = body.mass * (before.v_WB.norm() + after.v_WB.norm()) + loads_W.norm();
      // A rounding of the orientation turns I, by the largest moment.
      double L_size =
          InertiaOf(body).maxCoeff() * (before.w_WB.norm() + after.w_WB.norm());
      double turned = 0;
      for (const Push* push : pushes) {
        P_W += push->J_W;
        L_W += (before.q_WB * push->p_BoP).cross(push->J_W);
        size += push->J_W.norm();
        // An engine that takes a point in the world subtracts the centre from it.
        L_size += (push->p_BoP.norm() + before.p_WB.norm()) * push->J_W.norm();
        turned += allowed.At(s - 1).bodies[i].w_WB.norm() *
                  std::max(0.0, push->time - from) * push->p_BoP.norm() *
                  push->J_W.norm();
      }
      const Subjects subject{{index}, {}, {}};
      const std::vector<double> drift = GyroscopicMomentumDrift(motion, allowed, subject);
      const double rounding = RoundingOf(motion.oracle, world.sample_every);
      momentum.Take((body.mass * after.v_WB - P_W).norm(), rounding * size, [&] {
        return Citing("{} has {} at {} N s after {:.6g} s; the push leaves it {}",
                      motion.oracle.name, CitedName{body.name},
                      FormatVector(body.mass * after.v_WB, 9), CitedTime{to},
                      FormatVector(P_W, 9));
      });
      spin.Take((L_after - L_W).norm(),
                kSafety * (drift[s] - drift[s - 1] + turned) + rounding * L_size, [&] {
                  return Citing(
                      "{} has {} at an angular momentum of {} after {:.6g} s; the push "
                      "leaves it {}",
                      motion.oracle.name, CitedName{body.name}, FormatVector(L_after, 9),
                      CitedTime{to}, FormatVector(L_W, 9));
                });
    }
  }
  return FindingsOf({momentum, spin});
}

constexpr std::array<std::string_view, 2> kNumbers = {"expected_speed_gain",
                                                      "expected_spin_gain"};

}  // namespace

/** A push J at the point r of a body gives it the momentum J and the angular momentum r ×
 J about its centre; gravity and its force give Δt (m g + F). [N s], [N m s]

 Judged from the sample before each push to the one after it, relative to the motion's own
 state before. Tolerance of the momentum: rounding. Tolerance of the angular momentum:
 what the gyroscopic term may lose between the two samples, h Δt times the rate in
 law_support/scheme_drift.h, × 1.5; and, if no sample falls on the push, |ω| Δt |r| |J|,
 since the body has turned by then.

 About: bodies with pushes that nothing else touches or holds between those samples.
 Numbers: expected_speed_gain |J|/m and expected_spin_gain |I⁻¹ r × J|, of the first push
 of the first body. */
constinit const Law kPushed = {
    .name = "pushed",
    .documentation =
        "A push J at the point r gives a body the momentum J and the angular momentum r "
        "× J.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
