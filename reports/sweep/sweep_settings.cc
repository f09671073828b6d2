#include "reports/sweep/sweep_settings.h"

#include <algorithm>

#include <fmt/format.h>

#include "oracles/stated_tolerance.h"
#include "oracles/world_setup.h"
#include "reports/sweep/tally.h"

namespace touchstone {
namespace {

using Named = std::vector<std::pair<std::string, std::string>>;

std::string Described(const std::vector<const Oracle*>& oracles) {
  std::string text;
  for (const Oracle* oracle : oracles) {
    const OracleInfo& info = oracle->info();
    text += fmt::format(
        "{}{} ({} {}{}{})", text.empty() ? "" : "; ", info.name, info.library,
        info.version,
        info.tolerance.IsZero()
            ? ""
            : ", granted " + ToString(info.tolerance) + " by " + info.tolerance.by,
        info.setup.IsDefault() ? "" : ", " + ToString(info.setup, info.parameters));
  }
  return text;
}

Named NamedOf(const QuestionSeries& series) {
  return {{"family", std::string(NameOf(series.family))},
          {"pair", fmt::format("{} {}", NameOf(series.A), NameOf(series.B))},
          {"seed", fmt::format("{}", series.seed)},
          {"first", fmt::format("{}", series.first)},
          {"count", fmt::format("{}", series.count)},
          {"climb", fmt::format("{}", series.climb)}};
}

Named NamedOf(const FileSeries& series) {
  return {{"questions from", series.file},
          {fmt::format("questions in {} with digest", series.file), series.digest},
          {"pair", fmt::format("{} {}", NameOf(series.A), NameOf(series.B))},
          {"first", fmt::format("{}", series.first)},
          {"count", fmt::format("{}", series.count)}};
}

Named NamedOf(const WorldSeries& series) {
  return {{"family of worlds", std::string(NameOf(series.family))},
          {"seed", fmt::format("{}", series.seed)},
          {"first", fmt::format("{}", series.first)},
          {"count", fmt::format("{}", series.count)}};
}

/** Returns everything as names and values. */
Named Flat(const SweepSettings& settings) {
  Named flat(settings.values.begin(), settings.values.end());
  for (const Series& series : settings.series) {
    const Named named =
        std::visit([](const auto& of_kind) { return NamedOf(of_kind); }, series);
    flat.insert(flat.end(), named.begin(), named.end());
  }
  flat.emplace_back("number of series", fmt::format("{}", settings.series.size()));
  return flat;
}

}  // namespace

SweepSettings SettingsOf(const SweepPlan& plan) {
  SweepSettings settings;
  settings.values = {{"touchstone", TOUCHSTONE_VERSION},
                     {"subjects", Described(plan.subjects)},
                     {"references", Described(plan.references)},
                     {"contact_block", fmt::format("{}", kContactBlock)},
                     {"world_block", fmt::format("{}", kWorldBlock)},
                     {"examined_blocks", fmt::format("{}", kExaminedBlocks)},
                     {"examined_per_kind", fmt::format("{}", kExaminedPerKind)},
                     {"worst_kept", fmt::format("{}", kWorstKept)},
                     {"failures_kept", fmt::format("{}", kFailuresKept)}};
  settings.series = plan.series;
  for (const Oracle* subject : plan.subjects)
    settings.subjects.push_back(subject->info().name);
  return settings;
}

std::optional<std::string> DifferenceOf(const SweepSettings& has,
                                        const SweepSettings& wanted) {
  const Named a = Flat(has);
  const Named b = Flat(wanted);
  const auto [at_a, at_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (at_a == a.end() && at_b == b.end()) return std::nullopt;
  // The lists end with equal names, so neither ends first.
  if (at_a->first != at_b->first) return "other series of questions";
  return fmt::format("{} {}, not {}", at_a->first,
                     at_a->second.empty() ? "none" : at_a->second,
                     at_b->second.empty() ? "none" : at_b->second);
}

}  // namespace touchstone
