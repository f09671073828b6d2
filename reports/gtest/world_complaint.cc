#include "reports/gtest/world_complaint.h"

#include <optional>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "reports/run.h"
#include "reports/text/counted.h"
#include "reports/worlds/study/check_claims.h"
#include "reports/writers/explanation_writer.h"
#include "scenarios/scenario_file.h"

namespace touchstone {

std::string ComplaintAboutWorlds(const Oracle& subject,
                                 std::span<const WorldScenario> worlds,
                                 std::span<const Oracle* const> references) {
  std::vector<const Oracle*> oracles = {&subject};
  oracles.insert(oracles.end(), references.begin(), references.end());
  std::string faults;
  for (const WorldScenario& world : worlds) {
    for (const Diagnostic& error : ErrorsOfClaims(world))
      faults += ToString(error) + '\n';
  }
  if (!faults.empty()) return faults;
  std::string failed;
  std::size_t failures = 0;
  bool verified = false;
  std::optional<RunReport> first;
  RunOptions options;
  options.partial = true;
  for (const WorldScenario& world : worlds) {
    RunReport report =
        Run(Questions{.contacts = {}, .worlds = {world}}, oracles, {}, options);
    for (const std::string& fault : report.faults) faults += fault + '\n';
    verified = verified || IsSubjectExamined(report);
    // Code 1 is a failure of the subject or a fault of the file.
    if (!report.faults.empty() || ExitCode(report, {.whose = FailOn::kSubject}) != 1)
      continue;
    ++failures;
    failed += fmt::format("  {}\n", world.id);
    if (!first) first = std::move(report);
  }
  if (!faults.empty()) return faults;
  const std::string& name = subject.info().name;
  const std::string all = Counted(worlds.size(), "world");
  if (first) {
    std::ostringstream text;
    text << fmt::format("{} is wrong in {} of {}:\n{}The first:\n\n", name, failures, all,
                        failed);
    WriteExplanation(*first, {}, text);
    text << "\nThe world, as a file for `touchstone run`:\n\n"
         << WriteScenario(first->worlds[0].scenario);
    return text.str();
  }
  if (verified) return "";
  return fmt::format(
      "nothing of {} was verified in {}; expected a world that it "
      "simulates, to which a law applies, at a step that is small enough to decide",
      name, all);
}

std::string ComplaintAboutWorlds(const Oracle& subject,
                                 const std::filesystem::path& file_or_folder,
                                 std::span<const Oracle* const> references) {
  const Catalogue read = ReadCatalogue(file_or_folder);
  std::string errors;
  for (const Diagnostic& diagnostic : read.diagnostics)
    errors += ToString(diagnostic) + '\n';
  if (!errors.empty()) return errors;
  return ComplaintAboutWorlds(subject, read.worlds, references);
}

}  // namespace touchstone
