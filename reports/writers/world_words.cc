#include "reports/writers/world_words.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/text/counted.h"
#include "reports/worlds/study/judge_world.h"
#include "reports/worlds/study/universal_claims.h"
#include "reports/worlds/study/world_size.h"

namespace touchstone {
namespace {

constexpr double kShareOfScene = 1e-3;

struct Farthest {
  double distance = 0;
  std::string name;

  void Take(double d, const std::string& of) {
    if (d > distance) *this = {d, of};
  }
};

Farthest FarthestAt(const World& world, const WorldState& a, const WorldState& b) {
  Farthest farthest;
  for (std::size_t i = 0; i < a.bodies.size(); ++i)
    farthest.Take((a.bodies[i].p_WB - b.bodies[i].p_WB).norm(), world.bodies[i].name);
  for (std::size_t i = 0; i < a.particles.size(); ++i)
    farthest.Take((a.particles[i].p_W - b.particles[i].p_W).norm(),
                  world.particles[i].name);
  std::size_t node = 0;
  for (const Cloth& cloth : world.cloths) {
    for (int i = 0; i < cloth.n * cloth.n; ++i, ++node)
      farthest.Take((a.nodes[node].p_W - b.nodes[node].p_W).norm(),
                    fmt::format("{}[{}][{}]", cloth.name, i / cloth.n, i % cloth.n));
  }
  return farthest;
}

}  // namespace

std::string Describe(const World& world) {
  const auto fixed = std::count_if(world.bodies.begin(), world.bodies.end(),
                                   [](const RigidBody& body) { return body.mass == 0; });
  std::string words;
  const auto add = [&](std::size_t count, std::string_view noun,
                       std::string_view plural) {
    if (count > 0) words += (words.empty() ? "" : ", ") + Counted(count, noun, plural);
  };
  add(world.bodies.size(), "body", "bodies");
  if (fixed > 0) words += fmt::format(" ({} of them static)", fixed);
  add(world.particles.size(), "particle", "particles");
  add(world.springs.size(), "spring", "springs");
  add(world.joints.size(), "distance joint", "distance joints");
  add(world.cloths.size(), "cloth", "cloths");
  add(world.pushes.size(), "push", "pushes");
  return fmt::format("{}; {} of {:.6g} ms", words,
                     Counted(static_cast<std::uint64_t>(world.steps), "step"),
                     1e3 * world.dt);
}

std::string ClaimsOf(const WorldScenario& scenario) {
  std::string words;
  for (const Claim& claim : scenario.claims) {
    words += (words.empty() ? "" : "; ") + claim.law;
    for (std::size_t i = 0; i < claim.about.size(); ++i)
      words += (i == 0 ? " of " : ", ") + claim.about[i];
  }
  std::vector<std::string> universal;
  for (const Claim& claim : UniversalClaims(scenario)) universal.push_back(claim.law);
  if (!universal.empty())
    words += fmt::format("{}of every motion {}", words.empty() ? "" : "; and ",
                         fmt::join(universal, ", "));
  if (!scenario.expectations.empty())
    words += "; and " + Counted(scenario.expectations.size(), "expectation");
  return words;
}

std::string DriftsInWords(const WorldResult& world, std::size_t oracle,
                          std::span<const Finding> findings) {
  if (!IsWhole(world.trajectories[oracle])) return "";
  const auto judged = [&](MeasureKind measure) -> const Finding* {
    const auto found =
        std::find_if(findings.begin(), findings.end(), [&](const Finding& finding) {
          return finding.measure == measure && finding.reference == "law" &&
                 !finding.law.starts_with("expect");
        });
    return found == findings.end() ? nullptr : &*found;
  };
  const auto words = [&](std::string_view what, double value, MeasureKind measure) {
    const std::string_view unit = UnitOf(measure);
    const Finding* finding = judged(measure);
    std::string text = fmt::format("{} {:.3g} {}", what, value, unit);
    if (!finding) return text;
    // A law takes the worst instant of what it is about, with the tolerance of that
    // instant: another number than the drift of everything over the whole motion.
    const bool is_drift = std::abs(finding->value - value) <= 1e-3 * std::abs(value);
    if (!is_drift) text += fmt::format(", at worst {:.3g} {}", finding->value, unit);
    return text + fmt::format(" of {:.3g} {}", finding->tolerance, unit);
  };
  const MotionDrifts& drifts = world.drifts[oracle];
  std::string text =
      words("energy gained", drifts.energy_gained, MeasureKind::kEnergyDrift) +
      fmt::format(", lost {:.3g} J; ", drifts.energy_lost) +
      words("momentum", drifts.momentum, MeasureKind::kMomentumDrift) + "; " +
      words("angular momentum", drifts.angular_momentum,
            MeasureKind::kAngularMomentumDrift);
  if (const Finding* depth = judged(MeasureKind::kPenetration))
    text += "; " + words("depth", depth->value, MeasureKind::kPenetration);
  return text;
}

std::string Parting(const RunReport& report, const WorldResult& world, std::size_t o) {
  const Trajectory& subject = world.trajectories.front();
  const Trajectory& other = world.trajectories[o];
  const World& of = world.scenario.world;
  const double least = kShareOfScene * SizeOf(of, subject);
  const std::size_t samples = std::min(subject.samples.size(), other.samples.size());
  for (std::size_t s = 0; s < samples; ++s) {
    const Farthest farthest = FarthestAt(of, subject.samples[s], other.samples[s]);
    if (farthest.distance <= least) continue;
    return fmt::format("departs from {} at {:.6g} s: {} is {:.3g} m off", report.subject,
                       subject.times[s], farthest.name, farthest.distance);
  }
  return "";
}

}  // namespace touchstone
