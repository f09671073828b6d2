#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"
#include "reports/worlds/truth/net.h"
#include "reports/worlds/truth/net_motion.h"

namespace touchstone {
namespace {

bool Holds(const std::vector<int>& particles, const Anchor& anchor) {
  return anchor.on == AnchorKind::kParticle &&
         std::find(particles.begin(), particles.end(), anchor.index) != particles.end();
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.particles = true, .cloths = true});
  if (!faults.empty()) return faults;
  const Subjects subjects = SubjectsOf(world, claim);
  const auto refuse = [&](const std::string& name, const std::string& why) {
    faults.push_back(
        FaultAbout(claim, name, why, "damped cloths and particles on springs"));
  };
  for (const int i : subjects.cloths) {
    const Cloth& cloth = world.cloths[static_cast<std::size_t>(i)];
    if (cloth.damping == 0) refuse(cloth.name, "has no damping");
    if (cloth.pinned.empty() && !world.gravity_W.isZero(0))
      refuse(cloth.name, "is pinned nowhere");
  }
  for (const int i : subjects.particles) {
    const Particle& particle = world.particles[static_cast<std::size_t>(i)];
    if (particle.damping == 0) refuse(particle.name, "has no damping");
    const auto jointed = [&](const DistanceJoint& joint) {
      return Holds({i}, joint.A) || Holds({i}, joint.B);
    };
    if (std::any_of(world.joints.begin(), world.joints.end(), jointed))
      refuse(particle.name, "is held by a rod");
    for (const Spring& spring : world.springs) {
      if (!Holds({i}, spring.A) && !Holds({i}, spring.B)) continue;
      for (const Anchor& end : {spring.A, spring.B}) {
        if (!FixedPointOf(world, end) && !Holds(subjects.particles, end))
          refuse(particle.name, "is joined by a spring to another moving thing");
      }
    }
  }
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

/** The subjects as a net: the nodes of cloths, then particles, then fixed points. */
struct Hung {
  Net net;
  std::vector<double> drag;  ///< Indexed by point of the net. [1/s]
  Net::Points fixed_W;

  /** Returns the least damping of a point that moves. [1/s] */
  double LeastDrag() const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < drag.size(); ++i) {
      if (net.mass[i] > 0) least = std::min(least, drag[i]);
    }
    return least;
  }

  /** Positions and velocities of the points of the net. */
  struct Points {
    Net::Points p_W;
    Net::Points v_W;

    void Add(const PointState& point) {
      p_W.push_back(point.p_W);
      v_W.push_back(point.v_W);
    }
  };

  Points PointsOf(const World& world, const Subjects& subjects,
                  const WorldState& state) const {
    Points points;
    for (const int i : subjects.cloths) {
      const auto n =
          static_cast<std::size_t>(world.cloths[static_cast<std::size_t>(i)].n);
      const auto first = static_cast<std::size_t>(FirstNodeOf(world, i));
      for (std::size_t node = 0; node < n * n; ++node)
        points.Add(state.nodes[first + node]);
    }
    for (const int i : subjects.particles)
      points.Add(state.particles[static_cast<std::size_t>(i)]);
    for (const Eigen::Vector3d& p_W : fixed_W) points.Add({p_W, Eigen::Vector3d::Zero()});
    return points;
  }
};

Hung HungOf(const World& world, const Subjects& subjects) {
  Hung hung;
  hung.net.g_W = world.gravity_W;
  for (const int i : subjects.cloths) {
    const Cloth& cloth = world.cloths[static_cast<std::size_t>(i)];
    const int first = static_cast<int>(hung.net.mass.size());
    for (int node = 0; node < cloth.n * cloth.n; ++node)
      hung.net.mass.push_back(IsPinned(cloth, node) ? 0 : cloth.node_mass);
    for (const ClothSpring& spring : SpringsOf(cloth)) {
      hung.net.links.push_back({first + spring.a, first + spring.b, spring.stiffness,
                                spring.rest_length, spring.damping});
    }
    hung.drag.resize(hung.net.mass.size(), cloth.damping);
  }
  const int first = static_cast<int>(hung.net.mass.size());
  for (const int i : subjects.particles) {
    const Particle& particle = world.particles[static_cast<std::size_t>(i)];
    hung.net.mass.push_back(particle.mass);
    hung.drag.push_back(particle.damping);
  }
  const auto point = [&](const Anchor& anchor) {
    for (std::size_t k = 0; k < subjects.particles.size(); ++k) {
      if (Holds({subjects.particles[k]}, anchor)) return first + static_cast<int>(k);
    }
    hung.fixed_W.push_back(*FixedPointOf(world, anchor));
    hung.net.mass.push_back(0);
    return static_cast<int>(hung.net.mass.size()) - 1;
  };
  for (const Spring& spring : world.springs) {
    if (!Holds(subjects.particles, spring.A) && !Holds(subjects.particles, spring.B))
      continue;
    const int a = point(spring.A);
    const int b = point(spring.B);
    hung.net.links.push_back(
        {a, b, spring.stiffness, spring.rest_length, spring.damping});
  }
  hung.drag.resize(hung.net.mass.size());
  return hung;
}

double Farthest(const Net::Points& a, const Net::Points& b) {
  double farthest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    farthest = std::max(farthest, (a[i] - b[i]).norm());
  return farthest;
}

/** Returns the largest amplitude of a net about `rest_W`, in (x, ẋ/ω) of its modes. It is
 the larger of two bounds: the displacement at the start plus the speed at the start over
 the rate of the slowest mode, or all its energy in the softest mode. Damping by γ stops ẋ
 within ẋ/2γ, however soft a mode is. [m] */
double AmplitudeOf(const Net& net, const Decay& decay, const Net::Points& begin_W,
                   const Net::Points& rest_W, double kinetic, double energy) {
  const double rate =
      std::max(std::sqrt(decay.frequencies2.front()), 2 * decay.half_damping);
  double lightest = std::numeric_limits<double>::infinity();
  double out = 0;
  for (std::size_t i = 0; i < net.mass.size(); ++i) {
    if (net.mass[i] == 0) continue;
    lightest = std::min(lightest, net.mass[i]);
    out += net.mass[i] * (begin_W[i] - rest_W[i]).squaredNorm();
  }
  return std::max(std::sqrt(out) + std::sqrt(2 * kinetic) / rate,
                  std::sqrt(2 * std::max(0.0, energy)) / rate) /
         std::sqrt(lightest);
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Subjects subjects = SubjectsOf(world, claim);
  const Hung hung = HungOf(world, subjects);
  const WorldState& end = motion.trajectory.samples.back();
  const WorldState begin = StateAtStart(world);
  const Net::Points is = hung.PointsOf(world, subjects, end).p_W;
  const auto [start_W, start_v_W] = hung.PointsOf(world, subjects, begin);
  const Energy last = EnergyOf(world, end, subjects);
  const double rounding = RoundingOf(
      motion.oracle, StepsBefore(motion, motion.trajectory.samples.size() - 1));

  // The truth is the minimum nearest to the answer if the one downhill from the start is
  // not lower: mirror images are equivalent. A higher one may be right for a motion that
  // swings over a hump. But an engine in a hollow of its own must not decide that, so an
  // independent integration does.
  Net::Points rest = hung.net.Minimum(is);
  const double least_downhill = hung.net.EnergyAt(hung.net.Minimum(start_W));
  if (hung.net.EnergyAt(rest) > least_downhill + rounding * last.size) {
    const std::optional<Net::Points> moved_there =
        RestAfter(hung.net, hung.drag, start_W, start_v_W, world.steps * world.dt);
    if (!moved_there) return {};
    rest = *moved_there;
  }
  const Decay decay = hung.net.DecayAbout(rest, hung.LeastDrag());
  const double t = motion.trajectory.times.back();
  const double left_of_start = decay.LeftAfter(t);
  double reach = 0;
  for (const Eigen::Vector3d& p_W : rest) reach = std::max(reach, p_W.norm());
  const std::string because = fmt::format(
      "1.5 × what damping leaves of the start, at most {:.3g} of its amplitude, decaying "
      "at γ = {:.6g}/s, and 64 roundings per step",
      left_of_start, decay.Slowest());

  const double kinetic = EnergyOf(world, begin, subjects).kinetic;
  const double least = hung.net.EnergyAt(rest);
  const double given = hung.net.EnergyAt(start_W) + kinetic - least;
  const double amplitude = AmplitudeOf(hung.net, decay, start_W, rest, kinetic, given);

  Worst position(MeasureKind::kPositionError, because);
  const double off = Farthest(is, rest);
  position.Take(off, kSafety * amplitude * left_of_start + rounding * reach, [&] {
    return Citing("{} has a point {:.6g} m from its place of least energy after {:.6g} s",
                  motion.oracle.name, off, CitedTime{t});
  });

  Worst energy(MeasureKind::kEnergyDrift, because);
  const double left = hung.net.EnergyAt(is) + last.kinetic - least;
  energy.Take(
      std::abs(left),
      kSafety * std::abs(given) * left_of_start * left_of_start + rounding * last.size,
      [&] {
        return Citing("{} has {:.9g} J more than the minimum of {:.9g} J after {:.6g} s",
                      motion.oracle.name, left, least, CitedTime{t});
      });
  return FindingsOf({position, energy});
}

}  // namespace

/** A damped system comes to rest at a minimum of its energy. [m], [J]

 An independent minimiser (truth/net.h) finds the minimum of −Σ m g·x + Σ ½ k (|p_AB| −
 L)² nearest to the last sample. The measures are the distance of the points from it and
 the energy, kinetic and potential, above it. A stationary shape carries its weight, so
 that needs no claim of its own.

 That minimum is the truth if the one downhill from the start is not lower. Otherwise the
 truth is the minimum that an independent integration comes to (truth/net_motion.h). If
 that is uncertain, nothing is judged.

 Tolerance: the amplitude at the start (of position, speed and energy) times e^{−γ t}, and
 the energy at the start times e^{−2 γ t}, both × 1.5; γ is the slowest decay of small
 motion by the damping of particles and nodes. 64 roundings per step.

 About: damped cloths, and damped particles, with the springs among them and to static
 things; no rods. Numbers: none. */
constinit const Law kMinimumEnergy = {
    .name = "minimum_energy",
    .documentation =
        "Damped cloths and particles on springs come to rest at a minimum of their "
        "energy.",
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
