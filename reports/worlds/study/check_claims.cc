#include "reports/worlds/study/check_claims.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/worlds/laws/laws.h"
#include "reports/worlds/study/body_steps.h"
#include "reports/worlds/study/run_claims.h"
#include "scenarios/schema/nearest_name.h"

namespace touchstone {
namespace {

/** Returns what is expected instead of the unknown law `misspelt`. */
std::string LawLike(std::string_view misspelt) {
  std::vector<std::string_view> names = {kDeterministic, kStable};
  for (const Law& known : Laws()) names.push_back(known.name);
  const std::string_view nearest = NearestName(misspelt, names);
  return nearest.empty() ? fmt::format("one of {}", fmt::join(names, ", "))
                         : fmt::format("\"{}\"", nearest);
}

/** Returns what is expected instead of a number that is not one of `known`. */
std::string OneOf(std::span<const std::string_view> known, std::string_view law) {
  if (known.empty()) return fmt::format("none: {} takes no numbers", law);
  if (known.size() == 1) return fmt::format("\"{}\"", known.front());
  return fmt::format("one of {}", fmt::join(known, ", "));
}

/** Adds the error in the gain of a `stable` claim, if there is one. */
void AddErrorOfGain(const Claim& claim, std::string_view path, const FilePlaces& places,
                    std::vector<Diagnostic>& errors) {
  const auto gain = claim.numbers.find(std::string(kStableGain));
  const bool is_there = gain != claim.numbers.end();
  if (is_there && gain->second >= 1 && std::isfinite(gain->second)) return;
  errors.push_back(ErrorAtValue(
      places,
      is_there ? fmt::format("{}.numbers.{}", path, kStableGain)
               : fmt::format("{}.law", path),
      is_there ? fmt::format("{}.numbers.{} is {}", path, kStableGain, gain->second)
               : fmt::format("{} has no number \"{}\" ({})", path, kStableGain, kStable),
      "the largest factor by which the motion amplifies a change of its start, 1 or "
      "more"));
}

/** Adds the errors of one claim; `path` is its path in the file, e.g. "claims[2]". */
void AddErrors(const World& world, const Claim& claim, std::string_view path,
               const FilePlaces& places, std::vector<Diagnostic>& errors) {
  const Law* law = FindLaw(claim.law);
  const bool is_stable = claim.law == kStable;
  if (!law && !is_stable && claim.law != kDeterministic) {
    errors.push_back(
        ErrorAtValue(places, fmt::format("{}.law", path),
                     fmt::format("{}.law is \"{}\", which is not a law", path, claim.law),
                     LawLike(claim.law)));
    return;
  }
  const std::span<const std::string_view> known =
      law         ? law->numbers
      : is_stable ? std::span(&kStableGain, 1)
                  : std::span<const std::string_view>();
  Claim understood = claim;
  for (const auto& [name, number] : claim.numbers) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    understood.numbers.erase(name);
    errors.push_back(
        ErrorAtKey(places, fmt::format("{}.numbers.{}", path, name),
                   fmt::format("unknown key \"{}\" in {}.numbers", name, path),
                   OneOf(known, claim.law)));
  }
  if (is_stable) AddErrorOfGain(claim, path, places, errors);
  if (!law && !claim.about.empty()) {
    errors.push_back(
        ErrorAtValue(places, fmt::format("{}.about", path),
                     fmt::format("{}.about names something ({})", path, claim.law),
                     "no names: it is about everything that moves"));
  }
  if (!law) return;
  std::set<std::tuple<std::string, std::string, std::string>> told;
  for (const Fault& fault : law->faults(world, understood)) {
    // A law may report the same fault of a number once for each body.
    if (!told.emplace(fault.where, fault.what, fault.expected).second) continue;
    errors.push_back(ErrorAtValue(
        places, fmt::format("{}.{}", path, fault.where),
        fmt::format("{}.{} {} ({})", path, fault.where, fault.what, claim.law),
        fault.expected));
  }
}

}  // namespace

std::vector<ClaimName> ClaimNames() {
  std::vector<ClaimName> claims = {
      {kDeterministic, "A second run of the same world gives the same bits."},
      {kStable,
       "The motion amplifies a change of its start at most gain times, a number of the "
       "claim."}};
  for (const Law& law : Laws()) {
    claims.push_back({law.name, law.documentation});
    for (const std::string_view alias : law.aliases)
      claims.push_back({alias, law.documentation});
  }
  std::sort(claims.begin(), claims.end(),
            [](const ClaimName& a, const ClaimName& b) { return a.name < b.name; });
  return claims;
}

std::vector<Diagnostic> ErrorsOfClaims(const WorldScenario& scenario) {
  FilePlaces places = scenario.places;
  if (places.file.empty()) places.file = scenario.id;
  std::vector<Diagnostic> errors;
  for (std::size_t i = 0; i < scenario.claims.size(); ++i) {
    const Claim& claim = scenario.claims[i];
    const std::string path = fmt::format("claims[{}]", i);
    AddErrors(scenario.world, claim, path, places, errors);
    if (claim.law != kStable) continue;
    const auto add = [&](std::string_view what, std::string_view expected) {
      errors.push_back(ErrorAtValue(places, fmt::format("{}.law", path),
                                    fmt::format("{}.law is \"stable\" {}", path, what),
                                    std::string(expected)));
    };
    if (!IsStudied(scenario)) {
      add("in a world too large to be simulated twice",
          fmt::format("at most {:g} bodies times steps", kStudiedBodySteps));
    }
    const auto is_stable = [](const Claim& other) { return other.law == kStable; };
    if (std::any_of(scenario.claims.begin(),
                    scenario.claims.begin() + static_cast<std::ptrdiff_t>(i), is_stable))
      add("a second time", "one gain per world");
  }
  return errors;
}

}  // namespace touchstone
