// Each erratum of the published recipes is found by a measure when it is the only one
// enabled; with none enabled, nothing is found. The comparators do not know which erratum
// is enabled: they only see an oracle.
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
#include "reports/referee/referee.h"
#include "reports/run.h"
#include "reports/threads/parallel_for.h"
#include "reports/worlds/study/run_worlds.h"
#include "scenarios/scenario_file.h"
#include "tests/source_tree.h"

namespace touchstone {
namespace {

const Catalogue& TheCatalogue() {
  static const Catalogue catalogue = ReadCatalogue(InSourceTree("scenarios/catalogue"));
  return catalogue;
}

const Oracle* OracleNamed(const std::string& name) {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry.Find(name);
}

// The number of failed findings per measure.
std::map<std::string, int> FailuresAmong(const std::vector<Finding>& findings) {
  std::map<std::string, int> failures;
  for (const Finding& finding : findings) {
    if (finding.verdict == Verdict::kFail || finding.verdict == Verdict::kInvalid) {
      ++failures[std::string(NameOf(finding.measure))];
    }
  }
  return failures;
}

// The truths of the contact queries of the catalogue, computed once for all specimens.
const std::vector<ContactTruth>& TheTruths() {
  static const std::vector<ContactTruth> truths = [] {
    std::vector<ContactTruth> all(TheCatalogue().scenarios.size());
    ParallelFor(all.size(), 0, [&](std::size_t i) {
      all[i] = ComputeContactTruth(TheCatalogue().scenarios[i].contact);
    });
    return all;
  }();
  return truths;
}

// The failures per measure of an oracle in the contact queries of the catalogue.
std::map<std::string, int> FailuresOf(const std::string& oracle_name) {
  const Oracle* oracle = OracleNamed(oracle_name);
  if (oracle == nullptr) return {};
  // The same for all specimens, which differ in their answers only.
  static TruthsOfNeighbours truths_of_neighbours;
  static VariantsOfAll variants;
  RunOptions options;
  options.truths = TheTruths();
  options.truths_of_neighbours = &truths_of_neighbours;
  options.variants = &variants;
  return FailuresAmong(
      Run(TheCatalogue().scenarios, std::span(&oracle, 1), {}, options).findings);
}

// The failures per measure of an oracle in the worlds whose ids start with `beginning`.
std::map<std::string, int> FailuresInWorlds(const std::string& oracle_name,
                                            const std::string& beginning) {
  const Oracle* oracle = OracleNamed(oracle_name);
  std::vector<WorldScenario> worlds;
  const std::vector<WorldScenario>& all = TheCatalogue().worlds;
  std::copy_if(
      all.begin(), all.end(), std::back_inserter(worlds),
      [&](const WorldScenario& world) { return world.id.starts_with(beginning); });
  if (oracle == nullptr || worlds.empty()) return {{"nothing was asked", 1}};
  return FailuresAmong(RunWorlds(worlds, std::span(&oracle, 1), {.jobs = 1}).findings);
}

// The form of an erratum in the names of worlds and tests: "e10" for "E-10".
std::string FileNameOf(std::string erratum) {
  erratum.erase(erratum.find('-'), 1);
  erratum[0] = 'e';
  return erratum;
}

struct Specimen {
  const char* erratum;
  const char* measure;  // A measure that must find it, by the nature of the erratum.
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
        Specimen{"E-01", "touching"},  // Apart on an untested axis.
        Specimen{"E-02", "excess"},    // The normal loses its negative components.
        Specimen{"E-03", "separation_error"}, Specimen{"E-04", "consistency_error"},
        Specimen{"E-05", "excess"},    // A centre inside is pushed out of the wrong face.
        Specimen{"E-06", "touching"},  // Concentric shapes are reported as apart.
        Specimen{"E-07", "answering"},          // Touching, without the promised contact.
        Specimen{"E-08", "contact_off_patch"},  // Four contacts where two are right.
        Specimen{"E-09", "patch_coverage"},  // Contacts within a centimetre are merged.
        Specimen{"E-26", "separation_error"},
        Specimen{"E-27", "patch_coverage"},  // Rounding takes contacts of flush faces.
        Specimen{"E-28", "touching"},        // Depth zero counts as apart.
        Specimen{"E-29",
                 "excess"},  // Nearly parallel edges: the depth of a face instead.
        Specimen{"E-30", "separation_error"}),  // A centre near a face counts as inside.
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

// E-21 is left out, because no scenario file can express its world.
INSTANTIATE_TEST_SUITE_P(
    OfMotion, PrintedErratumOfMotion,
    testing::Values(
        Specimen{"E-10", "velocity_error"},     // An impulse is not divided by the mass.
        Specimen{"E-11", "momentum_drift"},     // Damping that the world does not state.
        Specimen{"E-12", "restitution"},        // Four contacts share one bounce.
        Specimen{"E-13", "orientation_error"},  // Spheres do not rotate.
        Specimen{"E-14", "spin_error"},  // The inertia does not rotate with the plank.
        Specimen{"E-15", "orientation_error"},       // Adds ω dt to Euler angles.
        Specimen{"E-16", "angular_momentum_drift"},  // No gyroscopic term.
        Specimen{"E-17", "energy_drift"},            // Damping by an unsigned speed.
        Specimen{"E-18", "energy_drift"},            // A force without dt.
        Specimen{"E-19", "limit_error"},             // Damping per step, not per time.
        Specimen{"E-20", "answering"},  // Cloth position multiplied by its spacing.
        Specimen{"E-22", "angular_momentum_drift"},  // Corrections split half and half.
        Specimen{"E-23", "velocity_error"},  // Friction uses the slip before the impact.
        Specimen{"E-24", "penetration"},     // Pushed out, but not rotated.
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
