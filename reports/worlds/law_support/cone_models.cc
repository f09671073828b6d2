#include "reports/worlds/law_support/cone_models.h"

#include "reports/worlds/law_support/landing.h"

namespace touchstone {

World Rougher(World world) {
  for (RigidBody& body : world.bodies) body.friction *= kRough;
  return world;
}

bool IsFrictionCone(std::string_view model) {
  return model == NameOf(FrictionCone::kBox) || model == NameOf(FrictionCone::kDiamond);
}

std::vector<LawFinding> JudgedByCone(
    const std::vector<PlacedCone>& cones,
    const std::function<std::vector<Worst>(const PlacedCone&)>& judge_by,
    const std::function<std::vector<Worst>()>& by_rougher) {
  const std::vector<Worst> by_circle = judge_by(cones.front());
  std::string_view recognised;
  for (std::size_t i = 1; i < cones.size() && AnyBeyond(by_circle); ++i) {
    if (AnyBeyond(judge_by(cones[i]))) continue;
    if (AnyBeyond(by_rougher())) recognised = NameOf(cones[i].cone);
    break;
  }
  return FindingsOf(by_circle, recognised);
}

std::vector<LawFinding> JudgedByCone(
    const Motion& motion, const std::vector<int>& bodies,
    const std::function<std::vector<Worst>(const PlacedCone&, const Motion&, int body)>&
        judge_by) {
  const World rougher = Rougher(motion.world);
  const Motion on_rougher{rougher, motion.oracle, motion.trajectory};
  return WorstOfEach(bodies, [&](int body) {
    const std::vector<PlacedCone> cones = ConesOn(LandingOf(motion.world, body)->n_W);
    return JudgedByCone(
        cones, [&](const PlacedCone& cone) { return judge_by(cone, motion, body); },
        [&] { return judge_by(cones.front(), on_rougher, body); });
  });
}

}  // namespace touchstone
