#include "reports/bench/contact_bench.h"

#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/reports/fake_oracle.h"

namespace touchstone {
namespace {

/** A batch that does nothing. */
class EmptyBatch final : public PreparedBatch {
 public:
  void Run() override {}
  std::span<const double> separations() const override { return {}; }
};

/** A fake oracle that can be timed. */
class TimedOracle final : public FakeOracle {
 public:
  using FakeOracle::FakeOracle;
  std::unique_ptr<PreparedBatch> Prepare(std::span<const ContactQuery>) const override {
    return std::make_unique<EmptyBatch>();
  }
};

ContactBench Bench(const Oracle& oracle) {
  const std::vector<const Oracle*> oracles = {&oracle};
  return BenchContacts(ShapeKind::kSphere, ShapeKind::kSphere, oracles,
                       {.count = 40, .sample = 20, .seed = 1});
}

TEST(BenchContacts, HasNoErrorForRightAnswers) {
  const ContactBench bench = Bench(TimedOracle("right"));
  EXPECT_EQ(bench.queries, 40u);
  EXPECT_EQ(bench.sample, 20u);
  EXPECT_GT(bench.touching, 0u);
  EXPECT_LT(bench.touching, 20u);
  ASSERT_EQ(bench.rows.size(), 1u);
  EXPECT_TRUE(bench.rows[0].nanoseconds.has_value());
  const SampleAccuracy& accuracy = bench.rows[0].accuracy;
  EXPECT_EQ(accuracy.worst_error, 0);
  EXPECT_EQ(accuracy.measured, 20);
  EXPECT_EQ(accuracy.wrong_verdicts, 0);
  EXPECT_EQ(accuracy.without_answer, 0);
}

TEST(BenchContacts, MeasuresWrongAnswers) {
  const FakeOracle off = FakeOracle::Wrong("off", [](const auto&, ContactAnswer& answer) {
    answer.touching = !answer.touching;
    if (answer.separation) *answer.separation += 0.25;
  });
  const SampleAccuracy accuracy = Bench(off).rows[0].accuracy;
  EXPECT_NEAR(accuracy.worst_error, 0.25, 1e-9);
  EXPECT_EQ(accuracy.wrong_verdicts, 20);
  const FakeOracle silent("silent", [](const ContactQuery&) { return ContactAnswer{}; });
  EXPECT_EQ(Bench(silent).rows[0].accuracy.without_answer, 20);
}

TEST(BenchContacts, DoesNotTimeAnEngineThatRunsInItsOwnProcess) {
  TimedOracle isolated("isolated");
  isolated.info().isolated = true;
  EXPECT_EQ(Bench(isolated).rows[0].nanoseconds, std::nullopt);
}

TEST(BenchContacts, HasNoRowForAnOracleThatDoesNotSupportThePair) {
  TimedOracle unable("unable");
  unable.ForEachPair([](Capability& capability) { capability.supported = false; });
  EXPECT_TRUE(Bench(unable).rows.empty());
}

}  // namespace
}  // namespace touchstone
