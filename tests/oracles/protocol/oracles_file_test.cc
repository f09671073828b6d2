#include "oracles/protocol/oracles_file.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace touchstone {
namespace {

using testing::ElementsAre;

std::filesystem::path FileOf(const std::string& text) {
  std::filesystem::path file = std::filesystem::path(testing::TempDir()) /
                               ("oracles" + std::to_string(getpid()) + ".toml");
  std::ofstream(file) << text;
  return file;
}

std::vector<std::string> ErrorsOf(const std::string& text) {
  const OraclesFileResult result = ReadOraclesFile(FileOf(text));
  EXPECT_FALSE(result.oracles);
  std::vector<std::string> errors;
  for (const Diagnostic& diagnostic : result.diagnostics) {
    errors.push_back(std::to_string(diagnostic.line) + ":" +
                     std::to_string(diagnostic.column) + ": " + diagnostic.what);
  }
  return errors;
}

TEST(OraclesFile, NamesCommandsInItsOrderAndFolder) {
  const std::filesystem::path file =
      FileOf("zeta = \"./z\"\n\"a@1.2\" = \"python3 a.py\"\n");
  const OraclesFileResult result = ReadOraclesFile(file);
  ASSERT_TRUE(result.oracles);
  ASSERT_EQ(result.oracles->size(), 2U);
  EXPECT_EQ((*result.oracles)[0].name, "zeta");
  EXPECT_EQ((*result.oracles)[1].name, "a@1.2");
  EXPECT_EQ((*result.oracles)[1].command.line, "python3 a.py");
  EXPECT_EQ((*result.oracles)[1].command.folder, file.parent_path());
}

TEST(OraclesFile, SaysEveryErrorWithItsPlace) {
  EXPECT_THAT(ErrorsOf("a = 1\n\"all\" = \"x\"\nb = \"\"\n"),
              ElementsAre("1:5: a has no command", "2:1: \"all\" is no name",
                          "3:5: b has no command"));
  EXPECT_THAT(ErrorsOf("\"a b\" = \"x\""), ElementsAre("1:1: \"a b\" is no name"));
  EXPECT_EQ(ErrorsOf("a = ").size(), 1U);
}

TEST(OraclesFile, MustExist) {
  const OraclesFileResult result = ReadOraclesFile("no/such/oracles.toml");
  ASSERT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics[0].what, "cannot be read");
}

}  // namespace
}  // namespace touchstone
