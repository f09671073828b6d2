#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/point_mass.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/catenary.h"
#include "reports/worlds/truth/net.h"

namespace touchstone {
namespace {

/** Distance from rest at the start that counts as rounding, over the chain's length.
 [-] */
constexpr double kAtRest = 1e-6;

/** Stiffness of a spring that replaces a rod in the computation of the slowest decay,
 over the rod's transverse stiffness from its tension. The spring's own stretch changes
 the decay by the inverse. [-] */
constexpr double kRodStiffness = 1e6;

/** A rod or a spring between two ends. */
struct Link {
  double rest_length;
  double stiffness;
};

template <typename IsA, typename IsB>
std::vector<Link> LinksBetween(const World& world, const IsA& is_a, const IsB& is_b) {
  std::vector<Link> links;
  const auto joins = [&](const auto& link) {
    return (is_a(link.A) && is_b(link.B)) || (is_a(link.B) && is_b(link.A));
  };
  for (const DistanceJoint& joint : world.joints) {
    if (joins(joint))
      links.push_back({joint.length, std::numeric_limits<double>::infinity()});
  }
  for (const Spring& spring : world.springs) {
    if (joins(spring)) links.push_back({spring.rest_length, spring.stiffness});
  }
  return links;
}

/** Returns the fixed ends of the links at `point`. */
std::vector<Eigen::Vector3d> FixedEndsAt(const World& world, const PointMass& point) {
  std::vector<Eigen::Vector3d> ends;
  const auto add = [&](const auto& link) {
    for (const auto& [near, far] :
         {std::pair(&link.A, &link.B), std::pair(&link.B, &link.A)}) {
      const std::optional<Eigen::Vector3d> fixed = FixedPointOf(world, *far);
      if (point.IsAt(*near) && fixed) ends.push_back(*fixed);
    }
  };
  for (const DistanceJoint& joint : world.joints) add(joint);
  for (const Spring& spring : world.springs) add(spring);
  return ends;
}

int LinksAt(const World& world, const PointMass& point) {
  const auto at = [&](const auto& link) {
    return (link.A.on == point.on && link.A.index == point.index) ||
           (link.B.on == point.on && link.B.index == point.index);
  };
  return static_cast<int>(std::count_if(world.joints.begin(), world.joints.end(), at) +
                          std::count_if(world.springs.begin(), world.springs.end(), at));
}

/** The chain that a claim names, or the reason why there is none. */
struct Found {
  std::string why;
  HangingChain chain;
  bool has_rods = false;
};

Found ChainOf(const World& world, const std::vector<PointMass>& points) {
  Found found;
  const auto add = [&](const std::vector<Link>& links, const std::string& what) {
    if (links.size() != 1) {
      found.why = fmt::format("has {} links {}", links.size(), what);
      return;
    }
    found.chain.rest_length.push_back(links.front().rest_length);
    found.chain.stiffness.push_back(links.front().stiffness);
    found.has_rods = found.has_rods || std::isinf(links.front().stiffness);
  };
  const auto is_fixed = [&](const Anchor& anchor) {
    return FixedPointOf(world, anchor).has_value();
  };
  const auto is = [&](const PointMass& point) {
    return [&](const Anchor& anchor) { return point.IsAt(anchor); };
  };
  const std::vector<Eigen::Vector3d> first = FixedEndsAt(world, points.front());
  const std::vector<Eigen::Vector3d> last = FixedEndsAt(world, points.back());
  if (points.size() < 2) found.why = "is a single point";
  if (found.why.empty())
    add(LinksBetween(world, is(points.front()), is_fixed),
        "from its first point to something fixed");
  for (std::size_t i = 1; i < points.size() && found.why.empty(); ++i) {
    add(LinksBetween(world, is(points[i - 1]), is(points[i])),
        fmt::format("from {} to {}", points[i - 1].name, points[i].name));
  }
  if (!found.why.empty()) return found;
  found.chain.from_W = first.front();
  found.chain.free_end = last.empty();
  if (!last.empty()) {
    add(LinksBetween(world, is(points.back()), is_fixed),
        "from its last point to something fixed");
    found.chain.to_W = last.front();
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool ends = i + 1 == points.size() && found.chain.free_end;
    if (LinksAt(world, points[i]) != (ends ? 1 : 2))
      found.why = fmt::format("has other links at {}", points[i].name);
    found.chain.weight_W.push_back(points[i].mass * points[i].a_W);
  }
  if (!found.why.empty() || found.chain.free_end) return found;
  const Eigen::Vector3d span_W = found.chain.to_W - found.chain.from_W;
  double length = 0;
  bool gives = false;
  for (std::size_t i = 0; i < found.chain.rest_length.size(); ++i) {
    length += found.chain.rest_length[i];
    gives = gives || std::isfinite(found.chain.stiffness[i]);
  }
  if (!gives && span_W.norm() >= length) found.why = "is too short for its ends";
  if (span_W.cross(world.gravity_W).norm() <= kAtRest * length * world.gravity_W.norm())
    found.why = "has one end right above the other";
  return found;
}

double LengthOf(const HangingChain& chain, const Catenary& rest) {
  double length = 0;
  for (std::size_t i = 0; i < rest.tension_W.size(); ++i)
    length += chain.rest_length[i] + rest.tension_W[i].norm() / chain.stiffness[i];
  return length;
}

double FarthestFromRest(const std::vector<PointMass>& points, const Catenary& rest) {
  double farthest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    farthest = std::max(farthest, (points[i].start.p_W - rest.points_W[i]).norm());
  return farthest;
}

double LeastDamping(const std::vector<PointMass>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (const PointMass& point : points) least = std::min(least, point.damping);
  return least;
}

/** Returns how the motion about rest decays. */
Decay DecayOf(const std::vector<PointMass>& points, const HangingChain& chain,
              const Catenary& rest) {
  Net net;
  Net::Points at = {chain.from_W};
  net.mass = {0};
  net.g_W = points.front().a_W;
  for (std::size_t i = 0; i < points.size(); ++i) {
    net.mass.push_back(points[i].mass);
    at.push_back(rest.points_W[i]);
  }
  if (!chain.free_end) {
    net.mass.push_back(0);
    at.push_back(chain.to_W);
  }
  for (std::size_t i = 0; i < rest.tension_W.size(); ++i) {
    const double T = rest.tension_W[i].norm();
    const int a = static_cast<int>(i);
    const double stiffness =
        std::min(chain.stiffness[i], kRodStiffness * T / chain.rest_length[i]);
    const double length = (at[i + 1] - at[i]).norm();
    net.links.push_back({a, a + 1, stiffness, length - T / stiffness});
  }
  return net.DecayAbout(at, LeastDamping(points));
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults =
      FaultsOfSubjects(world, claim, {.bodies = true, .particles = true});
  if (!faults.empty()) return faults;
  const std::vector<PointMass> points = PointMassesInOrder(world, claim);
  const std::string expected =
      "the points of a chain in order, from a fixed point to a fixed point or to its end";
  if (world.gravity_W.isZero(0))
    return {{"about", "is in a world without gravity", "gravity"}};
  const Found found = ChainOf(world, points);
  if (!found.why.empty()) return {{"about", found.why, expected}};
  const Catenary rest = CatenaryOf(found.chain);
  const double from = NumberOr(claim, "from", 0);
  if (from < 0 || from > world.steps * world.dt)
    faults.push_back(
        {"numbers.from", fmt::format("is {:.6g} s", from), "a time within the motion"});
  if (LeastDamping(points) == 0 &&
      FarthestFromRest(points, rest) > kAtRest * LengthOf(found.chain, rest)) {
    faults.push_back({"about",
                      fmt::format("starts {:.6g} m from rest and has no damping",
                                  FarthestFromRest(points, rest)),
                      "damped particles, or a start at rest"});
  }
  const Eigen::Vector3d down_W = world.gravity_W.normalized();
  double lowest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p_W : rest.points_W)
    lowest = std::max(lowest, down_W.dot(p_W));
  const double top = found.chain.free_end ? down_W.dot(found.chain.from_W)
                                          : std::min(down_W.dot(found.chain.from_W),
                                                     down_W.dot(found.chain.to_W));
  double largest = 0;
  for (const Eigen::Vector3d& T_W : rest.tension_W)
    largest = std::max(largest, T_W.norm());
  const Eigen::Vector3d& T_W = rest.tension_W.front();
  return Joined(std::move(faults),
                FaultsOfNumbers(claim, {{"expected_horizontal_tension",
                                         (T_W - T_W.dot(down_W) * down_W).norm()},
                                        {"expected_largest_tension", largest},
                                        {"expected_sag", lowest - top}}));
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  const std::vector<PointMass> points = PointMassesInOrder(world, claim);
  const Found found = ChainOf(world, points);
  const Catenary rest = CatenaryOf(found.chain);
  const double length = LengthOf(found.chain, rest);
  const double start =
      FarthestFromRest(points, rest) * std::sqrt(static_cast<double>(points.size()));
  const Decay decay = DecayOf(points, found.chain, rest);
  const double from = NumberOr(claim, "from", trajectory.times.back());
  Worst worst(MeasureKind::kPositionError,
              fmt::format("1.5 √n of the distance from rest at the start, times what "
                          "damping leaves of it, decaying at γ = {:.6g}/s; 1e-5 of the "
                          "chain's length for rods, and 64 roundings per step",
                          decay.Slowest()));
  for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
    const double t = trajectory.times[s];
    if (t < from - world.dt / 2) continue;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PointState is = points[i].In(trajectory.samples[s]);
      const Eigen::Vector3d& p_W = rest.points_W[i];
      worst.Take(
          (is.p_W - p_W).norm(),
          kSafety * start * decay.LeftAfter(t) +
              (found.has_rods ? kSolverResidual : 0) * length +
              RoundingOf(motion.oracle, StepsBefore(motion, s)) * (p_W.norm() + length),
          [&] {
            return Citing(
                "{} has {} at {} after {:.6g} s; at rest it hangs "
                "at {}",
                motion.oracle.name, CitedName{points[i].name}, CitedPoint{is.p_W},
                CitedTime{t}, CitedPoint{p_W});
          });
    }
  }
  return FindingsOf({worst});
}

constexpr std::array<std::string_view, 4> kNumbers = {
    "expected_horizontal_tension", "expected_largest_tension", "expected_sag", "from"};

}  // namespace

/** A chain of points on rods or springs, between two fixed points or from one, hangs as
 the discrete catenary (truth/catenary.h). [m]

 Judged at the last sample, or from the time `from` on. The remaining motion is at most
 the largest distance from rest at the start, times √n for n points and e^{−γ t}, × 1.5; γ
 is the slowest decay of small motion (truth/net.h) by the particles' damping. 1e-5 of the
 chain's length for the solver of rods, and 64 roundings per step.

 About: bodies held at their centres, or particles, in the order of the chain; without
 damping they must start at rest. Numbers: from [s]; expected_horizontal_tension,
 expected_largest_tension [N], expected_sag: how far the lowest point is below the higher
 end [m]. */
constinit const Law kHangsAsCatenary = {
    .name = "hangs_as_catenary",
    .documentation =
        "A chain of rods or springs hangs as the discrete catenary; about names it in "
        "order.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
