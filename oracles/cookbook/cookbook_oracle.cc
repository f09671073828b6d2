#include "oracles/cookbook/cookbook_oracle.h"

#include <tuple>
#include <type_traits>

#include "engine/collision/collide.h"
#include "oracles/cookbook/cookbook_world.h"
#include "oracles/cookbook/translate.h"
#include "oracles/no_answer.h"
#include "oracles/stopwatch.h"

namespace touchstone {
namespace {

/** Two shapes with poses in the engine's types, and the index of their query. */
template <class A, class B>
struct PlacedPair {
  A a;
  cookbook::Pose X_WA;
  B b;
  cookbook::Pose X_WB;
  std::size_t index;
};

/** Queries sorted by shape pair, so that Run() contains only calls of the engine. */
class PreparedManifolds final : public PreparedBatch {
 public:
  explicit PreparedManifolds(std::span<const ContactQuery> queries)
      : separations_(queries.size()) {
    for (std::size_t index = 0; index < queries.size(); ++index) {
      const ContactQuery& query = queries[index];
      VisitKnown(
          query,
          [&](const auto& shape_A, const auto& shape_B) {
            const auto a = ToCookbook(shape_A);
            const auto b = ToCookbook(shape_B);
            using Pair = PlacedPair<std::remove_const_t<decltype(a)>,
                                    std::remove_const_t<decltype(b)>>;
            std::get<std::vector<Pair>>(pairs_).push_back(
                {a, ToCookbook(query.A.X_WB), b, ToCookbook(query.B.X_WB), index});
          },
          [] {});
    }
  }

  void Run() override {
    std::apply([&](const auto&... pairs) { (CollideAll(pairs), ...); }, pairs_);
  }

  std::span<const double> separations() const override { return separations_; }

 private:
  void CollideAll(const auto& pairs) {
    for (const auto& pair : pairs) {
      const cookbook::Manifold manifold =
          cookbook::Collide(pair.a, pair.X_WA, pair.b, pair.X_WB);
      separations_[pair.index] = manifold.separation;
    }
  }

  std::tuple<std::vector<PlacedPair<cookbook::Sphere, cookbook::Sphere>>,
             std::vector<PlacedPair<cookbook::Sphere, cookbook::Box>>,
             std::vector<PlacedPair<cookbook::Box, cookbook::Sphere>>,
             std::vector<PlacedPair<cookbook::Box, cookbook::Box>>>
      pairs_;
  std::vector<double> separations_;
};

constexpr const char* kStepsWorldsOnly =
    "this setup only steps worlds; the oracle \"cookbook\" answers contact queries";

ContactAnswer AnswerOne(const ContactQuery& query) {
  return VisitKnown(
      query,
      [&]<class A, class B>(const A& a, const B& b) {
        constexpr bool kBoxes = std::is_same_v<A, Box> && std::is_same_v<B, Box>;
        return ToAnswer(cookbook::Collide(ToCookbook(a), ToCookbook(query.A.X_WB),
                                          ToCookbook(b), ToCookbook(query.B.X_WB)),
                        !kBoxes);
      },
      NoRecipe);
}

}  // namespace

CookbookOracle::CookbookOracle(CookbookSetup setup) {
  const bool sleeps = setup == CookbookSetup::kSleeping;
  info_.name = sleeps ? "cookbook/sleeping" : "cookbook";
  info_.library = "Touchstone";
  info_.version = "0.1.0";
  if (sleeps) {
    for (auto& row : info_.capabilities) {
      for (Capability& capability : row) capability.reason = kStepsWorldsOnly;
    }
  } else {
    info_.capabilities = SphereAndBoxCapabilities();
    info_.settings = {{"separation of boxes apart", "left out",
                       "the separating-axis test yields only a lower bound"}};
  }
  for (const Setting& setting : CookbookWorldSettings(setup)) {
    info_.settings.push_back(setting);
  }
  info_.simulates = true;
  // IntegrateAngularMomentum(), engine/dynamics/body/rotation.h.
  info_.documented_rotation_error = 1e-6;
  info_.stated_order = 4;
  info_.order_stated_by = "the settings \"integrator\" and \"rods and springs\"";
  info_.steps_in_threads = true;
  info_.parameters = CookbookWorldParameters(setup);
  info_.world_capabilities = CookbookWorldCapabilities();
  DescribeSleep();
}

void CookbookOracle::DescribeSleep() {
  info_.sleep_speed = CookbookSleepSpeed(ValuesOf(info_.parameters, info_.setup));
  info_.sleep_documented_by = info_.sleep_speed > 0 ? "the parameter sleep_speed" : "";
}

void CookbookOracle::Answer(std::span<const ContactQuery> queries,
                            std::span<ContactAnswer> answers) const {
  for (std::size_t k = 0; k < queries.size(); ++k) {
    const Stopwatch watch;
    answers[k] = info_.AnswersContacts() ? AnswerOne(queries[k])
                                         : UnsupportedAnswer(kStepsWorldsOnly);
    answers[k].seconds = watch.seconds();
  }
}

std::unique_ptr<PreparedBatch> CookbookOracle::Prepare(
    std::span<const ContactQuery> queries) const {
  if (!info_.AnswersContacts()) return nullptr;
  return std::make_unique<PreparedManifolds>(queries);
}

std::unique_ptr<Simulation> CookbookOracle::BeginWith(
    const World& world, std::span<const double> values) const {
  return BeginCookbookWorld(world, values);
}

std::unique_ptr<Simulation> CookbookOracle::BeginInThreads(const World& world,
                                                           int threads) const {
  return BeginCookbookWorldInThreads(world, threads,
                                     ValuesOf(info_.parameters, info_.setup));
}

std::unique_ptr<Oracle> CookbookOracle::SetUp(const WorldSetup& setup) const {
  auto oracle = std::make_unique<CookbookOracle>(*this);
  oracle->info_.setup = setup;
  oracle->DescribeSleep();
  return oracle;
}

}  // namespace touchstone
