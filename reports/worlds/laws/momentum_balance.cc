#include "reports/worlds/laws/momentum_balance.h"

#include <algorithm>

#include <fmt/format.h>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  for (const int i : SubjectsOf(world, claim).bodies) {
    if (!IsHeld(world, AnchorKind::kBody, i)) continue;
    const std::string& name = world.bodies[static_cast<std::size_t>(i)].name;
    faults.push_back(FaultAbout(claim, name, "a spring or a joint holds",
                                "a body that is held only by contacts"));
  }
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  if (!trajectory.gives_impulses) return {};
  Worst worst(
      MeasureKind::kMomentumBalance,
      "64 roundings per step: every scheme sums the impulses that it applies; and 3000 "
      "roundings of the impulses for each contact of a step, for the solver",
      Grants::kRounding);
  for (std::size_t s = 1; s < trajectory.samples.size(); ++s) {
    const std::vector<const ContactImpulse*> impulses = ImpulsesBetween(motion, s - 1, s);
    const double from = trajectory.times[s - 1];
    const double to = trajectory.times[s];
    for (const int index : SubjectsOf(world, claim).bodies) {
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
      for (const ContactImpulse* contact : impulses) {
        const Eigen::Vector3d J_W = ImpulseOn(*contact, index);
        given_W += J_W;
        pushed += J_W.norm();
      }
      size += pushed;
      // Each contact of a step rounds what all of them have given, through the bodies
      // between them.
      const double contacts = static_cast<double>(impulses.size());
      const double solver = kRoundingsOfSolver * motion.oracle.unit_roundoff *
                            std::max(1.0, contacts / world.sample_every) * pushed;
      const Eigen::Vector3d gained_W =
          body.mass * (trajectory.samples[s].bodies[i].v_WB -
                       trajectory.samples[s - 1].bodies[i].v_WB);
      worst.Take((gained_W - given_W).norm(),
                 RoundingOf(motion.oracle, world.sample_every) * size + solver, [&] {
                   return fmt::format(
                       "{} has {} gain {} from {:.6g} to {:.6g} s; gravity, force, "
                       "pushes and the reported contacts give {}",
                       motion.oracle.name, body.name, FormatVector(gained_W, 9), from, to,
                       FormatVector(given_W, 9));
                 });
    }
  }
  return FindingsOf({worst});
}

}  // namespace

constinit const Law kMomentumBalance = {
    .name = "momentum_balance",
    .documentation =
        "A body's momentum changes by gravity, force, pushes and the reported contacts.",
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
