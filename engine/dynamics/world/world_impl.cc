#include "engine/dynamics/world/world_impl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/dynamics/body/rotation.h"
#include "engine/dynamics/world/integrate.h"
#include "engine/dynamics/world/point_flight.h"

namespace cookbook {
namespace {

/** Minimum number of bodies of a world for any parallel loop. A step of fewer takes no
 longer than it takes to wake two threads. */
constexpr std::size_t kMinParallelWorld = 120;
/** Minimum number of bodies for a parallel loop over bodies. */
constexpr std::size_t kMinParallelBodies = 128;

const Settings& Valid(const Settings& settings) {
  Validate(settings);
  return settings;
}

bool IsBounded(const Eigen::Vector3d& v) {
  return v.cwiseAbs().maxCoeff() < kDivergenceBound;  // False for NaN.
}

/** Returns the rotational energy of a body that is not isotropic, else 0. [J] */
double RotationalEnergy(const RigidBody& body) {
  if (body.is_isotropic) return 0;
  const Eigen::Vector3d w_B = body.R_WB.transpose() * body.state.w_WB;
  return w_B.dot(body.moments.cwiseProduct(w_B)) / 2;
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
       {&before_, &free_, &solved_, &mean_, &corrections_}) {
    velocities->resize(places);
  }
  rotational_energies_.emplace_back();
  contact_flags_.emplace_back();
  static_.emplace_back();
  moved_fraction_.push_back(0.5);
  linked_.push_back(false);
  driven_.push_back(false);
  predicted_.push_back(bodies_.back());
  const RigidBody& body = bodies_.back();
  has_constant_forces_ = has_constant_forces_ || body.has_forces;
  fit_single_precision_ = fit_single_precision_ && FitsSinglePrecision(body);
  loads_valid_for_ = 0;
  const bool is_solid = std::holds_alternative<Box>(body.shape) ||
                        std::holds_alternative<HalfSpace>(body.shape);
  if (body.is_static() && body.collides && is_solid) static_colliders_.push_back(added);
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
  for (const int body : {A.body, B.body}) {
    if (body >= 0) linked_[static_cast<std::size_t>(body)] = true;
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
    StepOnce(dt / settings_.sub_steps);
  }
  if (!std::exchange(has_applied_forces_, false)) return;
  for (RigidBody& body : bodies_) {
    body.applied_force_W.setZero();
    body.applied_torque_W.setZero();
    body.has_forces = !body.force_W.isZero(0);
  }
}

void World::Impl::StepOnce(double h) {
  const ThreadPool::ParallelScope scope(pool_, bodies_.size(), kMinParallelWorld);
  const bool touching = UpdateContacts(h);
  if (settings_.sleep_after) sleep_.WakeNear(contact_cache_, bodies_);
  SolveJointImpacts(h);
  const bool may_use_fourth_order = settings_.fourth_order_joints && HasJoints() &&
                                    !touching &&
                                    !(settings_.continuous_collision && MayHaveImpact(h));
  if (!may_use_fourth_order || !StepFourthOrder(h))
    Advance(h, settings_.continuous_collision);
  if (settings_.sleep_after) PutToSleep(h);
}

void World::Impl::Advance(double h, bool with_impacts) {
  const StepContext step{settings_, h, pool_};
  ApplyForces(h);
  impact_solver_.Clear();
  if (with_impacts) {
    impact_solver_.Begin({bodies_, before_, free_, sleep_.asleep(), linked_},
                         contact_cache_, step);
  }
  Solve(h);
  IntegrateAll(h);
  if (with_impacts) impact_solver_.Solve(bodies_, mean_, contact_cache_, step);
  CorrectPositions(h);
}

bool World::Impl::MayHaveImpact(double h) {
  ApplyForces(h);
  const auto max_travel = [&](int body) {
    const auto i = static_cast<std::size_t>(body);
    return MaxTravel(bodies_[i], free_[i].v, h);
  };
  const auto may_collide = [&](int A, int B) {
    const auto is_free_or_static = [&](std::size_t i) {
      return !linked_[i] || bodies_[i].is_static();
    };
    return is_free_or_static(static_cast<std::size_t>(A)) &&
           is_free_or_static(static_cast<std::size_t>(B));
  };
  bool may_have_impact = false;
  contact_cache_.ForEachGap(
      0, contact_cache_.near_count(), may_collide, [&](int A, int B, double gap) {
        const double distance = max_travel(A) + max_travel(B);
        may_have_impact = may_have_impact || (distance > 0 && gap <= distance);
      });
  return may_have_impact;
}

bool World::Impl::StepFourthOrder(double h) {
  // Suzuki's composition (Phys. Lett. A 146, 1990): five steps of a scheme that is of
  // second order and symmetric in time, the third one backwards, are of fourth order.
  // They conserve whatever each of them conserves.
  const double s = 1 / (4 - std::cbrt(4.0));
  saved_bodies_ = bodies_;
  point_hit_ = false;
  for (const double fraction : {s, s, 1 - 4 * s, s, s}) {
    Advance(fraction * h, false);
    if (point_hit_ || diverged_) break;
  }
  if (!point_hit_ && !diverged_ && !UpdateContacts(h)) return true;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    contact_cache_.AddTravel(i, Travel(bodies_[i].state, saved_bodies_[i]));
    bodies_[i] = saved_bodies_[i];
  }
  diverged_ = false;
  UpdateContacts(h);
  return false;
}

void World::Impl::UpdateLoads(double h) {
  // Gravity alone loads all bodies equally in every step.
  const bool is_gravity_only =
      !has_constant_forces_ && !has_applied_forces_ && springs_.empty();
  if (is_gravity_only && loads_valid_for_ == h) return;
  loads_.Update(contact_cache_.pairs(), joints_, springs_, settings_, h, bodies_);
  loads_valid_for_ = is_gravity_only ? h : 0;
}

bool World::Impl::UpdateContacts(double h) {
  UpdateLoads(h);
  contact_cache_.Update(bodies_,
                        {loads_.max_speculative_margin(), settings_.reduce_manifolds},
                        settings_.continuous_collision ? h : 0, pool_);
  // Again, because new contacts change the islands.
  UpdateLoads(h);
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

void World::Impl::SolveJointImpacts(double h) {
  if (joints_.empty()) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    inertias_[i] = bodies_[i].is_static() ? inertias_[i] : InverseInertiaOf(bodies_[i]);
    solved_[i].v = bodies_[i].state.v_WB;
    solved_[i].w = bodies_[i].state.w_WB;
  }
  joint_solver_.Begin(joints_, bodies_, inertias_);
  // Stretch speed within (a + v²/L) h is discretisation error; more is an impact along a
  // joint, which takes no time. a is the load acceleration, v the speed, L the length.
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
  const double expected_speed =
      h * (max_load_acceleration + max_speed * max_speed / min_length);
  if (joint_solver_.MaxStretchSpeed(solved_) <= expected_speed) return;
  joint_solver_.ResetImpulses();
  const int iterations =
      std::max(settings_.impulse_iterations,
               settings_.iteration_budget / static_cast<int>(joints_.size()));
  for (int k = 0; k < iterations; ++k) {
    if (joint_solver_.Iterate(solved_) <= settings_.residual * max_speed) break;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!linked_[i]) continue;
    bodies_[i].state.v_WB = solved_[i].v;
    bodies_[i].state.w_WB = solved_[i].w;
  }
  joint_solver_.ResetImpulses();
}

void World::Impl::SolveJointsUntilConverged() {
  const double speed = std::max(contact_solver_.max_speed(), max_linked_speed_);
  const double tolerance = settings_.residual * speed;
  const int constraints = contact_solver_.constraint_count() +
                          static_cast<int>(joints_.size() + springs_.size());
  const long extra_work = iteration_budget_.Remaining(settings_, constraints);
  long spent = 0;
  for (int k = 0;; ++k) {
    if (k >= settings_.impulse_iterations) spent += constraints;
    if (spent > extra_work) break;
    const double joint_change = joint_solver_.Iterate(solved_);
    const double spring_change = spring_solver_.Iterate(solved_);
    if (std::max({joint_change, spring_change,
                  contact_solver_.Iterate(solved_, pool_)}) <= tolerance)
      break;
  }
  iteration_budget_.Spend(spent, settings_, constraints);
}

void World::Impl::Solve(double h) {
  const SolverBodies world{bodies_, inertias_, before_,
                           solved_, static_,   fit_single_precision_};
  if (!HasJoints()) {
    contact_solver_.Solve(contact_cache_.pairs(), contact_cache_.summaries(), world,
                          {settings_, h, pool_}, contact_flags_);
    return;
  }
  contact_solver_.Begin(contact_cache_.pairs(), contact_cache_.summaries(), world,
                        {settings_, h, pool_});
  SolveJoints(h);
}

void World::Impl::SolveJoints(double h) {
  // Relative tolerance of lengths: a few roundings.
  constexpr double kLengthTolerance = 1e-15;
  if (!settings_.warm_starting) joint_solver_.ResetImpulses();
  joint_solver_.Begin(joints_, bodies_, inertias_);
  joint_solver_.WarmStart(solved_, h);
  spring_solver_.Begin(springs_, bodies_, inertias_, before_, h);
  for (int round = 0;; ++round) {
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
    contact_solver_.StoreImpulses(contact_cache_.pairs(), {settings_, h, pool_},
                                  contact_flags_);
    if (round == settings_.joint_rounds) return;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!linked_[i]) continue;
      predicted_[i] = bodies_[i];
      IntegrateBody(i, h, predicted_[i]);
    }
    const double length_error =
        joint_solver_.Relinearize(joints_, predicted_, moved_fraction_, solved_, h);
    const bool springs_converged =
        spring_solver_.Relinearize(springs_, predicted_, moved_fraction_, solved_, h,
                                   settings_.residual * max_linked_speed_);
    if (springs_converged && length_error <= kLengthTolerance) return;
  }
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
  // change of velocity that is too great for the loads.
  const double change =
      (after.v - before.v).norm() + body.radius * (after.w - before.w).norm();
  const bool has_contact = contact_flags_[i].bounced || contact_flags_[i].rested;
  const bool has_impact =
      has_contact &&
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
  if (settings_.gyroscopic == Gyroscopic::kExact && body.is_isotropic) {
    body.state.q_WB = IntegrateRotation(body.state.q_WB, start_w, after.w, h);
    body.state.w_WB = after.w;
  } else if (settings_.gyroscopic == Gyroscopic::kExact) {
    const Eigen::Vector3d torque = h * body.Torque_W();
    const Eigen::Vector3d L = WorldInertiaTimes(body.R_WB, body.moments, before.w);
    const Eigen::Vector3d impact =
        WorldInertiaTimes(body.R_WB, body.moments, after.w - free.w);
    const AngularState start{body.state.q_WB, start_w};
    AngularImpulse spread{has_impact ? torque : torque + impact, {}};
    // Contacts do the work of their impulses at the start of the step.
    if (has_contact && !has_impact && !linked_[i])
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
      [&](std::size_t i) { return use_batches && bodies_[i].moves_isotropically(); },
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
  bool moved = contact_solver_.FindPositionCorrections(
      {mean_, solved_}, {settings_, h, pool_}, corrections_);
  if (!joints_.empty()) {
    if (!moved) {
      std::fill(corrections_.begin(), corrections_.end(), Velocity{});
    }
    moved |= joint_solver_.CorrectPositions(
        joints_, settings_.position_correction_fraction, bodies_, corrections_);
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
          rotational_energies_[k] = RotationalEnergy(bodies_[k]);
        }
        IntegratePositionCorrections(bodies_, corrections_, batch, travel);
        // The new orientation has other moments of inertia about the angular velocity.
        for (const int i : batch) {
          const auto k = static_cast<std::size_t>(i);
          RigidBody& body = bodies_[k];
          if (body.is_isotropic || rotational_energies_[k] == 0) continue;
          body.state.w_WB *= std::sqrt(rotational_energies_[k] / RotationalEnergy(body));
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
  for (const ContactPair& pair : impact_solver_.impact_contacts()) Read(pair, impulses);
  for (const ContactPair& pair : contact_cache_.pairs()) Read(pair, impulses);
}

}  // namespace cookbook
