#include "reports/worlds/laws/coulomb_cone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/truth/sliding.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return Joined(FaultsOfSubjects(world, claim, {.bodies = true}),
                FaultsOfNumbers(claim, {}));
}

/** Returns how far an impulse is outside the set that a contact can apply; NaN if its
 normal part is not finite. [N s] */
double Violation(const ContactImpulse& contact, double friction, double tangential) {
  const double J_n = contact.J_B_W.dot(contact.n_AB_W);
  if (!std::isfinite(J_n)) return std::numeric_limits<double>::quiet_NaN();
  return std::max({0.0, -J_n, tangential - friction * std::max(0.0, J_n)});
}

/** Tests whether impulses follow the box cone, which bounds the larger tangential
 component instead of the tangential magnitude.

 The engine states its friction directions, as Bullet does, which turns them into the
 slip. Or they follow from the normal by one rule for a whole motion: the
 projection of one world axis. Which axis that is depends on which component of the normal
 exceeds √½, if any. At least one impulse must be beyond the circle and as large as the
 box allows. Impulses inside the box alone only show too much friction. */
class BoxCone {
 public:
  void Take(const ContactImpulse& contact, double friction, bool beyond_circle,
            double tolerance) {
    if (!contact.t_W.isZero()) {
      Take(contact, friction, beyond_circle, tolerance, StatedFrame(contact), stated_);
      if (!IsOrthonormal(contact)) stated_.fits = false;
      return;
    }
    Eigen::Index largest = 0;
    const double component = contact.n_AB_W.cwiseAbs().maxCoeff(&largest);
    auto& axes =
        axes_[component > std::sqrt(0.5) ? static_cast<std::size_t>(largest) : 3];
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto frame = TangentFrameAlong(contact.n_AB_W, static_cast<int>(i));
      if (frame)
        Take(contact, friction, beyond_circle, tolerance, *frame, axes[i]);
      else
        axes[i].fits = false;
    }
  }

  bool IsFollowed() const {
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

  /** Returns whether an impulse beyond the circle is on the boundary of the box that the
   engine states. */
  bool IsShownAsStated() const { return stated_.shows; }

  /** Returns the larger component of friction along the directions that the engine states
   for `contact`. [N s] */
  static double LargerAsStated(const ContactImpulse& contact) {
    return (StatedFrame(contact).transpose() * contact.J_B_W).cwiseAbs().maxCoeff();
  }

 private:
  /** A rule for the friction directions: one world axis, or what the engine states. */
  struct Axis {
    bool fits = true;    ///< Every impulse is inside the box.
    bool shows = false;  ///< An impulse beyond the circle is on the box's boundary.
  };

  static TangentFrame StatedFrame(const ContactImpulse& contact) {
    TangentFrame frame;
    frame << contact.t_W, contact.n_AB_W.cross(contact.t_W);
    return frame;
  }

  /** Tells whether the stated direction is a unit vector in the plane of the contact, to
   the rounding of a float. */
  static bool IsOrthonormal(const ContactImpulse& contact) {
    constexpr double kStated = 1e-5;
    return std::abs(contact.t_W.squaredNorm() - 1) <= kStated &&
           std::abs(contact.t_W.dot(contact.n_AB_W)) <= kStated;
  }

  static void Take(const ContactImpulse& contact, double friction, bool beyond_circle,
                   double tolerance, const TangentFrame& frame, Axis& axis) {
    const double bound = friction * std::max(0.0, contact.J_B_W.dot(contact.n_AB_W));
    const double larger = (frame.transpose() * contact.J_B_W).cwiseAbs().maxCoeff();
    if (!(Violation(contact, friction, larger) <= tolerance)) axis.fits = false;
    if (beyond_circle && std::abs(larger - bound) <= tolerance) axis.shows = true;
  }

  Axis stated_;  ///< For contacts with directions that the engine states.
  /** Indexed by the normal's component above √½, or 3 if there is none. */
  std::array<std::array<Axis, 3>, 4> axes_;
};

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  if (!motion.trajectory.gives_impulses) return {};
  const std::vector<int> subjects = SubjectsOf(world, claim).bodies;
  const auto is_subject = [&](int index) {
    return std::find(subjects.begin(), subjects.end(), index) != subjects.end();
  };
  const std::string because =
      "1e-5 of the impulse and of the pair's gravity impulse in a step, for the solver, "
      "and 64 roundings";
  Worst worst(MeasureKind::kConeViolation, because, Grants::kSolver);
  // An engine that shows the box it states is judged by that box.
  Worst beyond_box(MeasureKind::kConeViolation, because, Grants::kSolver);
  BoxCone box;
  for (const ContactImpulse& contact : motion.trajectory.impulses) {
    if (!is_subject(contact.A) && !is_subject(contact.B)) continue;
    const RigidBody& A = world.bodies[static_cast<std::size_t>(contact.A)];
    const RigidBody& B = world.bodies[static_cast<std::size_t>(contact.B)];
    const double friction = std::sqrt(A.friction * B.friction);
    const double J_n = contact.J_B_W.dot(contact.n_AB_W);
    const double J_t = (contact.J_B_W - J_n * contact.n_AB_W).norm();
    const double size =
        contact.J_B_W.norm() + (A.mass + B.mass) * world.gravity_W.norm() * world.dt;
    const double tolerance =
        (kSolverResidual + RoundingOf(motion.oracle, 0)) * (1 + friction) * size;
    const double violation = Violation(contact, friction, J_t);
    box.Take(contact, friction, violation > tolerance, tolerance);
    worst.Take(violation, tolerance, [&] {
      return fmt::format(
          "{} gives {} at {} in step {} J_n = {:.6g} N s and |J_t| = {:.6g} N s; μ J_n "
          "is {:.6g}",
          motion.oracle.name, B.name, A.name, contact.step, J_n, J_t, friction * J_n);
    });
    if (contact.t_W.isZero()) continue;
    const double larger = BoxCone::LargerAsStated(contact);
    beyond_box.Take(Violation(contact, friction, larger), tolerance, [&] {
      return fmt::format(
          "{} shows the {}, but gives {} at {} in step {} J_n = {:.6g} N s and {:.6g} N "
          "s "
          "along one of its directions; μ J_n is {:.6g}",
          motion.oracle.name, NameOf(FrictionCone::kBox), B.name, A.name, contact.step,
          J_n, larger, friction * J_n);
    });
  }
  if (!worst.IsTaken()) return {};
  if (box.IsShownAsStated() && beyond_box.IsBeyond()) return {beyond_box.finding()};
  return {box.IsFollowed() ? worst.RecognisedAs(NameOf(FrictionCone::kBox))
                           : worst.finding()};
}

}  // namespace

constinit const Law kCoulombCone = {
    .name = "coulomb_cone",
    .documentation =
        "Every contact pushes, and its friction is at most μ times as large.",
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
