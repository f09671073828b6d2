#include "reports/writers/trajectory_csv.h"

#include <sstream>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

TEST(TrajectoryCsv, WritesARowForEachMovingObjectAtEachTime) {
  WorldScenario scenario;
  scenario.id = "world/test/all";
  RigidBody floor;
  floor.name = "floor";
  floor.mass = 0;
  RigidBody ball;
  ball.name = "ball";
  scenario.world.bodies = {floor, ball};
  scenario.world.particles = {{"drop"}};
  scenario.world.cloths.emplace_back();
  scenario.world.cloths[0].name = "flag";
  scenario.world.cloths[0].n = 3;
  Trajectory trajectory;
  trajectory.status = AnswerStatus::kAnswered;
  trajectory.times = {0.1};
  WorldState state;
  const BodyState still{Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity(),
                        Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  state.bodies = {still, still};
  state.bodies[1].p_WB = {1.0 / 3, -2, 1e-300};
  state.bodies[1].w_WB.z() = 7;
  state.particles = {{{1, 2, 3}, {4, 5, 6}}};
  for (int i = 0; i < 9; ++i) state.nodes.push_back({{i * 1.0, 0, 0}, {0, 0, 0}});
  trajectory.samples = {state};

  std::ostringstream out;
  WriteTrajectoryHeader(out);
  WriteTrajectory(scenario, "mine", trajectory, out);
  const std::string text = out.str();
  EXPECT_EQ(text.substr(0, text.find("world/test/all,mine,0.1,drop")),
            "world,oracle,time,name,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n"
            "world/test/all,mine,0.1,ball,0.3333333333333333,-2,1e-300,1,0,0,0,0,0,0,0,0,"
            "7\n");
  EXPECT_NE(text.find("world/test/all,mine,0.1,drop,1,2,3,,,,,4,5,6,,,\n"),
            std::string::npos);
  EXPECT_NE(text.find("world/test/all,mine,0.1,flag[1][2],5,0,0,,,,,0,0,0,,,\n"),
            std::string::npos);
}

}  // namespace
}  // namespace touchstone
