#include "engine/dynamics/contact_solver.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace cookbook {
namespace {

/** Colours that pairs are sorted by; the last is for pairs that found none of the others
 free, which are solved one after the other. */
constexpr int kColours = 64;
constexpr int kLastColour = kColours - 1;
/** Batches of a colour below which it does not pay to wake another thread: a batch takes
 about half a microsecond. */
constexpr std::size_t kFewBatches = 24;
/** Contacts of a manifold. */
constexpr int kMost = 8;

/** The greatest of numbers that several threads note. */
class Greatest {
 public:
  explicit Greatest(double start = 0) : value_(start) {}
  void Note(double value) {
    double known = value_.load(std::memory_order_relaxed);
    while (value > known &&
           !value_.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
    }
  }
  double value() const { return value_.load(std::memory_order_relaxed); }

 private:
  std::atomic<double> value_;
};

ContactRules RulesOf(const Settings& settings, double h) {
  ContactRules rules{};
  rules.h = h;
  rules.gravity_speed = h * settings.gravity_W.norm();
  rules.resting_speed = settings.resting_speed;
  rules.slack = SlackOf(settings, h);
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

void Put(const Eigen::Vector3d& v, std::size_t lane, VectorLanes& lanes) {
  for (int k = 0; k < 3; ++k) lanes[static_cast<std::size_t>(k)][lane] = v[k];
}

void Put(const Eigen::Matrix3d& t, std::size_t lane, TensorLanes& lanes) {
  lanes[0][lane] = t(0, 0);
  lanes[1][lane] = t(0, 1);
  lanes[2][lane] = t(0, 2);
  lanes[3][lane] = t(1, 1);
  lanes[4][lane] = t(1, 2);
  lanes[5][lane] = t(2, 2);
}

}  // namespace

void ContactSolver::Colour(std::span<const ContactPair> pairs,
                           std::span<const RigidBody> bodies) {
  // Pairs with more contacts first within a colour, so that the lanes of a batch are
  // about as long as each other.
  colours_.assign(bodies.size(), 0);
  key_.resize(pairs.size());
  starts_.assign(kColours * (kMost + 1) + 1, 0);
  row_count_ = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const ContactPair& pair = pairs[p];
    key_[p] = -1;
    if (pair.manifold.count == 0) continue;
    row_count_ += pair.manifold.count;
    const auto a = static_cast<std::size_t>(pair.A);
    const auto b = static_cast<std::size_t>(pair.B);
    const int colour = std::min(kLastColour, std::countr_one(colours_[a] | colours_[b]));
    const std::uint64_t bit = std::uint64_t{1} << colour;
    if (!bodies[a].is_static()) colours_[a] |= bit;
    if (!bodies[b].is_static()) colours_[b] |= bit;
    key_[p] = colour * (kMost + 1) + kMost - pair.manifold.count;
    ++starts_[static_cast<std::size_t>(key_[p]) + 1];
  }
  for (std::size_t k = 1; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
  order_.resize(static_cast<std::size_t>(starts_.back()));
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (key_[p] < 0) continue;
    order_[static_cast<std::size_t>(starts_[static_cast<std::size_t>(key_[p])]++)] =
        static_cast<int>(p);
  }
}

int ContactSolver::HeapOf(int body) {
  auto i = static_cast<std::size_t>(body);
  while (heap_[i] != static_cast<int>(i)) {
    // Halves the way for the next who asks (Tarjan & van Leeuwen, J. ACM 31, 1984).
    heap_[i] = heap_[static_cast<std::size_t>(heap_[i])];
    i = static_cast<std::size_t>(heap_[i]);
  }
  return static_cast<int>(i);
}

void ContactSolver::FindHeaps(std::span<const ContactPair> pairs,
                              std::span<const RigidBody> bodies) {
  heap_.resize(bodies.size());
  std::iota(heap_.begin(), heap_.end(), 0);
  for (const int p : order_) {
    const ContactPair& pair = pairs[static_cast<std::size_t>(p)];
    if (bodies[static_cast<std::size_t>(pair.A)].is_static() ||
        bodies[static_cast<std::size_t>(pair.B)].is_static()) {
      continue;
    }
    const int a = HeapOf(pair.A);
    const int b = HeapOf(pair.B);
    heap_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
}

void ContactSolver::LeaveBe(double solved) {
  if (least_change_ > solved) return;  // No pair is solved, and so no heap.
  // A lane of its own says of each pair which of its bodies moves; both are in one heap.
  const auto heap_of = [&](const ContactBatch& batch, std::size_t lane) {
    const int body = batch.inverse_mass_A[lane] > 0 ? batch.A[lane] : batch.B[lane];
    return static_cast<std::size_t>(HeapOf(body));
  };
  heap_changes_.assign(heap_.size(), 0);
  for (const ContactBatch& batch : batches_) {
    if (!batch.at_work) continue;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      if (batch.pair[lane] < 0) continue;
      double& change = heap_changes_[heap_of(batch, lane)];
      change = std::max(change, batch.change[lane]);
    }
  }
  row_count_ = 0;
  for (ContactBatch& batch : batches_) {
    batch.at_work = false;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      if (batch.pair[lane] < 0 || heap_changes_[heap_of(batch, lane)] <= solved) continue;
      batch.at_work = true;
      for (int k = 0; k < batch.count; ++k) {
        row_count_ +=
            contacts_[static_cast<std::size_t>(batch.first + k)].used[lane] != 0;
      }
    }
  }
}

void ContactSolver::Fill(std::span<const ContactPair> pairs, const SolverBodies& world,
                         bool warm_starting) {
  batches_.clear();
  contacts_.clear();
  firsts_.clear();
  const int nobody = static_cast<int>(world.bodies.size());
  int colour = -1;
  std::size_t lane = 4;
  for (const int p : order_) {
    const ContactPair& pair = pairs[static_cast<std::size_t>(p)];
    const int colour_here = key_[static_cast<std::size_t>(p)] / (kMost + 1);
    if (lane == 4 || colour_here != colour || colour == kLastColour) {
      if (colour_here != colour || colour == kLastColour)
        firsts_.push_back(batches_.size());
      colour = colour_here;
      lane = 0;
      ContactBatch& batch = batches_.emplace_back();
      batch = {};
      batch.pair.fill(-1);
      batch.A.fill(nobody);
      batch.B.fill(nobody);
      batch.first = static_cast<int>(contacts_.size());
      batch.count = pair.manifold.count;
      batch.at_work = true;
      contacts_.resize(contacts_.size() + static_cast<std::size_t>(batch.count),
                       ContactLanes{});
    }
    const auto a = static_cast<std::size_t>(pair.A);
    const auto b = static_cast<std::size_t>(pair.B);
    const RigidBody& A = world.bodies[a];
    const RigidBody& B = world.bodies[b];
    ContactBatch& batch = batches_.back();
    batch.pair[lane] = p;
    batch.A[lane] = pair.A;
    batch.B[lane] = pair.B;
    const Eigen::Vector3d& n = pair.manifold.n_AB_W;
    const Eigen::Vector3d t1 = n.unitOrthogonal();
    const Eigen::Vector3d t2 = n.cross(t1);
    Put(n, lane, batch.n);
    Put(t1, lane, batch.t1);
    Put(t2, lane, batch.t2);
    batch.friction[lane] = std::sqrt(A.friction * B.friction);
    batch.restitution[lane] = std::min(A.restitution, B.restitution);
    batch.inverse_mass_A[lane] = world.inertias[a].mass;
    batch.inverse_mass_B[lane] = world.inertias[b].mass;
    Put(world.inertias[a].tensor_W, lane, batch.inverse_inertia_A);
    Put(world.inertias[b].tensor_W, lane, batch.inverse_inertia_B);
    for (std::size_t i = 0; i < pair.manifold.points().size(); ++i) {
      const ContactPoint& point = pair.manifold.contacts[i];
      ContactLanes& contact = contacts_[static_cast<std::size_t>(batch.first) + i];
      Put(point.p_WC - A.state.p_WB, lane, contact.r_A);
      Put(point.p_WC - B.state.p_WB, lane, contact.r_B);
      contact.separation[lane] = point.separation;
      contact.used[lane] = 1;
      if (!warm_starting) continue;
      contact.impulse[lane] = std::max(0.0, pair.J_W[i].dot(n));
      contact.friction_impulse1[lane] = pair.J_W[i].dot(t1);
      contact.friction_impulse2[lane] = pair.J_W[i].dot(t2);
    }
    ++lane;
  }
  firsts_.push_back(batches_.size());
}

template <class Work>
void ContactSolver::ShareByColour(Crew& crew, const Work& work) {
  for (std::size_t k = 0; k + 1 < firsts_.size(); ++k) {
    const std::span<ContactBatch> colour =
        std::span(batches_).subspan(firsts_[k], firsts_[k + 1] - firsts_[k]);
    crew.Share(colour.size(), kFewBatches, [&](std::size_t begin, std::size_t end) {
      work(ContactRows{colour.subspan(begin, end - begin), contacts_});
    });
  }
}

void ContactSolver::Begin(std::span<const ContactPair> pairs, const SolverBodies& world,
                          const Settings& settings, double h, Crew& crew) {
  accumulated_ = settings.accumulated_impulses;
  Colour(pairs, world.bodies);
  FindHeaps(pairs, world.bodies);
  Fill(pairs, world, settings.warm_starting && settings.accumulated_impulses);
  const ContactRules rules = RulesOf(settings, h);
  Greatest scale;
  ShareByColour(crew, [&](const ContactRows& rows) {
    scale.Note(PrepareContacts(rows, rules, world.before, world.velocities));
  });
  scale_ = scale.value();
  // All rows have seen the velocities without impulses: now apply those to start from.
  ShareByColour(crew,
                [&](const ContactRows& rows) { ApplyImpulses(rows, world.velocities); });
}

double ContactSolver::Sweep(std::span<Velocity> velocities, Crew& crew) {
  Greatest change;
  Greatest closeness(-std::numeric_limits<double>::infinity());  // −(least change).
  ShareByColour(crew, [&](const ContactRows& rows) {
    const Changes changes = SweepContacts(rows, accumulated_, velocities);
    change.Note(changes.greatest);
    closeness.Note(-changes.least);
  });
  least_change_ = -closeness.value();
  return change.value();
}

void ContactSolver::End(std::span<ContactPair> pairs, std::span<Touch> touches) const {
  for (const ContactBatch& batch : batches_) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      if (batch.pair[lane] < 0) continue;
      const auto at = [&](const VectorLanes& v) {
        return Eigen::Vector3d(v[0][lane], v[1][lane], v[2][lane]);
      };
      const Eigen::Vector3d n = at(batch.n);
      const Eigen::Vector3d t1 = at(batch.t1);
      const Eigen::Vector3d t2 = at(batch.t2);
      ContactPair& pair = pairs[static_cast<std::size_t>(batch.pair[lane])];
      Touch& A = touches[static_cast<std::size_t>(batch.A[lane])];
      Touch& B = touches[static_cast<std::size_t>(batch.B[lane])];
      for (std::size_t i = 0; i < pair.manifold.points().size(); ++i) {
        const ContactLanes& contact =
            contacts_[static_cast<std::size_t>(batch.first) + i];
        pair.J_W[i] = contact.impulse[lane] * n + contact.friction_impulse1[lane] * t1 +
                      contact.friction_impulse2[lane] * t2;
        if (contact.impulse[lane] == 0) continue;
        const bool bounces = contact.bounces[lane] != 0;
        const bool steady = contact.steady[lane] != 0;
        for (Touch* touch : {&A, &B}) {
          touch->bounced = touch->bounced || bounces;
          touch->rested = touch->rested || !bounces;
          touch->steady = touch->steady && steady;
        }
      }
    }
  }
}

}  // namespace cookbook
