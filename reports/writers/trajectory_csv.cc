#include "reports/writers/trajectory_csv.h"

#include <string>

#include <fmt/format.h>

namespace touchstone {
namespace {

std::string Cells(const Eigen::Vector3d& v) {
  return fmt::format("{},{},{}", v.x(), v.y(), v.z());
}

std::string Row(const PointState& point) {
  return fmt::format("{},,,,,{},,,", Cells(point.p_W), Cells(point.v_W));
}

std::string Row(const BodyState& body) {
  return fmt::format("{},{},{},{},{}", Cells(body.p_WB), body.q_WB.w(),
                     Cells(body.q_WB.vec()), Cells(body.v_WB), Cells(body.w_WB));
}

}  // namespace

void WriteTrajectoryHeader(std::ostream& out) {
  out << "world,oracle,time,name,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n";
}

void WriteTrajectory(const WorldScenario& scenario, std::string_view oracle,
                     const Trajectory& trajectory, std::ostream& out) {
  const World& world = scenario.world;
  for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
    const WorldState& state = trajectory.samples[s];
    const std::string start =
        fmt::format("{},{},{}", scenario.id, oracle, trajectory.times[s]);
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      if (world.bodies[i].mass == 0) continue;
      out << start << ',' << world.bodies[i].name << ',' << Row(state.bodies[i]) << '\n';
    }
    for (std::size_t i = 0; i < world.particles.size(); ++i)
      out << start << ',' << world.particles[i].name << ',' << Row(state.particles[i])
          << '\n';
    std::size_t node = 0;
    for (const Cloth& cloth : world.cloths) {
      for (int i = 0; i < cloth.n * cloth.n; ++i) {
        out << start
            << fmt::format(",{}[{}][{}],{}\n", cloth.name, i / cloth.n, i % cloth.n,
                           Row(state.nodes[node++]));
      }
    }
  }
}

}  // namespace touchstone
