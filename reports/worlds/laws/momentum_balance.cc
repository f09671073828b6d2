#include <algorithm>
#include <vector>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/reported_impulses.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  if (!trajectory.gives_impulses) return {};
  Worst worst(
      MeasureKind::kMomentumBalance,
      WithSleep(
          "64 roundings per step: every scheme sums the impulses that it applies; the "
          "square root of the unit roundoff, the error of a solver that minimises a "
          "cost, times the impulses on the body for each contact of a step, or all "
          "impulses of a step; and velocities that are roundings of positions over a "
          "step",
          motion.oracle),
      Grants::kRounding);
  const std::vector<int> bodies = SubjectsOf(world, claim).bodies;
  for (std::size_t s = 1; s < trajectory.samples.size(); ++s) {
    const ReportedImpulses reported = ReportedBefore(motion, s);
    const double from = trajectory.times[s - 1];
    const double to = trajectory.times[s];
    for (const int index : bodies) {
      const auto i = static_cast<std::size_t>(index);
      const RigidBody& body = world.bodies[i];
      const Eigen::Vector3d loads_W = ImpulseOfLoads(motion, index, s);
      Eigen::Vector3d given_W = loads_W;
      double size =
          loads_W.norm() + body.mass * (trajectory.samples[s - 1].bodies[i].v_WB.norm() +
                                        trajectory.samples[s].bodies[i].v_WB.norm());
      for (const Push* push : PushesBetween(world, index, from, to)) {
        given_W += push->J_W;
        size += push->J_W.norm();
      }
      double pushed = 0;
      for (const ContactImpulse* contact : reported.on_body[i]) {
        const Eigen::Vector3d J_W = ImpulseOn(*contact, index);
        given_W += J_W;
        pushed += J_W.norm();
      }
      size += pushed;
      // Each contact of a step rounds what all of them have given, through the bodies
      // between them; and a cost is one of all impulses of a step.
      const double solver =
          SolverRoundingOf(motion.oracle) *
          std::max(reported.contacts_per_step * pushed, pushed > 0 ? reported.total : 0);
      const Eigen::Vector3d gained_W =
          body.mass * (trajectory.samples[s].bodies[i].v_WB -
                       trajectory.samples[s - 1].bodies[i].v_WB);
      worst.Take(
          (gained_W - given_W).norm(),
          RoundingOf(motion.oracle, world.sample_every) * size + solver +
              NoiseOfPositions(world, trajectory.samples[s], Subjects{{index}, {}, {}},
                               motion.oracle.unit_roundoff)
                  .momentum +
              SleepLossBefore(motion, reported, index, s).momentum,
          [&] {
            const ToldApart told = TellApart(gained_W, given_W, 9);
            return Citing(
                "{} has {} gain {} from {:.6g} to {:.6g} s; gravity, force, "
                "pushes and the reported contacts give {}",
                motion.oracle.name, CitedName{body.name}, told.a, from, CitedTime{to},
                told.b);
          });
    }
  }
  return FindingsOf({worst});
}

}  // namespace

/** A body's momentum changes by gravity, its force, pushes and the contact impulses that
 the engine reports: m Δv = Δt (m g + F) + Σ J. [N s]

 Every scheme satisfies that, for any step and however badly contacts are solved. So the
 tolerance is rounding alone: 64 roundings per step of the sum of the magnitudes;
 SolverRoundingOf() of the impulses on the body for each contact of a step, or of all
 impulses of the step if that is more, since a cost is one of all of them; and the
 momentum of NoiseOfPositions(). An engine whose impulses do not balance reports others
 than it applied.

 Judges only engines that report contact impulses. About: bodies that no spring or joint
 holds. Numbers: none. */
constinit const Law kMomentumBalance = {
    .name = "momentum_balance",
    .documentation =
        "A body's momentum changes by gravity, force, pushes and the reported contacts.",
    .faults = FaultsOfReported,
    .judge = Judge,
    .universal =
        [](const World& world) { return ClaimAboutEach(kMomentumBalance, world); },
    .of_steps = true,
};

}  // namespace touchstone
