#include "oracles/cookbook/cookbook_batch_oracle.h"

#include "engine/box_batch.h"
#include "oracles/cookbook/translate.h"
#include "oracles/no_answer.h"

namespace touchstone {
namespace {

constexpr const char* kBoxesOnly = "the cookbook's batch call takes two boxes only";

bool AreBoxes(const ContactQuery& query) {
  return KindOf(query.A.shape) == ShapeKind::kBox &&
         KindOf(query.B.shape) == ShapeKind::kBox;
}

void SetPair(cookbook::BoxBatch& batch, std::size_t index, const ContactQuery& query) {
  batch.Set(index, ToCookbook(std::get<Box>(query.A.shape)), ToCookbook(query.A.X_WB),
            ToCookbook(std::get<Box>(query.B.shape)), ToCookbook(query.B.X_WB));
}

class PreparedGaps final : public PreparedBatch {
 public:
  explicit PreparedGaps(std::span<const ContactQuery> queries) : batch_(queries.size()) {
    for (std::size_t k = 0; k < queries.size(); ++k) SetPair(batch_, k, queries[k]);
  }

  void Run() override { batch_.FindGaps(); }
  std::span<const double> separations() const override { return batch_.separations(); }

 private:
  cookbook::BoxBatch batch_;
};

}  // namespace

CookbookBatchOracle::CookbookBatchOracle() {
  info_.name = "cookbook/batch";
  info_.library = "Touchstone";
  info_.version = "0.1.0";
  for (auto& row : info_.capabilities) {
    for (Capability& capability : row) capability.reason = kBoxesOnly;
  }
  constexpr auto kBox = static_cast<std::size_t>(ShapeKind::kBox);
  Capability& boxes = info_.capabilities[kBox][kBox];
  boxes = {};
  boxes.supported = true;
  boxes.family = "sat";
  boxes.depth = true;
  boxes.normal = true;
  info_.settings = {{"separation of boxes apart", "left out",
                     "the axis test gives only a lower bound"}};
}

void CookbookBatchOracle::Answer(std::span<const ContactQuery> queries,
                                 std::span<ContactAnswer> answers) const {
  std::vector<std::size_t> asked;
  for (std::size_t k = 0; k < queries.size(); ++k) {
    if (AreBoxes(queries[k])) {
      asked.push_back(k);
    } else {
      answers[k] = UnsupportedAnswer(kBoxesOnly);
    }
  }
  cookbook::BoxBatch batch(asked.size());
  for (std::size_t k = 0; k < asked.size(); ++k) SetPair(batch, k, queries[asked[k]]);
  batch.FindGaps();
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const cookbook::BoxGap gap = batch.gap(k);
    ContactAnswer& answer = answers[asked[k]];
    answer = {};
    answer.status = AnswerStatus::kAnswered;
    answer.touching = gap.separation <= 0;
    answer.n_AB_W = gap.n_AB_W;
    if (answer.touching) answer.separation = gap.separation;
  }
}

std::unique_ptr<PreparedBatch> CookbookBatchOracle::Prepare(
    std::span<const ContactQuery> queries) const {
  return std::make_unique<PreparedGaps>(queries);
}

}  // namespace touchstone
