#include "oracles/cookbook/cookbook_batch_oracle.h"

#include <limits>
#include <vector>

#include "engine/collision/box_batch.h"
#include "engine/collision/sphere_batch.h"
#include "oracles/cookbook/translate.h"
#include "oracles/no_answer.h"
#include "oracles/stopwatch.h"

namespace touchstone {
namespace {

constexpr const char* kBoxesOrSpheresOnly =
    "the cookbook's batch calls take two boxes or two spheres only";

bool AreBoth(ShapeKind kind, const ContactQuery& query) {
  return KindOf(query.A.shape) == kind && KindOf(query.B.shape) == kind;
}

/** The queries whose two shapes are of one kind, as a batch of the engine. */
template <class Shape, class Batch>
class SortedOut {
 public:
  SortedOut(ShapeKind kind, std::span<const ContactQuery> queries)
      : indices_(IndicesOf(kind, queries)), batch_(indices_.size()) {
    for (std::size_t k = 0; k < indices_.size(); ++k) {
      const ContactQuery& query = queries[indices_[k]];
      batch_.Set(k, ToCookbook(std::get<Shape>(query.A.shape)), ToCookbook(query.A.X_WB),
                 ToCookbook(std::get<Shape>(query.B.shape)), ToCookbook(query.B.X_WB));
    }
  }

  const std::vector<std::size_t>& indices() const { return indices_; }
  const Batch& batch() const { return batch_; }

  /** Finds all gaps and stores each separation at the index of its query. */
  void FindGaps(std::span<double> separations) {
    batch_.FindGaps();
    for (std::size_t k = 0; k < indices_.size(); ++k) {
      separations[indices_[k]] = batch_.separations()[k];
    }
  }

 private:
  static std::vector<std::size_t> IndicesOf(ShapeKind kind,
                                            std::span<const ContactQuery> queries) {
    std::vector<std::size_t> indices;
    for (std::size_t k = 0; k < queries.size(); ++k) {
      if (AreBoth(kind, queries[k])) indices.push_back(k);
    }
    return indices;
  }

  std::vector<std::size_t> indices_;
  Batch batch_;
};

class PreparedGaps final : public PreparedBatch {
 public:
  explicit PreparedGaps(std::span<const ContactQuery> queries)
      : boxes_(ShapeKind::kBox, queries),
        spheres_(ShapeKind::kSphere, queries),
        separations_(queries.size(), std::numeric_limits<double>::quiet_NaN()) {}

  void Run() override {
    boxes_.FindGaps(separations_);
    spheres_.FindGaps(separations_);
  }
  std::span<const double> separations() const override { return separations_; }

  const SortedOut<Box, cookbook::BoxBatch>& boxes() const { return boxes_; }

 private:
  SortedOut<Box, cookbook::BoxBatch> boxes_;
  SortedOut<Sphere, cookbook::SphereBatch> spheres_;
  std::vector<double> separations_;
};

Capability Supported(const char* family) {
  Capability capability;
  capability.supported = true;
  capability.family = family;
  capability.depth = true;
  capability.normal = true;
  return capability;
}

}  // namespace

CookbookBatchOracle::CookbookBatchOracle() {
  info_.name = "cookbook/batch";
  info_.library = "Touchstone";
  info_.version = "0.1.0";
  for (auto& row : info_.capabilities) {
    for (Capability& capability : row) capability.reason = kBoxesOrSpheresOnly;
  }
  constexpr auto kBox = static_cast<std::size_t>(ShapeKind::kBox);
  constexpr auto kSphere = static_cast<std::size_t>(ShapeKind::kSphere);
  info_.capabilities[kBox][kBox] = Supported("sat");
  info_.capabilities[kSphere][kSphere] = Supported("closed_form");
  info_.capabilities[kSphere][kSphere].distance = true;
  info_.settings = {{"separation of boxes apart", "left out",
                     "the separating-axis test yields only a lower bound"}};
}

void CookbookBatchOracle::Answer(std::span<const ContactQuery> queries,
                                 std::span<ContactAnswer> answers) const {
  const Stopwatch watch;
  PreparedGaps gaps(queries);
  gaps.Run();
  const double share = watch.seconds() / static_cast<double>(queries.size());
  for (std::size_t k = 0; k < queries.size(); ++k) {
    const ContactQuery& query = queries[k];
    if (!info_.For(KindOf(query.A.shape), KindOf(query.B.shape)).supported) {
      answers[k] = UnsupportedAnswer(kBoxesOrSpheresOnly);
      continue;
    }
    answers[k] = {};
    answers[k].status = AnswerStatus::kAnswered;
    answers[k].seconds = share;
    answers[k].touching = gaps.separations()[k] <= 0;
    if (AreBoth(ShapeKind::kSphere, query)) {
      answers[k].separation = gaps.separations()[k];
      answers[k].n_AB_W = cookbook::FindGap(ToCookbook(std::get<Sphere>(query.A.shape)),
                                            ToCookbook(query.A.X_WB),
                                            ToCookbook(std::get<Sphere>(query.B.shape)),
                                            ToCookbook(query.B.X_WB))
                              .n_AB_W;
    } else if (answers[k].touching) {
      answers[k].separation = gaps.separations()[k];
    }
  }
  const std::vector<std::size_t>& boxes = gaps.boxes().indices();
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    answers[boxes[k]].n_AB_W = gaps.boxes().batch().gap(k).n_AB_W;
  }
}

std::unique_ptr<PreparedBatch> CookbookBatchOracle::Prepare(
    std::span<const ContactQuery> queries) const {
  return std::make_unique<PreparedGaps>(queries);
}

}  // namespace touchstone
