#include "engine/dynamics/world/world.h"

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

/** Bodies of a world below which it does not pay to wake another thread: a step of so
 many takes as long as to wake two. */
constexpr std::size_t kFewToShare = 120;
/** Bodies below which it does not pay to share them out. */
constexpr std::size_t kFewBodies = 128;

const Settings& Valid(const Settings& settings) {
  Validate(settings);
  return settings;
}

bool IsSane(const Eigen::Vector3d& v) {
  return v.cwiseAbs().maxCoeff() < kLargest;  // False for NaN.
}

void Read(const ContactPair& pair, std::vector<ContactImpulse>& impulses) {
  for (std::size_t i = 0; i < pair.manifold.points().size(); ++i) {
    const ContactPoint& contact = pair.manifold.contacts[i];
    if (contact.separation > 0 && pair.J_W[i].isZero(0)) continue;
    impulses.push_back({pair.A, pair.B, contact.p_WC, pair.manifold.n_AB_W, pair.J_W[i],
                        contact.separation});
  }
}

}  // namespace

World::World(const Settings& settings)
    : settings_(Valid(settings)), pool_(settings.threads), contacts_(settings.threads) {}

int World::AddBody(const BodyDefinition& definition) {
  bodies_.push_back(MakeRigidBody(definition));
  const int added = body_count() - 1;
  contact_cache_.Add(bodies_.back());
  sleep_.Add(bodies_.back());
  inertias_.emplace_back();
  const std::size_t places = bodies_.size() + 1;
  for (std::vector<Velocity>* velocities :
       {&before_, &free_, &solved_, &mean_, &moves_}) {
    velocities->resize(places);
  }
  touches_.emplace_back();
  static_.emplace_back();
  shares_.push_back(0.5);
  linked_.push_back(false);
  driven_.push_back(false);
  ahead_.push_back(bodies_.back());
  const RigidBody& body = bodies_.back();
  has_forces_ = has_forces_ || body.has_forces;
  fit_single_precision_ = fit_single_precision_ && FitsSinglePrecision(body);
  found_for_ = 0;
  const bool is_solid = std::holds_alternative<Box>(body.shape) ||
                        std::holds_alternative<HalfSpace>(body.shape);
  if (body.is_static() && body.collides && is_solid) solids_.push_back(added);
  return added;
}

void World::ExpectTwoEnds(const Anchor& A, const Anchor& B, const char* what) {
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

void World::MarkLinked(const Anchor& A, const Anchor& B) {
  sleep_.Link(A.body, B.body);
  for (const int body : {A.body, B.body}) {
    if (body >= 0) linked_[static_cast<std::size_t>(body)] = true;
  }
}

int World::AddJoint(const DistanceJoint& joint) {
  ExpectTwoEnds(joint.A, joint.B, "joint");
  if (!(joint.length > 0) || !std::isfinite(joint.length)) {
    throw std::invalid_argument("The length of a joint has to be positive and finite.");
  }
  joints_.push_back(joint);
  MarkLinked(joint.A, joint.B);
  return static_cast<int>(joints_.size()) - 1;
}

int World::AddSpring(const Spring& spring) {
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

RigidBody& World::Find(int body) {
  if (body < 0 || body >= body_count()) {
    std::ostringstream sentence;
    sentence << "There is no body " << body << "; expected one of the " << body_count()
             << " added.";
    throw std::invalid_argument(sentence.str());
  }
  return bodies_[static_cast<std::size_t>(body)];
}

void World::ApplyImpulse(int body, const Eigen::Vector3d& p_W,
                         const Eigen::Vector3d& J_W) {
  RigidBody& struck = Find(body);
  if (!p_W.allFinite() || !J_W.allFinite()) {
    throw std::invalid_argument("An impulse or its point is not finite.");
  }
  sleep_.Wake(body, bodies_);
  if (struck.is_static()) return;
  struck.state.v_WB += struck.inverse_mass * J_W;
  struck.state.w_WB += WorldInertiaTimes(struck.R_WB, struck.inverse_moments,
                                          (p_W - struck.state.p_WB).cross(J_W));
}

void World::ApplyForce(int body, const Eigen::Vector3d& p_W, const Eigen::Vector3d& F_W) {
  RigidBody& pushed = Find(body);
  if (!p_W.allFinite() || !F_W.allFinite()) {
    throw std::invalid_argument("A force or its point is not finite.");
  }
  sleep_.Wake(body, bodies_);
  is_pushed_ = true;
  pushed.has_forces = true;
  pushed.applied_force_W += F_W;
  pushed.applied_torque_W += (p_W - pushed.state.p_WB).cross(F_W);
}

void World::Step(double dt) {
  if (!(dt > 0) || !std::isfinite(dt)) {
    throw std::invalid_argument("A step has to be a positive finite time.");
  }
  for (int k = 0; k < settings_.sub_steps && !diverged_; ++k) {
    StepOnce(dt / settings_.sub_steps);
  }
  if (!std::exchange(is_pushed_, false)) return;
  for (RigidBody& body : bodies_) {
    body.applied_force_W.setZero();
    body.applied_torque_W.setZero();
    body.has_forces = !body.force_W.isZero(0);
  }
}

void World::StepOnce(double h) {
  const ThreadPool::ParallelScope scope(pool_, bodies_.size(), kFewToShare);
  const bool touching = FindContacts(h);
  if (settings_.sleep_after) sleep_.WakeNear(contact_cache_, bodies_);
  StopStretching(h);
  const bool may_be_five = settings_.fourth_order_joints && HasLinks() && !touching &&
                           !(settings_.continuous_collision && MayImpact(h));
  if (!may_be_five || !StepFourthOrder(h)) Advance(h, settings_.continuous_collision);
  if (settings_.sleep_after) PutToSleep(h);
}

void World::Advance(double h, bool follow_blows) {
  ApplyForces(h);
  impacts_.Clear();
  if (follow_blows) {
    impacts_.Begin(
        {bodies_, before_, free_, sleep_.asleep(), linked_, contacts_.is_large()},
        contact_cache_, settings_, h, pool_);
  }
  Solve(h);
  Move(h);
  if (follow_blows) impacts_.Follow(bodies_, mean_, contact_cache_, settings_, pool_);
  Project(h);
}

bool World::MayImpact(double h) {
  ApplyForces(h);
  const auto reach = [&](int body) {
    const auto i = static_cast<std::size_t>(body);
    return MaxTravel(bodies_[i], free_[i].v, h);
  };
  const auto take_part = [&](int A, int B) {
    const auto takes_part = [&](std::size_t i) {
      return !linked_[i] || bodies_[i].is_static();
    };
    return takes_part(static_cast<std::size_t>(A)) &&
           takes_part(static_cast<std::size_t>(B));
  };
  bool may = false;
  contact_cache_.ForEachGap(0, contact_cache_.near_count(), take_part,
                            [&](int A, int B, double gap) {
                              const double way = reach(A) + reach(B);
                              may = may || (way > 0 && gap <= way);
                            });
  return may;
}

bool World::StepFourthOrder(double h) {
  // A step that is symmetric in time and of second order, taken as five, two of them
  // forwards, one backwards and two forwards again, is of fourth order; what each of them
  // keeps is kept (Suzuki, Phys. Lett. A 146, 1990).
  const double s = 1 / (4 - std::cbrt(4.0));
  kept_ = bodies_;
  point_hit_ = false;
  for (const double share : {s, s, 1 - 4 * s, s, s}) {
    Advance(share * h, false);
    if (point_hit_ || diverged_) break;
  }
  if (!point_hit_ && !diverged_ && !FindContacts(h)) return true;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    contact_cache_.AddTravel(i, Travel(bodies_[i].state, kept_[i]));
    bodies_[i] = kept_[i];
  }
  diverged_ = false;
  FindContacts(h);
  return false;
}

void World::FindLoads(double h) {
  // Gravity alone loads all alike, step after step.
  const bool is_even = !has_forces_ && !is_pushed_ && springs_.empty();
  if (is_even && found_for_ == h) return;
  loads_.Find(contact_cache_.contacts(), joints_, springs_, settings_, h, bodies_);
  found_for_ = is_even ? h : 0;
}

bool World::FindContacts(double h) {
  FindLoads(h);
  contact_cache_.Find(bodies_, {loads_.greatest_margin(), contacts_.is_large()},
                      settings_.continuous_collision ? h : 0, pool_);
  // What has come into contact presses from now on.
  FindLoads(h);
  return !contact_cache_.contacts().empty();
}

template <class Work>
void World::ForEachBody(const Work& work) {
  pool_.ParallelFor(bodies_.size(), kFewBodies, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) work(i);
  });
}

template <class Takes, class Work, class Other>
void World::ForSomeBodies(const Takes& takes, const Work& work, const Other& other) {
  pool_.ParallelFor(bodies_.size(), kFewBodies, [&](std::size_t begin, std::size_t end) {
    constexpr std::size_t kAtOnce = 32;
    std::array<int, kAtOnce> some;
    std::array<double, kAtOnce> ways;
    std::size_t count = 0;
    const auto flush = [&] {
      work(std::span<const int>(some).first(count), std::span(ways).first(count));
      for (std::size_t k = 0; k < count; ++k) {
        contact_cache_.AddTravel(static_cast<std::size_t>(some[k]), ways[k]);
      }
      count = 0;
    };
    for (std::size_t i = begin; i < end; ++i) {
      if (takes(i)) {
        some[count++] = static_cast<int>(i);
        if (count == kAtOnce) flush();
      } else {
        other(i);
      }
    }
    if (count > 0) flush();
  });
}

void World::ApplyForces(double h) {
  ForEachBody([&](std::size_t i) {
    ApplyForcesTo(i, h);
    solved_[i] = free_[i];
    touches_[i] = {};
    static_[i] = bodies_[i].is_static() ? 1 : 0;
  });
}

void World::ApplyForcesTo(std::size_t i, double h) {
  const RigidBody& body = bodies_[i];
  if (body.is_static()) return;
  // Of what is round it is what it was, but for what has slept.
  if (!body.is_isotropic || inertias_[i].mass != body.inverse_mass)
    inertias_[i] = InverseInertiaOf(body);
  before_[i].v = body.state.v_WB;
  before_[i].w = body.state.w_WB;
  const Eigen::Vector3d load = settings_.gravity_W + body.inverse_mass * body.Force_W();
  if (body.is_point) {
    // An impulse of the step acts as a constant force, on which drag has its effect
    // too.
    const Drag drag(body.drag, h);
    free_[i].v = drag.kept * body.state.v_WB + h * drag.gain * load;
    inertias_[i].mass *= drag.gain;
    shares_[i] = drag.share;
    return;
  }
  free_[i].v = body.state.v_WB + h * load;
  free_[i].w = body.state.w_WB;
  if (body.has_forces) free_[i].w += inertias_[i].Times(h * body.Torque_W());
  if (!body.is_isotropic) {
    free_[i].w += GyroscopicChange(body.R_WB, body.moments, body.state.w_WB, h,
                                   settings_.gyroscopic);
  }
}

void World::StopStretching(double h) {
  if (joints_.empty()) return;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    inertias_[i] = bodies_[i].is_static() ? inertias_[i] : InverseInertiaOf(bodies_[i]);
    solved_[i].v = bodies_[i].state.v_WB;
    solved_[i].w = bodies_[i].state.w_WB;
  }
  rods_.Begin(joints_, bodies_, inertias_);
  // The step itself leaves less than the accelerations times h. More is a impact along a
  // rod, which takes no time.
  double fastest = 0;
  double load = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!linked_[i] || bodies_[i].is_static()) continue;
    fastest = std::max(fastest, bodies_[i].state.v_WB.norm());
    load = std::max(load, bodies_[i].load_acceleration);
  }
  for (const DistanceJoint& joint : joints_) shortest = std::min(shortest, joint.length);
  const double usual = h * (load + fastest * fastest / shortest);
  if (rods_.MaxStretchSpeed(solved_) <= usual) return;
  rods_.ResetImpulses();
  const int sweeps =
      std::max(settings_.impulse_iterations,
               settings_.iteration_budget / static_cast<int>(joints_.size()));
  for (int k = 0; k < sweeps; ++k) {
    if (rods_.Iterate(solved_) <= settings_.residual * fastest) break;
  }
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!linked_[i]) continue;
    bodies_[i].state.v_WB = solved_[i].v;
    bodies_[i].state.w_WB = solved_[i].w;
  }
  rods_.ResetImpulses();
}

void World::SolveJointsUntilConverged() {
  const double speed = std::max(contacts_.scale(), fastest_);
  const double solved = settings_.residual * speed;
  const int rows =
      contacts_.constraint_count() + static_cast<int>(joints_.size() + springs_.size());
  const bool is_small = IsSmall(settings_, rows);
  const long iteration_budget =
      is_small ? iteration_budget_.Left(settings_) : settings_.iteration_budget;
  long spent = 0;
  for (int k = 0;; ++k) {
    spent += rows;
    if (k >= settings_.impulse_iterations && spent > iteration_budget) break;
    const double rods = rods_.Iterate(solved_);
    const double springs = spring_solver_.Iterate(solved_);
    if (std::max({rods, springs, contacts_.Iterate(solved_, pool_)}) <= solved) break;
  }
  if (is_small) iteration_budget_.Spend(spent, settings_);
}

void World::Solve(double h) {
  const SolverBodies world{bodies_, inertias_, before_,
                           solved_, static_,   fit_single_precision_};
  if (!HasLinks()) {
    contacts_.Solve(contact_cache_.contacts(), contact_cache_.edges(), world,
                    {settings_, h, pool_}, touches_);
    return;
  }
  contacts_.Begin(contact_cache_.contacts(), contact_cache_.edges(), world,
                  {settings_, h, pool_});
  SolveJoints(h);
}

void World::SolveJoints(double h) {
  // Lengths are kept to this share, a few roundings.
  constexpr double kSameLength = 1e-15;
  if (!settings_.warm_starting) rods_.ResetImpulses();
  rods_.Begin(joints_, bodies_, inertias_);
  rods_.WarmStart(solved_, h);
  spring_solver_.Begin(springs_, bodies_, inertias_, before_, h);
  for (int round = 0;; ++round) {
    // What is solved is a difference of velocities and loads: that rounds as they do.
    fastest_ = std::max(rods_.MaxVelocityChange(), spring_solver_.MaxVelocityChange());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!linked_[i]) continue;
      fastest_ = std::max({fastest_, free_[i].v.norm(), solved_[i].v.norm()});
    }
    SolveJointsUntilConverged();
    std::fill(touches_.begin(), touches_.end(), Touch{});
    contacts_.StoreImpulses(contact_cache_.contacts(), {settings_, h, pool_}, touches_);
    if (round == settings_.joint_rounds) return;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!linked_[i]) continue;
      ahead_[i] = bodies_[i];
      MoveBody(i, h, ahead_[i]);
    }
    const double rods = rods_.Relinearize(joints_, ahead_, shares_, solved_, h);
    const bool springs = spring_solver_.Relinearize(springs_, ahead_, shares_, solved_, h,
                                                settings_.residual * fastest_);
    if (springs && rods <= kSameLength) return;
  }
}

void World::MoveBody(std::size_t i, double h, RigidBody& body) {
  if (body.is_static()) return;
  const Velocity& before = before_[i];
  const Velocity& free = free_[i];
  const Velocity& after = solved_[i];
  if (body.is_point) {
    const Drag drag(body.drag, h);
    body.state.p_WB +=
        h * (drag.gain * before.v + drag.share * (after.v - drag.kept * before.v));
    body.state.v_WB = after.v;
    return;
  }

  // Forces act during all of the step: under them the mean of the velocities is exact.
  // A impact acts at its start. Where the body is sent back it then flies; where
  // something holds it, it has the velocity of the end from the start.
  const double change =
      (after.v - before.v).norm() + body.radius * (after.w - before.w).norm();
  const bool touched = touches_[i].bounced || touches_[i].rested;
  const bool struck =
      touched && (touches_[i].bounced || !touches_[i].steady ||
                  change > kImpactFactor * h * std::max(body.load_acceleration, body.island_load_acceleration));
  Velocity& mean = mean_[i];
  if (!struck) {
    mean.v = 0.5 * (before.v + after.v);
    mean.w = 0.5 * (before.w + after.w);
  } else {
    mean = after;
    if (!touches_[i].rested) mean.v -= 0.5 * (free.v - before.v);
  }
  shares_[i] = struck ? 1 : 0.5;

  body.state.p_WB += h * mean.v;
  body.state.v_WB = after.v;
  // A impact acts at once: it turns from the start as that leaves it.
  const Eigen::Vector3d from = struck ? before.w + (after.w - free.w) : before.w;
  if (settings_.gyroscopic == Gyroscopic::kExact && body.is_isotropic) {
    body.state.q_WB = IntegrateRotation(body.state.q_WB, from, after.w, h);
    body.state.w_WB = after.w;
  } else if (settings_.gyroscopic == Gyroscopic::kExact) {
    const Eigen::Vector3d torque = h * body.Torque_W();
    const Eigen::Vector3d L = WorldInertiaTimes(body.R_WB, body.moments, before.w);
    const Eigen::Vector3d impact =
        WorldInertiaTimes(body.R_WB, body.moments, after.w - free.w);
    const AngularState start{body.state.q_WB, from};
    const AngularState end =
        struck ? IntegrateAngularMomentum(start, body.moments, L + impact, torque, h)
               : IntegrateAngularMomentum(start, body.moments, L, torque + impact, h);
    body.state.q_WB = end.q_WB;
    body.state.w_WB = end.w_WB;
  } else {
    body.state.q_WB = (Exp(h * mean.w) * body.state.q_WB).normalized();
    body.state.w_WB = after.w;
  }
  body.R_WB = body.state.q_WB.toRotationMatrix();
}

void World::Move(double h) {
  const Motion motion{bodies_, before_, free_, solved_, touches_, mean_, h};
  const bool in_lanes = settings_.gyroscopic == Gyroscopic::kExact;
  ForSomeBodies([&](std::size_t i) { return in_lanes && bodies_[i].moves_isotropically(); },
                [&](std::span<const int> round, std::span<double> ways) {
                  if (!MoveRound(motion, round, ways)) diverged_ = true;
                },
                [&](std::size_t i) { MoveOne(i, h); });
}

void World::MoveOne(std::size_t i, double h) {
  RigidBody& body = bodies_[i];
  if (body.is_static()) return;
  if (body.is_point) {
    const RigidBody before = body;
    MoveBody(i, h, body);
    const bool may_meet = h > 0 && body.collides && !solids_.empty();
    touches_[i].bounced = may_meet && MeetSolids(h, before, body);
  } else {
    const BodyState before = body.state;
    MoveBody(i, h, body);
    contact_cache_.AddTravel(i, Travel(before, body));
  }
  if (!IsSane(body.state.p_WB) || !IsSane(body.state.v_WB) || !IsSane(body.state.w_WB)) {
    diverged_ = true;
  }
}

bool World::MeetSolids(double h, const RigidBody& before, RigidBody& point) {
  const Flight flight{before.state.p_WB, before.state.v_WB,
                      (point.state.v_WB - before.state.v_WB) / h};
  const double resting_speed = settings_.resting_speed * h * flight.a.norm();
  const Landing landing =
      Follow(flight, h, point.restitution, resting_speed, bodies_, solids_);
  if (!landing.hit) return false;
  point_hit_ = true;
  point.state.p_WB = landing.p_W;
  point.state.v_WB = landing.v_W;
  return true;
}

void World::Project(double h) {
  bool moved =
      contacts_.FindPositionCorrections({mean_, solved_}, {settings_, h, pool_}, moves_);
  if (!joints_.empty()) {
    if (!moved) {
      std::fill(moves_.begin(), moves_.end(), Velocity{});
    }
    moved |=
        rods_.CorrectPositions(joints_, settings_.position_correction_fraction, bodies_, moves_);
  }
  if (!moved) return;
  ForSomeBodies(
      [&](std::size_t i) {
        return !bodies_[i].is_static() &&
               !(moves_[i].v.isZero(0) && moves_[i].w.isZero(0));
      },
      [&](std::span<const int> shifted, std::span<double> ways) {
        Shift(bodies_, moves_, shifted, ways);
      },
      [](std::size_t) {});
}

void World::PutToSleep(double h) {
  // Forces that hold each other up leave this share of themselves: some roundings.
  constexpr double kNothing = 1e-15;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const RigidBody& body = bodies_[i];
    const Eigen::Vector3d push = body.inverse_mass * body.Force_W();
    const double load = (settings_.gravity_W + push).norm();
    const bool is_pulled = load > kNothing * (settings_.gravity_W.norm() + push.norm());
    const bool is_held = linked_[i] || touches_[i].rested || touches_[i].bounced;
    driven_[i] = !is_held && (is_pulled || !body.Torque_W().isZero(0));
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

void World::ReadImpulses(std::vector<ContactImpulse>& impulses) const {
  for (const ContactPair& pair : impacts_.struck()) Read(pair, impulses);
  for (const ContactPair& pair : contact_cache_.contacts()) Read(pair, impulses);
}

}  // namespace cookbook
