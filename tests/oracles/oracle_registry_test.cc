#include "oracles/oracle_registry.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace touchstone {
namespace {

/** An oracle with a name that answers nothing. */
class Named : public Oracle {
 public:
  explicit Named(std::string name, std::string library = "") {
    info_.name = std::move(name);
    info_.library = std::move(library);
  }
  const OracleInfo& info() const override { return info_; }
  void Answer(std::span<const ContactQuery>, std::span<ContactAnswer>) const override {}

 private:
  OracleInfo info_;
};

std::vector<std::string> NamesOf(const std::vector<const Oracle*>& oracles) {
  std::vector<std::string> names;
  names.reserve(oracles.size());
  for (const Oracle* oracle : oracles) names.push_back(oracle->info().name);
  return names;
}

TEST(OracleRegistry, PatternMatchesTheNameAndWhatIsBelowIt) {
  OracleRegistry registry;
  for (const char* name : {"alpha", "alpha/gjk", "alpha_float", "beta/collide"}) {
    registry.Add(std::make_unique<Named>(name));
  }
  using Names = std::vector<std::string>;
  EXPECT_EQ(NamesOf(registry.Matching("alpha")), (Names{"alpha", "alpha/gjk"}));
  EXPECT_EQ(NamesOf(registry.Matching("beta")), (Names{"beta/collide"}));
  EXPECT_EQ(NamesOf(registry.Matching("alpha/gjk")), (Names{"alpha/gjk"}));
  EXPECT_TRUE(registry.Matching("alp").empty());
  EXPECT_TRUE(registry.Matching("").empty());
}

TEST(OracleRegistry, FindsExactNamesOnlyAndKeepsTheOrder) {
  OracleRegistry registry;
  registry.Add(std::make_unique<Named>("beta/collide"));
  registry.Add(std::make_unique<Named>("alpha"));
  EXPECT_EQ(registry.Find("alpha")->info().name, "alpha");
  EXPECT_EQ(registry.Find("beta"), nullptr);
  EXPECT_EQ(NamesOf(registry.All()), (std::vector<std::string>{"beta/collide", "alpha"}));
}

TEST(OracleRegistry, KeepsTheVersionsOfALibraryTogether) {
  OracleRegistry registry;
  registry.Add(std::make_unique<Named>("alpha", "Alpha"));
  registry.Add(std::make_unique<Named>("beta", "Beta"));
  registry.Add(std::make_unique<Named>("gamma", "Gamma"));
  registry.Add(std::make_unique<Named>("beta@2", "Beta"));
  registry.Add(std::make_unique<Named>("alpha@2", "Alpha"));
  registry.Add(std::make_unique<Named>("beta@3", "Beta"));
  EXPECT_EQ(NamesOf(registry.All()),
            (std::vector<std::string>{"alpha", "alpha@2", "beta", "beta@2", "beta@3",
                                      "gamma"}));
}

TEST(OracleRegistry, RefusesANameThatExistsAndKeepsTheFirst) {
  OracleRegistry registry;
  registry.Add(std::make_unique<Named>("mine"));
  const Oracle* first = registry.Find("mine");
  EXPECT_THROW(registry.Add(std::make_unique<Named>("mine")), std::invalid_argument);
  EXPECT_EQ(registry.Find("mine"), first);
  EXPECT_EQ(registry.All().size(), 1u);
}

TEST(OracleRegistry, SpecimensAreCreatedOnDemandAndOnlyOnce) {
  const OracleRegistry registry = OracleRegistry::BuiltIn();
  const std::size_t listed = registry.All().size();
  std::vector<const Oracle*> found(4);
  std::vector<std::thread> threads;
  threads.reserve(found.size());
  for (const Oracle*& oracle : found) {
    threads.emplace_back([&] { oracle = registry.Find("printed:E-04"); });
  }
  for (std::thread& thread : threads) thread.join();
  ASSERT_NE(found.front(), nullptr);
  EXPECT_EQ(found, std::vector<const Oracle*>(4, found.front()));
  EXPECT_EQ(registry.Find("printed:E-00"), nullptr);
  EXPECT_EQ(registry.All().size(), listed);
}

TEST(OracleRegistry, FindsEverySpecimenThatItNames) {
  const OracleRegistry registry = OracleRegistry::BuiltIn();
  const std::vector<std::string> names = registry.SpecimenNames();
  EXPECT_EQ(names.size(), 32u);  // All errata, none, and each of 30 alone.
  for (const std::string& name : names) EXPECT_NE(registry.Find(name), nullptr) << name;
  EXPECT_TRUE(OracleRegistry().SpecimenNames().empty());
}

TEST(OracleRegistry, KnowsTheNamesThatAnotherBuildMayHave) {
  const OracleRegistry registry = OracleRegistry::BuiltIn();
  for (const char* name : {"cookbook", "printed:E-04", "bullet/gjk", "fcl/collide"}) {
    EXPECT_TRUE(registry.MayExist(name)) << name;
  }
  EXPECT_FALSE(registry.MayExist("cookbok"));
  EXPECT_FALSE(registry.MayExist("cookbook/quick"));
}

TEST(OracleRegistry, EveryEngineIsPresentOrMissingWithInstructions) {
  const OracleRegistry registry = OracleRegistry::BuiltIn();
  const auto is_missing = [&](const std::string& name) {
    const auto& missing = registry.missing();
    return std::any_of(missing.begin(), missing.end(), [&](const MissingOracle& m) {
      return m.name == name && !m.how_to_get.empty();
    });
  };
  for (const char* engine : {"cookbook", "printed", "bullet", "bullet_float", "ode",
                             "fcl", "libccd", "dart", "mujoco"}) {
    EXPECT_EQ(registry.Matching(engine).empty(), is_missing(engine)) << engine;
  }
}

}  // namespace
}  // namespace touchstone
