#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "reports/text/told_apart.h"
#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/isolated_system.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/scheme_drift.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfIsolation(world, claim);
  if (!faults.empty()) return faults;
  const Subjects subjects = SubjectsOf(world, claim);
  const bool alone =
      subjects.bodies.size() + subjects.particles.size() == 1 && subjects.cloths.empty();
  for (const int i : subjects.bodies) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    if (!alone && !body.force_W.isZero(0)) {
      faults.push_back({WhereAbout(claim, body.name),
                        fmt::format("is {}, on which a force acts", body.name),
                        "no force on one of several bodies: it has a torque"});
    }
    if (IsPushed(world, i)) {
      faults.push_back(
          FaultAbout(claim, body.name, "is pushed", "a body without pushes"));
    }
  }
  const WorldState start = StateAtStart(world);
  const double L_0 =
      AngularMomentumOf(world, start, subjects, CentreOf(world, start, subjects)).norm();
  return Joined(std::move(faults),
                FaultsOfNumbers(claim, {{"expected_angular_momentum", L_0}}));
}

/** Returns the sum of the impulses that colliding bodies receive from one sample to the
 next, beyond gravity and forces: twice the sum over their contacts. [N s] */
double ImpulsesBetween(const World& world, const WorldState& from, const WorldState& to,
                       double dt, const Subjects& subjects) {
  double sum = 0;
  for (const int i : subjects.bodies) {
    const auto index = static_cast<std::size_t>(i);
    const RigidBody& body = world.bodies[index];
    // The forces of springs and joints lie along the line of their ends and conserve L.
    if (!body.collides || IsHeld(world, AnchorKind::kBody, i)) continue;
    const Eigen::Vector3d J_W =
        body.mass * (to.bodies[index].v_WB - from.bodies[index].v_WB) -
        dt * (body.mass * world.gravity_W + body.force_W);
    sum += J_W.norm();
  }
  return sum;
}

double FastestOf(const WorldState& state, const Subjects& subjects) {
  double fastest = 0;
  for (const int i : subjects.bodies)
    fastest = std::max(fastest, state.bodies[static_cast<std::size_t>(i)].v_WB.norm());
  return fastest;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  const Subjects subjects = SubjectsOf(world, claim);
  const WorldState start = StateAtStart(world);
  const Eigen::Vector3d L_0 =
      AngularMomentumOf(world, start, subjects, CentreOf(world, start, subjects));
  const Eigen::Matrix3d kept = ProjectionOf(claim);
  const AllowedMotion allowed(motion);
  const std::vector<double> gyroscopic =
      GyroscopicMomentumDrift(motion, allowed, subjects);
  const std::vector<double> rods = RodMomentumDrift(motion, allowed, subjects);
  Worst worst(
      MeasureKind::kAngularMomentumDrift,
      "1.5 × the loss of first-order schemes: h ∫ |ω × (ω × L)| of the gyroscopic term, "
      "½ h ∫ m v³/L of rods, V h J of contacts, at speeds that the truth allows and at "
      "most |L|; "
      "64 roundings per step of I_max |ω| and m |x| |v|; and Σ m |x − c| δv of "
      "velocities δv that are roundings of "
      "positions over h");
  double terms = 0;
  double size = 0;
  double levers = 0;  // Σ V h |J| of the contacts so far.
  double fastest = 0;
  for (std::size_t s = 0; s < trajectory.samples.size(); ++s) {
    const double t = trajectory.times[s];
    const WorldState& state = trajectory.samples[s];
    const Eigen::Vector3d c_W = CentreOf(world, state, subjects);
    const WorldState& slowed = allowed.At(s);
    fastest = std::max(fastest, 2 * FastestOf(slowed, subjects));
    // Positions are rounded relative to their distance from the origin.
    terms = std::max(terms, AngularMomentumSize(world, slowed, subjects, c_W));
    size = std::max(size, GreatestAngularMomentum(world, slowed, subjects, c_W) +
                              c_W.norm() * MomentumSize(world, slowed, subjects));
    if (s > 0) {
      levers += fastest * world.dt *
                ImpulsesBetween(world, allowed.At(s - 1), slowed,
                                t - trajectory.times[s - 1], subjects) /
                2;
    }
    const double rounding = RoundingOf(motion.oracle, StepsBefore(motion, s)) * size;
    // The rounding error of gravity is no impulse.
    const double contacts = levers > rounding ? levers : 0;
    const Eigen::Vector3d L = AngularMomentumOf(world, state, subjects, c_W);
    const double floor =
        NoiseOfPositions(world, state, subjects, motion.oracle.unit_roundoff)
            .angular_momentum;
    if (s == 0) continue;  // The start is that of the world, whatever the law.
    worst.Take(
        (kept * (L - L_0)).norm(),
        kSafety * std::min(gyroscopic[s] + rods[s] + contacts, terms) + rounding + floor,
        [&] {
          const ToldApart told = TellApart(L, L_0, 9);
          return Citing(
              "{} has an angular momentum of {} N m s after {:.6g} s; it started "
              "with {}",
              motion.oracle.name, told.a, CitedTime{t}, told.b);
        });
  }
  return FindingsOf({worst});
}

/** Returns whether a body that hangs on a spring or a rod may also hit another. Its
 angular momentum shows only the sum of both, so a contact has no tolerance there. */
bool MayHitOnASpring(const World& world) {
  int colliding = 0;
  bool is_held = false;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!world.bodies[i].collides) continue;
    ++colliding;
    is_held = is_held || IsHeld(world, AnchorKind::kBody, static_cast<int>(i));
  }
  return is_held && colliding > 1;
}

std::optional<Claim> Universal(const World& world) {
  if (!TouchesNothingFixed(world) || MayHitOnASpring(world)) return std::nullopt;
  return ClaimAboutAll(kConservesAngularMomentum, world);
}

constexpr std::array<std::string_view, 4> kNumbers = {"expected_angular_momentum", "x",
                                                      "y", "z"};

}  // namespace

/** The angular momentum Σ (x − c) × m v + R I Rᵀ ω of an isolated system, about its
 centre of mass c, never changes: uniform gravity has no torque about c. [N m s]

 Impulses along the line of their points, and impulses at one common point, conserve it
 for any step. The tolerance is what a first-order scheme may lose along the
 motion, at speeds that the truth allows (law_support/allowed_motion.h), × 1.5. The
 gyroscopic term loses h ∫ max(|ω̇ × L − ½ ω × (ω × L)|, ½ |ω × (ω × L)|) dt. A rod loses ½
 h ∫ m v³/L dt. A contact impulse loses V h times its size if an engine applies it to each
 body at that body's own surface, which may lie V h inside the other body. Bodies at rest
 are granted the angular momentum of NoiseOfPositions().

 About: bodies, particles and cloths that nothing else holds. Numbers: x, y, z, a
 direction along which it is conserved if the rest is not; expected_angular_momentum:
 |L(0)|. */
constinit const Law kConservesAngularMomentum = {
    .name = "conserves_angular_momentum",
    .documentation =
        "Angular momentum about the centre of mass is conserved; x, y, z: only along "
        "that "
        "direction.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
    .universal = Universal,
};

}  // namespace touchstone
