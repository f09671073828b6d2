#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "scenarios/validate_scenario.h"
#include "scenarios/worlds/solid.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

/** Collects the faults of one part. Comparisons are written so that a NaN is a fault. */
class Check {
 public:
  void Finite(std::string_view where, double value) {
    if (!std::isfinite(value)) Add(where, value, "a finite number");
  }
  void Finite(std::string_view where, const Eigen::Vector3d& v) {
    for (int i = 0; i < 3; ++i) Finite(fmt::format("{}[{}]", where, i), v[i]);
  }
  void NotNegative(std::string_view where, double value) {
    if (!(value >= 0 && std::isfinite(value))) Add(where, value, "a finite number >= 0");
  }
  void Positive(std::string_view where, double value) {
    if (!(value > 0 && std::isfinite(value))) Add(where, value, "a finite number > 0");
  }
  void Length(std::string_view where, double value) {
    if (!(value > 0 && std::isfinite(value))) Add(where, value, "a finite length > 0");
  }
  void Share(std::string_view where, double value) {
    if (!(value >= 0 && value <= 1)) Add(where, value, "a number from 0 to 1");
  }
  void AtRest(std::string_view where, const Eigen::Vector3d& v) {
    if (v.allFinite() && !v.isZero(0)) {
      Add(where, "is not 0, but the mass is",
          "zero, since mass 0 means that it never moves");
    }
  }
  void Springs(std::string_view family, const ClothSprings& springs) {
    NotNegative(fmt::format("{}.stiffness", family), springs.stiffness);
    NotNegative(fmt::format("{}.damping", family), springs.damping);
  }
  void Add(std::string_view where, double value, std::string_view expected) {
    Add(where, fmt::format("is {}", value), expected);
  }
  void Add(std::string_view where, std::string what, std::string_view expected) {
    faults.push_back({std::string(where), std::move(what), std::string(expected)});
  }

  std::vector<Fault> faults;
};

/** Checks that the moments of a moving body follow from its shape. */
void CheckSolid(const Shape& shape, double mass, Check& check) {
  // Faults of its sizes and of its mass are reported elsewhere.
  if (!FaultsOf(Body{shape, {}}).empty() || !(mass > 0) || std::isinf(mass)) return;
  if (UniformMoments(shape, mass)) return;
  const std::string kind = fmt::format("is \"{}\"", NameOf(KindOf(shape)));
  const std::optional<Solid> solid = UniformSolid(shape, mass);
  if (!solid) {
    check.Add("shape", kind + " without volume", "a stated inertia");
  } else if (!solid->inertia_B.allFinite()) {
    check.Add("shape", kind + " whose moments of inertia are beyond the range of doubles",
              "smaller sizes or a smaller mass");
  } else if (const Eigen::Vector3d& c = solid->centre_B;
             c.norm() > kAligned * BoundingRadius(shape)) {
    check.Add(
        "shape",
        fmt::format("{} with its uniform solid's centre of mass at [{:.6g}, {:.6g}, "
                    "{:.6g}]",
                    kind, c.x(), c.y(), c.z()),
        "a stated inertia, or a shape about its centre of mass: that is the origin "
        "of a body that moves");
  } else {
    check.Add("shape", kind + " whose principal axes are not its body axes",
              "a stated inertia, or a shape turned to its principal axes");
  }
}

void CheckInertia(const RigidBody& body, Check& check) {
  const ShapeKind kind = KindOf(body.placed.shape);
  if (kind == ShapeKind::kHalfSpace) {
    if (body.mass != 0) check.Add("shape", "is \"half_space\", which moves", "mass = 0");
  } else if (!body.inertia && body.mass != 0) {
    CheckSolid(body.placed.shape, body.mass, check);
  }
  if (!body.inertia) return;
  const Eigen::Vector3d& moments = *body.inertia;
  const std::size_t before = check.faults.size();
  for (int i = 0; i < 3; ++i) {
    if (!(moments[i] > 0 && std::isfinite(moments[i]))) {
      check.Add(fmt::format("inertia[{}]", i), moments[i], "a finite moment > 0");
    }
  }
  if (check.faults.size() != before) return;
  // I_x + I_y − I_z = 2 ∫ z² dm >= 0, and likewise for the other axes. It is 0 for a flat
  // body, so the rounding of given moments is allowed for.
  const double largest = moments.maxCoeff();
  const double others = moments.sum() - largest;
  if (largest > others * (1 + 8 * std::numeric_limits<double>::epsilon())) {
    check.Add("inertia", "has a moment that exceeds the sum of the others",
              "moments that a solid can have");
  }
}

}  // namespace

std::vector<Fault> FaultsOf(const RigidBody& body) {
  Check check;
  check.faults = FaultsOf(body.placed);
  check.NotNegative("mass", body.mass);
  CheckInertia(body, check);
  check.Finite("velocity", body.v_WB);
  check.Finite("spin", body.w_WB);
  check.Share("restitution", body.restitution);
  check.NotNegative("friction", body.friction);
  check.Finite("force", body.force_W);
  if (body.mass == 0) {
    check.AtRest("velocity", body.v_WB);
    check.AtRest("spin", body.w_WB);
    check.AtRest("force", body.force_W);
  }
  return check.faults;
}

std::vector<Fault> FaultsOf(const Particle& particle) {
  Check check;
  check.Finite("position", particle.p_W);
  check.Finite("velocity", particle.v_W);
  check.NotNegative("mass", particle.mass);
  check.NotNegative("damping", particle.damping);
  check.Share("bounce", particle.bounce);
  if (particle.mass == 0) check.AtRest("velocity", particle.v_W);
  return check.faults;
}

std::vector<Fault> FaultsOf(const Spring& spring) {
  Check check;
  check.NotNegative("stiffness", spring.stiffness);
  check.NotNegative("damping", spring.damping);
  check.NotNegative("rest_length", spring.rest_length);
  return check.faults;
}

std::vector<Fault> FaultsOf(const DistanceJoint& joint) {
  Check check;
  check.Length("length", joint.length);
  return check.faults;
}

std::vector<Fault> FaultsOf(const Cloth& cloth) {
  Check check;
  if (cloth.n < 3) check.Add("n", fmt::format("is {}", cloth.n), "3 nodes or more");
  check.Length("spacing", cloth.spacing);
  check.Finite("centre", cloth.centre);
  check.Positive("node_mass", cloth.node_mass);
  check.NotNegative("damping", cloth.damping);
  check.Share("bounce", cloth.bounce);
  check.Springs("structural", cloth.structural);
  check.Springs("shear", cloth.shear);
  check.Springs("bend", cloth.bend);
  const auto outside = [&cloth](int i) { return i < 0 || i >= cloth.n; };
  std::set<std::pair<int, int>> pinned;
  for (std::size_t i = 0; i < cloth.pinned.size(); ++i) {
    const auto [row, column] = cloth.pinned[i];
    const std::string where = fmt::format("pinned[{}]", i);
    if (cloth.n >= 3 && (outside(row) || outside(column))) {
      check.Add(where, fmt::format("is [{}, {}]", row, column),
                fmt::format("a row and a column from 0 to {}", cloth.n - 1));
    } else if (!pinned.insert(cloth.pinned[i]).second) {
      check.Add(where, fmt::format("is [{}, {}] again", row, column), "each node once");
    }
  }
  return check.faults;
}

std::vector<Fault> FaultsOf(const Claim& claim) {
  Check check;
  if (!IsWord(claim.law)) {
    check.Add("law", fmt::format("is \"{}\"", claim.law), "a name of a-z, 0-9 and _");
  }
  for (std::size_t i = 0; i < claim.about.size(); ++i) {
    const auto end = claim.about.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(claim.about.begin(), end, claim.about[i]) != end) {
      check.Add(fmt::format("about[{}]", i), fmt::format("is \"{}\" again", *end),
                "each name once");
    }
  }
  for (const auto& [name, number] : claim.numbers) {
    if (!IsWord(name)) {
      check.Add("numbers", fmt::format("has a \"{}\"", name), "names of a-z, 0-9 and _");
    } else {
      check.Finite(fmt::format("numbers.{}", name), number);
    }
  }
  return check.faults;
}

std::vector<Fault> FaultsOf(const Ensemble& ensemble) {
  Check check;
  if (ensemble.members < 2) {
    check.Add("members", fmt::format("is {}", ensemble.members), "2 worlds or more");
  }
  check.Length("jitter", ensemble.jitter);
  return check.faults;
}

std::vector<Fault> FaultsOfClock(const World& world) {
  Check check;
  check.Finite("gravity", world.gravity_W);
  check.Positive("dt", world.dt);
  if (world.steps < 1 || world.steps > kMostSteps) {
    check.Add("steps", fmt::format("is {}", world.steps),
              fmt::format("a count from 1 to {}", kMostSteps));
  } else if (world.sample_every < 1) {
    check.Add("sample_every", fmt::format("is {}", world.sample_every),
              "a count, 1 or more");
  } else if (world.steps % world.sample_every != 0) {
    check.Add("sample_every", fmt::format("is {}", world.sample_every),
              fmt::format("a divisor of the {} steps", world.steps));
  } else if (!std::isfinite(world.steps * world.dt) && std::isfinite(world.dt)) {
    check.Add("dt", fmt::format("is {}", world.dt), "a dt with a finite end time");
  }
  return check.faults;
}

std::vector<Fault> FaultsOfEnds(const World& world, const Anchor& A, const Anchor& B) {
  Check check;
  check.Finite("A.point", A.point);
  check.Finite("B.point", B.point);
  const auto moves = [&world](const Anchor& end) {
    const auto index = static_cast<std::size_t>(end.index);
    return (end.on == AnchorKind::kBody && world.bodies[index].mass != 0) ||
           (end.on == AnchorKind::kParticle && world.particles[index].mass != 0);
  };
  const auto check_particle = [&check](const char* where, const Anchor& end) {
    if (end.on == AnchorKind::kParticle && end.point.allFinite() &&
        !end.point.isZero(0)) {
      check.Add(where, "is not 0", "zero, since a particle has no size");
    }
  };
  check_particle("A.point", A);
  check_particle("B.point", B);
  if (!check.faults.empty()) return check.faults;
  if (A.on == B.on && A.index == B.index && A.on != AnchorKind::kWorld) {
    check.Add("B", "is on the same body or particle as A",
              "another body or particle, or the world");
  } else if (!moves(A) && !moves(B)) {
    check.Add("B", "is on something that never moves, and so is A",
              "one end that can move");
  } else {
    const Eigen::Vector3d p_WA = StartOf(world, A);
    const Eigen::Vector3d p_WB = StartOf(world, B);
    // A few roundings of the coordinates: each coordinate of R p + p_WB sums four terms.
    const double rounding = 8 * std::numeric_limits<double>::epsilon() *
                            std::max(p_WA.stableNorm(), p_WB.stableNorm());
    if (!((p_WA - p_WB).stableNorm() > rounding)) {
      check.Add("B", "is at the same point as A", "two ends at different points");
    }
  }
  return check.faults;
}

std::vector<Fault> FaultsOf(const Push& push) {
  Check check;
  check.NotNegative("time", push.time);
  check.Finite("point", push.p_BoP);
  check.Finite("impulse", push.J_W);
  return check.faults;
}

std::vector<Fault> FaultsIn(const World& world, const Push& push) {
  Check check;
  if (world.bodies[static_cast<std::size_t>(push.body)].mass == 0) {
    check.Add("body", "has mass 0", "a body that can move");
  }
  const double step = std::round(push.time / world.dt);
  if (step >= world.steps) {
    check.Add("time", push.time,
              fmt::format("a time before the end at {} s", world.steps * world.dt));
  } else if (std::abs(push.time / world.dt - step) > kStepSlack) {
    check.Add("time", push.time, fmt::format("a multiple of dt = {}", world.dt));
  }
  return check.faults;
}

std::vector<Fault> FaultsOfHorizon(double horizon) {
  Check check;
  check.NotNegative("horizon", horizon);
  return check.faults;
}

}  // namespace touchstone
