#include "scenarios/worlds/magnitudes.h"

#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "scenarios/worlds/body_steps.h"
#include "scenarios/worlds/validate_world.h"

namespace touchstone {
namespace {

/** A length of a shape, with its key. */
struct NamedLength {
  std::string key;
  double length;  ///< [m]
};

struct LengthsOf {
  using Lengths = std::vector<NamedLength>;
  Lengths operator()(const Sphere& sphere) const { return {{"radius", sphere.radius}}; }
  Lengths operator()(const Box& box) const {
    return {{"half_extents[0]", box.half_extents[0]},
            {"half_extents[1]", box.half_extents[1]},
            {"half_extents[2]", box.half_extents[2]}};
  }
  Lengths operator()(const Capsule& capsule) const {
    return {{"radius", capsule.radius}, {"half_length", capsule.half_length}};
  }
  Lengths operator()(const Cylinder& cylinder) const {
    return {{"radius", cylinder.radius}, {"half_length", cylinder.half_length}};
  }
  Lengths operator()(const Cone& cone) const {
    return {{"radius", cone.radius}, {"half_height", cone.half_height}};
  }
  Lengths operator()(const ConvexHull& hull) const {
    return {{"vertices", BoundingRadius(hull)}};
  }
  Lengths operator()(const HalfSpace&) const { return {}; }
};

class MagnitudeCheck {
 public:
  explicit MagnitudeCheck(const World& world) : world_(world) {}

  std::vector<Fault> Faults() && {
    Clock();
    for (const RigidBody& body : world_.bodies) Of(body);
    for (const Particle& particle : world_.particles) Of(particle);
    for (const Cloth& cloth : world_.cloths) Of(cloth);
    for (std::size_t i = 0; i < world_.springs.size(); ++i)
      Of(fmt::format("springs[{}]", i), world_.springs[i]);
    for (std::size_t i = 0; i < world_.joints.size(); ++i)
      Of(fmt::format("joints[{}]", i), world_.joints[i]);
    for (std::size_t i = 0; i < world_.pushes.size(); ++i)
      Of(fmt::format("pushes[{}]", i), world_.pushes[i]);
    return std::move(faults_);
  }

 private:
  void Clock() {
    InRange("world.dt", world_.dt, "s");
    AtMost("world.gravity", world_.gravity_W, "m/s²");
    const double cost = BodySteps(world_);
    // The number of steps alone is reported elsewhere.
    if (cost <= kMostBodySteps || world_.steps > kMostSteps) return;
    Add("world.steps",
        fmt::format("is {} for {:g} moving bodies, particles and nodes", world_.steps,
                    cost / world_.steps),
        fmt::format("at most {:g} steps × moving bodies, particles and nodes, about a "
                    "minute of the "
                    "slowest engine",
                    kMostBodySteps));
  }

  void Of(const RigidBody& body) {
    const std::string path = fmt::format("bodies.{}.", body.name);
    AtMost(path + "position", body.placed.X_WB.p_WB, "m");
    for (const NamedLength& part : std::visit(LengthsOf(), body.placed.shape))
      InRange(path + part.key, part.length, "m");
    InRange(path + "mass", body.mass, "kg");
    if (body.inertia) {
      for (int i = 0; i < 3; ++i) {
        InRange(fmt::format("{}inertia[{}]", path, i), (*body.inertia)[i], "kg m²",
                kLeastInertia, kMostInertia);
      }
    }
    AtMost(path + "velocity", body.v_WB, "m/s");
    AtMost(path + "spin", body.w_WB, "rad/s");
    AtMost(path + "friction", body.friction, "");
    if (!(body.mass > 0)) return;
    const Eigen::Vector3d a_W = world_.gravity_W + body.force_W / body.mass;
    if (body.force_W.allFinite() &&
        !((body.force_W / body.mass).cwiseAbs().maxCoeff() <= kMostMagnitude)) {
      Add(path + "force",
          fmt::format("is {:.3g} N on {:.3g} kg", body.force_W.norm(), body.mass),
          fmt::format("at most {:g} m/s² times the mass", kMostMagnitude));
    } else {
      Reach(path + "velocity", body.placed.X_WB.p_WB, body.v_WB, a_W);
    }
  }

  void Of(const Particle& particle) {
    const std::string path = fmt::format("particles.{}.", particle.name);
    AtMost(path + "position", particle.p_W, "m");
    AtMost(path + "velocity", particle.v_W, "m/s");
    InRange(path + "mass", particle.mass, "kg");
    AtMost(path + "damping", particle.damping, "1/s");
    if (particle.mass > 0)
      Reach(path + "velocity", particle.p_W, particle.v_W, world_.gravity_W);
  }

  void Of(const Cloth& cloth) {
    const std::string path = fmt::format("cloths.{}.", cloth.name);
    InRange(path + "spacing", cloth.spacing, "m");
    AtMost(path + "centre", cloth.centre, "m");
    InRange(path + "node_mass", cloth.node_mass, "kg");
    AtMost(path + "damping", cloth.damping, "1/s");
    for (const auto& [family, springs] :
         {std::pair("structural", &cloth.structural), std::pair("shear", &cloth.shear),
          std::pair("bend", &cloth.bend)}) {
      AtMost(fmt::format("{}{}.stiffness", path, family), springs->stiffness, "N/m");
      AtMost(fmt::format("{}{}.damping", path, family), springs->damping, "N s/m");
    }
    Reach(path + "centre", cloth.centre, Eigen::Vector3d::Zero(), world_.gravity_W);
  }

  void Of(const std::string& path, const Spring& spring) {
    Ends(path, spring.A, spring.B);
    AtMost(path + ".stiffness", spring.stiffness, "N/m");
    AtMost(path + ".damping", spring.damping, "N s/m");
    AtMost(path + ".rest_length", spring.rest_length, "m");
  }

  void Of(const std::string& path, const DistanceJoint& joint) {
    Ends(path, joint.A, joint.B);
    InRange(path + ".length", joint.length, "m");
  }

  void Of(const std::string& path, const Push& push) {
    AtMost(path + ".point", push.p_BoP, "m");
    const auto body = static_cast<std::size_t>(push.body);
    if (push.body < 0 || body >= world_.bodies.size()) return;
    const double mass = world_.bodies[body].mass;
    if (!(mass > 0) || !push.J_W.allFinite() ||
        (push.J_W / mass).cwiseAbs().maxCoeff() <= kMostMagnitude)
      return;
    Add(path + ".impulse",
        fmt::format("is {:.3g} N s on {:.3g} kg", push.J_W.norm(), mass),
        fmt::format("at most {:g} m/s times the mass", kMostMagnitude));
  }

  void Ends(const std::string& path, const Anchor& A, const Anchor& B) {
    AtMost(path + ".A", A.point, "m");
    AtMost(path + ".B", B.point, "m");
  }

  /** Checks what free fall from `p_W` with `v_W` at the acceleration `a_W` reaches. */
  void Reach(const std::string& where, const Eigen::Vector3d& p_W,
             const Eigen::Vector3d& v_W, const Eigen::Vector3d& a_W) {
    const double T = world_.steps * world_.dt;
    const double speed = v_W.norm() + a_W.norm() * T;
    const double place = p_W.norm() + v_W.norm() * T + a_W.norm() * T * T / 2;
    if (!std::isfinite(p_W.norm() + v_W.norm() + a_W.norm() + T) ||
        (speed <= kMostReached && place <= kMostReached))
      return;
    Add(where,
        fmt::format("and the acceleration of {:.3g} m/s² may take it to {:.3g} m in "
                    "{:.3g} s",
                    a_W.norm(), place, T),
        fmt::format("a motion within {:g} m and {:g} m/s", kMostReached, kMostReached));
  }

  /** Checks a number that is 0 or in a range. Other checks refuse negative numbers. */
  void InRange(const std::string& where, double value, std::string_view unit,
               double least = kLeastMagnitude, double most = kMostMagnitude) {
    if (!(value > 0) || !std::isfinite(value) || (value >= least && value <= most))
      return;
    Add(where, fmt::format("is {}", value),
        fmt::format("a value from {:g} to {:g} {}", least, most, unit));
  }

  void AtMost(const std::string& where, double value, std::string_view unit) {
    if (!std::isfinite(value) || std::abs(value) <= kMostMagnitude) return;
    Add(where, fmt::format("is {}", value),
        unit.empty() ? fmt::format("at most {:g}", kMostMagnitude)
                     : fmt::format("at most {:g} {}", kMostMagnitude, unit));
  }

  void AtMost(const std::string& where, const Eigen::Vector3d& v, std::string_view unit) {
    for (int i = 0; i < 3; ++i) AtMost(fmt::format("{}[{}]", where, i), v[i], unit);
  }

  void Add(std::string where, std::string what, std::string expected) {
    faults_.push_back({std::move(where), std::move(what), std::move(expected)});
  }

  const World& world_;
  std::vector<Fault> faults_;
};

}  // namespace

std::vector<Fault> FaultsOfMagnitudes(const World& world) {
  return MagnitudeCheck(world).Faults();
}

}  // namespace touchstone
