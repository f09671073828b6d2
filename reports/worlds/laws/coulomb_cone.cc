#include <algorithm>
#include <cmath>
#include <string>

#include "reports/worlds/law_support/box_cone.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/sliding.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  return Joined(FaultsOfSubjects(world, claim, {.bodies = true}),
                FaultsOfNumbers(claim, {}));
}

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
    const double friction = FrictionOf(world, contact);
    const double J_n = contact.J_B_W.dot(contact.n_AB_W);
    const double J_t = (contact.J_B_W - J_n * contact.n_AB_W).norm();
    const double tolerance = ConeToleranceOf(motion, contact);
    const double violation = ViolationOf(contact, friction, J_t);
    box.Take(contact, friction, violation > tolerance, tolerance);
    worst.Take(violation, tolerance, [&] {
      return Citing(
          "{} gives {} at {} in step {}, up to {:.6g} s, J_n = {:.6g} N s and "
          "|J_t| = {:.6g} N s; μ J_n is {:.6g}",
          motion.oracle.name, CitedName{B.name}, CitedName{A.name}, contact.step,
          CitedTime{contact.step * world.dt}, J_n, J_t, friction * J_n);
    });
    if (contact.t_W.isZero()) continue;
    const double larger = BoxCone::LargerAsStated(contact);
    beyond_box.Take(ViolationOf(contact, friction, larger), tolerance, [&] {
      return Citing(
          "{} shows the {}, but gives {} at {} in step {}, up to {:.6g} s, "
          "J_n = {:.6g} N s and {:.6g} N s along one of its directions; μ J_n is {:.6g}",
          motion.oracle.name, NameOf(FrictionCone::kBox), CitedName{B.name},
          CitedName{A.name}, contact.step, CitedTime{contact.step * world.dt}, J_n,
          larger, friction * J_n);
    });
  }
  if (!worst.IsTaken()) return {};
  if (box.IsShownAsStated() && beyond_box.IsBeyond()) return {beyond_box.finding()};
  return {box.IsFollowed() ? worst.RecognisedAs(NameOf(FrictionCone::kBox))
                           : worst.finding()};
}

}  // namespace

/** Every contact pushes, and its friction stays in Coulomb's cone: J_n >= 0, |J_t| <= μ
 J_n, μ = √(μ_A μ_B). [N s]

 The value is the larger of |J_t| − μ J_n and −J_n. The tolerance is 1e-5 of the contact
 impulse and of the pair's gravity impulse in a step, for the solver, and 64 roundings. An
 engine whose friction has two directions may leave the circle and stay within the box of
 its axes, each |J_i| at most μ J_n; that is recognised. A diamond lies within the circle.

 Judges only engines that report contact impulses. About: bodies and all their contacts.
 Numbers: none. */
constinit const Law kCoulombCone = {
    .name = "coulomb_cone",
    .documentation =
        "Every contact pushes, and its friction is at most μ times as large.",
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
