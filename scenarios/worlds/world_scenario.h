#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/worlds/motion_expectation.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** A statement that is true of the world and checked for every engine: a closed form, an
 invariant or a state of rest. `law` names a function in reports/worlds/laws. The function
 documents its inputs, and derives its prediction and its tolerance from the world. */
struct Claim {
  std::string law;  ///< E.g. "ballistic", "torque_free", "conserves_momentum".
  /** The claim's subjects: names of bodies, particles or cloths; empty: everything that
   moves. */
  std::vector<std::string> about;
  /** Numbers that the author supplies to the law by name, e.g. {"length", 1.0}. */
  std::map<std::string, double> numbers;
  std::string because;  ///< The derivation or the citation; may be empty.
  /** Things whose pairs with the subjects other claims of the law judge already; never in
   a file. Laws about pairs leave these out. */
  std::vector<std::string> claimed = {};
};

/** Many slightly different copies of a world, for chaotic motion. Each coordinate of the
 initial position of each moving part is displaced by up to `jitter`. */
struct Ensemble {
  int members = 0;    ///< > 1
  double jitter = 0;  ///< [m], > 0
  unsigned seed = 1;
};

/** A world with its provenance and what is known about its motion. */
struct WorldScenario {
  std::string id;      ///< A path, e.g. "world/free/boxes_complex".
  std::string title;   ///< One line that describes the scene.
  std::string source;  ///< A citation or a derivation.
  World world;
  std::vector<Claim> claims;
  std::vector<MotionExpectation> expectations;  ///< The list [[expect]] of the file.
  /** The time from which trajectories of engines are not compared, because the motion is
   chaotic. [s] */
  std::optional<double> horizon;
  std::optional<Ensemble> ensemble;
  std::vector<Indictment> indicts;
  FilePlaces places;  ///< Positions in the file, for diagnostics.
};

}  // namespace touchstone
