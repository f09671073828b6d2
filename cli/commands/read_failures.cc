#include "cli/commands/read_failures.h"

#include <algorithm>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/input_error.h"
#include "cli/select_oracles.h"
#include "reports/sweep/sweep_file.h"
#include "reports/triage/run_failures.h"
#include "reports/triage/sweep_failures.h"
#include "reports/writers/read_report_data.h"

namespace touchstone {
namespace {

constexpr const char* kRunData = "report.data";
constexpr const char* kSweep = "sweep.sqlite";

/** Throws InputError if the oracles of this program are not set up as those of the sweep,
 which would be asked other questions. */
void RequireSameOracles(const SweepFile& file,
                        const std::vector<const Oracle*>& subjects) {
  SweepPlan plan;
  plan.subjects = subjects;
  const std::string now = SettingsOf(plan).values.at("subjects");
  const auto subjects_then = file.settings().values.find("subjects");
  const std::string then =
      subjects_then == file.settings().values.end() ? "" : subjects_then->second;
  if (now == then) return;
  throw InputError(
      fmt::format("{}: it asked {}, not {}; expected the same versions and settings",
                  file.file().string(), then, now));
}

/** Returns the names of those `asked` that `list` names, all of them if it is empty.
 Throws InputError if there are none. */
std::set<std::string> Wanted(const Session& session,
                             const std::vector<std::string>& asked,
                             const std::string& list) {
  if (list.empty() || list == "all") return {asked.begin(), asked.end()};
  std::set<std::string> wanted;
  for (const Oracle* const oracle :
       SubjectsNamed(session.registry, list, QuestionKind::kContact)) {
    if (std::ranges::find(asked, oracle->info().name) != asked.end())
      wanted.insert(oracle->info().name);
  }
  if (!wanted.empty()) return wanted;
  throw InputError(fmt::format("--subject {}: was not asked; expected one of {}", list,
                               fmt::join(asked, ", ")));
}

/** Returns those of `oracles` that are `named`, with their libraries and versions. */
std::string Described(const std::vector<const Oracle*>& oracles,
                      const std::set<std::string>& named) {
  std::vector<std::string> described;
  for (const Oracle* const oracle : oracles) {
    const OracleInfo& info = oracle->info();
    if (named.contains(info.name))
      described.push_back(
          fmt::format("{} ({} {})", info.name, info.library, info.version));
  }
  return fmt::format("{}", fmt::join(described, ", "));
}

FoundFailures OfSweep(const Session& session, const std::filesystem::path& path,
                      const std::string& wanted) {
  const SweepFile file = SweepFile::Open(path);
  FoundFailures found;
  for (const std::string& name : file.settings().subjects)
    found.oracles.push_back(&OracleNamed(session.registry, name));
  RequireSameOracles(file, found.oracles);
  const std::set<std::string> names = Wanted(session, file.settings().subjects, wanted);
  found.failures = FailuresOf(file, names);
  found.asked = Described(found.oracles, names);
  found.is_search = std::ranges::any_of(file.settings().series, IsSearch);
  return found;
}

FoundFailures OfRun(const Session& session, const std::filesystem::path& path,
                    const std::string& wanted, const ParallelWork& work) try {
  const ReadReportResult read = ReadReportFile(path);
  if (!read.data) throw InputError(ToString(read.diagnostics.front()));
  FoundFailures found;
  std::vector<std::string> names;
  for (const auto& [name, version] : read.data->oracles) {
    const Oracle& oracle = OracleNamed(session.registry, name);
    if (oracle.info().version != version) {
      throw InputError(fmt::format(
          "{}: it asked {} of {} {}, not {}; expected the same version", path.string(),
          name, oracle.info().library, version, oracle.info().version));
    }
    names.push_back(name);
    found.oracles.push_back(&oracle);
  }
  const std::set<std::string> chosen = Wanted(session, names, wanted);
  found.asked = Described(found.oracles, chosen);
  const RunQuestions questions = QuestionsOf(*read.data, chosen);
  std::vector<std::optional<OracleTally>> again(questions.failed.size());
  ForEachInParallel(work, again.size(), [&](std::size_t i) {
    const FailedAnswer& answer = questions.failed[i];
    again[i] = AskAgain(answer, OracleNamed(session.registry, answer.oracle));
  });
  found.failures = FailuresOf(questions, again);
  return found;
} catch (const UnreadableQuestion& error) {
  throw InputError(error.what());
}

}  // namespace

std::filesystem::path FailuresFileIn(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw InputError(fmt::format(
        "{}: does not exist; expected the folder of `touchstone sweep --out` or "
        "`touchstone run --out`",
        path.string()));
  }
  if (!std::filesystem::is_directory(path, error)) return path;
  for (const char* const name : {kSweep, kRunData}) {
    if (std::filesystem::exists(path / name, error)) return path / name;
  }
  if (std::filesystem::exists(path / "sweep.unfinished.sqlite", error)) {
    throw InputError(fmt::format(
        "{}: its sweep is not finished; expected the same `touchstone sweep` once more, "
        "which goes on where it stopped",
        path.string()));
  }
  throw InputError(fmt::format(
      "{}: has neither {} nor {}; expected the folder of `touchstone sweep --out` or "
      "`touchstone run --out`",
      path.string(), kSweep, kRunData));
}

FoundFailures ReadFailures(const Session& session, const std::filesystem::path& file,
                           const std::string& wanted, const ParallelWork& work) {
  return file.extension() == ".data" ? OfRun(session, file, wanted, work)
                                     : OfSweep(session, file, wanted);
}

}  // namespace touchstone
