#include "scenarios/validate.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/validate_scenario.h"

namespace touchstone {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A rotation about no coordinate axis, at a position that is not round.
Pose AwkwardPose() {
  return Pose::FromQuaternion({0.31, -0.72, 0.55},
                              Eigen::Quaterniond(0.7, -0.31, 0.22, 0.61).normalized());
}

std::vector<std::string> Sentences(const std::vector<Fault>& faults) {
  std::vector<std::string> sentences;
  sentences.reserve(faults.size());
  for (const Fault& fault : faults) {
    sentences.push_back(fault.where + " " + fault.what + "; expected " + fault.expected);
  }
  return sentences;
}

std::vector<std::string> FaultsOfShape(const Shape& shape) {
  return Sentences(FaultsOf(Body{shape, AwkwardPose()}));
}

TEST(FaultsOfBody, AreEmptyForEveryShapeOfPositiveSize) {
  EXPECT_THAT(FaultsOfShape(Sphere{0.3}), IsEmpty());
  EXPECT_THAT(FaultsOfShape(Box{{0.3, kShortest, kLongest}}), IsEmpty());
  EXPECT_THAT(FaultsOfShape(Capsule{0.3, 0.2}), IsEmpty());
  EXPECT_THAT(FaultsOfShape(Cylinder{0.3, 0.2}), IsEmpty());
  EXPECT_THAT(FaultsOfShape(Cone{0.3, 0.2}), IsEmpty());
  EXPECT_THAT(FaultsOfShape(ConvexHull{{{0.1, 0.2, 0.3}}}), IsEmpty());
  EXPECT_THAT(FaultsOfShape(HalfSpace{}), IsEmpty());
}

TEST(FaultsOfBody, NameEverySizeThatIsNotAPositiveLength) {
  EXPECT_THAT(FaultsOfShape(Sphere{-0.0}),
              ElementsAre("radius is -0; expected a finite length > 0"));
  EXPECT_THAT(FaultsOfShape(Box{{kNaN, 0.3, kInfinity}}),
              ElementsAre("half_extents[0] is nan; expected a finite length > 0",
                          "half_extents[2] is inf; expected a finite length > 0"));
  EXPECT_THAT(FaultsOfShape(Capsule{-1, 0}),
              ElementsAre("radius is -1; expected a finite length > 0",
                          "half_length is 0; expected a finite length > 0"));
  EXPECT_THAT(FaultsOfShape(Cylinder{0.3, -2}),
              ElementsAre("half_length is -2; expected a finite length > 0"));
  EXPECT_THAT(FaultsOfShape(Cone{0.3, -2}),
              ElementsAre("half_height is -2; expected a finite length > 0"));
}

TEST(FaultsOfBody, NameAVertexThatIsNotFiniteAndAHullWithoutAny) {
  EXPECT_THAT(FaultsOfShape(ConvexHull{}),
              ElementsAre("vertices is empty; expected at least one vertex"));
  EXPECT_THAT(FaultsOfShape(ConvexHull{{{0, 0, 0}, {0, -kInfinity, 0}}}),
              ElementsAre("vertices[1][1] is -inf; expected a finite number"));
}

TEST(FaultsOfBody, NameAPositionThatIsNotFinite) {
  Body body{Sphere{0.3}, AwkwardPose()};
  body.X_WB.p_WB.z() = kNaN;
  EXPECT_THAT(Sentences(FaultsOf(body)),
              ElementsAre("position[2] is nan; expected a finite number"));
}

TEST(FaultsOfBody, NameLengthsWhoseSquaresAreOutOfRange) {
  EXPECT_THAT(FaultsOfShape(Cylinder{1e160, 5e-324}),
              ElementsAre("radius is 1e+160; expected a length from 1e-100 to 1e+100 m",
                          "half_length is 5e-324; "
                          "expected a length from 1e-100 to 1e+100 m"));
  EXPECT_THAT(FaultsOfShape(ConvexHull{{{0, 1, -1e-200}}}),
              ElementsAre("vertices[0][2] is -1e-200; "
                          "expected 0 m, or a magnitude from 1e-100 to 1e+100 m"));
  Body body{Sphere{0.3}, AwkwardPose()};
  body.X_WB.p_WB = {-1e100, 1e-100, 1e101};
  EXPECT_THAT(Sentences(FaultsOf(body)),
              ElementsAre("position[2] is 1e+101; "
                          "expected 0 m, or a magnitude from 1e-100 to 1e+100 m"));
}

TEST(FaultsOfBody, AllowAQuaternionOnlyItsTolerance) {
  // Scaling a unit quaternion by 1 + s makes its norm 1 + s, up to a rounding of 1e-16.
  const Eigen::Quaterniond unit = *AwkwardPose().q_WB;
  const auto scaled = [&](double s) {
    return Body{Sphere{0.3}, Pose::FromQuaternion(
                                 {1, 2, 3}, Eigen::Quaterniond(unit.coeffs() * (1 + s)))};
  };
  EXPECT_THAT(FaultsOf(scaled(0.9 * kQuaternionSlack)), IsEmpty());
  EXPECT_EQ(FaultsOf(scaled(1.1 * kQuaternionSlack)).size(), 1U);
  EXPECT_EQ(FaultsOf(scaled(-1.1 * kQuaternionSlack)).size(), 1U);
  EXPECT_EQ(FaultsOf(scaled(kInfinity)).size(), 4U);
}

TEST(FaultsOfBody, NameAQuaternionThatDoesNotMatchTheMatrix) {
  Body body{Sphere{0.3}, AwkwardPose()};
  body.X_WB.R_WB(0, 1) = std::nextafter(body.X_WB.R_WB(0, 1), 1);
  EXPECT_THAT(Sentences(FaultsOf(body)),
              ElementsAre("quaternion does not match the pose's rotation matrix; "
                          "expected a pose made by Pose::FromQuaternion"));
}

TEST(FaultsOfBody, AllowAMatrixOnlyItsTolerance) {
  // Scaling a rotation by 1 + s makes RᵀR = (1 + s)² 1, which deviates by 2 s.
  const Eigen::Matrix3d R = AwkwardPose().R_WB;
  const auto scaled = [&](double s) {
    return Body{Sphere{0.3}, Pose::FromMatrix({1, 2, 3}, (1 + s) * R)};
  };
  EXPECT_THAT(FaultsOf(scaled(0.45 * kRotationSlack)), IsEmpty());
  EXPECT_EQ(FaultsOf(scaled(0.55 * kRotationSlack)).size(), 1U);
}

TEST(FaultsOfBody, NameAMatrixThatMirrors) {
  const Body body{Sphere{0.3}, Pose::FromMatrix({1, 2, 3}, -AwkwardPose().R_WB)};
  EXPECT_THAT(Sentences(FaultsOf(body)),
              ElementsAre("rotation mirrors: its determinant is -1; "
                          "expected three orthonormal rows of determinant +1"));
}

TEST(FaultsOfBody, NameAMatrixThatIsNotFinite) {
  Eigen::Matrix3d R = AwkwardPose().R_WB;
  R(2, 0) = kNaN;
  EXPECT_THAT(Sentences(FaultsOf(Body{Sphere{0.3}, Pose::FromMatrix({1, 2, 3}, R)})),
              ElementsAre("rotation[2][0] is nan; expected a finite number"));
}

TEST(FaultsOfQuery, NameTheBodyAndTwoHalfSpaces) {
  EXPECT_THAT(Sentences(FaultsOf(ContactQuery{{HalfSpace{}, AwkwardPose()},
                                              {HalfSpace{}, AwkwardPose()}})),
              ElementsAre("B.shape is a half_space, and so is the other body's; "
                          "expected at most one half_space"));
  EXPECT_THAT(Sentences(FaultsOf(ContactQuery{{Sphere{-1}, AwkwardPose()},
                                              {Sphere{-2}, AwkwardPose()}})),
              ElementsAre("A.radius is -1; expected a finite length > 0",
                          "B.radius is -2; expected a finite length > 0"));
}

TEST(FaultsOfScenario, NameASeparationThatContradictsTouching) {
  Scenario scenario;
  scenario.id = "mine/pair";
  scenario.title = "t";
  scenario.source = "s";
  scenario.name_A = "A";
  scenario.name_B = "B";
  scenario.contact = {{Sphere{1}, AwkwardPose()}, {Sphere{1}, AwkwardPose()}};
  scenario.expect.touching = true;
  scenario.expect.separation = 0.05;
  EXPECT_THAT(Sentences(FaultsOf(scenario)),
              ElementsAre("expect.separation is 0.05 with touching = true; expected 0 "
                          "or less, since the bodies touch"));
  scenario.expect.separation = 0;
  EXPECT_THAT(FaultsOf(scenario), IsEmpty());
  scenario.expect.touching = false;
  EXPECT_THAT(Sentences(FaultsOf(scenario)),
              ElementsAre("expect.separation is 0 with touching = false; expected more "
                          "than 0, since the bodies do not touch"));
}

TEST(FaultsOfScenario, NameEveryPartThatAFileCannotContain) {
  Scenario scenario;
  scenario.id = "No Path";
  scenario.title = "";
  scenario.source = "s";
  scenario.name_A = "a b";
  scenario.name_B = "a b";
  scenario.contact = {{Sphere{1}, AwkwardPose()}, {Sphere{1}, AwkwardPose()}};
  scenario.expect.separation = kInfinity;
  scenario.expect.normals = {{0, kNaN, 1}};
  scenario.expect.contacts = -1;
  scenario.tolerance = {0, ""};
  scenario.indicts = {{"", {}, "", true}};
  std::vector<std::string> where;
  for (const Fault& fault : FaultsOf(scenario)) where.push_back(fault.where);
  EXPECT_THAT(
      where, ElementsAre("id", "title", "contact.A", "contact.B", "contact.B",
                         "expect.separation", "expect.normals[0]", "expect.contacts",
                         "tolerance.separation", "tolerance.because", "indicts[0].oracle",
                         "indicts[0].measures", "indicts[0].anomaly"));
}

}  // namespace
}  // namespace touchstone
