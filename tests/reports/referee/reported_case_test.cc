// Cases reported to other projects' trackers. Their truth was found by a search in
// quadruple precision (113 bits) that shares nothing with the referee.

#include <limits>

#include <gtest/gtest.h>

#include "reports/referee/referee.h"

namespace touchstone {
namespace {

Eigen::Matrix3d Rows(double xx, double xy, double xz, double yx, double yy, double yz,
                     double zx, double zy, double zz) {
  return (Eigen::Matrix3d() << xx, xy, xz, yx, yy, yz, zx, zy, zz).finished();
}

void ExpectSeparation(const ContactQuery& query, double expected) {
  const ContactTruth truth = ComputeContactTruth(query);
  // Both ends enclose the truth to an ulp of the scene.
  const double ulp = std::numeric_limits<double>::epsilon() * SceneSize(query);
  EXPECT_NEAR(truth.separation.lo, expected, 2 * ulp);
  EXPECT_NEAR(truth.separation.hi, expected, 2 * ulp);
  EXPECT_EQ(truth.touching, expected < 0 ? Touching::kTouching : Touching::kApart);
}

// flexible-collision-library/fcl#399
TEST(ReportedCase, BoxesOverlappingBy34MicrometresInThePlane) {
  const Body A{Box{{0.11884018778800964, 0.07851152867078781, 0.125}},
               Pose::FromMatrix(
                   {0.2952640652656555, -0.013230856508016586, 0.0},
                   Rows(-0.09943238735307627, 0.9950443207944397, 0.0,
                        -0.9950443207944397, -0.09943238735307627, 0.0, 0.0, 0.0, 1.0))};
  const Body B{Box{{0.005, 0.39082854986190796, 0.125}},
               Pose::FromMatrix(
                   {0.22759585694545215, 0.14974093549228112, 0.0},
                   Rows(0.9950659844209923, 0.09921535490175673, 0.0,
                        -0.09921535490175673, 0.9950659844209923, 0.0, 0.0, 0.0, 1.0))};
  ExpectSeparation({A, B}, -3.3810643999200474e-05);
}

// flexible-collision-library/fcl#395
TEST(ReportedCase, TiltedBoxInAThinPlate) {
  const Body A{Box{{0.23, 0.24, 0.005}},
               Pose::FromMatrix({-0.721, -0.772, 0.81},
                                Rows(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0))};
  const Body B{Box{{0.0247605, 0.073, 0.03625}},
               Pose::FromMatrix(
                   {-0.4267713300299948, -0.7659685124774679, 0.8074673140009105},
                   Rows(0.10758262492983037, -0.6624881850015213, -0.7413065381787736,
                        0.22682184885125473, -0.7096140407752535, 0.6670830248314786,
                        -0.9679761503760854, -0.23991106241273435, 0.07392465377049165))};
  ExpectSeparation({A, B}, -0.013408613773995298);
}

// flexible-collision-library/fcl#390 (comment 481634606)
TEST(ReportedCase, CylinderAGapOf20NanometresFromABox) {
  const Body A{Cylinder{0.05, 0.03},
               Pose::FromMatrix(
                   {0.8747278146113856, -0.403868788134716, 1.5871328698116491},
                   Rows(-0.9731301075927928, -0.12202804064972551, 0.19526123781136842,
                        0.20950801135757172, -0.11745920593569326, 0.9707263919961958,
                        -0.09552060967892975, 0.9855518719154995, 0.13986894183635))};
  const Body B{Box{{0.0125, 0.175, 0.9225}},
               Pose::FromMatrix({0.8, -0.4575, 1.0225},
                                Rows(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0))};
  ExpectSeparation({A, B}, 2.0465735887974382e-08);
}

// RobotLocomotion/drake#21234
TEST(ReportedCase, CylinderRim33PicometresFromABoxEdge) {
  const Body A{
      Cylinder{0.041, 0.085},
      Pose::FromMatrix(
          {0.2023803334682546, 0.02784568359401101, 0.31142339392466933},
          Rows(0.6228644976275455, 0.7165153556804436, -0.3140789115322978,
               -0.20605566270224238, -0.23703718387133413, -0.9493968808305023,
               -0.7547058244531608, 0.6560633494842361, 4.0172294049188053e-17))};
  const Body B{Box{{0.15, 0.3, 0.008}},
               Pose::FromMatrix({0.4, 0.0, 0.26885000000000003},
                                Rows(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0))};
  ExpectSeparation({A, B}, 3.310850005517648e-11);
}

// coal-library/coal#351
TEST(ReportedCase, SphereGrazingACylinderRim) {
  const Body A{Sphere{0.055},
               Pose::FromMatrix({0.140834, -0.045449, 0.905432},
                                Rows(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0))};
  const Body B{Cylinder{0.136, 0.05},
               Pose::FromMatrix({0.0, 0.0, 0.7765},
                                Rows(0.0, 1.0, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0))};
  ExpectSeparation({A, B}, -6.106688262866356e-05);
}

// dimforge/parry#253
TEST(ReportedCase, HullsAGapOf200NanometresApart) {
  const Body A{ConvexHull{{{-13.174434, 1.0, 8.736801},
                           {3.5251038, 1.0, 12.1},
                           {3.2048466, 1.0, 12.218325}}},
               Pose::FromMatrix({0.0, 0.0, 0.0},
                                Rows(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0))};
  const Body B{ConvexHull{{{-1.63, 0.0, 11.19},
                           {-2.349647, 0.0, 11.037681},
                           {-2.349647, 1.0, 11.037681}}},
               Pose::FromMatrix({0.0, 0.0, 0.0},
                                Rows(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0))};
  ExpectSeparation({A, B}, 2.0373232802402248e-07);
}

// google-deepmind/mujoco@8655446f (test ThinBoxNoSpuriousDeepContact)
TEST(ReportedCase, BoxesAGapOf19MicrometresApart) {
  const Body A{
      Box{{0.047, 0.032, 0.00035}},
      Pose::FromMatrix(
          {2.821825771308448e-05, -0.013292121195706197, 0.02925607203779027},
          Rows(0.9999842774819248, -0.002299445579784584, 0.005114424598973962,
               0.005607461311880932, 0.41560254840784006, -0.9095290419412373,
               -3.415536179583994e-05, 0.9095434207925067, 0.41560890814138807))};
  const Body B{
      Box{{0.047, 0.032, 0.00035}},
      Pose::FromMatrix(
          {-5.352194487262811e-05, 0.01427117523229726, 0.029254416229696868},
          Rows(0.999999565496524, 0.0003998777453206644, 0.0008420834589797611,
               -0.0009321048184122195, 0.41564819056887203, 0.909524992981188,
               1.3688337473195908e-05, -0.9095253826994668, 0.4156483826962617))};
  ExpectSeparation({A, B}, 1.934904269149658e-05);
}

}  // namespace
}  // namespace touchstone
