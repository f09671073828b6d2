#include "reports/worlds/truth/mechanics.h"

#include <algorithm>
#include <cmath>

namespace touchstone {
namespace {

/** One body, particle or node as a mass. */
struct Mass {
  double mass;
  PointState at;
  Eigen::Vector3d spin_W = Eigen::Vector3d::Zero();  ///< R I Rᵀ ω. [N m s]
  double spin_energy = 0;                            ///< ½ ω·R I Rᵀ ω. [J]
  double greatest_spin = 0;                          ///< I_max |ω|. [N m s]
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
};

template <typename Visit>
void ForEachMass(const World& world, const WorldState& state, const Subjects& subjects,
                 const Visit& visit) {
  for (const int i : subjects.bodies) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    const BodyState& at = state.bodies[static_cast<std::size_t>(i)];
    // Along the axes of the body: the matrix R I Rᵀ has roundings of I_max, which are no
    // energy of a spin about the axis of I_min.
    const Eigen::Quaterniond q_WB = at.q_WB.normalized();
    const Eigen::Vector3d w_B = q_WB.conjugate() * at.w_WB;
    const Eigen::Vector3d inertia = InertiaOf(body);
    const Eigen::Vector3d spin_B = inertia.cwiseProduct(w_B);
    visit(Mass{body.mass,
               {at.p_WB, at.v_WB},
               q_WB * spin_B,
               w_B.dot(spin_B) / 2,
               inertia.maxCoeff() * at.w_WB.norm(),
               body.force_W});
  }
  for (const int i : subjects.particles) {
    visit(Mass{world.particles[static_cast<std::size_t>(i)].mass,
               state.particles[static_cast<std::size_t>(i)]});
  }
  for (const int i : subjects.cloths) {
    const Cloth& cloth = world.cloths[static_cast<std::size_t>(i)];
    const auto first = static_cast<std::size_t>(FirstNodeOf(world, i));
    for (int node = 0; node < cloth.n * cloth.n; ++node) {
      if (IsPinned(cloth, node)) continue;
      visit(Mass{cloth.node_mass, state.nodes[first + static_cast<std::size_t>(node)]});
    }
  }
}

void AddSpring(const PointState& A, const PointState& B, double stiffness,
               double rest_length, Energy& energy) {
  const Eigen::Vector3d p_AB = B.p_W - A.p_W;
  const double length = p_AB.norm();
  const double stretch = length - rest_length;
  energy.potential += stiffness * stretch * stretch / 2;
  energy.size += stiffness * (length * length + rest_length * rest_length) / 2;
  if (length > 0) energy.power += stiffness * stretch * p_AB.dot(B.v_W - A.v_W) / length;
}

}  // namespace

Eigen::Matrix3d InertiaInWorld(const RigidBody& body, const Eigen::Quaterniond& q_WB) {
  const Eigen::Matrix3d R_WB = q_WB.toRotationMatrix();
  return R_WB * InertiaOf(body).asDiagonal() * R_WB.transpose();
}

Eigen::Vector3d AccelerationOf(const World& world, const RigidBody& body) {
  return world.gravity_W + body.force_W / body.mass;
}

WorldState StateAtStart(const World& world) {
  WorldState state;
  for (const RigidBody& body : world.bodies) {
    const Pose& pose = body.placed.X_WB;
    state.bodies.push_back({pose.p_WB,
                            pose.q_WB ? *pose.q_WB : Eigen::Quaterniond(pose.R_WB),
                            body.v_WB, body.w_WB});
  }
  for (const Particle& particle : world.particles)
    state.particles.push_back({particle.p_W, particle.v_W});
  for (const Cloth& cloth : world.cloths) {
    for (int row = 0; row < cloth.n; ++row) {
      for (int column = 0; column < cloth.n; ++column) {
        state.nodes.push_back({NodeAtStart(cloth, row, column), Eigen::Vector3d::Zero()});
      }
    }
  }
  return state;
}

double MassOf(const World& world, const Subjects& subjects) {
  double sum = 0;
  ForEachMass(world, StateAtStart(world), subjects,
              [&](const Mass& mass) { sum += mass.mass; });
  return sum;
}

double SquaredLoadsOf(const World& world, const Subjects& subjects) {
  double sum = 0;
  ForEachMass(world, StateAtStart(world), subjects, [&](const Mass& mass) {
    sum += mass.mass * (world.gravity_W + mass.force_W / mass.mass).squaredNorm();
  });
  return sum;
}

MotionOfNoise NoiseOfPositions(const World& world, const WorldState& state,
                               const Subjects& subjects, double share) {
  MotionOfNoise noise;
  const Eigen::Vector3d c_W = CentreOf(world, state, subjects);
  ForEachMass(world, state, subjects, [&](const Mass& mass) {
    const double off = share * mass.at.p_W.norm() / world.dt;
    noise.angular_momentum += mass.mass * (mass.at.p_W - c_W).norm() * off;
    noise.momentum += mass.mass * off;
    noise.energy += mass.mass * off * off / 2;
  });
  return noise;
}

Eigen::Vector3d MomentumOf(const World& world, const WorldState& state,
                           const Subjects& subjects) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  ForEachMass(world, state, subjects,
              [&](const Mass& mass) { sum += mass.mass * mass.at.v_W; });
  return sum;
}

double MomentumSize(const World& world, const WorldState& state,
                    const Subjects& subjects) {
  double sum = 0;
  ForEachMass(world, state, subjects,
              [&](const Mass& mass) { sum += mass.mass * mass.at.v_W.norm(); });
  return sum;
}

Eigen::Vector3d CentreOf(const World& world, const WorldState& state,
                         const Subjects& subjects) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0;
  ForEachMass(world, state, subjects, [&](const Mass& mass) {
    sum += mass.mass * mass.at.p_W;
    total += mass.mass;
  });
  return sum / total;
}

Eigen::Vector3d AngularMomentumOf(const World& world, const WorldState& state,
                                  const Subjects& subjects, const Eigen::Vector3d& c_W) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  ForEachMass(world, state, subjects, [&](const Mass& mass) {
    sum += (mass.at.p_W - c_W).cross(mass.mass * mass.at.v_W) + mass.spin_W;
  });
  return sum;
}

double AngularMomentumSize(const World& world, const WorldState& state,
                           const Subjects& subjects, const Eigen::Vector3d& c_W) {
  double sum = 0;
  ForEachMass(world, state, subjects, [&](const Mass& mass) {
    sum +=
        (mass.at.p_W - c_W).norm() * mass.mass * mass.at.v_W.norm() + mass.spin_W.norm();
  });
  return sum;
}

double GreatestAngularMomentum(const World& world, const WorldState& state,
                               const Subjects& subjects, const Eigen::Vector3d& c_W) {
  double sum = 0;
  ForEachMass(world, state, subjects, [&](const Mass& mass) {
    sum +=
        (mass.at.p_W - c_W).norm() * mass.mass * mass.at.v_W.norm() + mass.greatest_spin;
  });
  return sum;
}

Energy EnergyOf(const World& world, const WorldState& state, const Subjects& subjects) {
  Energy energy;
  ForEachMass(world, state, subjects, [&](const Mass& mass) {
    const Eigen::Vector3d force_W = mass.mass * world.gravity_W + mass.force_W;
    energy.kinetic += mass.mass * mass.at.v_W.squaredNorm() / 2 + mass.spin_energy;
    energy.potential -= force_W.dot(mass.at.p_W);
    energy.power -= force_W.dot(mass.at.v_W);
    energy.size += force_W.norm() * mass.at.p_W.norm();
  });
  energy.size += energy.kinetic;
  for (const Spring& spring : world.springs) {
    if (!Has(subjects, spring.A) && !Has(subjects, spring.B)) continue;
    AddSpring(StateOf(world, state, spring.A), StateOf(world, state, spring.B),
              spring.stiffness, spring.rest_length, energy);
  }
  for (const int i : subjects.cloths) {
    const Cloth& cloth = world.cloths[static_cast<std::size_t>(i)];
    const auto first = static_cast<std::size_t>(FirstNodeOf(world, i));
    for (const ClothSpring& spring : SpringsOf(cloth)) {
      AddSpring(state.nodes[first + static_cast<std::size_t>(spring.a)],
                state.nodes[first + static_cast<std::size_t>(spring.b)], spring.stiffness,
                spring.rest_length, energy);
    }
  }
  return energy;
}

PointState StateOf(const World&, const WorldState& state, const Anchor& anchor) {
  switch (anchor.on) {
    case AnchorKind::kBody: {
      const BodyState& body = state.bodies[static_cast<std::size_t>(anchor.index)];
      const Eigen::Vector3d r_W = body.q_WB * anchor.point;
      return {body.p_WB + r_W, body.v_WB + body.w_WB.cross(r_W)};
    }
    case AnchorKind::kParticle:
      return state.particles[static_cast<std::size_t>(anchor.index)];
    case AnchorKind::kWorld:
      break;
  }
  return {anchor.point, Eigen::Vector3d::Zero()};
}

std::vector<ClothSpring> SpringsOf(const Cloth& cloth) {
  std::vector<ClothSpring> springs;
  const auto join = [&](int row, int column, int d_row, int d_column,
                        const ClothSprings& family) {
    const int to_row = row + d_row;
    const int to_column = column + d_column;
    if (to_row >= cloth.n || to_column >= cloth.n || to_column < 0) return;
    springs.push_back({row * cloth.n + column, to_row * cloth.n + to_column,
                       family.stiffness, family.damping,
                       cloth.spacing * std::hypot(d_row, d_column)});
  };
  for (int row = 0; row < cloth.n; ++row) {
    for (int column = 0; column < cloth.n; ++column) {
      join(row, column, 0, 1, cloth.structural);
      join(row, column, 1, 0, cloth.structural);
      join(row, column, 1, 1, cloth.shear);
      join(row, column, 1, -1, cloth.shear);
      join(row, column, 0, 2, cloth.bend);
      join(row, column, 2, 0, cloth.bend);
    }
  }
  return springs;
}

Eigen::Vector3d NodeAtStart(const Cloth& cloth, int row, int column) {
  const double middle = (cloth.n - 1) / 2.0;
  return cloth.centre + cloth.spacing * Eigen::Vector3d(column - middle, 0, row - middle);
}

bool IsPinned(const Cloth& cloth, int node) {
  const std::pair<int, int> at{node / cloth.n, node % cloth.n};
  return std::find(cloth.pinned.begin(), cloth.pinned.end(), at) != cloth.pinned.end();
}

}  // namespace touchstone
