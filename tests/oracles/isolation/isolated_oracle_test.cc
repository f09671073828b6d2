#include "oracles/isolation/isolated_oracle.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "oracles/isolation/sanitizers.h"
#include "oracles/oracle.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

// The planted behaviours of the oracle in this test. The radius of sphere A selects one.
enum Deed {
  kAnswer = 1,
  kAbort,
  kAssert,
  kSegfault,
  kHang,
  kBlock,
  kThrow,
  kThrowNonsense,
  kExit,
  kFlood,
  kFloodAndAbort,
  kNonsense,
  kCloseAllAndBlock,
  kEatMemory,
  kNaN,
};

ContactQuery Ask(Deed deed, double id = 0) {
  return {{Sphere{static_cast<double>(deed)}, {}},
          {Sphere{1}, {.p_WB = Vector3d(id, 0, 0), .q_WB = {}}}};
}

// Volatile, so that the compiler cannot remove the endless loops.
volatile int forever = 1;

void Do(Deed deed) {
  switch (deed) {
    case kAbort:
      std::abort();
    case kAssert:
      std::fputs("first line\nengine.cc:7: void f(int): Assertion `depth >= 0' failed.\n",
                 stderr);
      std::abort();
    case kSegfault:
      std::raise(SIGSEGV);
      break;
    case kHang:
      while (forever != 0) {
      }
      break;
    case kCloseAllAndBlock:
      for (int fd = 0; fd < 64; ++fd) close(fd);
      [[fallthrough]];
    case kBlock:
      while (forever != 0) pause();
      break;
    case kThrow:
      throw std::logic_error("origin outside the polytope");
    case kThrowNonsense:
      throw 7;
    case kExit:
      std::exit(3);
    case kFlood:
    case kFloodAndAbort:
      // Long lines, because each is a separate system call and the CPU time is limited.
      for (int i = 0; i < 1000; ++i) {
        const std::string line = std::string(3000, 'w') + '\n';
        std::fputs(line.c_str(), stderr);
        std::fputs(line.c_str(), stdout);
      }
      if (deed == kFloodAndAbort) {
        std::fputs("the last straw\n", stderr);
        std::abort();
      }
      break;
    case kNonsense:
      for (int fd = 3; fd < 8; ++fd) {
        [[maybe_unused]] const ssize_t count = write(fd, "\xff\xff\xff\x7f nonsense", 13);
      }
      break;
    case kEatMemory: {
      std::vector<std::vector<char>> eaten;
      while (forever != 0) eaten.emplace_back(std::size_t{1} << 28);
      break;
    }
    case kAnswer:
    case kNaN:
      break;
  }
}

// A ball at (step, 0, 0). Its radius selects the behaviour in the third step.
class PlantedSimulation final : public Simulation {
 public:
  explicit PlantedSimulation(const World& world)
      : deed_(static_cast<Deed>(
            std::get<Sphere>(world.bodies.front().placed.shape).radius)) {}

  void Push(int, const Vector3d&, const Vector3d&) override {}
  void Step() override {
    if (++step_ == 3) Do(deed_);
  }
  void Read(WorldState& state) const override {
    state.bodies = {{Vector3d(step_, 0, 0), Eigen::Quaterniond::Identity(),
                     Vector3d::Zero(), Vector3d::Zero()}};
  }

 private:
  Deed deed_;
  int step_ = 0;
};

// A ball at rest on which a NaN impulse acts in the second step.
class NaNImpulse final : public Simulation {
 public:
  void Push(int, const Vector3d&, const Vector3d&) override {}
  void Step() override { ++step_; }
  void Read(WorldState& state) const override {
    state.bodies = {{Vector3d::Zero(), Eigen::Quaterniond::Identity(), Vector3d::Zero(),
                     Vector3d::Zero()}};
  }
  bool GivesImpulses() const override { return true; }
  void ReadImpulses(std::vector<ContactImpulse>& impulses) const override {
    const double J = step_ == 2 ? std::numeric_limits<double>::quiet_NaN() : 1;
    impulses.push_back({0, 0, 0, Vector3d::Zero(), Vector3d::UnitY(), {0, J, 0}});
  }

 private:
  int step_ = 0;
};

class PlantedOracle final : public Oracle {
 public:
  PlantedOracle() {
    info_.name = "planted";
    info_.simulates = true;
    info_.world_capabilities.fill({true, ""});
    info_.world_capabilities[static_cast<std::size_t>(WorldFeature::kCloth)] = {
        false, "has no cloth"};
  }

  const OracleInfo& info() const override { return info_; }

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> answers) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const auto deed = static_cast<Deed>(std::get<Sphere>(queries[i].A.shape).radius);
      Do(deed);
      answers[i] = ContactAnswer{};
      answers[i].status = AnswerStatus::kAnswered;
      answers[i].separation = deed == kNaN ? std::numeric_limits<double>::quiet_NaN()
                                           : queries[i].B.X_WB.p_WB.x();
    }
  }

  std::unique_ptr<Simulation> Begin(const World& world) const override {
    return std::make_unique<PlantedSimulation>(world);
  }

  std::unique_ptr<Simulation> BeginAsShipped(const World&) const override {
    return nullptr;
  }

  std::unique_ptr<Simulation> BeginInThreads(const World& world,
                                             int threads) const override {
    if (threads != 3) return nullptr;
    return std::make_unique<PlantedSimulation>(world);
  }

 private:
  OracleInfo info_;
};

IsolationLimits Limits() {
  IsolationLimits limits;
  // Long enough for megabytes of output on a slow machine with sanitizers.
  limits.cpu = std::chrono::seconds(1);
  limits.world_cpu = std::chrono::seconds(1);
  limits.memory = std::size_t{1} << 30;
  return limits;
}

std::unique_ptr<Oracle> Isolated(const IsolationLimits& limits = Limits()) {
  return Isolate(std::make_unique<PlantedOracle>(), limits);
}

// Asks `deed` between two harmless questions, which must always be answered.
ContactAnswer AnswerTo(Deed deed, const IsolationLimits& limits = Limits()) {
  const std::vector<ContactQuery> queries = {Ask(kAnswer, 1), Ask(deed, 2),
                                             Ask(kAnswer, 3)};
  std::vector<ContactAnswer> answers(queries.size());
  Isolated(limits)->Answer(queries, answers);
  EXPECT_EQ(answers[0].separation, 1);
  EXPECT_EQ(answers[2].separation, 3);
  return answers[1];
}

void ExpectCrash(Deed deed, const std::string& reason) {
  const ContactAnswer answer = AnswerTo(deed);
  EXPECT_EQ(answer.status, AnswerStatus::kCrashed);
  EXPECT_EQ(answer.reason, reason);
}

// An oracle whose parameter decides what it does in a world.
class ParameterOracle final : public Oracle {
 public:
  ParameterOracle() {
    info_.name = "with_parameter";
    info_.simulates = true;
    info_.world_capabilities.fill({true, ""});
    info_.parameters = {{.name = "deed",
                         .here = kAnswer,
                         .shipped = kAbort,
                         .least = 0,
                         .most = 100,
                         .whole = true,
                         .what = "deed",
                         .why = ""}};
  }
  const OracleInfo& info() const override { return info_; }
  using Oracle::Answer;
  void Answer(std::span<const ContactQuery>, std::span<ContactAnswer>) const override {}
  std::unique_ptr<Simulation> BeginWith(const World& world,
                                        std::span<const double> values) const override {
    World asked = world;
    asked.bodies.front().placed.shape = Sphere{values.front()};
    return std::make_unique<PlantedSimulation>(asked);
  }

 private:
  OracleInfo info_;
};

bool HasNoChildren() {
  return waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD;
}

int OpenFiles() {
  int open = 0;
  for (int fd = 0; fd < 1024; ++fd) {
    if (fcntl(fd, F_GETFD) != -1) ++open;
  }
  return open;
}

TEST(IsolatedOracle, ReportsAnAbort) {
  ExpectCrash(kAbort, "aborted");
}

TEST(IsolatedOracle, ReportsTheAssertionThatFailed) {
  ExpectCrash(kAssert, "aborted: engine.cc:7: Assertion `depth >= 0' failed.");
}

TEST(IsolatedOracle, ReportsASignal) {
  ExpectCrash(kSegfault, "killed by SIGSEGV");
}

TEST(IsolatedOracle, ReportsAnException) {
  ExpectCrash(kThrow, "threw std::logic_error: origin outside the polytope");
  ExpectCrash(kThrowNonsense, "threw something that is not a std::exception");
}

TEST(IsolatedOracle, ReportsAnExit) {
  ExpectCrash(kExit, "exited with status 3");
}

TEST(IsolatedOracle, ReportsBytesThatAreNotAnAnswer) {
  ExpectCrash(kNonsense, "sent bytes that are not an answer");
}

TEST(IsolatedOracle, StopsAnEngineThatWorksForever) {
  const ContactAnswer answer = AnswerTo(kHang);
  EXPECT_EQ(answer.status, AnswerStatus::kTimedOut);
  EXPECT_EQ(answer.reason, "no answer after 1 s of CPU time");
  EXPECT_GT(answer.seconds, 0.5);
}

TEST(IsolatedOracle, StopsAnEngineThatWaitsForever) {
  IsolationLimits limits = Limits();
  limits.wall = std::chrono::milliseconds(2000);
  for (const Deed deed : {kBlock, kCloseAllAndBlock}) {
    const ContactAnswer answer = AnswerTo(deed, limits);
    EXPECT_EQ(answer.status, AnswerStatus::kTimedOut);
    EXPECT_EQ(answer.reason, "no answer after 2 s, blocked");
  }
}

TEST(IsolatedOracle, StopsAnEngineThatExhaustsTheMemory) {
  if (kSanitizerReservesMemory)
    GTEST_SKIP() << "the sanitizer reserves more memory than the limit";
  const ContactAnswer answer = AnswerTo(kEatMemory);
  // It may reach either limit first, because filling pages takes CPU time.
  EXPECT_TRUE(answer.reason == "threw std::bad_alloc: std::bad_alloc" ||
              answer.status == AnswerStatus::kTimedOut)
      << answer.reason;
}

TEST(IsolatedOracle, IsNotBlockedByMegabytesOfOutput) {
  EXPECT_EQ(AnswerTo(kFlood).separation, 2);
  ExpectCrash(kFloodAndAbort, "aborted: the last straw");
}

TEST(IsolatedOracle, DiscardsTheOutputOfEarlierQuestions) {
  const std::vector<ContactQuery> queries = {Ask(kFlood), Ask(kAbort)};
  std::vector<ContactAnswer> answers(queries.size());
  Isolated()->Answer(queries, answers);
  EXPECT_EQ(answers[1].reason, "aborted");
}

TEST(IsolatedOracle, PassesOnNaN) {
  EXPECT_TRUE(std::isnan(AnswerTo(kNaN).separation.value()));
}

TEST(IsolatedOracle, ReportsThatItIsIsolated) {
  EXPECT_TRUE(Isolated()->info().isolated);
  EXPECT_EQ(Isolated()->info().name, "planted");
}

// There is one answer per question, in the order of the questions, even after crashes.
TEST(IsolatedOracle, KeepsTheOrderOfALongBatch) {
  std::vector<ContactQuery> queries;
  queries.reserve(5000);
  for (int i = 0; i < 5000; ++i) {
    queries.push_back(Ask(i % 500 == 250   ? kSegfault
                          : i % 500 == 100 ? kThrow
                                           : kAnswer,
                          i));
  }
  std::vector<ContactAnswer> answers(queries.size());
  Isolated()->Answer(queries, answers);
  for (int i = 0; i < 5000; ++i) {
    const ContactAnswer& answer = answers[static_cast<std::size_t>(i)];
    if (i % 500 == 250) {
      EXPECT_EQ(answer.reason, "killed by SIGSEGV") << i;
    } else if (i % 500 == 100) {
      EXPECT_EQ(answer.status, AnswerStatus::kCrashed) << i;
    } else {
      EXPECT_EQ(answer.separation, i);
    }
  }
}

TEST(IsolatedOracle, LeavesNoProcessAndNoFileBehind) {
  const int open_before = OpenFiles();
  for (const Deed deed : {kAnswer, kAbort, kHang, kThrow, kExit, kNonsense})
    AnswerTo(deed);
  EXPECT_TRUE(HasNoChildren());
  EXPECT_EQ(OpenFiles(), open_before);
}

// Children of eight threads at once: half of the questions hang or abort.
TEST(IsolatedOracle, AnswersSeveralThreadsAtOnce) {
  IsolationLimits limits = Limits();
  limits.cpu = std::chrono::milliseconds(100);  // Short, because forty questions hang.
  const std::unique_ptr<Oracle> oracle = Isolated(limits);
  std::atomic<int> right = 0;
  std::vector<std::thread> threads;
  threads.reserve(8);
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      for (int round = 0; round < 10; ++round) {
        const std::vector<ContactQuery> queries = {
            Ask(kAnswer, t), Ask(t % 2 == 0 ? kHang : kAbort), Ask(kAnswer, round)};
        std::vector<ContactAnswer> answers(queries.size());
        oracle->Answer(queries, answers);
        const AnswerStatus expected =
            t % 2 == 0 ? AnswerStatus::kTimedOut : AnswerStatus::kCrashed;
        if (answers[0].separation == t && answers[1].status == expected &&
            answers[2].separation == round) {
          ++right;
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, 80);
  EXPECT_TRUE(HasNoChildren());
}

// The calling program is killed while its child blocks: the child must die with it.
TEST(IsolatedOracle, DiesWithTheCallingProgram) {
  ASSERT_EQ(prctl(PR_SET_CHILD_SUBREAPER, 1), 0);  // Orphans become our children.
  const pid_t asker = fork();
  if (asker == 0) {
    Isolate(std::make_unique<PlantedOracle>())->Answer(Ask(kBlock));
    _exit(0);
  }
  std::ostringstream children;
  children << "/proc/" << asker << "/task/" << asker << "/children";
  pid_t child = 0;
  while (child == 0) {
    std::ifstream(children.str()) >> child;
    std::this_thread::yield();
  }
  kill(asker, SIGKILL);
  ASSERT_EQ(waitpid(asker, nullptr, 0), asker);
  // This would wait for a minute if the child lived on.
  EXPECT_EQ(waitpid(child, nullptr, 0), child);
  EXPECT_TRUE(HasNoChildren());
  prctl(PR_SET_CHILD_SUBREAPER, 0);
}

World WorldOf(Deed deed) {
  World world;
  world.steps = 5;
  world.bodies.emplace_back().placed = {Sphere{static_cast<double>(deed)}, {}};
  return world;
}

TEST(IsolatedOracle, BeginsWorldsInThisProcessLikeTheInnerOracle) {
  EXPECT_NE(Isolated()->Begin(WorldOf(kAnswer)), nullptr);
  EXPECT_EQ(Isolated()->BeginAsShipped(WorldOf(kAnswer)), nullptr);
  EXPECT_EQ(Isolated()->BeginInThreads(WorldOf(kAnswer), 2), nullptr);
  EXPECT_NE(Isolated()->BeginInThreads(WorldOf(kAnswer), 3), nullptr);
}

TEST(IsolatedWorlds, HaveTheEnginesTrajectoryAndItsLastLineOfOutput) {
  const Trajectory quiet = Isolated()->Simulate(WorldOf(kAnswer));
  ASSERT_EQ(quiet.status, AnswerStatus::kAnswered) << quiet.reason;
  ASSERT_EQ(quiet.samples.size(), 6u);
  EXPECT_EQ(quiet.samples[5].bodies[0].p_WB.x(), 5);
  EXPECT_EQ(quiet.complaint, "");
  EXPECT_GT(quiet.seconds, 0);
  const Trajectory loud = Isolated()->Simulate(WorldOf(kFlood));
  EXPECT_EQ(loud.samples.size(), 6u);
  EXPECT_EQ(loud.complaint, std::string(3000, 'w'));
}

TEST(IsolatedWorlds, HaveNoSamplesAndAReasonIfTheEngineFails) {
  const auto ending = [](Deed deed) {
    const Trajectory trajectory = Isolated()->Simulate(WorldOf(deed));
    EXPECT_TRUE(trajectory.samples.empty());
    EXPECT_EQ(trajectory.status,
              deed == kHang ? AnswerStatus::kTimedOut : AnswerStatus::kCrashed);
    EXPECT_GT(trajectory.seconds, deed == kHang ? 0.5 : 0);
    return trajectory.reason;
  };
  EXPECT_EQ(ending(kAssert), "aborted: engine.cc:7: Assertion `depth >= 0' failed.");
  EXPECT_EQ(ending(kSegfault), "killed by SIGSEGV");
  EXPECT_EQ(ending(kThrow), "threw std::logic_error: origin outside the polytope");
  EXPECT_EQ(ending(kExit), "exited with status 3");
  EXPECT_EQ(ending(kNonsense), "sent bytes that are not an answer");
  EXPECT_EQ(ending(kHang), "no answer after 1 s of CPU time");
  EXPECT_TRUE(HasNoChildren());
}

TEST(IsolatedWorlds, OfABatchDoNotAffectEachOtherIfTheEngineFails) {
  World unsupported = WorldOf(kAnswer);
  unsupported.cloths.emplace_back();
  const std::vector<World> worlds = {WorldOf(kAbort), WorldOf(kAnswer),
                                     unsupported,     WorldOf(kSegfault),
                                     WorldOf(kThrow), WorldOf(kAnswer)};
  std::vector<std::string> reasons;
  for (const Trajectory& trajectory : Isolated()->SimulateEach(worlds)) {
    EXPECT_EQ(trajectory.samples.size(), trajectory.reason.empty() ? 6u : 0u);
    reasons.push_back(trajectory.reason);
  }
  EXPECT_EQ(reasons, (std::vector<std::string>{
                         "aborted", "", "has no cloth", "killed by SIGSEGV",
                         "threw std::logic_error: origin outside the polytope", ""}));
  EXPECT_TRUE(HasNoChildren());
}

TEST(IsolatedWorlds, OfABatchHaveTheirOwnOutput) {
  const std::vector<World> worlds = {WorldOf(kAnswer), WorldOf(kFlood), WorldOf(kAnswer)};
  std::vector<std::string> printed;
  for (const Trajectory& trajectory : Isolated()->SimulateEach(worlds))
    printed.push_back(trajectory.complaint);
  EXPECT_EQ(printed, (std::vector<std::string>{"", std::string(3000, 'w'), ""}));
}

TEST(IsolatedWorlds, ThatAreUnsupportedHaveAReason) {
  World world = WorldOf(kAnswer);
  world.cloths.emplace_back();
  const Trajectory trajectory = Isolated()->Simulate(world);
  EXPECT_EQ(trajectory.status, AnswerStatus::kUnsupported);
  EXPECT_EQ(trajectory.reason, "has no cloth");
}

TEST(IsolatedWorlds, BeginInProcess) {
  const std::unique_ptr<Simulation> simulation = Isolated()->Begin(WorldOf(kAnswer));
  ASSERT_NE(simulation, nullptr);
  simulation->Step();
  WorldState state;
  simulation->Read(state);
  EXPECT_EQ(state.bodies[0].p_WB.x(), 1);
}

TEST(IsolatedWorlds, CanBeIsolatedWithoutContactQueries) {
  const auto oracle =
      Isolate(std::make_unique<PlantedOracle>(), Limits(), IsolationScope::kWorlds);
  EXPECT_FALSE(oracle->info().isolated);
  EXPECT_EQ(oracle->Simulate(WorldOf(kAbort)).reason, "aborted");
  // The query is answered in this process, so its exception arrives here.
  EXPECT_THROW(oracle->Answer(Ask(kThrow)), std::logic_error);
}

TEST(RunToEnd, TreatsANaNImpulseAsADivergedWorld) {
  World world;
  world.dt = 0.01;
  world.steps = 5;
  NaNImpulse simulation;
  EXPECT_EQ(RunToEnd(simulation, world).diverged_at_step, 2);
}

TEST(IsolatedOracle, AnswersAnEmptyBatch) {
  Isolated()->Answer(std::span<const ContactQuery>(), std::span<ContactAnswer>());
  EXPECT_TRUE(HasNoChildren());
}

TEST(IsolatedOracle, SimulatesInAChildWithTheSetupThatIsChosen) {
  const std::unique_ptr<Oracle> isolated =
      Isolate(std::make_unique<ParameterOracle>(), Limits());
  const World world = WorldOf(kAnswer);
  EXPECT_EQ(isolated->Simulate(world).status, AnswerStatus::kAnswered);
  const auto chosen =
      isolated->SetUp({.as_shipped = false, .chosen = {{"deed", kAbort}}});
  EXPECT_EQ(chosen->info().setup.chosen.at("deed"), kAbort);
  EXPECT_EQ(chosen->info().settings.size(), isolated->info().settings.size());
  EXPECT_EQ(chosen->Simulate(world).status, AnswerStatus::kCrashed);
  const auto shipped = isolated->SetUp({.as_shipped = true, .chosen = {}});
  EXPECT_EQ(shipped->Simulate(world).status, AnswerStatus::kCrashed);
  const auto back = shipped->SetUp({.as_shipped = true, .chosen = {{"deed", kAnswer}}});
  EXPECT_EQ(back->Simulate(world).status, AnswerStatus::kAnswered);
  EXPECT_TRUE(HasNoChildren());
}

}  // namespace
}  // namespace touchstone
