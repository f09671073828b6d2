#include "engine/printed/particle_motion.h"

#include <cmath>
#include <optional>

namespace cookbook::printed {
namespace {

/** The height above the surface at which a particle is put. [m] */
constexpr double kAbove = 0.003;

/** The step that the decay of velocity under E-19 assumes. [s] */
constexpr double kNominalStep = 1.0 / 60;

/** The point where a path enters a box. World frame. */
struct Hit {
  double share;  ///< Fraction of the path, in [0, 1].
  Eigen::Vector3d n_W;
};

/** Returns where the path enters a box, or nothing if it starts inside. Slab method: Kay
 & Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986. */
std::optional<Hit> Enter(const Body& body, const Eigen::Vector3d& from_W,
                         const Eigen::Vector3d& to_W) {
  const auto* box = std::get_if<Box>(&body.shape);
  if (!box) return std::nullopt;
  const Eigen::Matrix3d R_BW = body.q_WB.toRotationMatrix().transpose();
  const Eigen::Vector3d from = R_BW * (from_W - body.p_WB);
  const Eigen::Vector3d way = R_BW * (to_W - from_W);
  double entered = -HUGE_VAL;
  double left = HUGE_VAL;
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double half = box->half_extents[axis];
    if (way[axis] == 0) {
      if (std::abs(from[axis]) > half) return std::nullopt;
      continue;
    }
    const double side = way[axis] > 0 ? -1 : 1;
    const double in = (side * half - from[axis]) / way[axis];
    if (in > entered) {
      entered = in;
      n = side * Eigen::Vector3d::Unit(axis);
    }
    left = std::min(left, (-side * half - from[axis]) / way[axis]);
  }
  if (entered < 0 || entered > 1 || entered > left) return std::nullopt;
  return Hit{entered, R_BW.transpose() * n};
}

}  // namespace

void Integrate(Particle& particle, const Eigen::Vector3d& gravity_W, double dt,
               const Errata& errata) {
  particle.p_previous = particle.p_W;
  if (particle.mass == 0) return;
  const double decay_time = errata.Has(Erratum::kE19) ? kNominalStep : dt;
  particle.v_W = std::exp(-particle.damping * decay_time) * particle.v_W + dt * gravity_W;
  particle.p_W += dt * particle.v_W;
}

void KeepOutside(Particle& particle, std::span<const Body> bodies) {
  std::optional<Hit> first;
  for (const Body& body : bodies) {
    if (body.mass != 0 || !body.collides) continue;
    const std::optional<Hit> hit = Enter(body, particle.p_previous, particle.p_W);
    if (hit && (!first || hit->share < first->share)) first = hit;
  }
  if (!first) return;
  const Eigen::Vector3d way = particle.p_W - particle.p_previous;
  particle.p_W = particle.p_previous + first->share * way + kAbove * first->n_W;
  const Eigen::Vector3d v_n = particle.v_W.dot(first->n_W) * first->n_W;
  particle.v_W += -v_n - particle.bounce * v_n;
}

}  // namespace cookbook::printed
