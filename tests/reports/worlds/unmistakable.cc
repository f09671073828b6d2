#include "tests/reports/worlds/unmistakable.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <regex>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/text/format_vector.h"

namespace touchstone {
namespace {

/** Calls `each` with the name of every body, particle and cloth. */
template <typename SomeWorld, typename Each>
void ForEachName(SomeWorld& world, Each each) {
  for (auto& body : world.bodies) each(body.name);
  for (auto& particle : world.particles) each(particle.name);
  for (auto& cloth : world.cloths) each(cloth.name);
}

/** Returns the names in `sentence`, in the order in which they first occur. */
std::vector<std::string> NamesIn(const World& world, std::string_view sentence) {
  std::map<std::size_t, std::string> by_place;
  ForEachName(world, [&](const std::string& name) {
    const std::size_t at = sentence.find(name);
    if (at != std::string_view::npos) by_place[at] = name;
  });
  std::vector<std::string> names;
  for (auto& [at, name] : by_place) names.push_back(std::move(name));
  return names;
}

}  // namespace

Unmistakable WithUnmistakableNames(World world, Claim claim) {
  std::map<std::string, std::string> renamed;
  ForEachName(world, [&](std::string& name) {
    // Ends in a letter, so that none is the beginning of another.
    std::string unmistakable = fmt::format("Q{}Q", renamed.size());
    renamed[name] = unmistakable;
    name = std::move(unmistakable);
  });
  for (std::vector<std::string>* names : {&claim.about, &claim.claimed}) {
    for (std::string& name : *names) name = renamed.at(name);
  }
  return {std::move(world), std::move(claim)};
}

testing::AssertionResult CitesWhatItSays(const World& world, std::string_view sentence,
                                         const Cited& cited) {
  const std::vector<std::string> named = NamesIn(world, sentence);
  if (named != cited.names) {
    return testing::AssertionFailure()
           << fmt::format("cites {}, but not as it says: {}", cited.names, sentence);
  }
  static const std::regex moment("\\d s\\b");
  const bool has_moment = std::regex_search(sentence.begin(), sentence.end(), moment);
  if (has_moment != cited.time.has_value()) {
    return testing::AssertionFailure()
           << (has_moment ? "cites no moment: " : "cites an unsaid moment: ") << sentence;
  }
  if (cited.time &&
      sentence.find(fmt::format("{:.6g} s", *cited.time)) == std::string_view::npos) {
    return testing::AssertionFailure()
           << "cites the moment " << *cited.time << " s: " << sentence;
  }
  for (const Eigen::Vector3d& p_W : cited.points_W) {
    if (sentence.find(FormatVector(p_W, 9)) != std::string_view::npos) continue;
    return testing::AssertionFailure()
           << "cites the point " << FormatVector(p_W, 9) << ": " << sentence;
  }
  return testing::AssertionSuccess();
}

}  // namespace touchstone
