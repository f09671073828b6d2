#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/scenario_file.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::string_view kWorld = R"(id = "mine/fall"
title = "A ball above a floor"
source = "Made up."

[world]
dt = 0.01
steps = 100
sample_every = 5

[bodies.floor]
shape = "half_space"
mass = 0

[bodies.ball]
shape = "sphere"
radius = 0.5

[particles.bob]
position = [0, 1, 0]
)";

class ReadExpectations : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  ReadResult Read(std::string_view keys) const {
    std::string text(kWorld);
    return ReadScenario(text.append("\n[[expect]]\n").append(keys),
                        (folder_ / "f.toml").string());
  }

  /** Returns the errors without the folder's name. */
  std::vector<std::string> ErrorsOf(std::string_view keys) const {
    std::vector<std::string> errors;
    for (const Diagnostic& error : Read(keys).diagnostics)
      errors.push_back(ToString(error).substr(folder_.string().size() + 1));
    return errors;
  }

  MotionExpectation Good(std::string_view keys) const {
    const ReadResult read = Read(keys);
    EXPECT_TRUE(read.world) << ToString(read.diagnostics.at(0));
    return read.world ? read.world->expectations.at(0) : MotionExpectation();
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(ReadExpectations, ReturnsAPlaceWithItsTimeAndTolerance) {
  const MotionExpectation read = Good(
      "body = \"ball\"\nat = 0.5\nposition = [1, 2, 3]\nalong = [0, 2, 0]\n"
      "tolerance = 0.01\nbecause = \"It falls.\"\n");
  EXPECT_EQ(read.body, "ball");
  EXPECT_EQ(read.time, 0.5);
  EXPECT_EQ(read.tolerance, 0.01);
  EXPECT_EQ(read.because, "It falls.");
  const auto& expected = std::get<ExpectedVector>(read.what);
  EXPECT_EQ(expected.of, ExpectedVector::Of::kPosition);
  EXPECT_EQ(expected.value, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(expected.along, Eigen::Vector3d(0, 2, 0));
}

TEST_F(ReadExpectations, ReturnsEveryOtherStatement) {
  const std::string ball = "body = \"ball\"\ntolerance = 0.1\n";
  EXPECT_EQ(
      std::get<ExpectedVector>(Good(ball + "at = 0\nvelocity = [0, 1, 0]\n").what).of,
      ExpectedVector::Of::kVelocity);
  EXPECT_EQ(std::get<ExpectedVector>(Good(ball + "at = 0\nspin = [0, 1, 0]\n").what).of,
            ExpectedVector::Of::kSpin);
  EXPECT_EQ(std::get<ExpectedOrientation>(
                Good(ball + "at = 0\nquaternion = [0, 0, 1, 0]\n").what)
                .q_WB.y(),
            1);
  EXPECT_EQ(std::get<ExpectedAngle>(
                Good(ball + "at = 0\nangle = -1.5\nalong = [0, 0, 1]\n").what)
                .angle,
            -1.5);
  EXPECT_EQ(std::get<ExpectedTouch>(Good(ball + "at = 0.123\ntouches = \"floor\"\n").what)
                .other,
            "floor");
  EXPECT_FALSE(
      std::get<ExpectedTopple>(Good("body = \"ball\"\nby = 1\ntopples = false\n").what)
          .topples);
  EXPECT_TRUE(std::holds_alternative<ExpectedRest>(
      Good("body = \"bob\"\nby = 1\nrests = true\ntolerance = 1\n").what));
}

TEST_F(ReadExpectations, ReadsBackWhatIsWritten) {
  const ReadResult read = Read(
      "body = \"ball\"\nat = 0.5\nposition = [0.1, 2, 3]\ntolerance = 0.01\n"
      "[[expect]]\nbody = \"ball\"\nat = 0.15\nangle = 0.1\nalong = [0, 0.1, 0]\n"
      "tolerance = 0.1\n[[expect]]\nbody = \"ball\"\nby = 1\ntopples = false\n"
      "[[expect]]\nbody = \"bob\"\nby = 1\nrests = true\ntolerance = 1\n"
      "[[expect]]\nbody = \"ball\"\nat = 0.5\ntouches = \"floor\"\ntolerance = 1\n"
      "[[expect]]\nbody = \"ball\"\nat = 0\nquaternion = [1, 0, 0, 0]\n"
      "tolerance = 1\n");
  ASSERT_TRUE(read.world) << ToString(read.diagnostics.at(0));
  EXPECT_THAT(FaultsOf(*read.world), IsEmpty());
  const std::string written = WriteScenario(*read.world);
  const ReadResult again = ReadScenario(written, "f.toml");
  ASSERT_TRUE(again.world) << ToString(again.diagnostics.at(0));
  EXPECT_EQ(again.world->expectations.size(), 6U);
  EXPECT_EQ(WriteScenario(*again.world), written);
}

TEST_F(ReadExpectations, RefusesAnUnknownNameAtItsPlace) {
  EXPECT_THAT(
      ErrorsOf("body = \"bal\"\nat = 0.5\nposition = [1, 2, 3]\ntolerance = 1\n"),
      ElementsAre("f.toml:22:8: expect[0].body is \"bal\", which is not a body or "
                  "particle; expected \"ball\""));
  EXPECT_THAT(ErrorsOf("body = \"ball\"\nat = 0.5\ntouches = \"flor\"\ntolerance = 1\n"),
              ElementsAre(HasSubstr("f.toml:24:11: expect[0].touches is \"flor\"")));
  EXPECT_THAT(ErrorsOf("body = \"floor\"\nat = 0\nposition = [1, 2, 3]\ntolerance = 1\n"),
              ElementsAre(HasSubstr(":22:8: expect[0].body is \"floor\", which never")));
  EXPECT_THAT(ErrorsOf("body = \"bob\"\nat = 0\nspin = [1, 2, 3]\ntolerance = 1\n"),
              ElementsAre(HasSubstr(":22:8: expect[0].body is \"bob\", a particle")));
}

TEST_F(ReadExpectations, RefusesATimeThatIsNoSampleOrAfterTheEnd) {
  EXPECT_THAT(
      ErrorsOf("body = \"ball\"\nat = 0.51\nposition = [1, 2, 3]\ntolerance = 1\n"),
      ElementsAre(HasSubstr(":23:6: expect[0].at is 0.51; expected a time of a sample")));
  EXPECT_THAT(
      ErrorsOf("body = \"ball\"\nby = 1.5\nrests = true\ntolerance = 1\n"),
      ElementsAre(HasSubstr(":23:6: expect[0].by is 1.5; expected a time up to")));
}

TEST_F(ReadExpectations, RefusesNothingTwoThingsAndMissingKeys) {
  EXPECT_THAT(ErrorsOf("body = \"ball\"\n"),
              ElementsAre(HasSubstr("expect[0] states nothing; expected one of")));
  EXPECT_THAT(ErrorsOf("body = \"ball\"\nat = 0\nposition = [1, 2, 3]\n"
                       "spin = [1, 2, 3]\ntolerance = 1\n"),
              ElementsAre(HasSubstr(":25:8: expect[0] states position and spin")));
  EXPECT_THAT(ErrorsOf("body = \"ball\"\nangle = 1\n"),
              ElementsAre(HasSubstr("expect[0].at is missing"),
                          HasSubstr("expect[0].along is missing"),
                          HasSubstr("expect[0].tolerance is missing")));
  EXPECT_THAT(ErrorsOf("body = \"ball\"\nat = 0\nby = 0\nposition = [1, 2, 3]\n"
                       "tolerance = 1\n"),
              ElementsAre(HasSubstr(":24:6: expect[0].by is stated; expected none")));
  EXPECT_THAT(ErrorsOf("body = \"ball\"\nplace = [1, 2, 3]\n"),
              testing::Contains(HasSubstr("unknown key \"place\"")));
}

TEST_F(ReadExpectations, RefusesValuesThatCannotBe) {
  EXPECT_THAT(ErrorsOf("body = \"ball\"\nat = 0\nangle = 1\nalong = [0, 0, 0]\n"
                       "tolerance = 1\n"),
              ElementsAre(HasSubstr(":25:9: expect[0].along has no direction")));
  EXPECT_THAT(ErrorsOf("body = \"ball\"\nat = 0\nquaternion = [1, 1, 0, 0]\n"
                       "tolerance = 1\n"),
              ElementsAre(HasSubstr("expect[0].quaternion has norm 1.41421")));
  EXPECT_THAT(ErrorsOf("body = \"ball\"\nby = 0\nrests = false\ntolerance = 1\n"),
              ElementsAre(HasSubstr(":24:9: expect[0].rests is false; expected true")));
}

class ReadReference : public ReadExpectations {
 protected:
  std::vector<std::string> ErrorsIn(std::string_view csv) const {
    std::ofstream(folder_ / "r.csv") << csv;
    return ErrorsOf("trajectory = \"r.csv\"\ntolerance = 0.1\n");
  }
};

TEST_F(ReadReference, ReadsColumnsInAnyOrderBesideTheScenario) {
  std::ofstream(folder_ / "r.csv") << "name,time,pz,py,px,qw,qx,qy,qz,more\n"
                                      "ball,0.05,3,2,1,0,0,1,0,x\n"
                                      "bob,0.1,6,5,4,,,,,\n";
  const auto read = std::get<ExpectedTrajectory>(
      Good("trajectory = \"r.csv\"\ntolerance = 0.1\n").what);
  ASSERT_EQ(read.states.size(), 2U);
  EXPECT_EQ(read.states[0].p_W, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read.states[0].q_WB->y(), 1);
  EXPECT_EQ(read.states[1].name, "bob");
  EXPECT_EQ(read.states[1].time, 0.1);
  EXPECT_FALSE(read.states[1].q_WB);
  EXPECT_EQ(std::get<ExpectedTrajectory>(
                Good("body = \"bob\"\ntrajectory = \"r.csv\"\ntolerance = 0.1\n").what)
                .states.size(),
            1U);
}

TEST_F(ReadReference, RefusesWhatItCannotCompareAtItsPlace) {
  const std::string header = "time,name,px,py,pz\n";
  EXPECT_THAT(ErrorsIn(header + "0.05,bal,1,2,3\n"),
              ElementsAre(HasSubstr("r.csv:2:6: name is \"bal\"")));
  EXPECT_THAT(ErrorsIn(header + "0.06,ball,1,2,3\n"),
              ElementsAre(HasSubstr("r.csv:2:1: time is 0.06; expected a time of a")));
  EXPECT_THAT(ErrorsIn(header + "0.05,ball,1,2,nan\n"),
              ElementsAre(HasSubstr("r.csv:2:15: pz is \"nan\"; expected a finite")));
  EXPECT_THAT(ErrorsIn(header + "0.05,ball,1,2\n"),
              ElementsAre(HasSubstr("r.csv:2:1: has 4 cells; expected 5")));
  EXPECT_THAT(ErrorsIn("time,name,px,py\n"),
              ElementsAre(HasSubstr("r.csv:1:1: has no column pz")));
  EXPECT_THAT(ErrorsIn(header), ElementsAre(HasSubstr("r.csv: has no states")));
  EXPECT_THAT(ErrorsIn("time,name,px,py,pz,oracle\n0,ball,1,2,3,ode\n"
                       "0.05,ball,1,2,3,dart\n"),
              ElementsAre(HasSubstr("r.csv:3:17: oracle is \"dart\" after \"ode\"")));
  EXPECT_THAT(ErrorsOf("trajectory = \"none.csv\"\ntolerance = 0.1\n"),
              ElementsAre(HasSubstr("none.csv: is not there")));
}

}  // namespace
}  // namespace touchstone
