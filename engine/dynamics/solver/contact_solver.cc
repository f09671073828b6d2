#include "engine/dynamics/solver/contact_solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/dynamics/solver/position_correction.h"

namespace cookbook {
namespace {

/** Contacts of a manifold. */
constexpr int kMost = 8;
/** Contacts of a part: its rows, of 220 bytes a contact or of 110 in single precision,
 stay in a cache of 256 KiB, and the batches that its colours leave unfilled are few. */
constexpr int kPart = 1000;
/** A part of more contacts is solved by all threads, colour after colour. */
constexpr int kLargePart = 2 * kPart;
/** By how much a large world makes up for what is missing: a stack passes on a load
 sooner, and seven such sweeps leave less than eight others. */
constexpr double kRelaxation = 1.4;
/** Contacts below which it does not pay to share them out. */
constexpr int kFewContacts = 200;
/** Contacts from which on single precision pays: fewer leave most of sixteen lanes empty.
 */
constexpr int kManyContacts = 100;

ContactRules RulesOf(const Settings& settings, double h) {
  ContactRules rules{};
  rules.h = h;
  rules.resting_speed = settings.resting_speed;
  rules.soft_mass_scale = 1;
  rules.accumulated = settings.accumulated_impulses;
  rules.warm_starting = settings.warm_starting && settings.accumulated_impulses;
  if (settings.stabilisation == Stabilisation::kBaumgarte) {
    rules.baumgarte = settings.position_correction_fraction / h;
  } else if (settings.stabilisation == Stabilisation::kSoft) {
    // A damped spring stepped implicitly (Catto 2011): ω = 2π f, damping ratio ζ.
    const double omega =
        2 * std::numbers::pi * std::min(settings.soft_frequency, 0.125 / h);
    const double a1 = 2 * settings.soft_damping_ratio + h * omega;
    const double a2 = h * omega * a1;
    const double a3 = 1 / (1 + a2);
    rules.soft_rate = omega / a1;
    rules.soft_mass_scale = a2 * a3;
    rules.soft_impulse_scale = a3;
  }
  return rules;
}

Velocity Exact(const SingleVelocity& velocity) {
  const Eigen::Map<const Eigen::Matrix<float, 6, 1>> numbers(velocity.numbers.data());
  return {numbers.head<3>().cast<double>(), numbers.tail<3>().cast<double>()};
}

bool RemovesOverlap(const Settings& settings) {
  return settings.stabilisation == Stabilisation::kNonLinearProjection ||
         settings.stabilisation == Stabilisation::kLinearProjection;
}

/** Notes what is too deep in a group, where that is removed by moves. */
template <class Real>
void CollectPositionConstraints(ConstraintGroup<Real>& group, const Settings& settings,
                                Overlaps<Real>& overlaps) {
  if (!RemovesOverlap(settings)) return;
  group.CollectPositionConstraints(
      settings.stabilisation == Stabilisation::kNonLinearProjection, overlaps);
}

}  // namespace

bool FitsSinglePrecision(const RigidBody& body) {
  constexpr double kMostMass = 1e6;      // [kg], and of 1 / mass.
  constexpr double kMostResponse = 1e3;  // Of r² I⁻¹ by 1/m; 2.5 of a ball.
  if (body.is_static() || body.is_point) return true;
  const double turning = body.radius * body.radius * body.inverse_moments.maxCoeff();
  const double least = body.inverse_moments.minCoeff();
  return body.inverse_mass <= kMostMass && body.inverse_mass >= 1 / kMostMass &&
         turning <= kMostResponse * body.inverse_mass &&
         body.inverse_moments.maxCoeff() <= kMostResponse * least;
}

ContactSolver::ContactSolver(int threads)
    : groups_(static_cast<std::size_t>(threads)),
      single_groups_(static_cast<std::size_t>(threads)) {}

void ContactSolver::BuildConstraintGraph(std::span<const ContactEdge> edges,
                                         std::span<const char> is_static,
                                         const Settings& settings) {
  colours_.assign(is_static.size(), 0);
  islands_.Reset(is_static.size());
  coloured_.clear();
  colours_used_ = 0;
  contacts_ = 0;
  for (std::size_t p = 0; p < edges.size(); ++p) {
    const ContactEdge& edge = edges[p];
    const auto a = static_cast<std::size_t>(edge.A);
    const auto b = static_cast<std::size_t>(edge.B);
    if (edge.count == 0 || (is_static[a] && is_static[b])) continue;
    contacts_ += edge.count;
    const int colour = std::min(kLastColour, std::countr_one(colours_[a] | colours_[b]));
    const std::uint64_t bit = std::uint64_t{1} << colour;
    if (!is_static[a]) colours_[a] |= bit;
    if (!is_static[b]) colours_[b] |= bit;
    colours_used_ = std::max(colours_used_, colour + 1);
    coloured_.push_back({static_cast<int>(p), colour, edge.A, edge.B, edge.count});
    if (!is_static[a] && !is_static[b]) islands_.Unite(edge.A, edge.B);
  }
  island_ = islands_.Roots();
  is_large_ = !IsSmall(settings, is_large_ ? 2 * contacts_ : contacts_);
}

void ContactSolver::Divide(std::span<const char> is_static, int least) {
  // Of a island first its contacts, then its part.
  heap_part_.assign(is_static.size(), 0);
  part_.clear();
  for (const ColouredPair& pair : coloured_) {
    const int moving = is_static[static_cast<std::size_t>(pair.A)] ? pair.B : pair.A;
    part_.push_back(island_[static_cast<std::size_t>(moving)]);
    heap_part_[static_cast<std::size_t>(part_.back())] += pair.count;
  }
  parts_.clear();
  for (int& island : heap_part_) {
    if (island == 0) continue;
    if (parts_.empty() || parts_.back().contacts >= least) parts_.emplace_back();
    parts_.back().contacts += island;
    island = static_cast<int>(parts_.size()) - 1;
  }
  for (int& part : part_) {
    part = heap_part_[static_cast<std::size_t>(part)];
    ++parts_[static_cast<std::size_t>(part)].end;
  }
  std::size_t begin = 0;
  for (Part& part : parts_) {
    part.begin = begin;
    begin += part.end;
    part.end = part.begin;  // Grows to its end as pairs are put there.
  }
}

void ContactSolver::Order() {
  // Pairs with more contacts first within a colour, so that the lanes of a batch are
  // about as long as each other.
  const auto key = [](const ColouredPair& pair) {
    return static_cast<std::size_t>(pair.colour * (kMost + 1) + kMost - pair.count);
  };
  starts_.assign(static_cast<std::size_t>(colours_used_ * (kMost + 1)) + 1, 0);
  for (const ColouredPair& pair : coloured_) ++starts_[key(pair) + 1];
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  by_key_.resize(coloured_.size());
  for (std::size_t k = 0; k < coloured_.size(); ++k) {
    by_key_[static_cast<std::size_t>(starts_[key(coloured_[k])]++)] = static_cast<int>(k);
  }
  ordered_.resize(coloured_.size());
  for (const int next : by_key_) {
    const auto k = static_cast<std::size_t>(next);
    ordered_[parts_[static_cast<std::size_t>(part_[k])].end++] = coloured_[k];
  }
}

void ContactSolver::ForgetOverlaps() {
  for (Overlaps<double>& overlaps : groups_.overlaps) overlaps.Clear();
  for (Overlaps<float>& overlaps : single_groups_.overlaps) overlaps.Clear();
}

void ContactSolver::Solve(std::span<ContactPair> pairs,
                          std::span<const ContactEdge> edges, const SolverBodies& world,
                          const StepContext& step, std::span<Touch> touches) {
  ForgetOverlaps();
  BuildConstraintGraph(edges, world.is_static, step.settings);
  // ImpactSolver may have taken them all.
  if (contacts_ == 0) return;
  if (!is_large_) {
    BeginWhole(pairs, world, step);
    IterateUntilConverged(world, step);
    StoreImpulses(pairs, step, touches);
    return;
  }
  Divide(world.is_static, kPart);
  Order();
  is_single_ = step.settings.single_precision && contacts_ >= kManyContacts &&
               world.fit_single_precision;
  const Problem problem{pairs, world, step, touches};
  if (is_single_) {
    single_.assign(world.velocities.size(), {});
    SolveLarge<float>(problem, single_, single_groups_);
  } else {
    SolveLarge<double>(problem, world.velocities, groups_);
  }
}

void ContactSolver::Begin(std::span<const ContactPair> pairs,
                          std::span<const ContactEdge> edges, const SolverBodies& world,
                          const StepContext& step) {
  BuildConstraintGraph(edges, world.is_static, step.settings);
  BeginWhole(pairs, world, step);
}

void ContactSolver::BeginWhole(std::span<const ContactPair> pairs,
                               const SolverBodies& world, const StepContext& step) {
  is_single_ = false;
  // A world that may be swept more often than any world is solved as a whole: the sweeps
  // that one island leaves over are for the others.
  Divide(world.is_static, contacts_);
  Order();
  whole_.Begin(ordered_, pairs, world, RulesOf(step.settings, step.h), world.velocities,
               step.pool);
}

double ContactSolver::Iterate(std::span<Velocity> velocities, ThreadPool& pool) {
  return whole_.Iterate(1, velocities, pool);
}

void ContactSolver::IterateUntilConverged(const SolverBodies& world,
                                          const StepContext& step) {
  const Settings& settings = step.settings;
  heap_changes_.resize(world.bodies.size());
  const double solved = settings.residual * whole_.scale();
  const long iteration_budget = iteration_budget_.Left(settings);
  const ContactRules rules = RulesOf(settings, step.h);
  const bool may_rest = settings.static_equilibrium && rules.accumulated &&
                        rules.soft_impulse_scale == 0 && rules.baumgarte == 0;
  long spent = 0;
  for (int k = 0;; ++k) {
    // What sweeps do not solve soon may be brought to rest at once.
    if (k == settings.impulse_iterations && may_rest) {
      standstill_.Find(whole_.rows(), island_, solved, world);
    }
    // What is solved is left be, so that all the iteration_budget is for what is not.
    if (k >= settings.impulse_iterations) {
      whole_.FreezeConvergedIslands(solved, island_, heap_changes_);
    }
    spent += std::max(1, whole_.constraint_count());
    if (k >= settings.impulse_iterations && spent > iteration_budget) break;
    if (Iterate(world.velocities, step.pool) <= solved) break;
  }
  iteration_budget_.Spend(spent, settings);
}

void ContactSolver::StoreImpulses(std::span<ContactPair> pairs, const StepContext& step,
                                  std::span<Touch> touches) {
  ForgetOverlaps();
  whole_.StoreImpulses(pairs, touches, step.pool);
  CollectPositionConstraints(whole_, step.settings, groups_.overlaps.back());
}

template <class Real>
void ContactSolver::SolveLarge(const Problem& problem,
                               std::span<SolverVelocity<Real>> velocities,
                               Groups<Real>& groups) {
  const Settings& settings = problem.step.settings;
  ThreadPool& pool = problem.step.pool;
  const ContactRules rules = RulesOf(settings, problem.step.h);
  const int sweeps = settings.impulse_iterations - settings.impulse_iterations / 8;
  const auto solve = [&](const Part& part, ConstraintGroup<Real>& group,
                         Overlaps<Real>& overlaps, ThreadPool& helpers) {
    group.Begin(std::span(ordered_).subspan(part.begin, part.end - part.begin),
                problem.pairs, problem.world, rules, velocities, helpers);
    const double solved = settings.residual * group.scale();
    for (int k = 1; k <= sweeps; ++k) {
      // The last sweep leaves what it solves last without overshoot.
      const double relaxation = k < sweeps ? kRelaxation : 1;
      if (group.Iterate(relaxation, velocities, helpers) <= solved) break;
    }
    group.Apply(problem.world, helpers);
    group.StoreImpulses(problem.pairs, problem.touches, helpers);
    CollectPositionConstraints(group, settings, overlaps);
  };

  const std::size_t threads = groups.own.size();
  const auto is_large = [&](const Part& part) {
    return threads > 1 && (part.contacts > kLargePart || parts_.size() == 1);
  };
  int left = contacts_;
  for (const Part& part : parts_) {
    if (!is_large(part)) continue;
    solve(part, groups.shared, groups.overlaps.back(), pool);
    left -= part.contacts;
  }
  // The others are shared out, to each thread about as many contacts.
  const std::size_t least = left < kFewContacts ? threads + 1 : 0;
  pool.ParallelFor(threads, least, [&](std::size_t begin, std::size_t end) {
    for (std::size_t thread = begin; thread < end; ++thread) {
      long before = 0;
      for (const Part& part : parts_) {
        if (is_large(part)) continue;
        const long middle = before + part.contacts / 2;
        before += part.contacts;
        if (static_cast<std::size_t>(middle) * threads / static_cast<std::size_t>(left) !=
            thread) {
          continue;
        }
        solve(part, groups.own[thread], groups.overlaps[thread], alone_);
      }
    }
  });
}

bool ContactSolver::FindPositionCorrections(const StepMotion& motion,
                                            const StepContext& step,
                                            std::span<Velocity> corrections) {
  if (!is_single_) {
    return cookbook::FindPositionCorrections<double>(groups_.overlaps, is_large_, motion,
                                                     step, corrections);
  }
  const bool moved = cookbook::FindPositionCorrections<float>(
      single_groups_.overlaps, is_large_, motion, step, single_);
  if (moved) std::transform(single_.begin(), single_.end(), corrections.begin(), Exact);
  return moved;
}

}  // namespace cookbook
