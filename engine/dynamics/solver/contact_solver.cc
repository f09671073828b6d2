#include "engine/dynamics/solver/contact_solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <type_traits>

#include "engine/dynamics/solver/position_correction.h"

namespace cookbook {
namespace {

/** Greatest number of contacts of a pair. */
constexpr int kMaxContactsPerPair = 8;
/** Number of contacts of a group. Its constraints, about 220 bytes for each contact or
 110 in single precision, fit in a cache of 256 KiB, and there are few batches that a
 colour does not fill. */
constexpr int kGroupContacts = 1000;
/** A group of more contacts is solved by all threads together, colour after colour. */
constexpr int kSharedGroupContacts = 2 * kGroupContacts;
/** Over-relaxation of the normal impulses in the first iterations. A stack passes on
 loads faster: seven such iterations left less error than eight without over-relaxation.
 */
constexpr double kRelaxation = 1.4;
/** Number of contacts from which solving groups in parallel pays. */
constexpr int kMinParallelContacts = 200;

ContactParameters MakeContactParameters(const Settings& settings, double h,
                                        double restitution_factor) {
  ContactParameters parameters{};
  parameters.h = h;
  parameters.restitution_threshold_factor = settings.restitution_threshold_factor;
  parameters.restitution_factor = restitution_factor;
  parameters.soft_mass_scale = 1;
  parameters.accumulated = settings.accumulated_impulses;
  parameters.warm_starting = settings.warm_starting && settings.accumulated_impulses;
  const bool may_yield =
      parameters.warm_starting && settings.stabilisation != Stabilisation::kSoft;
  const double yield_omega = 2 * std::numbers::pi * settings.contact_frequency;
  const double damping = yield_omega * yield_omega * settings.contact_retardation;
  parameters.yield = may_yield ? 1 / (1 + damping * h) : 0;
  parameters.sag_time = may_yield ? 1 / (h * yield_omega * yield_omega) : 0;
  parameters.mean_load_fraction = h / (h + settings.contact_retardation);
  if (settings.stabilisation == Stabilisation::kBaumgarte) {
    parameters.baumgarte = settings.position_correction_fraction / h;
  } else if (settings.stabilisation == Stabilisation::kSoft) {
    // A damped spring stepped implicitly (Catto 2011): ω = 2π f, damping ratio ζ.
    const double omega =
        2 * std::numbers::pi * std::min(settings.soft_frequency, 0.125 / h);
    const double a1 = 2 * settings.soft_damping_ratio + h * omega;
    const double a2 = h * omega * a1;
    const double a3 = 1 / (1 + a2);
    parameters.soft_rate = omega / a1;
    parameters.soft_mass_scale = a2 * a3;
    parameters.soft_impulse_scale = a3;
  }
  return parameters;
}

Velocity ToDouble(const SingleVelocity& velocity) {
  const Eigen::Map<const Eigen::Matrix<float, 6, 1>> numbers(velocity.numbers.data());
  return {numbers.head<3>().cast<double>(), numbers.tail<3>().cast<double>()};
}

bool CorrectsPositions(const Settings& settings) {
  return settings.stabilisation == Stabilisation::kSplitImpulse ||
         settings.stabilisation == Stabilisation::kDeepestContact;
}

/** Collects the contacts of a group that are too deep, if positions are corrected. */
template <class Real>
void CollectPositionConstraints(ConstraintGroup<Real>& group, const Settings& settings,
                                PositionConstraints<Real>& constraints) {
  if (!CorrectsPositions(settings)) return;
  group.CollectPositionConstraints(settings.stabilisation == Stabilisation::kSplitImpulse,
                                   constraints);
}

}  // namespace

bool FitsSinglePrecision(const RigidBody& body) {
  constexpr double kMaxMass = 1e6;   // [kg]; the least mass is its inverse.
  constexpr double kMaxRatio = 1e3;  // r² I⁻¹ relative to 1/m; 2.5 for a ball.
  if (body.is_static() || body.is_point) return true;
  const double rotational = body.radius * body.radius * body.inverse_moments.maxCoeff();
  const double least = body.inverse_moments.minCoeff();
  return body.inverse_mass <= kMaxMass && body.inverse_mass >= 1 / kMaxMass &&
         rotational <= kMaxRatio * body.inverse_mass &&
         body.inverse_moments.maxCoeff() <= kMaxRatio * least;
}

ContactSolver::ContactSolver(int threads)
    : double_groups_(static_cast<std::size_t>(threads)),
      float_groups_(static_cast<std::size_t>(threads)) {}

void ContactSolver::BuildConstraintGraph(std::span<const PairSummary> summaries,
                                         std::span<const char> is_static) {
  body_colours_.assign(is_static.size(), 0);
  islands_.Reset(is_static.size());
  coloured_pairs_.clear();
  colours_used_ = 0;
  contact_count_ = 0;
  for (std::size_t p = 0; p < summaries.size(); ++p) {
    const PairSummary& pair = summaries[p];
    const auto a = static_cast<std::size_t>(pair.A);
    const auto b = static_cast<std::size_t>(pair.B);
    if (pair.count == 0 || (is_static[a] && is_static[b])) continue;
    contact_count_ += pair.count;
    const int colour =
        std::min(kLastColour, std::countr_one(body_colours_[a] | body_colours_[b]));
    const std::uint64_t bit = std::uint64_t{1} << colour;
    if (!is_static[a]) body_colours_[a] |= bit;
    if (!is_static[b]) body_colours_[b] |= bit;
    colours_used_ = std::max(colours_used_, colour + 1);
    coloured_pairs_.push_back({static_cast<int>(p), colour, pair.A, pair.B, pair.count});
    if (!is_static[a] && !is_static[b]) islands_.Unite(pair.A, pair.B);
  }
  island_roots_ = islands_.Roots();
}

void ContactSolver::DivideIntoGroups(std::span<const char> is_static, int min_contacts) {
  // group_of_island_ first holds the number of contacts of an island, then its group;
  // group_of_pair_ first the island of a pair.
  group_of_island_.assign(is_static.size(), 0);
  group_of_pair_.clear();
  for (const ColouredPair& pair : coloured_pairs_) {
    const int moving = is_static[static_cast<std::size_t>(pair.A)] ? pair.B : pair.A;
    group_of_pair_.push_back(island_roots_[static_cast<std::size_t>(moving)]);
    group_of_island_[static_cast<std::size_t>(group_of_pair_.back())] += pair.count;
  }
  group_ranges_.clear();
  for (int& entry : group_of_island_) {
    if (entry == 0) continue;
    if (group_ranges_.empty() || group_ranges_.back().contacts >= min_contacts)
      group_ranges_.emplace_back();
    group_ranges_.back().contacts += entry;
    entry = static_cast<int>(group_ranges_.size()) - 1;
  }
  for (int& group : group_of_pair_) {
    group = group_of_island_[static_cast<std::size_t>(group)];
    ++group_ranges_[static_cast<std::size_t>(group)].end;
  }
  std::size_t begin = 0;
  for (GroupRange& range : group_ranges_) {
    range.begin = begin;
    begin += range.end;
    range.end = range.begin;  // SortPairs() increments it for each pair of the group.
  }
}

void ContactSolver::SortPairs() {
  // A counting sort. In a colour, pairs with more contacts come first, so that the lanes
  // of a batch have similar numbers of contacts.
  const auto key = [](const ColouredPair& pair) {
    return static_cast<std::size_t>(pair.colour * (kMaxContactsPerPair + 1) +
                                    kMaxContactsPerPair - pair.count);
  };
  key_starts_.assign(
      static_cast<std::size_t>(colours_used_ * (kMaxContactsPerPair + 1)) + 1, 0);
  for (const ColouredPair& pair : coloured_pairs_) ++key_starts_[key(pair) + 1];
  std::partial_sum(key_starts_.begin(), key_starts_.end(), key_starts_.begin());
  pairs_by_key_.resize(coloured_pairs_.size());
  for (std::size_t k = 0; k < coloured_pairs_.size(); ++k) {
    pairs_by_key_[static_cast<std::size_t>(key_starts_[key(coloured_pairs_[k])]++)] =
        static_cast<int>(k);
  }
  sorted_pairs_.resize(coloured_pairs_.size());
  for (const int next : pairs_by_key_) {
    const auto k = static_cast<std::size_t>(next);
    sorted_pairs_[group_ranges_[static_cast<std::size_t>(group_of_pair_[k])].end++] =
        coloured_pairs_[k];
  }
}

void ContactSolver::ClearPositionConstraints() {
  for (auto& constraints : double_groups_.position_constraints) constraints.Clear();
  for (auto& constraints : float_groups_.position_constraints) constraints.Clear();
}

void ContactSolver::Solve(std::span<ContactPair> pairs,
                          std::span<const PairSummary> summaries,
                          const SolverBodies& bodies, const StepContext& step,
                          std::span<ContactFlags> contact_flags) {
  ClearPositionConstraints();
  BuildConstraintGraph(summaries, bodies.is_static);
  // ImpactSolver may have taken all contacts.
  if (contact_count_ == 0) return;
  const Problem problem{pairs, bodies, step, contact_flags};
  free_velocities_.assign(bodies.velocities.begin(), bodies.velocities.end());
  const long remaining = iteration_budget_.Remaining(step.settings, contact_count_);
  const bool may_converge = remaining >= contact_count_;
  const long extra_work = may_converge ? remaining : 0;
  // One group if they may converge: iterations that one island does not need are
  // available to the others.
  DivideIntoGroups(bodies.is_static, may_converge ? contact_count_ : kGroupContacts);
  SortPairs();
  is_single_precision_ =
      step.settings.single_precision && !may_converge && bodies.fit_single_precision;
  has_converged_ = true;
  long work_spent = SolveGroups(problem, 1, extra_work);
  if (AddsEnergy(problem, free_velocities_)) {
    work_spent += SolveGroups(problem, 0, extra_work);
    BlendRestitution(problem);
  }
  iteration_budget_.Spend(work_spent, step.settings, contact_count_);
}

long ContactSolver::SolveGroups(const Problem& problem, double restitution_factor,
                                long extra_work) {
  if (is_single_precision_) {
    single_velocities_.assign(problem.bodies.velocities.size(), {});
    return SolveGroups<float>(problem, restitution_factor, extra_work, single_velocities_,
                              float_groups_);
  }
  double_velocities_.assign(free_velocities_.begin(), free_velocities_.end());
  return SolveGroups<double>(problem, restitution_factor, extra_work, double_velocities_,
                             double_groups_);
}

void ContactSolver::Begin(std::span<const ContactPair> pairs,
                          std::span<const PairSummary> summaries,
                          const SolverBodies& bodies, const StepContext& step,
                          bool impacts_resolved) {
  BuildConstraintGraph(summaries, bodies.is_static);
  BeginWholeWorld(pairs, bodies, step, 1, impacts_resolved);
}

void ContactSolver::BeginWholeWorld(std::span<const ContactPair> pairs,
                                    const SolverBodies& bodies, const StepContext& step,
                                    double restitution_factor, bool impacts_resolved) {
  is_single_precision_ = false;
  acceleration_.Reset();
  DivideIntoGroups(bodies.is_static, contact_count_);
  SortPairs();
  ContactParameters parameters =
      MakeContactParameters(step.settings, step.h, restitution_factor);
  parameters.impacts_resolved = impacts_resolved;
  if (impacts_resolved) parameters.yield = parameters.sag_time = 0;
  whole_world_.Begin(sorted_pairs_, pairs, bodies, parameters, bodies.velocities,
                     step.pool);
}

double ContactSolver::Iterate(std::span<Velocity> velocities, ThreadPool& pool) {
  return whole_world_.Iterate(1, velocities, pool);
}

void ContactSolver::StoreImpulses(std::span<ContactPair> pairs, const StepContext& step,
                                  std::span<ContactFlags> contact_flags) {
  ClearPositionConstraints();
  whole_world_.StoreImpulses(pairs, contact_flags, step.pool);
  CollectPositionConstraints(whole_world_, step.settings,
                             double_groups_.position_constraints.back());
}

void ContactSolver::StoreSolution(const Problem& problem,
                                  std::span<const Velocity> free) {
  std::copy(free.begin(), free.end(), problem.bodies.velocities.begin());
  whole_world_.ApplyToBodies(problem.bodies, problem.step.pool);
  StoreImpulses(problem.pairs, problem.step, problem.contact_flags);
}

bool ContactSolver::Finish(const Problem& problem, std::span<const Velocity> free,
                           bool has_converged) {
  StoreSolution(problem, free);
  has_converged_ = has_converged;
  if (!AddsEnergy(problem, free)) return false;
  BeginWholeWorld(problem.pairs, problem.bodies, problem.step, 0, false);
  return true;
}

void ContactSolver::FinishWithLessRestitution(const Problem& problem,
                                              std::span<const Velocity> free) {
  StoreSolution(problem, free);
  BlendRestitution(problem);
}

bool ContactSolver::AddsEnergy(const Problem& problem, std::span<const Velocity> free) {
  const std::span<const ContactFlags> flags = problem.contact_flags;
  const auto bounced = [](const ContactFlags& body) { return body.bounced; };
  if (has_converged_ && std::none_of(flags.begin(), flags.end(), bounced)) return false;
  const SolverBodies& bodies = problem.bodies;
  if (!restitution_limit_.Exceeds(problem.pairs, coloured_pairs_, bodies, free,
                                  island_roots_))
    return false;
  bounce_flags_.assign(flags.begin(), flags.end());
  std::copy(free.begin(), free.end(), bodies.velocities.begin());
  ClearPositionConstraints();
  return true;
}

void ContactSolver::BlendRestitution(const Problem& problem) {
  std::copy(bounce_flags_.begin(), bounce_flags_.end(), problem.contact_flags.begin());
  restitution_limit_.Blend(problem.pairs, coloured_pairs_, problem.bodies, island_roots_);
}

template <class Real>
long ContactSolver::IterateGroup(ConstraintGroup<Real>& group, const Problem& problem,
                                 const ContactParameters& parameters, long extra_work,
                                 std::span<SolverVelocity<Real>> velocities,
                                 ThreadPool& pool) {
  const Settings& settings = problem.step.settings;
  const double solved = settings.residual * group.max_speed();
  for (int k = 1; k <= settings.impulse_iterations; ++k) {
    // No overshoot in the last iteration.
    const double relaxation = k < settings.impulse_iterations ? kRelaxation : 1;
    if (group.Iterate(relaxation, velocities, pool) <= solved) return 0;
  }
  long spent = 0;
  if constexpr (std::is_same_v<Real, double>) {
    if (extra_work < group.constraint_count()) return 0;
    // Islands that have not converged yet may be in static equilibrium.
    const bool any_rests = settings.static_equilibrium && parameters.accumulated &&
                           parameters.soft_impulse_scale == 0 &&
                           parameters.baumgarte == 0 &&
                           static_equilibrium_.Solve(group.view(), island_roots_, solved,
                                                     problem.bodies, velocities);
    island_changes_.resize(velocities.size());
    for (bool any_is_solved = any_rests;; any_is_solved = false) {
      // Spend the work on the islands that have not converged.
      if (any_is_solved || group.min_change() <= solved)
        group.FreezeConvergedIslands(solved, island_roots_, island_changes_);
      spent += std::max(1, group.constraint_count());
      has_converged_ = spent <= extra_work;
      if (!has_converged_ || group.Iterate(1, velocities, pool) <= solved) break;
    }
    if (any_rests) static_equilibrium_.Apply(group.view(), velocities);
  }
  return spent;
}

template <class Real>
long ContactSolver::SolveGroups(const Problem& problem, double restitution_factor,
                                long extra_work,
                                std::span<SolverVelocity<Real>> velocities,
                                ThreadGroups<Real>& groups) {
  const Settings& settings = problem.step.settings;
  ThreadPool& pool = problem.step.pool;
  const ContactParameters parameters =
      MakeContactParameters(settings, problem.step.h, restitution_factor);
  long work_spent = 0;
  const auto solve = [&](const GroupRange& range, ConstraintGroup<Real>& group,
                         PositionConstraints<Real>& deep, ThreadPool& group_pool) {
    group.Begin(std::span(sorted_pairs_).subspan(range.begin, range.end - range.begin),
                problem.pairs, problem.bodies, parameters, velocities, group_pool);
    const long spent =
        IterateGroup(group, problem, parameters, extra_work, velocities, group_pool);
    // Only a single group has extra work.
    if (spent > 0) work_spent = spent;
    group.ApplyToBodies(problem.bodies, group_pool);
    group.StoreImpulses(problem.pairs, problem.contact_flags, group_pool);
    CollectPositionConstraints(group, settings, deep);
  };

  const std::size_t threads = groups.own.size();
  // Large groups are solved by all threads together.
  const auto is_shared = [&](const GroupRange& range) {
    return threads > 1 &&
           (range.contacts > kSharedGroupContacts || group_ranges_.size() == 1);
  };
  int remaining = contact_count_;
  for (const GroupRange& range : group_ranges_) {
    if (!is_shared(range)) continue;
    solve(range, groups.shared, groups.position_constraints.back(), pool);
    remaining -= range.contacts;
  }
  // The others are distributed, about the same number of contacts to each thread.
  const std::size_t min_count = remaining < kMinParallelContacts ? threads + 1 : 0;
  pool.ParallelFor(threads, min_count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t thread = begin; thread < end; ++thread) {
      long before = 0;
      for (const GroupRange& range : group_ranges_) {
        if (is_shared(range)) continue;
        const long middle = before + range.contacts / 2;
        before += range.contacts;
        if (static_cast<std::size_t>(middle) * threads /
                static_cast<std::size_t>(remaining) !=
            thread) {
          continue;
        }
        solve(range, groups.own[thread], groups.position_constraints[thread],
              one_thread_);
      }
    }
  });
  return work_spent;
}

bool ContactSolver::FindPositionCorrections(const StepMotion& motion,
                                            const StepContext& step,
                                            std::span<Velocity> corrections) {
  if (!is_single_precision_) {
    return cookbook::FindPositionCorrections<double>(double_groups_.position_constraints,
                                                     motion, step, corrections);
  }
  const bool corrected = cookbook::FindPositionCorrections<float>(
      float_groups_.position_constraints, motion, step, single_velocities_);
  if (corrected)
    std::transform(single_velocities_.begin(), single_velocities_.end(),
                   corrections.begin(), ToDouble);
  return corrected;
}

}  // namespace cookbook
