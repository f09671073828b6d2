#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class ReadCatalogue : public ::testing::Test {
 protected:
  ReadCatalogue()
      : root_(fs::path(::testing::TempDir()) / "touchstone_read_catalogue" /
              ::testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  ~ReadCatalogue() override { fs::remove_all(root_); }

  /** Writes a valid scenario with that id to `file`, a path below the root. */
  void Write(const std::string& file, const std::string& id, double radius = 0.7) {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << fmt::format(
        "id = \"{}\"\ntitle = \"t\"\nsource = \"s\"\n"
        "bodies.a = {{shape = \"sphere\", radius = {}}}\n"
        "bodies.b = {{shape = \"half_space\"}}\ncontact = {{A = \"a\", B = \"b\"}}\n",
        id, radius);
  }

  /** Writes a valid world with that id to `file`, a path below the root. */
  void WriteWorld(const std::string& file, const std::string& id) {
    std::ofstream(root_ / file) << fmt::format(
        "id = \"{}\"\ntitle = \"t\"\nsource = \"s\"\n"
        "particles.a = {{position = [0, 0, 0]}}\nworld = {{dt = 1, steps = 2}}\n",
        id);
  }

  /** Returns the messages of a catalogue without the path of the test's folder. */
  std::vector<std::string> Errors(const Catalogue& catalogue) const {
    std::vector<std::string> errors;
    for (const Diagnostic& diagnostic : catalogue.diagnostics) {
      std::string error = ToString(diagnostic);
      const std::string root = root_.generic_string() + "/";
      for (std::size_t at = error.find(root); at != std::string::npos;
           at = error.find(root)) {
        error.erase(at, root.size());
      }
      errors.push_back(error);
    }
    return errors;
  }

  template <class AnyScenario>
  static std::vector<std::string> Ids(const std::vector<AnyScenario>& scenarios) {
    std::vector<std::string> ids;
    for (const AnyScenario& scenario : scenarios) ids.push_back(scenario.id);
    return ids;
  }

  const fs::path root_;
};

TEST_F(ReadCatalogue, FindsFilesInFoldersBelowAndSortsThemById) {
  Write("b.toml", "b");
  Write("c/z.toml", "c/z");
  Write("c/d/y.toml", "c/d/y");
  Write("a/x.toml", "a/x");
  std::ofstream(root_ / "README.md") << "not a scenario";
  const Catalogue catalogue = touchstone::ReadCatalogue(root_);
  EXPECT_THAT(Errors(catalogue), IsEmpty());
  EXPECT_THAT(Ids(catalogue.scenarios), ElementsAre("a/x", "b", "c/d/y", "c/z"));
}

TEST_F(ReadCatalogue, ReportsAnIdUsedTwiceAndNamesTheOtherFile) {
  Write("a.toml", "a");
  Write("b.toml", "b");
  Write("c.toml", "a");
  const std::vector<fs::path> files = {root_ / "c.toml", root_ / "b.toml",
                                       root_ / "a.toml"};
  const Catalogue catalogue = touchstone::ReadCatalogue(files);
  EXPECT_THAT(Errors(catalogue),
              ElementsAre("a.toml:1:6: id \"a\" is already used by c.toml:1:6; "
                          "expected a unique id"));
  EXPECT_THAT(Ids(catalogue.scenarios), ElementsAre("a", "b"));
}

TEST_F(ReadCatalogue, SeparatesWorldsFromContactQueriesButRequiresUniqueIds) {
  WriteWorld("z.toml", "z");
  WriteWorld("y.toml", "y");
  Write("x.toml", "x");
  WriteWorld("w.toml", "x");
  const std::vector<fs::path> files = {root_ / "x.toml", root_ / "z.toml",
                                       root_ / "y.toml", root_ / "w.toml"};
  const Catalogue catalogue = touchstone::ReadCatalogue(files);
  EXPECT_THAT(Errors(catalogue),
              ElementsAre("w.toml:1:6: id \"x\" is already used by x.toml:1:6; "
                          "expected a unique id"));
  EXPECT_THAT(Ids(catalogue.scenarios), ElementsAre("x"));
  EXPECT_THAT(Ids(catalogue.worlds), ElementsAre("y", "z"));
}

TEST_F(ReadCatalogue, ReportsAnIdUsedTwiceEvenIfTheRestIsWrong) {
  Write("a.toml", "a", -1);
  Write("b.toml", "a");
  const std::vector<fs::path> files = {root_ / "a.toml", root_ / "b.toml"};
  EXPECT_THAT(
      Errors(touchstone::ReadCatalogue(files)),
      ElementsAre("a.toml:4:40: bodies.a.radius is -1; expected a finite length > 0",
                  "b.toml:1:6: id \"a\" is already used by a.toml:1:6; "
                  "expected a unique id"));
}

TEST_F(ReadCatalogue, ReportsAnIdThatIsNotTheFilesPath) {
  Write("box/edge.toml", "box/egde");
  Write("box/face.toml", "face");
  EXPECT_THAT(Errors(touchstone::ReadCatalogue(root_)),
              ElementsAre("box/edge.toml:1:6: id \"box/egde\" is not the path of "
                          "box/edge.toml; expected \"box/edge\"",
                          "box/face.toml:1:6: id \"face\" is not the path of "
                          "box/face.toml; expected \"box/face\""));
}

TEST_F(ReadCatalogue, ReportsOnlyThePathsOfACopiedFolder) {
  Write("box/edge.toml", "box/edge");
  Write("a_copy/edge.toml", "box/edge");
  EXPECT_THAT(Errors(touchstone::ReadCatalogue(root_)),
              ElementsAre("a_copy/edge.toml:1:6: id \"box/edge\" is not the path of "
                          "a_copy/edge.toml; expected \"a_copy/edge\""));
}

TEST_F(ReadCatalogue, ReadsAPartOfACatalogueAlone) {
  Write("box/edge.toml", "box/edge");
  Write("box/odd.toml", "bax/odd");
  EXPECT_THAT(Errors(touchstone::ReadCatalogue(root_ / "box")),
              ElementsAre("box/odd.toml:1:6: id \"bax/odd\" is not the path of "
                          "box/odd.toml; expected \"odd\""));
}

TEST_F(ReadCatalogue, AllowsAnyIdInASingleFile) {
  Write("from_upstream.toml", "box/edge");
  const Catalogue catalogue = touchstone::ReadCatalogue(root_ / "from_upstream.toml");
  EXPECT_THAT(Errors(catalogue), IsEmpty());
  EXPECT_THAT(Ids(catalogue.scenarios), ElementsAre("box/edge"));
}

TEST_F(ReadCatalogue, ReadsAFileGivenTwiceOnce) {
  Write("a.toml", "a");
  const std::vector<fs::path> files = {root_ / "a.toml", root_};
  const Catalogue catalogue = touchstone::ReadCatalogue(files);
  EXPECT_THAT(Errors(catalogue), IsEmpty());
  EXPECT_THAT(Ids(catalogue.scenarios), ElementsAre("a"));
}

TEST_F(ReadCatalogue, ReportsTheErrorsOfEveryFile) {
  Write("a.toml", "a", -1);
  Write("b.toml", "b", -2);
  EXPECT_THAT(
      Errors(touchstone::ReadCatalogue(root_)),
      ElementsAre("a.toml:4:40: bodies.a.radius is -1; expected a finite length > 0",
                  "b.toml:4:40: bodies.a.radius is -2; expected a finite length > 0"));
}

TEST_F(ReadCatalogue, ReportsAFolderWithoutAScenario) {
  fs::create_directory(root_ / "empty");
  EXPECT_THAT(
      Errors(touchstone::ReadCatalogue(root_ / "empty")),
      ElementsAre("empty: contains no scenario; expected at least one .toml file"));
}

TEST_F(ReadCatalogue, ReportsAPathThatDoesNotExist) {
  EXPECT_THAT(Errors(touchstone::ReadCatalogue(root_ / "none.toml")),
              ElementsAre("none.toml: cannot be read; expected a readable file"));
}

TEST_F(ReadCatalogue, ReadScenarioFileRefusesAFolder) {
  const ReadResult read = ReadScenarioFile(root_);
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_EQ(read.diagnostics[0].what, "cannot be read");
}

}  // namespace
}  // namespace touchstone
