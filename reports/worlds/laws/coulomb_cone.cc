#include "reports/worlds/laws/coulomb_cone.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "reports/worlds/laws/contact_history.h"
#include "reports/worlds/laws/error_laws.h"
#include "reports/worlds/laws/numbers.h"
#include "reports/worlds/laws/subjects.h"
#include "reports/worlds/laws/worst.h"
#include "reports/worlds/truth/sliding.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return Joined(FaultsOfSubjects(world, claim, {true, false, false}),
                FaultsOfNumbers(claim, {}));
}

/** How far an impulse is outside of what a contact can give. [N s] */
double Violation(const ContactImpulse& contact, double friction, double tangential) {
  const double J_n = contact.J_B_W.dot(contact.n_AB_W);
  return std::max({0.0, -J_n, tangential - friction * std::max(0.0, J_n)});
}

/** The least violation of the box cone in any of the frames that follow from the normal:
 its larger component in place of its size. */
double ViolationOfBox(const ContactImpulse& contact, double friction) {
  double least = std::numeric_limits<double>::infinity();
  for (const TangentFrame& frame : TangentFramesOf(contact.n_AB_W)) {
    const double larger = (frame.transpose() * contact.J_B_W).cwiseAbs().maxCoeff();
    least = std::min(least, Violation(contact, friction, larger));
  }
  return least;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  if (!motion.trajectory.gives_impulses) return {};
  const std::vector<int> subjects = SubjectsOf(world, claim).bodies;
  const auto is_subject = [&](int index) {
    return std::find(subjects.begin(), subjects.end(), index) != subjects.end();
  };
  Worst worst(MeasureKind::kConeViolation,
              "1e-5 of the impulse and of what gravity gives the pair in a step, for the "
              "solver, and 64 roundings");
  bool in_box = true;
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
    in_box = in_box &&
             (violation <= tolerance || ViolationOfBox(contact, friction) <= tolerance);
    worst.Take(violation, tolerance, [&] {
      return fmt::format(
          "{} gives {} at {} in step {} J_n = {:.6g} N s and |J_t| = {:.6g} N s; μ J_n "
          "is {:.6g}",
          motion.oracle.name, B.name, A.name, contact.step, J_n, J_t, friction * J_n);
    });
  }
  if (!worst.IsTaken()) return {};
  return {in_box ? worst.RecognisedAs(NameOf(FrictionCone::kBox)) : worst.finding()};
}

}  // namespace

constinit const Law kCoulombCone = {
    "coulomb_cone", "Every contact pushes, and its friction is at most μ times as large.",
    Faults, Judge};

}  // namespace touchstone
