#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracles/contact_answer.h"
#include "oracles/simulation.h"
#include "oracles/trajectory.h"
#include "oracles/world_setup.h"
#include "scenarios/contact_query.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** The capability of an oracle for one ordered pair of shape kinds. */
struct Capability {
  bool supported = false;
  std::string family;  ///< Algorithm, the unit of consensus: "sat", "gjk_epa", "mpr", …
  bool depth = false;  ///< Returns the separation of penetrating pairs.
  bool distance = false;  ///< Returns the separation of pairs that are apart.
  bool normal = false;    ///< Returns the normal of penetrating pairs.
  /** Returns contact points that are meant to span the contact patch. False for
   algorithms that return one point per call: their point is judged but need not span a
   face. */
  bool manifold = false;
  bool witnesses = false;  ///< Returns witness points of pairs that are apart.
  /** Returns witness points of penetrating pairs. */
  bool penetrating_witnesses = false;
  /** The engine's own documented convergence tolerance or margin, added to the rounding
   tolerance when its separation is judged. [m]; 0 for closed forms. */
  double documented_error = 0;
  /** Like documented_error, but as a fraction of the true |separation|. */
  double documented_relative_error = 0;
  std::string documented_by;  ///< Source of these errors; empty when both are 0.
  std::string reason;         ///< Why the pair is unsupported; empty when supported.
};

/** An error of lengths along the normal that a person states for an oracle, in addition
 to the rounding of its arithmetic. Reports show it with its origin. */
struct StatedTolerance {
  double length = 0;    ///< [m]
  double share = 0;     ///< A fraction of SceneSize(). [-]
  std::string by = {};  ///< Its source, e.g. "--tolerance"; empty only if both are 0.

  bool IsZero() const { return length == 0 && share == 0; }
};

/** Whether an oracle supports one feature of a world. */
struct WorldCapability {
  bool supported = false;
  std::string reason;  ///< Why it is unsupported; empty when supported.
};

/** One value that an adapter sets or converts, as `touchstone oracles --settings` prints
 it. */
struct Setting {
  std::string name;   ///< E.g. "normal", "depth sign", "box margin".
  std::string value;  ///< The value in force, e.g. "B->A, negated".
  std::string why;    ///< The reason, one sentence.
};

/** The description of an oracle: name, version, settings and capabilities. */
struct OracleInfo {
  std::string name;  ///< Path-like: "cookbook", "bullet", "bullet/gjk", "fcl/collide", …
  std::string library;  ///< "Bullet", "ODE", …; "Touchstone" for our own engines.
  std::string version;  ///< Version that the library itself reports.
  /** Unit roundoff of the arithmetic: 2^-53 for double, 2^-24 for float. */
  double unit_roundoff = 0x1p-53;
  /** Whether it computes contacts from p_B − p_A, so that its lengths round like the
   distance of the bodies and not like their coordinates. */
  bool subtracts_first = false;
  /** Whether contact queries are answered in a forked child with a deadline, because the
   engine can abort, crash or hang. */
  bool isolated = false;
  /** Whether it is a program of its own, asked through the oracle protocol. */
  bool external = false;
  /** The tolerance that its contact answers are granted; set by SetTolerance() only. */
  StatedTolerance tolerance;
  std::vector<Setting> settings;
  std::array<std::array<Capability, kShapeKinds>, kShapeKinds> capabilities;
  /** The documented depth at which the engine leaves bodies in contact. [m] */
  double slop = 0;
  std::string slop_documented_by;  ///< Source of `slop`; empty only if it is 0.
  /** The documented speed |v| + R |ω| below which the engine sets a body's velocity to
   zero when it falls asleep, R the radius of its bounding sphere; 0 if none sleeps. [m/s]
 */
  double sleep_speed = 0;
  std::string sleep_documented_by;  ///< Source of `sleep_speed`; empty only if it is 0.
  /** Whether it simulates worlds at all; see also AnswersContacts(). */
  bool simulates = false;
  /** The engine's own documented relative error of the energy and of the angular momentum
   of a body that rotates freely for a step. Absent: that of a first-order scheme for the
   gyroscopic term. [-] */
  std::optional<double> documented_rotation_error;
  /** The order in the step of the engine's scheme for motion without contacts, as its
   documentation states it: halving the step divides the error by 2^order. The default, 1,
   is the order of every consistent scheme. The engine is held to it. */
  double stated_order = 1;
  std::string order_stated_by;    ///< Source of `stated_order`; empty only if it is 1.
  bool steps_in_threads = false;  ///< Whether it has BeginInThreads().
  /** The numbers that may be chosen for its worlds; empty if the adapter offers none. */
  std::vector<WorldParameter> parameters;
  WorldSetup setup;  ///< The setup of its worlds; set by Oracle::SetUp() only.
  /** The name of the parameter that is the softness of contacts and joints: the speed at
   which they yield, per force. Empty if they are rigid. [m/(N s)] */
  std::string softness;
  std::array<WorldCapability, kWorldFeatures> world_capabilities;

  /** Returns the capability for A of kind `a` and B of kind `b`. */
  const Capability& For(ShapeKind a, ShapeKind b) const {
    return capabilities[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
  }

  /** Returns whether it answers contact queries for at least one pair of shapes. */
  bool AnswersContacts() const;

  /** Returns whether Oracle::SetUp() can change how it simulates. */
  bool HasSetups() const { return !parameters.empty(); }

  /** Returns the capability for a feature of a world. */
  const WorldCapability& For(WorldFeature feature) const {
    return world_capabilities[static_cast<std::size_t>(feature)];
  }

  /** Returns why this oracle cannot simulate `world`; empty if it can. */
  std::string CannotSimulate(const World& world) const;
};

/** Returns the softness of contacts and joints in the setup of `oracle`; 0 if they are
 rigid. [m/(N s)] */
double SoftnessOf(const OracleInfo& oracle);

/** Returns the table of `capability_of(a, b)` over all kinds of A and of B. */
template <class CapabilityOf>
decltype(OracleInfo::capabilities) CapabilityTable(CapabilityOf capability_of) {
  decltype(OracleInfo::capabilities) table;
  for (std::size_t a = 0; a < table.size(); ++a) {
    for (std::size_t b = 0; b < table.size(); ++b) {
      table[a][b] = capability_of(static_cast<ShapeKind>(a), static_cast<ShapeKind>(b));
    }
  }
  return table;
}

/** A batch whose engine objects are built in advance, so that only the engine's work is
 timed. */
class PreparedBatch {
 public:
  virtual ~PreparedBatch() = default;

  /** Runs the engine once on every query of the batch, without translating the answers.
   */
  virtual void Run() = 0;

  /** Returns the separation that the engine computed in Run() for each query, with the
   project's sign; NaN where it returned none. [m] */
  virtual std::span<const double> separations() const = 0;
};

/** An engine that answers questions: a library behind an adapter, the cookbook engine, or
 a user's function.

 An oracle is library + entry point + precision. It is a pure function with a name: it
 keeps no state between calls, so it may be called in any order and from any thread. No
 exception crosses this interface: a failure is part of the answer.

 Every oracle passes tests/conformance, which states this contract in full. */
class Oracle {
 public:
  virtual ~Oracle() = default;

  virtual const OracleInfo& info() const = 0;

  /** Answers every query; `answers[i]` is overwritten with the answer to `queries[i]`,
   which states the time that it took.
   @pre The sizes are equal and every query is valid (scenarios/validate.h). */
  virtual void Answer(std::span<const ContactQuery> queries,
                      std::span<ContactAnswer> answers) const = 0;

  /** Returns `queries` ready for timing, or null if the oracle is not timed.
   @pre Every query is supported by this oracle. */
  virtual std::unique_ptr<PreparedBatch> Prepare(
      std::span<const ContactQuery> queries) const;

  /** Returns why it cannot simulate `world`; empty if it can. The default is
   info().CannotSimulate(world). */
  virtual std::string CannotSimulate(const World& world) const;

  /** Returns `world` at its start with `values` for info().parameters, in their order.
   Null, the default, for an oracle without parameters.
   @pre As for Begin(). */
  virtual std::unique_ptr<Simulation> BeginWith(const World& world,
                                                std::span<const double> values) const;

  /** Returns `world` at its start, ready to be stepped, or null if the oracle does not
   simulate. The default is BeginWith() the values of info().setup.
   @pre The world is valid and CannotSimulate(world) is empty. */
  virtual std::unique_ptr<Simulation> Begin(const World& world) const;

  /** Like Begin(), but with the engine's default iterations and stabilisation, except for
   the values that info().setup has chosen: Begin() is configured for accuracy at any
   cost. Equal to Begin() if there is no difference. */
  virtual std::unique_ptr<Simulation> BeginAsShipped(const World& world) const;

  /** Returns this oracle, which must live longer, with its worlds set up by `setup` in
   place of info().setup. */
  virtual std::unique_ptr<Oracle> SetUp(const WorldSetup& setup) const;

  /** Like BeginAsShipped() and bitwise identical to it, but `threads` >= 1 threads share
   each step, including the caller's. Null unless info().steps_in_threads. */
  virtual std::unique_ptr<Simulation> BeginInThreads(const World& world,
                                                     int threads) const;

  /** Returns how `world` moves, and the time that this took; kUnsupported, with the
   reason, if the oracle cannot simulate it.
   @pre The world is valid (scenarios/worlds/validate_world.h). */
  virtual Trajectory Simulate(const World& world) const;

  /** Returns how each of `worlds` moves, as Simulate() does. An isolated oracle forks
   once for all of them. */
  virtual std::vector<Trajectory> SimulateEach(std::span<const World> worlds) const;

  /** Answers one query. */
  ContactAnswer Answer(const ContactQuery& query) const;
};

}  // namespace touchstone
