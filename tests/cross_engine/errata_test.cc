// Each contact erratum of the published recipes, alone, is found by a measure; with all
// of them off, nothing is. The comparators do not know which erratum is on: they see an
// oracle.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/oracle_registry.h"
#include "reports/run.h"
#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

// What was found of an oracle: failed findings per measure.
std::map<std::string, int> FailuresOf(const std::string& oracle_name) {
  static const Catalogue catalogue =
      ReadCatalogue(std::filesystem::path(TOUCHSTONE_DATA_DIR) / "catalogue");
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  const Oracle* oracle = registry.Find(oracle_name);
  if (oracle == nullptr) return {};
  const RunReport report = Run(catalogue.scenarios, std::span(&oracle, 1), {}, {});
  std::map<std::string, int> failures;
  for (const Finding& finding : report.findings) {
    if (finding.verdict == Verdict::kFail || finding.verdict == Verdict::kInvalid) {
      ++failures[std::string(NameOf(finding.measure))];
    }
  }
  return failures;
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
      std::string name = instance.param.erratum;
      name.erase(name.find('-'), 1);
      return name;
    });

TEST(PrintedWithoutErrata, IsNeverProvedWrong) {
  EXPECT_THAT(FailuresOf("printed:none"), testing::IsEmpty());
}

TEST(PrintedWithAllErrata, IsProvedWrong) {
  EXPECT_THAT(FailuresOf("printed"), testing::Not(testing::IsEmpty()));
}

}  // namespace
}  // namespace touchstone
