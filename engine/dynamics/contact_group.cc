#include "engine/dynamics/contact_group.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace cookbook {
namespace {

/** Batches of a colour below which it does not pay to wake another thread: a batch takes
 about a quarter of a microsecond. */
constexpr std::size_t kFewBatches = 48;

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

}  // namespace

void Overlaps::Clear() {
  batches.clear();
  rows.clear();
  firsts.clear();
  groups.clear();
}

void ContactGroup::LayOut(std::span<const ColouredPair> ordered, int nobody) {
  batches_.clear();
  firsts_.clear();
  row_count_ = 0;
  int rows = 0;
  int colour = -1;
  std::size_t lane = 4;
  for (const ColouredPair& next : ordered) {
    const bool starts_colour = next.colour != colour || next.colour == kLastColour;
    if (lane == 4 || starts_colour) {
      if (starts_colour) firsts_.push_back(batches_.size());
      colour = next.colour;
      lane = 0;
      ContactBatch& batch = batches_.emplace_back();
      batch.pair.fill(-1);
      batch.A.fill(nobody);
      batch.B.fill(nobody);
      batch.first = rows;
      batch.count = 0;
      batch.at_work = true;
    }
    ContactBatch& batch = batches_.back();
    batch.pair[lane] = next.pair;
    batch.A[lane] = next.A;
    batch.B[lane] = next.B;
    row_count_ += next.count;
    rows += std::max(0, next.count - batch.count);
    batch.count = std::max(batch.count, next.count);
    ++lane;
  }
  firsts_.push_back(batches_.size());
  contacts_.resize(static_cast<std::size_t>(rows));
}

template <class Work>
void ContactGroup::ShareByColour(Crew& crew, const Work& work) {
  for (std::size_t k = 0; k + 1 < firsts_.size(); ++k) {
    const std::span<ContactBatch> colour =
        std::span(batches_).subspan(firsts_[k], firsts_[k + 1] - firsts_[k]);
    crew.Share(colour.size(), kFewBatches, [&](std::size_t begin, std::size_t end) {
      work(ContactRows{colour.subspan(begin, end - begin), contacts_});
    });
  }
}

void ContactGroup::Begin(std::span<const ColouredPair> ordered,
                         std::span<const ContactPair> pairs, const SolverBodies& world,
                         const ContactRules& rules, bool warm_starting, Crew& crew) {
  rules_ = rules;
  LayOut(ordered, static_cast<int>(world.bodies.size()));
  Greatest scale;
  ShareByColour(crew, [&](const ContactRows& rows) {
    scale.Note(PrepareContacts(rows, rules, pairs, world, warm_starting));
  });
  scale_ = scale.value();
  // All rows have seen the velocities without impulses: now apply those to start from.
  ShareByColour(crew,
                [&](const ContactRows& rows) { ApplyImpulses(rows, world.velocities); });
}

double ContactGroup::Sweep(double relaxation, std::span<Velocity> velocities,
                           Crew& crew) {
  Greatest change;
  Greatest closeness(-std::numeric_limits<double>::infinity());  // −(least change).
  ShareByColour(crew, [&](const ContactRows& rows) {
    const Changes changes = SweepContacts(rows, rules_, relaxation, velocities);
    change.Note(changes.greatest);
    closeness.Note(-changes.least);
  });
  least_change_ = -closeness.value();
  return change.value();
}

void ContactGroup::LeaveBe(double solved, std::span<const int> heaps,
                           std::span<double> heap_changes) {
  if (least_change_ > solved) return;  // No pair is solved, and so no heap.
  // A lane of its own says of each pair which of its bodies moves; both are in one heap.
  const auto change_of = [&](const ContactBatch& batch, std::size_t lane) -> double& {
    const int body = batch.inverse_mass_A[lane] > 0 ? batch.A[lane] : batch.B[lane];
    return heap_changes[static_cast<std::size_t>(heaps[static_cast<std::size_t>(body)])];
  };
  const auto for_each_pair = [&](const auto& visit) {
    for (ContactBatch& batch : batches_) {
      for (std::size_t lane = 0; lane < 4; ++lane) {
        if (batch.pair[lane] >= 0) visit(batch, lane);
      }
    }
  };
  for_each_pair(
      [&](const ContactBatch& batch, std::size_t lane) { change_of(batch, lane) = 0; });
  for_each_pair([&](const ContactBatch& batch, std::size_t lane) {
    if (!batch.at_work) return;
    double& change = change_of(batch, lane);
    change = std::max(change, batch.change[lane]);
  });
  row_count_ = 0;
  for (ContactBatch& batch : batches_) batch.at_work = false;
  for_each_pair([&](ContactBatch& batch, std::size_t lane) {
    if (change_of(batch, lane) <= solved) return;
    batch.at_work = true;
    for (int k = 0; k < batch.count; ++k) {
      row_count_ +=
          contacts_[static_cast<std::size_t>(batch.first) + static_cast<std::size_t>(k)]
              .used[lane] != 0;
    }
  });
}

void ContactGroup::Note(const ContactBatch& batch, const OverlapNotes& notes) const {
  std::vector<OverlapBatch>& batches = notes.overlaps->batches;
  std::vector<OverlapLanes>& rows = notes.overlaps->rows;
  const std::size_t first = rows.size();
  for (int k = 0; k < batch.count; ++k) {
    const ContactLanes& contact =
        contacts_[static_cast<std::size_t>(batch.first) + static_cast<std::size_t>(k)];
    Lanes mass{};
    bool any = false;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const bool counts = contact.used[lane] != 0 && contact.bounces[lane] == 0 &&
                          contact.separation[lane] < -batch.slack[lane];
      if (!counts) continue;
      any = true;
      mass[lane] = notes.turns
                       ? 1 / contact.response[lane]
                       : 1 / (batch.inverse_mass_A[lane] + batch.inverse_mass_B[lane]);
    }
    if (!any) continue;
    OverlapLanes& overlap = rows.emplace_back();
    overlap.r_A = contact.r_A;
    overlap.r_B = contact.r_B;
    overlap.mass = mass;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      overlap.depth[lane] = -contact.separation[lane] - batch.slack[lane];
    }
  }
  if (rows.size() == first) return;
  OverlapBatch& noted = batches.emplace_back();
  noted.A = batch.A;
  noted.B = batch.B;
  noted.first = static_cast<int>(first);
  noted.count = static_cast<int>(rows.size() - first);
  noted.n = batch.n;
  noted.usual = batch.usual;
  noted.inverse_mass_A = batch.inverse_mass_A;
  noted.inverse_mass_B = batch.inverse_mass_B;
  noted.inverse_inertia_A = notes.turns ? batch.inverse_inertia_A : TensorLanes{};
  noted.inverse_inertia_B = notes.turns ? batch.inverse_inertia_B : TensorLanes{};
}

void ContactGroup::End(std::span<ContactPair> pairs, std::span<Touch> touches,
                       const OverlapNotes& notes) {
  const std::span<const ContactBatch> batches = batches_;
  ReadContacts({batches_, contacts_}, pairs, touches);
  if (notes.overlaps == nullptr) return;
  notes.overlaps->groups.push_back(notes.overlaps->batches.size());
  for (std::size_t k = 0; k + 1 < firsts_.size(); ++k) {
    notes.overlaps->firsts.push_back(notes.overlaps->batches.size());
    for (const ContactBatch& batch :
         batches.subspan(firsts_[k], firsts_[k + 1] - firsts_[k])) {
      Note(batch, notes);
    }
  }
}

}  // namespace cookbook
