#include "engine/printed/world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/printed/body_motion.h"
#include "engine/printed/contact_pairs.h"
#include "engine/printed/links.h"
#include "engine/printed/particle_motion.h"

namespace cookbook::printed {
namespace {

void Require(bool holds, const char* otherwise) {
  if (!holds) throw std::invalid_argument(otherwise);
}

bool IsAmount(double x) {
  return std::isfinite(x) && x >= 0;
}

/** Returns the Euler angles of `q` for E-15: R = R_z R_y R_x. [rad] */
Eigen::Vector3d AnglesOf(const Eigen::Quaterniond& q) {
  const Eigen::Matrix3d R = q.toRotationMatrix();
  return {std::atan2(R(2, 1), R(2, 2)), std::asin(std::clamp(-R(2, 0), -1.0, 1.0)),
          std::atan2(R(1, 0), R(0, 0))};
}

bool AreSame(const Anchor& a, const Anchor& b) {
  return a.on == b.on && a.index == b.index && a.point == b.point;
}

template <typename T>
int Last(const std::vector<T>& things) {
  return static_cast<int>(things.size()) - 1;
}

Anchor NodeOf(int first, const Cloth& cloth, int row, int column) {
  return {Anchor::On::kParticle, first + row * cloth.n + column, Eigen::Vector3d::Zero()};
}

}  // namespace

int World::Add(const Body& body) {
  Require(IsAmount(body.mass), "the mass of a body is a finite number, not negative");
  Require(body.p_WB.allFinite() && body.v_WB.allFinite() && body.w_WB.allFinite() &&
              body.q_WB.coeffs().allFinite() && body.force_W.allFinite(),
          "the state of a body is finite");
  Body& added = bodies_.emplace_back(body);
  if (added.inertia.isZero(0)) added.inertia = SolidInertia(added);
  added.angles = AnglesOf(added.q_WB);
  return Last(bodies_);
}

int World::Add(const Particle& particle) {
  Require(IsAmount(particle.mass) && IsAmount(particle.damping),
          "the mass and the damping of a particle are finite numbers, not negative");
  Require(particle.p_W.allFinite() && particle.v_W.allFinite(),
          "the state of a particle is finite");
  particles_.push_back(particle);
  particles_.back().p_previous = particle.p_W;
  return Last(particles_);
}

int World::Add(const Spring& spring) {
  Require(IsAmount(spring.stiffness) && IsAmount(spring.damping) &&
              IsAmount(spring.rest_length),
          "the constants of a spring are finite numbers, not negative");
  Require(!AreSame(spring.A, spring.B), "a spring joins two ends");
  springs_.push_back(spring);
  return Last(springs_);
}

int World::Add(const DistanceJoint& joint) {
  Require(std::isfinite(joint.length) && joint.length > 0,
          "the length of a joint is a finite number > 0");
  Require(!AreSame(joint.A, joint.B), "a joint joins two ends");
  joints_.push_back(joint);
  return Last(joints_);
}

int World::Add(const Cloth& cloth) {
  if (cloth.n < 3 && errata_.Has(Erratum::kE21))
    throw std::out_of_range("the recipe writes past the end of the cloth's particles");
  Require(cloth.n >= 3, "a cloth has at least 3 x 3 particles");
  Require(std::isfinite(cloth.spacing) && cloth.spacing > 0,
          "the spacing of a cloth is a finite number > 0");
  const int first = Last(particles_) + 1;
  Eigen::Vector3d centre = cloth.centre;
  if (errata_.Has(Erratum::kE20)) {
    centre.x() *= cloth.spacing;
    centre.z() *= cloth.spacing;
  }
  const double middle = 0.5 * (cloth.n - 1);
  for (int row = 0; row < cloth.n; ++row) {
    for (int column = 0; column < cloth.n; ++column) {
      Particle node;
      node.mass = cloth.node_mass;
      node.damping = cloth.damping;
      node.bounce = cloth.bounce;
      node.p_W =
          centre + cloth.spacing * Eigen::Vector3d(column - middle, 0, row - middle);
      Add(node);
    }
  }
  for (const auto& [row, column] : cloth.pinned) {
    const int node = first + row * cloth.n + column;
    particles_[static_cast<std::size_t>(node)].mass = 0;
  }
  const auto join = [&](const ClothSprings& family, int rows, int columns) {
    for (int row = 0; row + rows < cloth.n; ++row) {
      for (int column = std::max(0, -columns); column + std::max(0, columns) < cloth.n;
           ++column) {
        Spring spring{NodeOf(first, cloth, row, column),
                      NodeOf(first, cloth, row + rows, column + columns),
                      family.stiffness, family.damping, 0};
        spring.rest_length = cloth.spacing * std::hypot(rows, columns);
        Add(spring);
      }
    }
  };
  join(cloth.structural, 0, 1);
  join(cloth.structural, 1, 0);
  join(cloth.shear, 1, 1);
  join(cloth.shear, 1, -1);
  join(cloth.bend, 0, 2);
  join(cloth.bend, 2, 0);
  return first;
}

void World::ApplyImpulse(int body, const Eigen::Vector3d& p_W,
                         const Eigen::Vector3d& J_W) {
  Body& hit = bodies_[static_cast<std::size_t>(body)];
  if (hit.mass == 0) return;
  Give(hit, p_W, J_W, errata_);
  if (errata_.Has(Erratum::kE10)) hit.v_WB += (1 - 1 / hit.mass) * J_W;
}

void World::Step(double dt) {
  const std::vector<ContactPair> pairs = TouchingPairs(bodies_, errata_);
  impulses_ = ApplyImpulses(bodies_, pairs, settings_.impulse_iterations, errata_);
  for (Body& body : bodies_) Integrate(body, settings_.gravity_W, dt, errata_);
  for (Particle& particle : particles_)
    Integrate(particle, settings_.gravity_W, dt, errata_);
  Project(bodies_, pairs, settings_.position_correction_fraction,
          settings_.penetration_slop, errata_);
  const Things things{bodies_, particles_};
  for (const Spring& spring : springs_) Pull(spring, things, dt, errata_);
  for (Particle& particle : particles_) KeepOutside(particle, bodies_);
  for (const DistanceJoint& joint : joints_) Satisfy(joint, things, errata_);
}

}  // namespace cookbook::printed
