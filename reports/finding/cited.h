#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace touchstone {

/** The parts of a world that the proof of a finding names, as data: a page shows them
 without reading the sentence. Empty for a proof that names none. */
struct Cited {
  /** The names of bodies, particles, nodes and cloths, each once, in the order of the
   sentence. */
  std::vector<std::string> names;
  /** The moment that the sentence is about, that of the worst break; of an interval, its
   end. [s] */
  std::optional<double> time;
  /** Positions, in the world frame. [m] */
  std::vector<Eigen::Vector3d> points_W;
  /** The first moment at which the law is broken, at the latest, where `time` is that of
   the worst break. [s] */
  std::optional<double> first_time = std::nullopt;

  bool operator==(const Cited&) const = default;
};

}  // namespace touchstone
