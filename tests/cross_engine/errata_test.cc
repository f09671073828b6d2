// Each erratum of the published recipes, alone, is found by a measure; with all of them
// off, nothing is. The comparators do not know which erratum is on: they see an oracle.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/oracle_registry.h"
#include "reports/run_report.h"
#include "reports/worlds/study/run_worlds.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

const Catalogue& TheCatalogue() {
  static const Catalogue catalogue =
      ReadCatalogue(std::filesystem::path(TOUCHSTONE_DATA_DIR) / "catalogue");
  return catalogue;
}

const Oracle* OracleNamed(const std::string& name) {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry.Find(name);
}

// Failed findings per measure.
std::map<std::string, int> FailuresAmong(const std::vector<Finding>& findings) {
  std::map<std::string, int> failures;
  for (const Finding& finding : findings) {
    if (finding.verdict == Verdict::kFail || finding.verdict == Verdict::kInvalid) {
      ++failures[std::string(NameOf(finding.measure))];
    }
  }
  return failures;
}

// What was found of an oracle in contact queries.
std::map<std::string, int> FailuresOf(const std::string& oracle_name) {
  const Oracle* oracle = OracleNamed(oracle_name);
  if (oracle == nullptr) return {};
  return FailuresAmong(
      Run(TheCatalogue().scenarios, std::span(&oracle, 1), {}, {}).findings);
}

// What was found of an oracle in the worlds whose ids begin so.
std::map<std::string, int> FailuresInWorlds(const std::string& oracle_name,
                                            const std::string& beginning) {
  const Oracle* oracle = OracleNamed(oracle_name);
  std::vector<WorldScenario> worlds;
  const std::vector<WorldScenario>& all = TheCatalogue().worlds;
  std::copy_if(
      all.begin(), all.end(), std::back_inserter(worlds),
      [&](const WorldScenario& world) { return world.id.starts_with(beginning); });
  if (oracle == nullptr || worlds.empty()) return {{"nothing was asked", 1}};
  return FailuresAmong(RunWorlds(worlds, std::span(&oracle, 1), 1, {}).findings);
}

// "E-10" is "e10" in the names of worlds and of tests.
std::string FileNameOf(std::string erratum) {
  erratum.erase(erratum.find('-'), 1);
  erratum[0] = 'e';
  return erratum;
}

struct Specimen {
  const char* erratum;
  const char* measure;  // One that must find it, by what the erratum does.
};

class PrintedErratum : public testing::TestWithParam<Specimen> {};

TEST_P(PrintedErratum, AloneIsFoundByTheMeasureOfItsKind) {
  const auto [erratum, measure] = GetParam();
  const std::map<std::string, int> failures =
      FailuresOf(std::string("printed:") + erratum);
  EXPECT_THAT(failures, testing::Contains(testing::Key(measure)))
      << testing::PrintToString(failures);
}

INSTANTIATE_TEST_SUITE_P(
    OfContact, PrintedErratum,
    testing::Values(
        Specimen{"E-01", "touching"},  // Apart on an axis it does not test.
        Specimen{"E-02", "excess"},    // The normal loses its negative components.
        Specimen{"E-03", "separation_error"}, Specimen{"E-04", "consistency_error"},
        Specimen{"E-05", "excess"},     // A centre inside leaves by the wrong face.
        Specimen{"E-06", "touching"},   // Concentric shapes are said to be apart.
        Specimen{"E-07", "answering"},  // Touching, without the promised contact.
        Specimen{"E-08", "contact_off_patch"},  // Four contacts where two are right.
        Specimen{"E-09", "patch_coverage"},     // Contacts within a centimetre are one.
        Specimen{"E-26", "separation_error"}),
    [](const testing::TestParamInfo<Specimen>& instance) {
      return FileNameOf(instance.param.erratum);
    });

class PrintedErratumOfMotion : public testing::TestWithParam<Specimen> {};

TEST_P(PrintedErratumOfMotion, AloneIsFoundInItsWorldByTheMeasureOfItsKind) {
  const auto [erratum, measure] = GetParam();
  const std::map<std::string, int> failures = FailuresInWorlds(
      std::string("printed:") + erratum, "world/errata/" + FileNameOf(erratum));
  EXPECT_THAT(failures, testing::Contains(testing::Key(measure)))
      << testing::PrintToString(failures);
}

// Without E-21: no file can hold its world.
INSTANTIATE_TEST_SUITE_P(
    OfMotion, PrintedErratumOfMotion,
    testing::Values(
        Specimen{"E-10", "velocity_error"},     // A blow is not divided by the mass.
        Specimen{"E-11", "momentum_drift"},     // Damped, though nobody asked.
        Specimen{"E-12", "restitution"},        // Four contacts share one bounce.
        Specimen{"E-13", "orientation_error"},  // Balls do not turn.
        Specimen{"E-14", "spin_error"},  // The inertia does not turn with the plank.
        Specimen{"E-15", "orientation_error"},       // Euler angles gain ω dt.
        Specimen{"E-16", "angular_momentum_drift"},  // No gyroscopic term.
        Specimen{"E-17", "energy_drift"},            // Damping that drives.
        Specimen{"E-18", "energy_drift"},            // A force without dt.
        Specimen{"E-19", "limit_error"},             // A share kept per step.
        Specimen{"E-20", "answering"},  // Starts at its place times the spacing.
        Specimen{"E-22", "angular_momentum_drift"},  // Corrections half and half.
        Specimen{"E-23", "velocity_error"},  // Friction against the slip from before.
        Specimen{"E-24", "penetration"},     // Pushed out, but not turned.
        Specimen{"E-25", "friction"}),       // No friction below a threshold.
    [](const testing::TestParamInfo<Specimen>& instance) {
      return FileNameOf(instance.param.erratum);
    });

TEST(PrintedWithoutErrata, IsNeverProvedWrongInTheWorldsOfErrata) {
  EXPECT_THAT(FailuresInWorlds("printed:none", "world/errata/"), testing::IsEmpty());
}

TEST(PrintedWithoutErrata, IsNeverProvedWrong) {
  EXPECT_THAT(FailuresOf("printed:none"), testing::IsEmpty());
}

TEST(PrintedWithAllErrata, IsProvedWrong) {
  EXPECT_THAT(FailuresOf("printed"), testing::Not(testing::IsEmpty()));
}

}  // namespace
}  // namespace touchstone
