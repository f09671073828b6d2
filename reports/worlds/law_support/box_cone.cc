#include "reports/worlds/law_support/box_cone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "reports/worlds/law_support/error_laws.h"

namespace touchstone {
namespace {

TangentFrame StatedFrame(const ContactImpulse& contact) {
  TangentFrame frame;
  frame << contact.t_W, contact.n_AB_W.cross(contact.t_W);
  return frame;
}

/** Tells whether the stated direction is a unit vector in the plane of the contact, to
 the rounding of a float. */
bool IsOrthonormal(const ContactImpulse& contact) {
  constexpr double kStated = 1e-5;
  return std::abs(contact.t_W.squaredNorm() - 1) <= kStated &&
         std::abs(contact.t_W.dot(contact.n_AB_W)) <= kStated;
}

const RigidBody& BodyOf(const World& world, int index) {
  return world.bodies[static_cast<std::size_t>(index)];
}

/** Returns whether two contacts belong to one patch of one step. */
bool HaveOnePatch(const ContactImpulse& a, const ContactImpulse& b) {
  constexpr double kParallel = 1e-6;
  return a.step == b.step && a.A == b.A && a.B == b.B &&
         (a.n_AB_W - b.n_AB_W).norm() <= kParallel;
}

}  // namespace

double ViolationOf(const ContactImpulse& contact, double friction, double tangential) {
  const double J_n = contact.J_B_W.dot(contact.n_AB_W);
  if (!std::isfinite(J_n)) return std::numeric_limits<double>::quiet_NaN();
  return std::max({0.0, -J_n, tangential - friction * std::max(0.0, J_n)});
}

double ConeToleranceOf(const Motion& motion, const ContactImpulse& contact) {
  const World& world = motion.world;
  const double mass = BodyOf(world, contact.A).mass + BodyOf(world, contact.B).mass;
  const double size = contact.J_B_W.norm() + mass * world.gravity_W.norm() * world.dt;
  return (kSolverResidual + RoundingOf(motion.oracle, 0)) *
         (1 + FrictionOf(world, contact)) * size;
}

double FrictionOf(const World& world, const ContactImpulse& contact) {
  return std::sqrt(BodyOf(world, contact.A).friction * BodyOf(world, contact.B).friction);
}

void BoxCone::Take(const ContactImpulse& contact, double friction, bool beyond_circle,
                   double tolerance) {
  if (!contact.t_W.isZero()) {
    Take(contact, friction, beyond_circle, tolerance, StatedFrame(contact), stated_);
    if (!IsOrthonormal(contact)) stated_.fits = false;
    return;
  }
  Eigen::Index largest = 0;
  const double component = contact.n_AB_W.cwiseAbs().maxCoeff(&largest);
  auto& axes = axes_[component > std::sqrt(0.5) ? static_cast<std::size_t>(largest) : 3];
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::optional<TangentFrame> frame =
        TangentFrameAlong(contact.n_AB_W, static_cast<int>(i));
    if (frame)
      Take(contact, friction, beyond_circle, tolerance, *frame, axes[i]);
    else
      axes[i].fits = false;
  }
}

bool BoxCone::IsFollowed() const {
  if (!stated_.fits) return false;
  bool shows = stated_.shows;
  for (const auto& axes : axes_) {
    const auto fits = [](const Axis& axis) { return axis.fits; };
    if (std::none_of(axes.begin(), axes.end(), fits)) return false;
    shows = shows || std::any_of(axes.begin(), axes.end(), [](const Axis& axis) {
              return axis.fits && axis.shows;
            });
  }
  return shows;
}

double BoxCone::LargerAsStated(const ContactImpulse& contact) {
  return (StatedFrame(contact).transpose() * contact.J_B_W).cwiseAbs().maxCoeff();
}

void BoxCone::Take(const ContactImpulse& contact, double friction, bool beyond_circle,
                   double tolerance, const TangentFrame& frame, Axis& axis) {
  const double bound = friction * std::max(0.0, contact.J_B_W.dot(contact.n_AB_W));
  const double larger = (frame.transpose() * contact.J_B_W).cwiseAbs().maxCoeff();
  if (!(ViolationOf(contact, friction, larger) <= tolerance)) axis.fits = false;
  if (beyond_circle && std::abs(larger - bound) <= tolerance) axis.shows = true;
}

bool FollowsBoxCone(const Motion& motion) {
  BoxCone box;
  const auto take = [&](const ContactImpulse& patch) {
    const double friction = FrictionOf(motion.world, patch);
    const double tolerance = ConeToleranceOf(motion, patch);
    const double J_n = patch.J_B_W.dot(patch.n_AB_W);
    const double J_t = (patch.J_B_W - J_n * patch.n_AB_W).norm();
    box.Take(patch, friction, ViolationOf(patch, friction, J_t) > tolerance, tolerance);
  };
  std::optional<ContactImpulse> patch;
  for (const ContactImpulse& contact : motion.trajectory.impulses) {
    if (patch && HaveOnePatch(*patch, contact)) {
      patch->J_B_W += contact.J_B_W;
      continue;
    }
    if (patch) take(*patch);
    patch = contact;
    // Directions that an engine turns into the slip are not fixed in the world.
    if (!contact.t_W.isZero()) return false;
  }
  if (patch) take(*patch);
  return box.IsFollowed();
}

}  // namespace touchstone
