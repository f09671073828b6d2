#include "tests/scenarios/same_bits.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace touchstone {
namespace {

bool Same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

template <class Derived>
bool Same(const Eigen::MatrixBase<Derived>& a, const Eigen::MatrixBase<Derived>& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    if (!Same(a(i % a.rows(), i / a.rows()), b(i % a.rows(), i / a.rows()))) return false;
  }
  return true;
}

bool Same(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const Eigen::Vector3d& v, const Eigen::Vector3d& w) { return Same(v, w); });
}

struct SameShape {
  bool operator()(const Sphere& a, const Sphere& b) const {
    return Same(a.radius, b.radius);
  }
  bool operator()(const Box& a, const Box& b) const {
    return Same(a.half_extents, b.half_extents);
  }
  bool operator()(const Capsule& a, const Capsule& b) const {
    return Same(a.radius, b.radius) && Same(a.half_length, b.half_length);
  }
  bool operator()(const Cylinder& a, const Cylinder& b) const {
    return Same(a.radius, b.radius) && Same(a.half_length, b.half_length);
  }
  bool operator()(const Cone& a, const Cone& b) const {
    return Same(a.radius, b.radius) && Same(a.half_height, b.half_height);
  }
  bool operator()(const ConvexHull& a, const ConvexHull& b) const {
    return Same(a.vertices, b.vertices);
  }
  bool operator()(const HalfSpace&, const HalfSpace&) const { return true; }
  template <class A, class B>
  bool operator()(const A&, const B&) const {
    return false;
  }
};

bool Same(const Body& a, const Body& b) {
  const std::optional<Eigen::Quaterniond>& q = a.X_WB.q_WB;
  const std::optional<Eigen::Quaterniond>& r = b.X_WB.q_WB;
  return std::visit(SameShape{}, a.shape, b.shape) && Same(a.X_WB.p_WB, b.X_WB.p_WB) &&
         Same(a.X_WB.R_WB, b.X_WB.R_WB) && q.has_value() == r.has_value() &&
         (!q || Same(q->coeffs(), r->coeffs()));
}

bool Same(const ContactExpectation& a, const ContactExpectation& b) {
  return a.touching == b.touching &&
         a.separation.has_value() == b.separation.has_value() &&
         (!a.separation || Same(*a.separation, *b.separation)) &&
         Same(a.normals, b.normals) && a.contacts == b.contacts;
}

bool Same(const std::optional<ToleranceOverride>& a,
          const std::optional<ToleranceOverride>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return Same(a->separation, b->separation) && a->because == b->because;
}

bool Same(const std::vector<Indictment>& a, const std::vector<Indictment>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Indictment& i, const Indictment& j) {
                      return i.oracle == j.oracle && i.measures == j.measures &&
                             i.anomaly == j.anomaly && i.reproduces == j.reproduces;
                    });
}

template <class Part, class Same>
bool AllSame(const std::vector<Part>& a, const std::vector<Part>& b, const Same& same) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

bool Same(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || Same(*a, *b));
}

bool SameBody(const RigidBody& a, const RigidBody& b) {
  return a.name == b.name && Same(a.placed, b.placed) && Same(a.mass, b.mass) &&
         a.inertia.has_value() == b.inertia.has_value() &&
         (!a.inertia || Same(*a.inertia, *b.inertia)) && Same(a.v_WB, b.v_WB) &&
         Same(a.w_WB, b.w_WB) && Same(a.restitution, b.restitution) &&
         Same(a.friction, b.friction) && Same(a.force_W, b.force_W) &&
         a.collides == b.collides;
}

bool SameParticle(const Particle& a, const Particle& b) {
  return a.name == b.name && Same(a.p_W, b.p_W) && Same(a.v_W, b.v_W) &&
         Same(a.mass, b.mass) && Same(a.damping, b.damping) && Same(a.bounce, b.bounce);
}

bool Same(const Anchor& a, const Anchor& b) {
  return a.on == b.on && a.index == b.index && Same(a.point, b.point);
}

bool SameSpring(const Spring& a, const Spring& b) {
  return Same(a.A, b.A) && Same(a.B, b.B) && Same(a.stiffness, b.stiffness) &&
         Same(a.damping, b.damping) && Same(a.rest_length, b.rest_length);
}

bool SameJoint(const DistanceJoint& a, const DistanceJoint& b) {
  return Same(a.A, b.A) && Same(a.B, b.B) && Same(a.length, b.length);
}

bool Same(const ClothSprings& a, const ClothSprings& b) {
  return Same(a.stiffness, b.stiffness) && Same(a.damping, b.damping);
}

bool SameCloth(const Cloth& a, const Cloth& b) {
  return a.name == b.name && a.n == b.n && Same(a.spacing, b.spacing) &&
         Same(a.centre, b.centre) && Same(a.node_mass, b.node_mass) &&
         Same(a.damping, b.damping) && Same(a.bounce, b.bounce) &&
         Same(a.structural, b.structural) && Same(a.shear, b.shear) &&
         Same(a.bend, b.bend) && a.pinned == b.pinned;
}

bool SamePush(const Push& a, const Push& b) {
  return a.body == b.body && Same(a.time, b.time) && Same(a.p_BoP, b.p_BoP) &&
         Same(a.J_W, b.J_W);
}

bool SameClaim(const Claim& a, const Claim& b) {
  return a.law == b.law && a.about == b.about && a.because == b.because &&
         std::equal(a.numbers.begin(), a.numbers.end(), b.numbers.begin(),
                    b.numbers.end(), [](const auto& x, const auto& y) {
                      return x.first == y.first && Same(x.second, y.second);
                    });
}

bool Same(const World& a, const World& b) {
  return AllSame(a.bodies, b.bodies, SameBody) &&
         AllSame(a.particles, b.particles, SameParticle) &&
         AllSame(a.springs, b.springs, SameSpring) &&
         AllSame(a.joints, b.joints, SameJoint) &&
         AllSame(a.cloths, b.cloths, SameCloth) &&
         AllSame(a.pushes, b.pushes, SamePush) && Same(a.gravity_W, b.gravity_W) &&
         Same(a.dt, b.dt) && a.steps == b.steps && a.sample_every == b.sample_every;
}

bool Same(const std::optional<Ensemble>& a, const std::optional<Ensemble>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->members == b->members && Same(a->jitter, b->jitter) && a->seed == b->seed;
}

}  // namespace

bool SameBits(const ContactQuery& a, const ContactQuery& b) {
  return Same(a.A, b.A) && Same(a.B, b.B);
}

bool SameBits(const Scenario& a, const Scenario& b) {
  return a.id == b.id && a.title == b.title && a.source == b.source &&
         a.name_A == b.name_A && a.name_B == b.name_B && SameBits(a.contact, b.contact) &&
         Same(a.expect, b.expect) && Same(a.tolerance, b.tolerance) &&
         Same(a.indicts, b.indicts);
}

bool SameBits(const WorldScenario& a, const WorldScenario& b) {
  return a.id == b.id && a.title == b.title && a.source == b.source &&
         Same(a.world, b.world) && AllSame(a.claims, b.claims, SameClaim) &&
         Same(a.horizon, b.horizon) && Same(a.ensemble, b.ensemble) &&
         Same(a.indicts, b.indicts);
}

}  // namespace touchstone
