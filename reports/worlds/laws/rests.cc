#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/slop.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true, .cloths = true});
  const double from = NumberOr(claim, "from", 0);
  if (from < 0 || from >= world.steps * world.dt)
    faults.push_back(
        {"numbers.from", fmt::format("is {:.6g} s", from), "a time before the end"});
  if (NumberOr(claim, "slack", 0) < 0)
    faults.push_back({"numbers.slack", "is negative", "a length >= 0"});
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

/** Bodies that overlap at the start, directly or through others that move. */
struct Pile {
  std::vector<std::pair<int, int>> pairs;  ///< Indices into World::bodies.
  double overlap = 0;                      ///< Sum of their overlaps at the start. [m]
  /** The first sample at which they no longer overlap. */
  std::size_t parted = std::numeric_limits<std::size_t>::max();
};

/** Returns the pile of each body; a body that overlaps nothing has one without pairs. */
std::vector<std::shared_ptr<Pile>> PilesOf(const World& world) {
  const WorldState start = StateAtStart(world);
  std::vector<std::shared_ptr<Pile>> piles(world.bodies.size());
  for (std::shared_ptr<Pile>& pile : piles) pile = std::make_shared<Pile>();
  for (std::size_t A = 0; A < piles.size(); ++A) {
    for (std::size_t B = A + 1; B < piles.size(); ++B) {
      const RigidBody& a = world.bodies[A];
      const RigidBody& b = world.bodies[B];
      if (!a.collides || !b.collides || a.mass + b.mass == 0) continue;
      const double overlap =
          OverlapOf(world, start, static_cast<int>(A), static_cast<int>(B)).depth;
      if (overlap == 0) continue;
      // A static body does not connect those that touch it.
      const std::shared_ptr<Pile> pile = piles[a.mass > 0 ? A : B];
      if (a.mass > 0 && b.mass > 0 && piles[B] != pile) {
        const std::shared_ptr<Pile> other = piles[B];
        pile->pairs.insert(pile->pairs.end(), other->pairs.begin(), other->pairs.end());
        pile->overlap += other->overlap;
        std::replace(piles.begin(), piles.end(), other, pile);
      }
      pile->pairs.emplace_back(static_cast<int>(A), static_cast<int>(B));
      pile->overlap += overlap;
    }
  }
  return piles;
}

/** Finds the sample, from `first` on, at which each pile has separated to within `slack`
 [m]. */
void FindParting(const World& world, const Trajectory& trajectory, std::size_t first,
                 double slack, const std::vector<std::shared_ptr<Pile>>& piles) {
  for (const std::shared_ptr<Pile>& pile : piles) {
    for (std::size_t s = first; s < std::min(pile->parted, trajectory.samples.size());
         ++s) {
      double left = 0;
      for (const auto& [A, B] : pile->pairs)
        left += OverlapOf(world, trajectory.samples[s], A, B).depth;
      if (left <= slack) pile->parted = s;
    }
  }
}

/** Returns how far the slop of one contact lets a body sink, plus how far it lets the
 body turn, times its radius. One edge of the least face may sink by the slop and the
 opposite edge not: the body turns by the slop over that width. [m] */
double SinkOf(const RigidBody& body, const OracleInfo& oracle) {
  const auto* box = std::get_if<Box>(&body.placed.shape);
  if (!box) return oracle.slop;
  const double width = 2 * box->half_extents.minCoeff();
  return oracle.slop * (1 + BoundingRadius(*box) / width);
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  const Subjects subjects = SubjectsOf(world, claim);
  const double from = NumberOr(claim, "from", 0);
  const double h = world.dt;
  double g = world.gravity_W.norm();
  for (const int i : subjects.bodies) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    g = std::max(g, AccelerationOf(world, body).norm());
  }
  const double contacts = static_cast<double>(
      std::max<std::size_t>(1, subjects.bodies.size() + subjects.particles.size()));
  const double slack = NumberOr(claim, "slack", 0);
  const double settling = kSafety * 2 * contacts * g * h * h;
  const auto first = static_cast<std::size_t>(
      std::find_if(trajectory.times.begin(), trajectory.times.end(),
                   [&](double t) { return t >= from - h / 2; }) -
      trajectory.times.begin());
  const std::vector<std::shared_ptr<Pile>> piles = PilesOf(world);
  FindParting(world, trajectory, first, settling, piles);
  Worst rest(
      MeasureKind::kRestMotion,
      WithSlop("1.5 × 2 g h² for each contact that may carry it, overlaps at the start "
               "until they are resolved, 1e-5 of g h per step for the solver, and 64 "
               "roundings per step",
               motion.oracle));
  Worst velocity(MeasureKind::kVelocityError,
                 "1.5 × 2 g h for each contact that may carry it, overlaps at the start "
                 "in a step until they are resolved, and 64 roundings per step");
  for (std::size_t s = first; s < trajectory.samples.size(); ++s) {
    const double t = trajectory.times[s];
    const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s));
    const auto hold = [&](const std::string& name, const Eigen::Vector3d& was,
                          const Eigen::Vector3d& is, double turned, double speed,
                          double granted, double sunk = 0) {
      rest.Take((is - was).norm() + turned,
                settling + sunk + granted + kSolverResidual * g * h * (t - from) +
                    rounding * (1 + is.norm()),
                [&] {
                  return Citing("{} has {} at {} after {:.6g} s; it rested at {}",
                                motion.oracle.name, CitedName{name}, CitedPoint{is},
                                CitedTime{t}, CitedPoint{was});
                });
      velocity.Take(
          speed, kSafety * 2 * contacts * g * h + granted / h + rounding * is.norm() / h,
          [&] {
            return Citing("{} has {} moving at {:.6g} m/s after {:.6g} s; it should rest",
                          motion.oracle.name, CitedName{name}, speed, CitedTime{t});
          });
    };
    const WorldState& now = trajectory.samples[s];
    for (const int index : subjects.bodies) {
      const auto i = static_cast<std::size_t>(index);
      const RigidBody& body = world.bodies[i];
      const double radius = BoundingRadius(body.placed.shape);
      const Pile& pile = *piles[i];
      // After the separation a body rests.
      const bool parted = s > pile.parted;
      const WorldState& then = trajectory.samples[parted ? pile.parted : first];
      hold(body.name, then.bodies[i].p_WB, now.bodies[i].p_WB,
           radius * now.bodies[i].q_WB.angularDistance(then.bodies[i].q_WB),
           now.bodies[i].v_WB.norm() + radius * now.bodies[i].w_WB.norm(),
           slack + (parted ? 0 : pile.overlap), contacts * SinkOf(body, motion.oracle));
    }
    const WorldState& then = trajectory.samples[first];
    for (const int index : subjects.particles) {
      const auto i = static_cast<std::size_t>(index);
      hold(world.particles[i].name, then.particles[i].p_W, now.particles[i].p_W, 0,
           now.particles[i].v_W.norm(), slack);
    }
    for (const int index : subjects.cloths) {
      const Cloth& cloth = world.cloths[static_cast<std::size_t>(index)];
      const int nodes = FirstNodeOf(world, index);
      for (int node = nodes; node < nodes + cloth.n * cloth.n; ++node) {
        const auto i = static_cast<std::size_t>(node);
        hold(cloth.name, then.nodes[i].p_W, now.nodes[i].p_W, 0, now.nodes[i].v_W.norm(),
             slack);
      }
    }
  }
  return FindingsOf({rest, velocity});
}

constexpr std::array<std::string_view, 2> kNumbers = {"from", "slack"};

}  // namespace

/** A body at rest stays where it is. [m], [m/s]

 Motion: the displacement of the centre plus the radius times the angle of rotation, since
 the time `from`. An engine that detects a contact once per step lets the body fall 2 g h²
 before the contact resists. So does each contact that carries it, at most as many as the
 claim has subjects: × 1.5. A solver that does not converge leaves a velocity of 1e-5 g h.
 An overlap at the start, of a body and those it is piled with, may be resolved. Once what
 is left of it is at most what a step lets the bodies fall, they rest where they are. The
 author may grant more by `slack`. 64 roundings per step are added. Velocity: that of the
 same motion in one step; 2 n g h × 1.5 for the settling.

 About: bodies, particles and cloths that rest from `from` on; the author vouches that
 they can. Numbers: from [s], 0 if absent; slack [m]. */
constinit const Law kRests = {
    .name = "rests",
    .documentation =
        "A body at rest stays where it is; from [s] and slack [m] may be given.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
