#include "engine/dynamics/world/world_impl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/dynamics/body/rotation.h"
#include "engine/dynamics/contacts/collide_bodies.h"
#include "engine/dynamics/solver/free_pair_correction.h"
#include "engine/dynamics/world/integrate.h"
#include "engine/dynamics/world/point_flight.h"

namespace cookbook {
namespace {

/** Minimum number of bodies of a world for any parallel loop. A step of fewer takes no
 longer than it takes to wake two threads. */
constexpr std::size_t kMinParallelWorld = 120;
/** Minimum number of bodies for a parallel loop over bodies. */
constexpr std::size_t kMinParallelBodies = 128;
/** A part of a step is halved at most this often in a row until its joints can be solved.
 */
constexpr int kMaxHalvingDepth = 12;

/** The parts of a step are halved this many times at most in all. The mechanisms of
 tests/engine/dynamics/joints/rod_energy_test.cc need at most 16, near one moment of the
 step; masses of 1 : 10^9 would take thousands, in every part. */
constexpr int kMaxHalvings = 64;

/** Rounding error of a depth, relative to the places of the bodies. */
constexpr double kRelativeDepthTolerance = 1e-14;

/** A step in which linked bodies get into each other is halved at most this often in a
 row. The depth of the impact then is that of a 64th of the step. */
constexpr int kMaxImpactHalvings = 6;

const Settings& Valid(const Settings& settings) {
  Validate(settings);
  return settings;
}

bool IsBounded(const Eigen::Vector3d& v) {
  return v.cwiseAbs().maxCoeff() < kDivergenceBound;  // False for NaN.
}

/** Appends the impulses of the touching contacts of `pair`. */
void Read(const ContactPair& pair, std::vector<ContactImpulse>& impulses) {
  for (std::size_t i = 0; i < pair.manifold.points().size(); ++i) {
    const ContactPoint& contact = pair.manifold.contacts[i];
    if (contact.separation > 0 && pair.J_W[i].isZero(0)) continue;
    impulses.push_back({pair.A, pair.B, contact.p_WC, pair.manifold.n_AB_W, pair.J_W[i],
                        contact.separation});
  }
}

}  // namespace

World::Impl::Impl(const Settings& settings)
    : settings_(Valid(settings)),
      pool_(settings.threads),
      contact_solver_(settings.threads) {}

int World::Impl::AddBody(const BodyDefinition& definition) {
  bodies_.push_back(MakeRigidBody(definition));
  const int added = body_count() - 1;
  contact_cache_.Add(bodies_.back());
  sleep_.Add(bodies_.back());
  inertias_.emplace_back();
  const std::size_t places = bodies_.size() + 1;
  for (std::vector<Velocity>* velocities :
       {&before_, &free_, &solved_, &mean_, &corrections_, &linked_corrections_}) {
    velocities->resize(places);
  }
  uncorrected_.emplace_back();
  contact_flags_.emplace_back();
  static_.emplace_back();
  moved_fraction_.push_back(0.5);
  linked_.push_back(false);
  has_lever_arm_.push_back(false);
  driven_.push_back(false);
  predicted_.push_back(bodies_.back());
  const RigidBody& body = bodies_.back();
  has_constant_forces_ = has_constant_forces_ || body.has_forces;
  fit_single_precision_ = fit_single_precision_ && FitsSinglePrecision(body);
  loads_valid_for_ = 0;
  const bool is_solid = std::holds_alternative<Box>(body.shape) ||
                        std::holds_alternative<HalfSpace>(body.shape);
  if (body.is_static() && body.collides && is_solid) static_colliders_.push_back(added);
  if (body.is_static() && body.collides && std::holds_alternative<Box>(body.shape))
    ++static_boxes_;
  return added;
}

void World::Impl::ExpectTwoEnds(const Anchor& A, const Anchor& B, const char* what) {
  for (const Anchor& anchor : {A, B}) {
    if (anchor.body != -1) Find(anchor.body);
    if (!anchor.point.allFinite()) {
      throw std::invalid_argument("An anchor of a " + std::string(what) +
                                  " is not finite.");
    }
  }
  if (A.body == B.body) {
    throw std::invalid_argument("Both anchors of a " + std::string(what) +
                                " are on the same body.");
  }
}

void World::Impl::MarkLinked(const Anchor& A, const Anchor& B) {
  sleep_.Link(A.body, B.body);
  for (const Anchor& anchor : {A, B}) {
    if (anchor.body < 0) continue;
    const auto i = static_cast<std::size_t>(anchor.body);
    linked_[i] = true;
    if (bodies_[i].is_point || anchor.point.isZero(0)) continue;
    has_lever_arm_[i] = true;
    has_lever_arms_ = true;
  }
}

int World::Impl::AddJoint(const DistanceJoint& joint) {
  ExpectTwoEnds(joint.A, joint.B, "joint");
  if (!(joint.length > 0) || !std::isfinite(joint.length)) {
    throw std::invalid_argument("The length of a joint has to be positive and finite.");
  }
  joints_.push_back(joint);
  MarkLinked(joint.A, joint.B);
  return static_cast<int>(joints_.size()) - 1;
}

int World::Impl::AddSpring(const Spring& spring) {
  ExpectTwoEnds(spring.A, spring.B, "spring");
  for (const double constant : {spring.stiffness, spring.damping, spring.rest_length}) {
    if (!(constant >= 0) || !std::isfinite(constant)) {
      throw std::invalid_argument(
          "The stiffness, damping and rest length of a spring have to be finite and not "
          "negative.");
    }
  }
  springs_.push_back(spring);
  MarkLinked(spring.A, spring.B);
  return static_cast<int>(springs_.size()) - 1;
}

RigidBody& World::Impl::Find(int body) {
  if (body < 0 || body >= body_count()) {
    std::ostringstream sentence;
    sentence << "There is no body " << body << "; expected one of the " << body_count()
             << " added.";
    throw std::invalid_argument(sentence.str());
  }
  return bodies_[static_cast<std::size_t>(body)];
}

void World::Impl::ApplyImpulse(int body, const Eigen::Vector3d& p_W,
                               const Eigen::Vector3d& J_W) {
  RigidBody& hit = Find(body);
  if (!p_W.allFinite() || !J_W.allFinite()) {
    throw std::invalid_argument("An impulse or its point is not finite.");
  }
  sleep_.Wake(body, bodies_);
  if (hit.is_static()) return;
  hit.state.v_WB += hit.inverse_mass * J_W;
  hit.state.w_WB +=
      WorldInertiaTimes(hit.R_WB, hit.inverse_moments, (p_W - hit.state.p_WB).cross(J_W));
}

void World::Impl::ApplyForce(int body, const Eigen::Vector3d& p_W,
                             const Eigen::Vector3d& F_W) {
  RigidBody& target = Find(body);
  if (!p_W.allFinite() || !F_W.allFinite()) {
    throw std::invalid_argument("A force or its point is not finite.");
  }
  sleep_.Wake(body, bodies_);
  has_applied_forces_ = true;
  target.has_forces = true;
  target.applied_force_W += F_W;
  target.applied_torque_W += (p_W - target.state.p_WB).cross(F_W);
}

void World::Impl::Step(double dt) {
  if (!(dt > 0) || !std::isfinite(dt)) {
    throw std::invalid_argument("A step has to be a positive finite time.");
  }
  for (int k = 0; k < settings_.sub_steps && !diverged_; ++k) {
    earlier_contacts_.clear();
    whole_step_ = dt / settings_.sub_steps;
    halvings_left_ = kMaxHalvings;
    impact_halvings_left_ = kMaxHalvings;
    StepOnce(whole_step_, 0);
  }
  if (!std::exchange(has_applied_forces_, false)) return;
  for (RigidBody& body : bodies_) {
    body.applied_force_W.setZero();
    body.applied_torque_W.setZero();
    body.has_forces = !body.force_W.isZero(0);
  }
}

void World::Impl::StepOnce(double h, int halvings) {
  const ThreadPool::ParallelScope scope(pool_, bodies_.size(), kMinParallelWorld);
  const bool touching = UpdateContacts(h);
  if (settings_.sleep_after) sleep_.WakeNear(contact_cache_, bodies_);
  SolveLinkageImpacts(h);
  const bool may_use_fourth_order = settings_.fourth_order_joints && HasJoints() &&
                                    !touching &&
                                    !(settings_.continuous_collision && MayHaveImpact(h));
  must_solve_joints_ = halvings == kMaxHalvingDepth || halvings_left_ == 0;
  joints_solved_ = true;
  const bool may_miss_impact = settings_.continuous_collision && HasJoints() &&
                               contact_cache_.near_count() > 0 &&
                               halvings < kMaxImpactHalvings && impact_halvings_left_ > 0;
  bool has_impact = may_miss_impact && LinkedBodyMayPassThrough(h);
  bool is_done =
      !has_impact && may_use_fourth_order && !must_solve_joints_ && StepFourthOrder(h);
  if (!is_done && !has_impact && joints_solved_) {
    if (may_miss_impact) saved_bodies_ = bodies_;
    is_done = Advance(h, settings_.continuous_collision);
    if (is_done && may_miss_impact && HasMissedImpact()) {
      RestoreBodies(h);
      has_impact = true;
      is_done = false;
    }
  }
  if (!is_done) {
    // Either linked bodies have an impact within the step, or the equations of the joints
    // have no solution that Newton's method finds. They have one near the linear motion
    // if the step is short enough.
    --(has_impact ? impact_halvings_left_ : halvings_left_);
    StepOnce(h / 2, halvings + 1);
    KeepContacts();
    StepOnce(h / 2, halvings + 1);
    return;
  }
  if (settings_.sleep_after) PutToSleep(h);
}

bool World::Impl::HasMissedImpact() const {
  const auto is_linked = [&](int A, int B) { return IsLinked(A) || IsLinked(B); };
  const auto depth_of = [](const Manifold& manifold) {
    double depth = 0;
    for (const ContactPoint& contact : manifold.points())
      depth = std::max(depth, -contact.separation);
    return depth;
  };
  bool has_missed = false;
  contact_cache_.ForEachGap(
      0, contact_cache_.near_count(), is_linked, [&](int A, int B, double gap) {
        if (has_missed || gap > 0) return;
        const RigidBody& a = bodies_[static_cast<std::size_t>(A)];
        const RigidBody& b = bodies_[static_cast<std::size_t>(B)];
        Manifold manifold;
        CollideSpeculative(0, a, b, Eigen::Vector3d::Zero(), manifold);
        double granted =
            SpeculativeMarginBetween(a, b) +
            kRelativeDepthTolerance * (a.state.p_WB.norm() + b.state.p_WB.norm() +
                                       std::min(a.radius, b.radius));
        if (depth_of(manifold) <= granted) return;
        for (const ContactPair& pair : contact_cache_.pairs()) {
          if (pair.A == A && pair.B == B) granted += depth_of(pair.manifold);
        }
        has_missed = depth_of(manifold) > granted;
      });
  return has_missed;
}

void World::Impl::RestoreBodies(double h) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    contact_cache_.AddTravel(i, Travel(bodies_[i].state, saved_bodies_[i]));
    bodies_[i] = saved_bodies_[i];
  }
  diverged_ = false;
  UpdateContacts(h);
}

void World::Impl::KeepContacts() {
  for (const std::span<const ContactPair> pairs :
       {impact_solver_.impact_contacts(),
        std::span<const ContactPair>(contact_cache_.pairs())}) {
    earlier_contacts_.insert(earlier_contacts_.end(), pairs.begin(), pairs.end());
  }
}

bool World::Impl::Advance(double h, bool with_impacts) {
  const StepContext step{settings_, h, pool_};
  is_last_resort_ = false;
  ApplyForces(h);
  impact_solver_.Clear();
  if (with_impacts) {
    impact_solver_.Begin({bodies_, before_, free_, sleep_.asleep(), linked_},
                         contact_cache_, step);
  }
  if (!Solve(h)) return false;
  IntegrateAll(h);
  if (with_impacts) impact_solver_.Solve(bodies_, mean_, contact_cache_, step);
  CorrectPositions(h);
  return true;
}

template <class Takes, class Counts>
bool World::Impl::AnyApproach(double h, const Takes& takes, const Counts& counts) {
  ApplyForces(h);
  const auto distance = [&](int A, int B) {
    const auto a = static_cast<std::size_t>(A);
    const auto b = static_cast<std::size_t>(B);
    // Static bodies have the velocity 0 in both.
    const double speed =
        std::max((before_[a].v - before_[b].v).norm(), (free_[a].v - free_[b].v).norm());
    return h * speed + MaxTravelByRotation(bodies_[a], h) +
           MaxTravelByRotation(bodies_[b], h);
  };
  bool any = false;
  contact_cache_.ForEachGap(
      0, contact_cache_.near_count(), takes,
      [&](int A, int B, double gap) { any = any || counts(A, B, distance(A, B), gap); });
  return any;
}

bool World::Impl::MayHaveImpact(double h) {
  const auto is_free_or_static = [&](int body) {
    const auto i = static_cast<std::size_t>(body);
    return !linked_[i] || bodies_[i].is_static();
  };
  return AnyApproach(
      h, [&](int A, int B) { return is_free_or_static(A) && is_free_or_static(B); },
      [](int, int, double distance, double gap) {
        return distance > 0 && gap <= distance;
      });
}

bool World::Impl::LinkedBodyMayPassThrough(double h) {
  return AnyApproach(
      h, [&](int A, int B) { return IsLinked(A) || IsLinked(B); },
      [&](int A, int B, double distance, double gap) {
        return distance - gap > SafePenetration(bodies_[static_cast<std::size_t>(A)],
                                                bodies_[static_cast<std::size_t>(B)]);
      });
}

bool World::Impl::StepFourthOrder(double h) {
  // Suzuki's composition (Phys. Lett. A 146, 1990): five steps of a scheme that is of
  // second order and symmetric in time, the third one backwards, are of fourth order.
  // They conserve whatever each of them conserves.
  const double s = 1 / (4 - std::cbrt(4.0));
  saved_bodies_ = bodies_;
  point_hit_ = false;
  bool is_solved = true;
  for (const double fraction : {s, s, 1 - 4 * s, s, s}) {
    is_solved = is_solved && Advance(fraction * h, false);
    if (!is_solved || point_hit_ || diverged_) break;
  }
  if (is_solved && !point_hit_ && !diverged_ && !UpdateContacts(h)) return true;
  RestoreBodies(h);
  return false;
}

void World::Impl::UpdateLoads() {
  // Gravity alone loads all bodies equally in every step.
  const bool is_gravity_only =
      !has_constant_forces_ && !has_applied_forces_ && springs_.empty();
  if (is_gravity_only && loads_valid_for_ == whole_step_) return;
  loads_.Update(contact_cache_.pairs(), joints_, springs_, settings_, whole_step_,
                bodies_);
  loads_valid_for_ = is_gravity_only ? whole_step_ : 0;
}

bool World::Impl::UpdateContacts(double h) {
  UpdateLoads();
  contact_cache_.Update(bodies_,
                        {loads_.max_speculative_margin(), settings_.reduce_manifolds},
                        settings_.continuous_collision ? h : 0, pool_);
  if (static_boxes_ > 1) seams_.RemoveContacts(bodies_, contact_cache_);
  // Again, because new contacts change the islands.
  UpdateLoads();
  return !contact_cache_.pairs().empty();
}

template <class Work>
void World::Impl::ForEachBody(const Work& work) {
  pool_.ParallelFor(bodies_.size(), kMinParallelBodies,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t i = begin; i < end; ++i) work(i);
                    });
}

template <class Takes, class Work, class Other>
void World::Impl::IntegrateInBatches(const Takes& is_batched, const Work& work,
                                     const Other& other) {
  pool_.ParallelFor(
      bodies_.size(), kMinParallelBodies, [&](std::size_t begin, std::size_t end) {
        constexpr std::size_t kBatch = 32;
        std::array<int, kBatch> batch;
        std::array<double, kBatch> travel;
        std::size_t count = 0;
        const auto flush = [&] {
          work(std::span<const int>(batch).first(count), std::span(travel).first(count));
          for (std::size_t k = 0; k < count; ++k) {
            contact_cache_.AddTravel(static_cast<std::size_t>(batch[k]), travel[k]);
          }
          count = 0;
        };
        for (std::size_t i = begin; i < end; ++i) {
          if (is_batched(i)) {
            batch[count++] = static_cast<int>(i);
            if (count == kBatch) flush();
          } else {
            other(i);
          }
        }
        if (count > 0) flush();
      });
}

void World::Impl::ApplyForces(double h) {
  ForEachBody([&](std::size_t i) {
    ApplyForcesTo(i, h);
    solved_[i] = free_[i];
    contact_flags_[i] = {};
    static_[i] = bodies_[i].is_static() ? 1 : 0;
  });
}

void World::Impl::ApplyForcesTo(std::size_t i, double h) {
  const RigidBody& body = bodies_[i];
  if (body.is_static()) return;
  // The tensor of an isotropic body is constant, unless the body has slept.
  if (!body.is_isotropic || inertias_[i].mass != body.inverse_mass)
    inertias_[i] = InverseInertiaOf(body);
  before_[i].v = body.state.v_WB;
  before_[i].w = body.state.w_WB;
  const Eigen::Vector3d acceleration =
      settings_.gravity_W + body.inverse_mass * body.Force_W();
  if (body.is_point) {
    // Impulses of the step act as constant forces, and drag affects their result too.
    const Drag drag(body.drag, h);
    free_[i].v = drag.decay * body.state.v_WB + h * drag.force_factor * acceleration;
    inertias_[i].mass *= drag.force_factor;
    moved_fraction_[i] = drag.travel_factor;
    return;
  }
  free_[i].v = body.state.v_WB + h * acceleration;
  free_[i].w = body.state.w_WB;
  if (body.has_forces) free_[i].w += inertias_[i].Times(h * body.Torque_W());
  // Exact rotation comes after the impulses: with its change of ω among the loads,
  // contacts would take away an approach that the body does not have, and add energy.
  if (!body.is_isotropic && settings_.gyroscopic != Gyroscopic::kExact) {
    free_[i].w += GyroscopicChange(body.R_WB, body.moments, body.state.w_WB, h,
                                   settings_.gyroscopic);
  }
}

bool World::Impl::HasImpactAlongJoint(double h) {
  // Stretch speed within (a + v²/L) h and the last change of velocity by a rod is
  // discretisation error: only the mean velocity of a step keeps the length. More is an
  // impact along a joint, which takes no time. a is the load acceleration, v the speed, L
  // the length. A rod with a heavy body at its end changes the velocity of a light one at
  // its other end by far more than a h.
  double max_speed = 0;
  double max_load_acceleration = 0;
  double min_length = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!linked_[i] || bodies_[i].is_static()) continue;
    max_speed = std::max(max_speed, bodies_[i].state.v_WB.norm());
    max_load_acceleration = std::max(max_load_acceleration, bodies_[i].load_acceleration);
  }
  for (const DistanceJoint& joint : joints_)
    min_length = std::min(min_length, joint.length);
  joint_solver_.Begin(joints_, bodies_, inertias_);
  const double expected_speed =
      h * (max_load_acceleration + max_speed * max_speed / min_length) +
      joint_solver_.MaxVelocityChange();
  return joint_solver_.MaxStretchSpeed(solved_) > expected_speed;
}

bool World::Impl::HasImpact(const ContactPair& pair, double h) const {
  const RigidBody& A = bodies_[static_cast<std::size_t>(pair.A)];
  const RigidBody& B = bodies_[static_cast<std::size_t>(pair.B)];
  const double threshold =
      settings_.restitution_threshold_factor * h * LoadAccelerationOn(pair, A, B);
  const auto points = pair.manifold.points();
  return std::any_of(points.begin(), points.end(), [&](const ContactPoint& contact) {
    const Velocity& v_A = solved_[static_cast<std::size_t>(pair.A)];
    const Velocity& v_B = solved_[static_cast<std::size_t>(pair.B)];
    const Eigen::Vector3d u_A = v_A.At(contact.p_WC - A.state.p_WB);
    const Eigen::Vector3d u_B = v_B.At(contact.p_WC - B.state.p_WB);
    const double rounding = kRelativeSpeedTolerance * (u_A.norm() + u_B.norm());
    return contact.separation <= 0 &&
           pair.manifold.n_AB_W.dot(u_B - u_A) < -threshold - rounding;
  });
}

void World::Impl::SolveLinkageImpacts(double h) {
  if (!HasJoints()) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const RigidBody& body = bodies_[i];
    static_[i] = body.is_static() ? 1 : 0;
    inertias_[i] = body.is_static() ? InverseInertia{} : InverseInertiaOf(body);
    solved_[i] = {body.state.v_WB, body.state.w_WB};
  }
  bool has_impact = !joints_.empty() && HasImpactAlongJoint(h);
  if (has_impact) {
    rod_projection_.Begin(joints_, bodies_, inertias_);
    rod_projection_.Project(solved_);
  }
  linked_islands_.Find(contact_cache_.summaries(), joints_, springs_, static_, linked_);
  const std::span<const PairSummary> pairs = linked_islands_.linked_pairs();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (pairs[p].count == 0 || !HasImpact(contact_cache_.pairs()[p], h)) continue;
    SolveLinkageImpact(linked_islands_.IslandOf(pairs[p]), h);
    has_impact = true;
  }
  if (!has_impact) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].is_static() || !linked_islands_.Contains(i)) continue;
    bodies_[i].state.v_WB = solved_[i].v;
    bodies_[i].state.w_WB = solved_[i].w;
  }
  joint_solver_.ResetImpulses();
}

void World::Impl::SolveLinkageImpact(std::size_t island, double h) {
  const std::span<const PairSummary> summaries = linked_islands_.linked_pairs();
  std::vector<ContactPair> pairs;
  for (std::size_t p = 0; p < summaries.size(); ++p) {
    if (summaries[p].count > 0 && linked_islands_.IslandOf(summaries[p]) == island)
      pairs.push_back(contact_cache_.pairs()[p]);
  }
  std::vector<DistanceJoint> joints;
  for (const DistanceJoint& joint : joints_) {
    const auto is_in = [&](int body) {
      return body >= 0 && static_[static_cast<std::size_t>(body)] == 0 &&
             linked_islands_.IslandOf(static_cast<std::size_t>(body)) == island;
    };
    if (is_in(joint.A.body) || is_in(joint.B.body)) joints.push_back(joint);
  }
  linkage_impact_.Solve({bodies_, inertias_, pairs, joints}, {settings_, h, pool_},
                        solved_, earlier_contacts_);
}

void World::Impl::SolveJointsUntilConverged() {
  const double speed = std::max(linked_contact_solver_.max_speed(), max_linked_speed_);
  const double tolerance = settings_.residual * speed;
  const int constraints = linked_contact_solver_.constraint_count() +
                          static_cast<int>(joints_.size() + springs_.size());
  const long extra_work = iteration_budget_.Remaining(settings_, constraints);
  long spent = 0;
  for (int k = 0;; ++k) {
    if (k >= settings_.impulse_iterations) spent += constraints;
    if (spent > extra_work) break;
    const double joint_change = joint_solver_.Iterate(solved_);
    const double spring_change = spring_solver_.Iterate(solved_);
    if (std::max({joint_change, spring_change,
                  linked_contact_solver_.Iterate(solved_, pool_)}) <= tolerance)
      break;
  }
  iteration_budget_.Spend(spent, settings_, constraints);
}

bool World::Impl::Solve(double h) {
  const SolverBodies world{bodies_, inertias_, before_,
                           solved_, static_,   fit_single_precision_};
  const StepContext step{settings_, h, pool_};
  if (!HasJoints()) {
    contact_solver_.Solve(contact_cache_.pairs(), contact_cache_.summaries(), world, step,
                          contact_flags_);
    return true;
  }
  linked_islands_.Find(contact_cache_.summaries(), joints_, springs_, static_, linked_);
  linked_contact_solver_.Begin(contact_cache_.pairs(), linked_islands_.linked_pairs(),
                               world, step, true);
  if (!SolveJoints(h)) return false;
  if (!is_last_resort_ && linked_contact_solver_.constraint_count() > 0 &&
      !LimitContactWork(h)) {
    return false;
  }
  if (!is_last_resort_ && has_lever_arms_) {
    PredictLinkedBodies(h);
    if (!rotations_solved_ && !EndWithoutSolution(h)) return false;
  }
  contact_solver_.Solve(contact_cache_.pairs(), linked_islands_.other_pairs(), world,
                        step, contact_flags_);
  return true;
}

void World::Impl::PredictLinkedBodies(double h) {
  rotations_solved_ = true;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!linked_islands_.Contains(i)) continue;
    predicted_[i] = bodies_[i];
    IntegrateBody(i, h, predicted_[i]);
  }
}

void World::Impl::SumContactImpulses() {
  given_ = free_;
  linked_contact_solver_.AddImpulses(
      {bodies_, inertias_, before_, given_, static_, fit_single_precision_}, pool_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!linked_[i]) solved_[i] = given_[i];
  }
}

bool World::Impl::SolveJointsDirectly(double h) {
  const StepContext step{settings_, h, pool_};
  // Block Gauss-Seidel: joints and springs exactly, then contacts. The joints come last,
  // so that they do no work whatever error the contacts have.
  const bool touching = linked_contact_solver_.constraint_count() > 0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (linked_[i]) solved_[i] = before_[i];
  }
  bool converged = !touching;
  for (int round = 0;; ++round) {
    SumContactImpulses();
    const bool is_solved = direct_joint_solver_.Solve(
        {joints_, springs_, bodies_, inertias_, given_, moved_fraction_,
         settings_.gyroscopic == Gyroscopic::kExact, h},
        {solved_, joint_solver_.impulses(), predicted_}, [&] { PredictLinkedBodies(h); });
    if (!is_solved) return false;
    if (converged || round == settings_.joint_rounds) return true;
    double greatest = 0;
    for (int k = 0; k < settings_.impulse_iterations; ++k)
      greatest = std::max(greatest, linked_contact_solver_.Iterate(solved_, pool_));
    std::fill(contact_flags_.begin(), contact_flags_.end(), ContactFlags{});
    linked_contact_solver_.StoreImpulses(contact_cache_.pairs(), step, contact_flags_);
    converged = greatest <= settings_.residual * linked_contact_solver_.max_speed();
  }
}

bool World::Impl::LimitContactWork(double h) {
  contact_work_limit_.Begin(contact_cache_.pairs(), linked_islands_, bodies_.size());
  for (bool is_limited = false;; is_limited = true) {
    PredictLinkedBodies(h);
    work_mean_ = mean_;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (bodies_[i].is_static()) work_mean_[i] = {};
      if (!has_lever_arm_[i] || settings_.gyroscopic != Gyroscopic::kExact) continue;
      // The Cayley map turns by 2 atan(h |ω|/2).
      const Eigen::Quaterniond turn =
          predicted_[i].state.q_WB * bodies_[i].state.q_WB.conjugate();
      work_mean_[i].w = 2 / h * turn.vec() / turn.w();
    }
    if (!contact_work_limit_.Exceeds({bodies_, before_, work_mean_, h})) {
      if (is_limited) contact_work_limit_.Scale(contact_cache_.pairs());
      return true;
    }
    given_ = free_;
    contact_work_limit_.AddImpulses(bodies_, inertias_, given_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!linked_[i]) solved_[i] = given_[i];
    }
    if (!direct_joint_solver_.Solve(
            {joints_, springs_, bodies_, inertias_, given_, moved_fraction_,
             settings_.gyroscopic == Gyroscopic::kExact, h},
            {solved_, joint_solver_.impulses(), predicted_},
            [&] { PredictLinkedBodies(h); })) {
      contact_work_limit_.Scale(contact_cache_.pairs());
      return EndWithoutSolution(h);
    }
  }
}

bool World::Impl::EndWithoutSolution(double h) {
  std::copy(warm_impulses_.begin(), warm_impulses_.end(),
            joint_solver_.impulses().begin());
  if (must_solve_joints_) SolveJointsInelastically(h);
  joints_solved_ = must_solve_joints_;
  return joints_solved_;
}

void World::Impl::SolveJointsInelastically(double h) {
  is_last_resort_ = true;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (linked_islands_.Contains(i)) solved_[i] = free_[i];
  }
  rod_projection_.Begin(joints_, bodies_, inertias_);
  rod_projection_.Project(solved_);
  joint_solver_.ResetImpulses();
  const std::span<const PairSummary> pairs = linked_islands_.linked_pairs();
  std::vector<char> is_solved(bodies_.size());
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (pairs[p].count == 0) continue;
    const std::size_t island = linked_islands_.IslandOf(pairs[p]);
    if (std::exchange(is_solved[island], 1) == 0) SolveLinkageImpact(island, h);
    contact_cache_.pairs()[p].J_W.fill(Eigen::Vector3d::Zero());
  }
}

bool World::Impl::SolveJoints(double h) {
  // Relative tolerance of lengths: a few roundings.
  constexpr double kLengthTolerance = 1e-15;
  // Greatest error that the last round may leave, in multiples of that: the rounds stop
  // making progress at roundings.
  constexpr double kGrant = 10;
  if (!settings_.warm_starting) joint_solver_.ResetImpulses();
  joint_solver_.Begin(joints_, bodies_, inertias_);
  joint_solver_.WarmStart(solved_, h);
  warm_impulses_.assign(joint_solver_.impulses().begin(), joint_solver_.impulses().end());
  spring_solver_.Begin(springs_, bodies_, inertias_, before_, h);
  double last_error = std::numeric_limits<double>::infinity();
  for (int round = 0; round <= settings_.joint_rounds; ++round) {
    // Relative to the largest velocity or velocity change, because rounding scales with
    // it.
    max_linked_speed_ =
        std::max(joint_solver_.MaxVelocityChange(), spring_solver_.MaxVelocityChange());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!linked_[i]) continue;
      max_linked_speed_ =
          std::max({max_linked_speed_, free_[i].v.norm(), solved_[i].v.norm()});
    }
    SolveJointsUntilConverged();
    std::fill(contact_flags_.begin(), contact_flags_.end(), ContactFlags{});
    linked_contact_solver_.StoreImpulses(contact_cache_.pairs(), {settings_, h, pool_},
                                         contact_flags_);
    PredictLinkedBodies(h);
    const double error = joint_solver_.MaxError(joints_, predicted_) / kLengthTolerance;
    if (round == settings_.joint_rounds && error <= kGrant) {
      SumContactImpulses();
      return true;
    }
    // The rounds converge too slowly, or not at all.
    if (error > kGrant && error > 0.5 * last_error) break;
    last_error = error;
    const double length_error =
        joint_solver_.Relinearize(joints_, predicted_, moved_fraction_, solved_, h);
    const bool springs_converged =
        spring_solver_.Relinearize(springs_, predicted_, moved_fraction_, solved_, h,
                                   settings_.residual * max_linked_speed_);
    if (springs_converged && length_error <= kLengthTolerance) {
      SumContactImpulses();
      return true;
    }
  }
  std::copy(warm_impulses_.begin(), warm_impulses_.end(),
            joint_solver_.impulses().begin());
  return SolveJointsDirectly(h) || EndWithoutSolution(h);
}

void World::Impl::IntegrateBody(std::size_t i, double h, RigidBody& body) {
  if (body.is_static()) return;
  const Velocity& before = before_[i];
  const Velocity& free = free_[i];
  const Velocity& after = solved_[i];
  if (body.is_point) {
    const Drag drag(body.drag, h);
    body.state.p_WB += h * (drag.force_factor * before.v +
                            drag.travel_factor * (after.v - drag.decay * before.v));
    body.state.v_WB = after.v;
    return;
  }

  // Forces act during the whole step: the mean of the velocities is exact for them. An
  // impact acts at the start of the step. A body that bounces is in free flight after it;
  // a body that rests has its final velocity from the start. A contact new in this step
  // counts as an impact: one that approached before the step is not `steady`. So does a
  // change of velocity that is too great for the loads. Bodies in linked islands have had
  // their impacts before the step.
  const double change =
      (after.v - before.v).norm() + body.radius * (after.w - before.w).norm();
  const bool has_contact = contact_flags_[i].bounced || contact_flags_[i].rested;
  const bool has_impact =
      has_contact && !IsInLinkedIsland(i) &&
      (contact_flags_[i].bounced || !contact_flags_[i].steady ||
       change > kImpactFactor * h *
                    std::max(body.load_acceleration, body.island_load_acceleration));
  Velocity& mean = mean_[i];
  if (!has_impact) {
    mean.v = 0.5 * (before.v + after.v);
    mean.w = 0.5 * (before.w + after.w);
  } else {
    mean = after;
    if (!contact_flags_[i].rested) mean.v -= 0.5 * (free.v - before.v);
  }
  moved_fraction_[i] = has_impact ? 1 : 0.5;

  body.state.p_WB += h * mean.v;
  body.state.v_WB = after.v;
  // The change of angular velocity by an impact acts from the start of the step.
  const Eigen::Vector3d start_w = has_impact ? before.w + (after.w - free.w) : before.w;
  if (has_lever_arm_[i] && !is_last_resort_ &&
      settings_.gyroscopic == Gyroscopic::kExact) {
    const LeverArmState end = IntegrateWithLeverArms(
        {body.state.q_WB, before.w}, body.moments,
        WorldInertiaTimes(body.R_WB, body.moments, before.w),
        WorldInertiaTimes(body.R_WB, body.moments, after.w - before.w), h);
    if (!end.is_solved) rotations_solved_ = false;
    body.state.q_WB = end.q_WB;
    body.state.w_WB = end.w_WB;
  } else if (settings_.gyroscopic == Gyroscopic::kExact && body.is_isotropic) {
    body.state.q_WB = IntegrateRotation(body.state.q_WB, start_w, after.w, h);
    body.state.w_WB = after.w;
  } else if (settings_.gyroscopic == Gyroscopic::kExact) {
    const Eigen::Vector3d torque = h * body.Torque_W();
    const Eigen::Vector3d L = WorldInertiaTimes(body.R_WB, body.moments, before.w);
    const Eigen::Vector3d impact =
        WorldInertiaTimes(body.R_WB, body.moments, after.w - free.w);
    const AngularState start{body.state.q_WB, start_w};
    AngularImpulse spread{has_impact ? torque : torque + impact, {}};
    // Contacts do the work of their impulses at the start of the step, and so do the rods
    // in the last resort.
    if ((has_contact && !has_impact) || is_last_resort_)
      spread.work = spread.dL_W.dot(before.w + after.w) / 2;
    const AngularState end = IntegrateAngularMomentum(
        start, body.moments, has_impact ? L + impact : L, spread, h);
    body.state.q_WB = end.q_WB;
    body.state.w_WB = end.w_WB;
  } else {
    body.state.q_WB = (Exp(h * mean.w) * body.state.q_WB).normalized();
    body.state.w_WB = after.w;
  }
  body.R_WB = body.state.q_WB.toRotationMatrix();
}

void World::Impl::IntegrateAll(double h) {
  const Integration integration{bodies_,        before_, free_, solved_,
                                contact_flags_, mean_,   h};
  const bool use_batches = settings_.gyroscopic == Gyroscopic::kExact;
  IntegrateInBatches(
      [&](std::size_t i) {
        return use_batches && bodies_[i].moves_isotropically() && !IsInLinkedIsland(i);
      },
      [&](std::span<const int> batch, std::span<double> travel) {
        if (!IntegrateIsotropicBodies(integration, batch, travel)) diverged_ = true;
      },
      [&](std::size_t i) { IntegrateOne(i, h); });
}

void World::Impl::IntegrateOne(std::size_t i, double h) {
  RigidBody& body = bodies_[i];
  if (body.is_static()) return;
  if (body.is_point) {
    const RigidBody before = body;
    IntegrateBody(i, h, body);
    const bool may_meet = h > 0 && body.collides && !static_colliders_.empty();
    contact_flags_[i].bounced = may_meet && CollidePoint(h, before, body);
  } else {
    const BodyState before = body.state;
    IntegrateBody(i, h, body);
    contact_cache_.AddTravel(i, Travel(before, body));
  }
  if (!IsBounded(body.state.p_WB) || !IsBounded(body.state.v_WB) ||
      !IsBounded(body.state.w_WB)) {
    diverged_ = true;
  }
}

bool World::Impl::CollidePoint(double h, const RigidBody& before, RigidBody& point) {
  const PointFlight flight{before.state.p_WB, before.state.v_WB,
                           (point.state.v_WB - before.state.v_WB) / h};
  const double resting_speed =
      settings_.restitution_threshold_factor * h * flight.a.norm();
  const PointFlightEnd end = FollowPoint(flight, h, point.restitution, resting_speed,
                                         bodies_, static_colliders_);
  if (!end.hit) return false;
  point_hit_ = true;
  point.state.p_WB = end.p_W;
  point.state.v_WB = end.v_W;
  return true;
}

void World::Impl::CorrectPositions(double h) {
  Settings settings = settings_;
  if (h != whole_step_) {
    // The parts of a step that is halved remove as much depth together as one step would.
    settings.position_correction_fraction =
        1 - std::pow(1 - settings_.position_correction_fraction, h / whole_step_);
  }
  const StepContext step{settings, h, pool_};
  bool moved =
      contact_solver_.FindPositionCorrections({mean_, solved_}, step, corrections_);
  if (HasJoints()) {
    if (!moved) {
      std::fill(corrections_.begin(), corrections_.end(), Velocity{});
    }
    if (linked_contact_solver_.FindPositionCorrections({mean_, solved_}, step,
                                                       linked_corrections_)) {
      moved = true;
      for (std::size_t i = 0; i < bodies_.size(); ++i) {
        if (linked_islands_.Contains(i)) corrections_[i] = linked_corrections_[i];
      }
      // A body that is moved out of another takes what rods hold to it along.
      rod_projection_.Begin(joints_, bodies_, inertias_);
      rod_projection_.Project(corrections_);
    }
    moved |= joint_solver_.CorrectPositions(
        joints_, settings_.position_correction_fraction, bodies_, corrections_);
  }
  if (settings.stabilisation == Stabilisation::kSplitImpulse) {
    const auto free_pairs = impact_solver_.deep_hit_pairs();
    if (!moved && !free_pairs.empty())
      std::fill(corrections_.begin(), corrections_.end(), Velocity{});
    for (const auto& [A, B] : free_pairs) {
      const auto a = static_cast<std::size_t>(A);
      const auto b = static_cast<std::size_t>(B);
      moved |=
          CorrectFreePair(bodies_[a], bodies_[b], settings.position_correction_fraction,
                          settings.position_iterations, corrections_[a], corrections_[b]);
    }
  }
  if (!moved) return;
  IntegrateInBatches(
      [&](std::size_t i) {
        return !bodies_[i].is_static() &&
               !(corrections_[i].v.isZero(0) && corrections_[i].w.isZero(0));
      },
      [&](std::span<const int> batch, std::span<double> travel) {
        for (const int i : batch) {
          const auto k = static_cast<std::size_t>(i);
          uncorrected_[k] = bodies_[k].R_WB;
        }
        IntegratePositionCorrections(bodies_, corrections_, batch, travel);
        for (const int i : batch) {
          const auto k = static_cast<std::size_t>(i);
          RigidBody& body = bodies_[k];
          Eigen::Vector3d& w_WB = body.state.w_WB;
          if (body.is_isotropic || w_WB.isZero(0)) continue;
          w_WB = SpinAfterCorrection(uncorrected_[k], body.R_WB, body.moments, w_WB);
        }
      },
      [](std::size_t) {});
}

void World::Impl::PutToSleep(double h) {
  // Forces in balance leave this fraction of themselves, by rounding.
  constexpr double kNegligible = 1e-15;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const RigidBody& body = bodies_[i];
    const Eigen::Vector3d force_acceleration = body.inverse_mass * body.Force_W();
    const double acceleration = (settings_.gravity_W + force_acceleration).norm();
    const bool is_accelerated = acceleration > kNegligible * (settings_.gravity_W.norm() +
                                                              force_acceleration.norm());
    const bool is_held =
        linked_[i] || contact_flags_[i].rested || contact_flags_[i].bounced;
    driven_[i] = !is_held && (is_accelerated || !body.Torque_W().isZero(0));
  }
  if (!sleep_.PutToSleep(contact_cache_, driven_, settings_, h, bodies_)) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].is_static()) continue;
    inertias_[i] = {};
    for (std::vector<Velocity>* velocities : {&before_, &free_, &solved_, &mean_}) {
      (*velocities)[i] = {};
    }
  }
}

void World::Impl::AppendContactImpulses(std::vector<ContactImpulse>& impulses) const {
  for (const ContactPair& pair : earlier_contacts_) Read(pair, impulses);
  for (const ContactPair& pair : impact_solver_.impact_contacts()) Read(pair, impulses);
  for (const ContactPair& pair : contact_cache_.pairs()) Read(pair, impulses);
}

}  // namespace cookbook
