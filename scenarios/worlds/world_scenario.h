#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Something that is true of the world, to be held against every engine: a closed form,
 an invariant, a state of rest. `law` names a function of reports/worlds/laws, which
 documents what it needs, derives what it predicts from the world itself, and derives its
 own tolerance. */
struct Claim {
  std::string law;  ///< E.g. "ballistic", "torque_free", "conserves_momentum".
  /** What it is about: names of bodies, particles or cloths; empty: everything that
   moves. */
  std::vector<std::string> about;
  /** What the author derived by hand and the law does not know, e.g. {"length", 1.0}. */
  std::map<std::string, double> numbers;
  std::string because;  ///< The derivation or the citation; may be empty.
};

/** The same world many times, each a little different: for motion that is chaotic. Every
 coordinate of the starting positions of what moves is moved by up to `jitter`. */
struct Ensemble {
  int members = 0;    ///< > 1
  double jitter = 0;  ///< [m], > 0
  unsigned seed = 1;
};

/** A world with its provenance and what is known of its motion. */
struct WorldScenario {
  std::string id;      ///< A path, e.g. "world/free/boxes_complex".
  std::string title;   ///< What is there, in one line.
  std::string source;  ///< A citation or a derivation.
  World world;
  std::vector<Claim> claims;
  /** From here on trajectories are not compared from engine to engine: the motion is
   chaotic. [s] */
  std::optional<double> horizon;
  std::optional<Ensemble> ensemble;
  std::vector<Indictment> indicts;
  FilePlaces places;  ///< Where it says so.
};

}  // namespace touchstone
