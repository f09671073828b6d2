#include "reports/worlds/law_support/reported_impulses.h"

#include <algorithm>
#include <string>
#include <utility>

#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/numbers.h"

namespace touchstone {

ReportedImpulses ReportedBefore(const Motion& motion, std::size_t s) {
  ReportedImpulses reported;
  reported.on_body.resize(motion.world.bodies.size());
  const std::vector<const ContactImpulse*> all = ImpulsesBetween(motion, s - 1, s);
  for (const ContactImpulse* contact : all) {
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

}  // namespace touchstone
