#include "reports/clusters/shares.h"

#include <algorithm>
#include <map>
#include <string_view>

#include "reports/contacts/body_size.h"
#include "reports/contacts/grade.h"
#include "reports/worlds/study/motion_scale.h"

namespace touchstone {

std::vector<FindingPlace> PlacesOf(const RunReport& report) {
  std::map<std::string_view, std::size_t> questions;
  for (std::size_t i = 0; i < QuestionCount(report); ++i) questions[IdOf(report, i)] = i;
  std::map<std::string_view, std::size_t> oracles;
  for (std::size_t o = 0; o < report.oracles.size(); ++o)
    oracles[report.oracles[o].name] = o;
  std::vector<FindingPlace> places;
  places.reserve(report.findings.size());
  for (const Finding& finding : report.findings)
    places.push_back({questions.at(finding.scenario), oracles.at(finding.oracle)});
  return places;
}

std::vector<double> SharesOf(const RunReport& report,
                             const std::vector<FindingPlace>& places) {
  const std::size_t contacts = report.scenarios.size();
  std::vector<double> shares;
  shares.reserve(places.size());
  // Findings are sorted by question, then by oracle: each motion has one scale.
  MotionScale scale;
  FindingPlace of_scale{QuestionCount(report), 0};
  for (std::size_t f = 0; f < places.size(); ++f) {
    const auto [question, oracle] = places[f];
    const Finding& finding = report.findings[f];
    if (question < contacts) {
      const ScenarioResult& result = report.scenarios[question];
      shares.push_back(ShareOf(finding, result.scenario.contact, result.truth));
      continue;
    }
    if (question != of_scale.question || oracle != of_scale.oracle) {
      const WorldResult& world = report.worlds[question - contacts];
      scale = ScaleOf(world.scenario.world, world.trajectories[oracle].samples);
      of_scale = places[f];
    }
    shares.push_back(ShareOf(finding, scale));
  }
  return shares;
}

double SizeOfQuestion(const RunReport& report, std::size_t i) {
  const std::size_t contacts = report.scenarios.size();
  if (i < contacts) return SmallerExtent(report.scenarios[i].scenario.contact);
  const WorldResult& world = report.worlds[i - contacts];
  const auto motion = std::ranges::find_if(
      world.trajectories, [](const Trajectory& t) { return !t.samples.empty(); });
  return ScaleOf(world.scenario.world, motion == world.trajectories.end()
                                           ? std::vector<WorldState>()
                                           : motion->samples)
      .length;
}

std::string_view SizedPartOf(const RunReport& report, std::size_t i) {
  const std::size_t contacts = report.scenarios.size();
  if (i < contacts) return "the smaller body";
  const World& world = report.worlds[i - contacts].scenario.world;
  return std::ranges::any_of(world.bodies,
                             [](const RigidBody& body) { return body.mass > 0; })
             ? "the smallest moving body"
             : "the extent of its points";
}

}  // namespace touchstone
