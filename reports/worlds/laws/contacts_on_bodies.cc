#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/allowed_motion.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/contact_history.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/overlap.h"
#include "reports/worlds/law_support/placed_contact.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/law_support/surface_line.h"
#include "reports/worlds/law_support/universal.h"
#include "reports/worlds/law_support/worst.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  for (const int i : SubjectsOf(world, claim).bodies) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    if (!HasChords(body.placed.shape))
      faults.push_back(FaultAbout(claim, body.name, "is neither a sphere nor a box",
                                  "a sphere or a box"));
  }
  return Joined(std::move(faults), FaultsOfNumbers(claim, {}));
}

/** The speed of a light body after an elastic impact by a heavy one, over that one's. [-]
 */
constexpr double kGainOfImpact = 2;

/** Returns the outward normal of the one that is a half-space, out of A into B. */
std::optional<Eigen::Vector3d> NormalOfHalfSpace(const Body& A, const Body& B) {
  if (std::holds_alternative<HalfSpace>(A.shape)) return A.X_WB.R_WB.col(2);
  if (std::holds_alternative<HalfSpace>(B.shape)) return -B.X_WB.R_WB.col(2);
  return std::nullopt;
}

/** Returns how fast any point of a body's surface moves. A spinning sphere's does not. */
double SurfaceSpeed(const RigidBody& body, const BodyState& at) {
  const double lever = std::holds_alternative<Sphere>(body.placed.shape)
                           ? 0
                           : BoundingRadius(body.placed.shape);
  return at.v_WB.norm() + at.w_WB.norm() * lever;
}

/** Returns the most by which an impulse of 1 N s at a surface speeds that surface up.
 [1/kg] */
double MobilityOf(const RigidBody& body) {
  const double R = std::holds_alternative<Sphere>(body.placed.shape)
                       ? 0
                       : BoundingRadius(body.placed.shape);
  return 1 / body.mass + R * R / InertiaOf(body).minCoeff();
}

/** Returns the radius of a body; infinite for a half-space. [m] */
double RadiusOf(const Body& body) {
  return std::holds_alternative<HalfSpace>(body.shape)
             ? std::numeric_limits<double>::infinity()
             : BoundingRadius(body.shape);
}

/** Bodies that touch each other in one step, directly or through others. */
class Groups {
 public:
  Groups(const World& world, std::span<const ContactImpulse> contacts)
      : parents_(world.bodies.size()) {
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    for (const ContactImpulse& contact : contacts) {
      const auto A = static_cast<std::size_t>(contact.A);
      const auto B = static_cast<std::size_t>(contact.B);
      if (world.bodies[A].mass > 0 && world.bodies[B].mass > 0)
        parents_[RootOf(A)] = RootOf(B);
    }
  }

  std::size_t RootOf(std::size_t body) const {
    while (parents_[body] != body) body = parents_[body];
    return body;
  }

 private:
  std::vector<std::size_t> parents_;
};

/** The contact impulses on one body in a step. */
struct ImpulsesOnBody {
  double J = 0;      ///< Sum of the lengths of their impulses. [N s]
  int contacts = 0;  ///< Number of contacts.
};

/** The two bodies of a contact at one moment of a step. */
struct BodiesOfContact {
  Body A;
  Body B;
  double time = 0;  ///< Since the start of the step. [s]
};

/** Returns the rotation with the rotation vector `r`. [rad] */
Eigen::Matrix3d RotationBy(const Eigen::Vector3d& r) {
  return Eigen::AngleAxisd(r.norm(), r.stableNormalized()).toRotationMatrix();
}

/** The contacts of one step that starts at a sample, and how fast they let bodies be. */
class JudgedStep {
 public:
  JudgedStep(const Motion& motion, const AllowedMotion& allowed,
             std::span<const ContactImpulse> contacts, std::size_t sample)
      : motion_(motion),
        allowed_(allowed),
        s_(sample),
        groups_(motion.world, contacts),
        impulses_(motion.world.bodies.size()),
        fastest_(motion.world.bodies.size(), 0),
        is_held_(motion.world.bodies.size(), false) {
    for (const ContactImpulse& contact : contacts) {
      for (const int index : {contact.A, contact.B}) {
        ImpulsesOnBody& on_body = impulses_[static_cast<std::size_t>(index)];
        on_body.J += contact.J_B_W.norm();
        ++on_body.contacts;
      }
    }
    const World& world = motion.world;
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      if (world.bodies[i].mass == 0) continue;
      const std::size_t root = groups_.RootOf(i);
      const double speed = std::max(SpeedAt(i, s_), SpeedAt(i, s_ + 1)) + PushedSpeed(i);
      fastest_[root] = std::max(fastest_[root], speed);
      fastest_of_all_ = std::max(fastest_of_all_, speed);
      if (IsHeld(world, AnchorKind::kBody, static_cast<int>(i))) is_held_[root] = true;
    }
  }

  void Take(const ContactImpulse& contact, Worst& worst) const {
    const World& world = motion_.world;
    const WorldState& state = motion_.trajectory.samples[s_];
    const Body A = PlacedAt(world, state, contact.A);
    const Body B = PlacedAt(world, state, contact.B);
    if (!HasChords(A.shape) || !HasChords(B.shape)) return;
    const double length = contact.n_AB_W.norm();
    const double R = std::min(RadiusOf(A), RadiusOf(B));
    const double size = (contact.p_WC - A.X_WB.p_WB).norm() + R +
                        (contact.p_WC - B.X_WB.p_WB).norm() +
                        std::abs(contact.separation);
    const Capability& pair = motion_.oracle.For(KindOf(A.shape), KindOf(B.shape));
    const double far = A.X_WB.p_WB.norm() + B.X_WB.p_WB.norm() + 2 * R;
    const double rounding = RoundingOf(motion_.oracle, 1) * far + pair.documented_error;
    const double speed_A = SpeedOf(contact.A);
    const double speed_B = SpeedOf(contact.B);
    const double fastest = std::max(speed_A, speed_B);
    const auto share_of = [&](int index, double speed) {
      if (world.bodies[static_cast<std::size_t>(index)].mass == 0) return 0.0;
      return fastest > 0 ? speed / fastest : 1.0;
    };
    double error = std::numeric_limits<double>::quiet_NaN();
    double turned = 0;
    BodiesOfContact nearest{A, B};
    if (std::isfinite(size) && std::isfinite(length) && length > 0) {
      const auto place = [&](const Body& at_A, const Body& at_B) {
        return PlacedContact{contact,
                             at_A,
                             at_B,
                             contact.n_AB_W / length,
                             TurnOf(contact.A, speed_A),
                             TurnOf(contact.B, speed_B),
                             share_of(contact.A, speed_A),
                             share_of(contact.B, speed_B),
                             rounding};
      };
      const auto error_of = [&](const PlacedContact& placed) {
        return std::max({placed.LeastError(size), placed.LeastErrorOfNormal(),
                         R * std::abs(length - 1)});
      };
      const PlacedContact at_start = place(A, B);
      error = error_of(at_start);
      turned = at_start.TurnOfNormal();
      if (error > rounding) {
        for (const BodiesOfContact& other : LaterInTheStep(contact)) {
          const double less = error_of(place(other.A, other.B));
          if (!(less < error)) continue;
          error = less;
          nearest = other;
        }
      }
      // No motion turns a half-space.
      if (const auto n_W = NormalOfHalfSpace(A, B)) {
        const double across = R * (contact.n_AB_W - *n_W).norm();
        worst.Take(across, RoundingOf(motion_.oracle, 1) * R + pair.documented_error,
                   [&] { return ProofOfNormal(contact, *n_W, across); });
      }
    }
    worst.Take(error, kSafety * (world.dt * fastest + turned) + rounding,
               [&] { return ProofOf(contact, nearest, error); });
  }

 private:
  /** Returns a body extrapolated by `later` [s] from a sample, with its velocities there.
   */
  Body MovedOn(std::size_t sample, int index, double later) const {
    Body body = PlacedAt(motion_.world, motion_.trajectory.samples[sample], index);
    const auto i = static_cast<std::size_t>(index);
    if (motion_.world.bodies[i].mass == 0) return body;
    const BodyState& at = motion_.trajectory.samples[sample].bodies[i];
    body.X_WB.p_WB += later * at.v_WB;
    body.X_WB.R_WB = RotationBy(later * at.w_WB) * body.X_WB.R_WB;
    return body;
  }

  /** Returns how long after a sample the surfaces have the separation of the contact
   along its line, at the velocities there; negative: before it. Empty if they never have.
   [s] */
  std::optional<double> TimeOfContact(const ContactImpulse& contact,
                                      std::size_t sample) const {
    const Eigen::Vector3d n_W = contact.n_AB_W.normalized();
    const auto end_of = [&](int index, const Eigen::Vector3d& d_W) {
      return ChordThrough(MovedOn(sample, index, 0), 0, contact.p_WC, d_W);
    };
    const auto speed_of = [&](int index) {
      const auto i = static_cast<std::size_t>(index);
      if (motion_.world.bodies[i].mass == 0) return 0.0;
      const BodyState& at = motion_.trajectory.samples[sample].bodies[i];
      return n_W.dot(at.v_WB + at.w_WB.cross(contact.p_WC - at.p_WB));
    };
    const std::optional<Chord> a = end_of(contact.A, n_W);
    const std::optional<Chord> b = end_of(contact.B, n_W);
    const double parting = speed_of(contact.B) - speed_of(contact.A);
    if (!a || !b || parting == 0) return std::nullopt;
    return (contact.separation - (b->enters - a->leaves)) / parting;
  }

  /** Returns the two bodies at other moments of the step, at which an engine may have
   collided them: at its end, and at an impact that is reached from its start or left for
   its end. */
  std::vector<BodiesOfContact> LaterInTheStep(const ContactImpulse& contact) const {
    std::vector<BodiesOfContact> moments;
    const double h = motion_.world.dt;
    const auto add = [&](std::size_t sample, double later) {
      const double time = sample == s_ ? later : h + later;
      moments.push_back(
          {MovedOn(sample, contact.A, later), MovedOn(sample, contact.B, later), time});
    };
    const std::optional<double> from_start = TimeOfContact(contact, s_);
    if (from_start && *from_start > 0 && *from_start <= h) add(s_, *from_start);
    if (motion_.world.sample_every > 1) return moments;  // The end is not known.
    add(s_ + 1, 0);
    const std::optional<double> from_end = TimeOfContact(contact, s_ + 1);
    if (from_end && *from_end < 0 && *from_end >= -h) add(s_ + 1, *from_end);
    return moments;
  }

  double SpeedAt(std::size_t i, std::size_t s) const {
    return SurfaceSpeed(motion_.world.bodies[i], allowed_.At(s).bodies[i]);
  }

  /** Returns by how much a body may turn in the step if its surface moves at `speed`.
   [rad] */
  double TurnOf(int index, double speed) const {
    const auto i = static_cast<std::size_t>(index);
    const RigidBody& body = motion_.world.bodies[i];
    if (body.mass == 0 || std::holds_alternative<Sphere>(body.placed.shape)) return 0;
    return motion_.world.dt * speed / BoundingRadius(body.placed.shape) +
           RoundingOf(motion_.oracle, 1);
  }

  /** Returns how fast the surface of a body may move in the step, at speeds that the
   truth allows. [m/s] */
  double SpeedOf(int index) const {
    const World& world = motion_.world;
    const auto i = static_cast<std::size_t>(index);
    const RigidBody& body = world.bodies[i];
    if (body.mass == 0) return 0;
    double speed = SpeedAt(i, s_);
    if (world.sample_every == 1) speed = std::max(speed, SpeedAt(i, s_ + 1));
    // Between several contacts of a step it may be faster than at either end of it.
    if (impulses_[i].contacts > 1 || world.sample_every > 1) {
      const std::size_t root = groups_.RootOf(i);
      const double struck =
          kGainOfImpact * (is_held_[root] ? fastest_of_all_ : fastest_[root]);
      speed = std::max(
          speed, std::min(struck, SpeedAt(i, s_) + impulses_[i].J * MobilityOf(body)));
    }
    return speed + PushedSpeed(i) + AccelerationOf(world, body).norm() * world.dt;
  }

  /** Returns the speed that pushes give to the surface of a body between the samples,
   which an impact may take again before the later one. [m/s] */
  double PushedSpeed(std::size_t i) const {
    const RigidBody& body = motion_.world.bodies[i];
    double speed = 0;
    for (const Push* push :
         PushesBetween(motion_.world, static_cast<int>(i), motion_.trajectory.times[s_],
                       motion_.trajectory.times[s_ + 1])) {
      const double lever = BoundingRadius(body.placed.shape);
      speed += push->J_W.norm() *
               (1 / body.mass + lever * push->p_BoP.norm() / InertiaOf(body).minCoeff());
    }
    return speed;
  }

  const std::string& NameOf(int index) const {
    return motion_.world.bodies[static_cast<std::size_t>(index)].name;
  }

  CitingProof ProofOfNormal(const ContactImpulse& contact, const Eigen::Vector3d& n_W,
                            double error) const {
    return Citing(
        "{} reports a contact of {} and {} in the step after {:.6g} s with the normal "
        "{}; that of the plane is {}, so over the smaller body they differ by {:.3g} m",
        motion_.oracle.name, CitedName{NameOf(contact.A)}, CitedName{NameOf(contact.B)},
        CitedTime{motion_.trajectory.times[s_]}, FormatVector(contact.n_AB_W, 9),
        FormatVector(n_W, 9), error);
  }

  CitingProof ProofOf(const ContactImpulse& contact, const BodiesOfContact& nearest,
                      double error) const {
    const Eigen::Vector3d n_W = contact.n_AB_W.normalized();
    const std::optional<Chord> a = ChordThrough(nearest.A, 0, contact.p_WC, n_W);
    const std::optional<Chord> b = ChordThrough(nearest.B, 0, contact.p_WC, n_W);
    std::string truth;
    if (nearest.time > 0)
      truth =
          fmt::format("with the bodies where they are {:.6g} s later, ", nearest.time);
    if (a && b) {
      truth +=
          fmt::format("along that line {} ends at {:.6g} m and {} begins at {:.6g} m",
                      NameOf(contact.A), a->leaves, NameOf(contact.B), b->enters);
    } else {
      truth += fmt::format("that line misses {}", NameOf(a ? contact.B : contact.A));
    }
    return Citing(
        "{} reports a contact of {} and {} in the step after {:.6g} s at {} with the "
        "normal {} and the separation {:.6g} m; {}, so surfaces would have to be "
        "{:.3g} m elsewhere",
        motion_.oracle.name, CitedName{NameOf(contact.A)}, CitedName{NameOf(contact.B)},
        CitedTime{motion_.trajectory.times[s_]}, CitedPoint{contact.p_WC},
        FormatVector(contact.n_AB_W, 9), contact.separation, truth, error);
  }

  const Motion& motion_;
  const AllowedMotion& allowed_;
  std::size_t s_;
  Groups groups_;
  std::vector<ImpulsesOnBody> impulses_;  ///< Indexed by body.
  /** The fastest surface of a group, indexed by its root. [m/s] */
  std::vector<double> fastest_;
  std::vector<bool> is_held_;  ///< Whether a spring or joint holds one of a group.
  double fastest_of_all_ = 0;
};

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const World& world = motion.world;
  const Trajectory& trajectory = motion.trajectory;
  if (!trajectory.gives_impulses) return {};
  const std::vector<int> subjects = SubjectsOf(world, claim).bodies;
  const auto is_subject = [&](int index) {
    return std::find(subjects.begin(), subjects.end(), index) != subjects.end();
  };
  Worst worst(
      MeasureKind::kContactPlace,
      "1.5 × V h, V the speed of the faster of the two surfaces, at most what the "
      "truth allows; 64 roundings of the positions; and the documented error of "
      "the pair");
  const AllowedMotion allowed(motion);
  const std::span<const ContactImpulse> all(trajectory.impulses);
  for (std::size_t first = 0; first < all.size();) {
    std::size_t last = first;
    while (last < all.size() && all[last].step == all[first].step) ++last;
    const std::span<const ContactImpulse> contacts = all.subspan(first, last - first);
    first = last;
    const int before = contacts.front().step - 1;
    if (before % world.sample_every != 0) continue;
    const auto s = static_cast<std::size_t>(before / world.sample_every);
    if (s + 1 >= trajectory.samples.size()) continue;
    const JudgedStep step(motion, allowed, contacts, s);
    for (const ContactImpulse& contact : contacts)
      if (is_subject(contact.A) || is_subject(contact.B)) step.Take(contact, worst);
  }
  return FindingsOf({worst});
}

}  // namespace

/** Every contact that an engine reports is on both bodies, with the gap that it states.

 A contact states a point p, a normal n from A to B, and a separation s. On the line
 p + t n let A end at t = a and B begin at t = b. Then s = b − a, and p is between the two
 surfaces: b ≤ 0 ≤ a if the bodies overlap there, a ≤ 0 ≤ b if they are apart. The measure
 is the least ε by which surfaces must move for that to hold: with the surface of the
 faster body anywhere within ε of its place, that of the other within its share of ε, by
 its speed, and that of a static body within a rounding, a and b are known up to
 intervals, and s and p have to fit those. So a line along an edge, which meets a box or
 passes it, is no error. A box ends where its face towards n does: a line through a corner
 meets another face farther on, which is no contact. [m]

 The normal n is judged where only one is right. Let R be the smaller radius of the two.
 - Half-space: its normal n' does not turn. |n − n'| R has a tolerance of rounding alone.
 - Sphere with a sphere or a box: the normal lies along the vector w from the nearest
 point of the other shape to the centre, unless the centre is inside. Moving both bodies
 by δ changes w by at most δ, so the measure contains the distance of w from the ray along
 n. It also contains R ||n| − 1|.

 An engine collides its bodies at the start of a step, at an impact within it, or at its
 end. The measure is that at the start; or, if that is more than rounding, the least of
 those at the start, at the end, and where the surfaces have the separation s along the
 line if the bodies move on at the velocities of the start, or back at those of the end.
 The true moment may lie between impacts and have none of these poses, but from the start
 no surface moves by more than V h. So the tolerance is 1.5 × V h, with the speed V of the
 faster of the two surfaces, at most what the truth allows; 64 roundings of the positions;
 and the error that the engine documents for the pair. It is 1.5 × a h² and rounding where
 bodies rest under the load a, since an engine may add the load before it collides. A body
 with several contacts in the step may be struck and stopped again before its end: V is
 then up to twice that of the fastest body that touches it in the step, directly or
 through others, at most its own and what the impulses of the step give. Twice is what a
 light body gains from a heavy one. Springs and joints reach farther, so bodies that they
 hold are granted the fastest of all. No other body counts. Only contacts of the steps
 that start at a sample are judged, since only those poses are known.

 The law does not ask whether all contacts are there, nor whether the n of two boxes is
 the direction of least depth: engines choose among several.

 Judges only engines that report contact impulses. About: spheres and boxes. Contacts with
 other shapes than spheres, boxes and half-spaces are left out. Numbers: none. */
constinit const Law kContactsOnBodies = {
    .name = "contacts_on_bodies",
    .documentation =
        "Every reported contact lies on both bodies, with the separation it states.",
    .faults = Faults,
    .judge = Judge,
    .universal =
        [](const World& world) { return ClaimAboutEach(kContactsOnBodies, world); },
    .of_steps = true,
};

}  // namespace touchstone
