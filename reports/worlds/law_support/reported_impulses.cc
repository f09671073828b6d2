#include "reports/worlds/law_support/reported_impulses.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Least part of the loads on a sleeping body that its contacts carry. They carry all of
 it to within the residual of a solver at rest: half is far from both. [-] */
constexpr double kLeastCarried = 0.5;

}  // namespace

ReportedImpulses ReportedBefore(const Motion& motion, std::size_t s) {
  ReportedImpulses reported;
  reported.on_body.resize(motion.world.bodies.size());
  const std::vector<const ContactImpulse*> all = ImpulsesBetween(motion, s - 1, s);
  for (const ContactImpulse* contact : all) {
    reported.total += contact->J_B_W.norm();
    for (const int body : {contact->A, contact->B})
      reported.on_body[static_cast<std::size_t>(body)].push_back(contact);
  }
  reported.contacts_per_step =
      std::max(1.0, static_cast<double>(all.size()) / motion.world.sample_every);
  return reported;
}

std::vector<Fault> FaultsOfReported(const World& world, const Claim& claim) {
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

SleepLoss SleepLossBefore(const Motion& motion, const ReportedImpulses& reported,
                          int index, std::size_t s) {
  const auto i = static_cast<std::size_t>(index);
  const BodyState& at = motion.trajectory.samples[s].bodies[i];
  if (motion.oracle.sleep_speed == 0 || !at.v_WB.isZero(0) || !at.w_WB.isZero(0))
    return {};
  const Eigen::Vector3d loads_W = ImpulseOfLoads(motion, index, s);
  Eigen::Vector3d carried_W = Eigen::Vector3d::Zero();
  for (const ContactImpulse* contact : reported.on_body[i])
    carried_W += ImpulseOn(*contact, index);
  // Written so that a NaN carries nothing. Without loads any slow body may fall asleep.
  if (!(-carried_W.dot(loads_W) >= kLeastCarried * loads_W.squaredNorm())) return {};
  const RigidBody& body = motion.world.bodies[i];
  const double u = motion.oracle.sleep_speed;
  return {body.mass * u,
          InertiaOf(body).maxCoeff() * u / BoundingRadius(body.placed.shape)};
}

std::string WithSleep(std::string because, const OracleInfo& oracle) {
  if (oracle.sleep_speed == 0) return because;
  return fmt::format(
      "{}; and what a body loses that falls asleep, at {:.3g} m/s at most ({})", because,
      oracle.sleep_speed, oracle.sleep_documented_by);
}

}  // namespace touchstone
