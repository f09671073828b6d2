#include "engine/dynamics/contact_solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

namespace cookbook {
namespace {

/** Contacts of a manifold. */
constexpr int kMost = 8;
/** Contacts of a part: its rows, of 200 bytes a contact, stay in a cache of 256 KiB, and
 the batches that its colours leave unfilled are few. */
constexpr int kPart = 1000;
/** A part of more contacts is solved by all threads, colour after colour. */
constexpr int kLargePart = 2 * kPart;
/** By how much a large world makes up for what is missing: a stack passes on a load
 sooner, and seven such sweeps leave less than eight others. */
constexpr double kRelaxation = 1.4;
/** Contacts below which it does not pay to wake another thread. */
constexpr int kFewContacts = 200;

ContactRules RulesOf(const Settings& settings, double h) {
  ContactRules rules{};
  rules.h = h;
  rules.resting_speed = settings.resting_speed;
  rules.soft_mass_scale = 1;
  rules.accumulated = settings.accumulated_impulses;
  if (settings.stabilisation == Stabilisation::kBaumgarte) {
    rules.baumgarte = settings.projection_share / h;
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

/** Returns what is noted of overlaps, if anything is, in `overlaps`. */
OverlapNotes RulesOfOverlap(const Settings& settings, Overlaps& overlaps) {
  const bool turns = settings.stabilisation == Stabilisation::kNonLinearProjection;
  const bool projects =
      turns || settings.stabilisation == Stabilisation::kLinearProjection;
  return {turns, projects ? &overlaps : nullptr};
}

}  // namespace

ContactSolver::ContactSolver(int threads)
    : own_(static_cast<std::size_t>(threads)),
      overlaps_(static_cast<std::size_t>(threads) + 1) {}

void ContactSolver::ColourAndJoin(std::span<const ContactPair> pairs,
                                  std::span<const RigidBody> bodies) {
  colours_.assign(bodies.size(), 0);
  static_.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i)
    static_[i] = bodies[i].is_static() ? 1 : 0;
  heaps_.Reset(bodies.size());
  coloured_.clear();
  contacts_ = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const ContactPair& pair = pairs[p];
    const auto a = static_cast<std::size_t>(pair.A);
    const auto b = static_cast<std::size_t>(pair.B);
    if (pair.manifold.count == 0 || (static_[a] && static_[b])) continue;
    contacts_ += pair.manifold.count;
    const int colour = std::min(kLastColour, std::countr_one(colours_[a] | colours_[b]));
    const std::uint64_t bit = std::uint64_t{1} << colour;
    if (!static_[a]) colours_[a] |= bit;
    if (!static_[b]) colours_[b] |= bit;
    coloured_.push_back(
        {static_cast<int>(p), colour, pair.A, pair.B, pair.manifold.count});
    if (!static_[a] && !static_[b]) heaps_.Join(pair.A, pair.B);
  }
  heap_ = heaps_.All();
}

void ContactSolver::Divide(std::size_t bodies, int least) {
  // Of a heap first its contacts, then its part.
  heap_part_.assign(bodies, 0);
  part_.clear();
  for (const ColouredPair& pair : coloured_) {
    const int moving = static_[static_cast<std::size_t>(pair.A)] ? pair.B : pair.A;
    part_.push_back(heap_[static_cast<std::size_t>(moving)]);
    heap_part_[static_cast<std::size_t>(part_.back())] += pair.count;
  }
  parts_.clear();
  for (int& heap : heap_part_) {
    if (heap == 0) continue;
    if (parts_.empty() || parts_.back().contacts >= least) parts_.emplace_back();
    parts_.back().contacts += heap;
    heap = static_cast<int>(parts_.size()) - 1;
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
  starts_.assign(kColours * (kMost + 1) + 1, 0);
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

OverlapNotes ContactSolver::NotesIn(Overlaps& overlaps) const {
  OverlapNotes notes = notes_;
  if (notes.overlaps != nullptr) notes.overlaps = &overlaps;
  return notes;
}

void ContactSolver::Solve(std::span<ContactPair> pairs, const SolverBodies& world,
                          const Settings& settings, double h, Crew& crew,
                          std::span<Touch> touches) {
  for (Overlaps& overlaps : overlaps_) overlaps.Clear();
  if (pairs.empty()) return;
  const ContactRules rules = RulesOf(settings, h);
  notes_ = RulesOfOverlap(settings, overlaps_.back());
  ColourAndJoin(pairs, world.bodies);
  // A world that may be swept more often than any world is solved as a whole: the sweeps
  // that one heap leaves over are for the others.
  const bool is_small = IsSmall(settings, contacts_);
  Divide(world.bodies.size(), is_small ? contacts_ : kPart);
  Order();
  heap_changes_.resize(world.bodies.size());
  const bool warm_starting = settings.warm_starting && settings.accumulated_impulses;
  const long patience = is_small ? patience_.Left(settings) : settings.patience;
  const int sweeps =
      settings.impulse_iterations - (is_small ? 0 : settings.impulse_iterations / 8);

  const auto solve = [&](const Part& part, ContactGroup& group, Overlaps& overlaps,
                         Crew& helpers) {
    group.Begin(std::span(ordered_).subspan(part.begin, part.end - part.begin), pairs,
                world, rules, warm_starting, helpers);
    const double solved = settings.residual * group.scale();
    long spent = 0;
    for (int k = 0;; ++k) {
      // What is solved is left be, so that all the patience is for what is not.
      if (k >= sweeps) {
        if (!is_small) break;
        group.LeaveBe(solved, heap_, heap_changes_);
      }
      spent += std::max(1, group.row_count());
      if (k >= sweeps && spent > patience) break;
      // The last sweep leaves what it solves last without overshoot.
      const bool relaxes = !is_small && k + 1 < sweeps;
      if (group.Sweep(relaxes ? kRelaxation : 1, world.velocities, helpers) <= solved)
        break;
    }
    // A small world is one part: no other thread is here.
    if (is_small) patience_.Spend(spent, settings);
    group.End(pairs, touches, NotesIn(overlaps));
  };

  const auto is_large = [&](const Part& part) {
    return own_.size() > 1 && (part.contacts > kLargePart || parts_.size() == 1);
  };
  int left = contacts_;
  for (const Part& part : parts_) {
    if (!is_large(part)) continue;
    solve(part, whole_, overlaps_.back(), crew);
    left -= part.contacts;
  }
  // The others are shared out, to each thread about as many contacts.
  const std::size_t threads = own_.size();
  const std::size_t least = left < kFewContacts ? threads + 1 : 0;
  crew.Share(threads, least, [&](std::size_t begin, std::size_t end) {
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
        solve(part, own_[thread], overlaps_[thread], alone_);
      }
    }
  });
}

void ContactSolver::Begin(std::span<const ContactPair> pairs, const SolverBodies& world,
                          const Settings& settings, double h, Crew& crew) {
  notes_ = RulesOfOverlap(settings, overlaps_.back());
  ColourAndJoin(pairs, world.bodies);
  Divide(world.bodies.size(), contacts_);
  Order();
  whole_.Begin(ordered_, pairs, world, RulesOf(settings, h),
               settings.warm_starting && settings.accumulated_impulses, crew);
}

double ContactSolver::Sweep(std::span<Velocity> velocities, Crew& crew) {
  return whole_.Sweep(1, velocities, crew);
}

void ContactSolver::End(std::span<ContactPair> pairs, std::span<Touch> touches) {
  for (Overlaps& overlaps : overlaps_) overlaps.Clear();
  whole_.End(pairs, touches, NotesIn(overlaps_.back()));
}

}  // namespace cookbook
