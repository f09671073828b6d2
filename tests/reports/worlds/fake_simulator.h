#pragma once

#include <functional>
#include <string>

#include "oracles/oracle.h"

namespace touchstone {

/** An oracle for worlds that is made of a function, so that an error can be planted. */
class FakeSimulator : public Oracle {
 public:
  using Function = std::function<Trajectory(const World&)>;

  /** Supports every feature of a world, in double, and no contact query. */
  FakeSimulator(std::string name, Function function);

  using Oracle::Answer;
  const OracleInfo& info() const override { return info_; }
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override;
  Trajectory Simulate(const World& world) const override { return function_(world); }

 private:
  OracleInfo info_;
  Function function_;
};

/** Returns the closed form of the free flight of bodies that rotate at a constant spin,
 as spheres do, with `off(t)` [m] added to every position at t [s]. */
Trajectory FreeFlight(const World& world,
                      const std::function<Eigen::Vector3d(double)>& off = {});

}  // namespace touchstone
