// Ten mistakes that adapters make, seeded into right engines one by one: each is named.

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracles/forwarding_oracle.h"
#include "oracles/oracle_registry.h"
#include "reports/adapter_check/check_contacts.h"
#include "reports/adapter_check/check_worlds.h"

namespace touchstone {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;

const OracleRegistry& Registry() {
  static const OracleRegistry registry = OracleRegistry::BuiltIn();
  return registry;
}

bool Exists(const std::string& name) {
  return Registry().Find(name) != nullptr;
}

const Oracle& Right(const std::string& name = "cookbook") {
  return *Registry().Find(name);
}

/** A right engine behind an adapter with mistakes. */
class Mistaken final : public ForwardingOracle {
 public:
  explicit Mistaken(const Oracle& right) : ForwardingOracle(right) {}

  std::function<void(ContactQuery&)> asks = [](ContactQuery&) {};
  std::function<void(const ContactQuery&, ContactAnswer&)> answers =
      [](const ContactQuery&, ContactAnswer&) {};
  std::function<void(World&)> simulates = [](World&) {};
  std::function<void(const World&, Trajectory&)> moves = [](const World&, Trajectory&) {};

  using Oracle::Answer;
  void Answer(std::span<const ContactQuery> queries,
              std::span<ContactAnswer> given) const override {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ContactQuery query = queries[i];
      asks(query);
      given[i] = oracle_.Answer(query);
      answers(queries[i], given[i]);
    }
  }
  Trajectory Simulate(const World& world) const override {
    World simulated = world;
    simulates(simulated);
    Trajectory motion = oracle_.Simulate(simulated);
    moves(world, motion);
    return motion;
  }
};

void ForEachBox(ContactQuery& query, double factor) {
  for (Body* body : {&query.A, &query.B}) {
    if (auto* box = std::get_if<Box>(&body->shape)) box->half_extents *= factor;
  }
}

void Misread(Pose& pose) {
  const Quaterniond q = *pose.q_WB;
  const double in_file[] = {q.w(), q.x(), q.y(), q.z()};
  // The constructor of Eigen takes w first.
  pose = Pose::FromQuaternion(
      pose.p_WB, Quaterniond(in_file[3], in_file[0], in_file[1], in_file[2]));
}

std::vector<std::string> MistakesOf(const Oracle& oracle, ShapeKind A, ShapeKind B) {
  for (const PairCheck& pair : CheckContacts(oracle)) {
    if (pair.A != A || pair.B != B) continue;
    EXPECT_GT(pair.wrong, 0U);
    EXPECT_FALSE(pair.example.empty());
    return pair.mistakes;
  }
  return {};
}

std::vector<std::string> MistakesOfBoxes(const Oracle& oracle) {
  return MistakesOf(oracle, ShapeKind::kBox, ShapeKind::kBox);
}

TEST(CheckOracle, FindsNothingWrongWithARightOracle) {
  for (const PairCheck& pair : CheckContacts(Right())) {
    EXPECT_EQ(pair.wrong, 0U) << pair.example;
    EXPECT_EQ(pair.inexact, 0U);
    EXPECT_GT(pair.touching, 4U);
    EXPECT_LT(pair.touching, pair.asked - 4);
  }
  EXPECT_EQ(CheckRepeatability(Right()), "");
  EXPECT_EQ(CheckWorlds(Right(), Right()).size(), 4U);
  for (const WorldCheck& world : CheckWorlds(Right(), Right()))
    EXPECT_EQ(world.wrong + world.reason, "") << world.world;
}

// Engines of first order are alike to kSameMotion, far below any mistake.
TEST(CheckOracle, FindsNothingWrongWithTheMotionsOfOtherEngines) {
  for (const char* name : {"bullet", "bullet_float", "ode", "dart", "mujoco"}) {
    if (!Exists(name)) continue;
    for (const WorldCheck& world : CheckWorlds(Right(name), Right()))
      EXPECT_EQ(world.wrong + world.reason, "") << name << ": " << world.world;
  }
}

TEST(CheckOracle, NamesANormalThatIsInverted) {
  Mistaken oracle(Right());
  oracle.answers = [](const ContactQuery&, ContactAnswer& answer) {
    if (answer.n_AB_W) answer.n_AB_W = -*answer.n_AB_W;
  };
  EXPECT_THAT(MistakesOfBoxes(oracle), ElementsAre(HasSubstr("from B to A")));
}

TEST(CheckOracle, NamesADepthWithTheWrongSign) {
  Mistaken oracle(Right());
  oracle.answers = [](const ContactQuery&, ContactAnswer& answer) {
    if (!answer.touching) return;
    if (answer.separation) answer.separation = -*answer.separation;
    for (ContactPoint& point : answer.points) point.separation = -point.separation;
  };
  EXPECT_THAT(MistakesOf(oracle, ShapeKind::kSphere, ShapeKind::kSphere),
              ElementsAre(HasSubstr("positive, a depth; expected a negative number")));
}

TEST(CheckOracle, NamesHalfExtentsTakenForEdges) {
  Mistaken oracle(Right());
  oracle.asks = [](ContactQuery& query) { ForEachBox(query, 0.5); };
  EXPECT_THAT(MistakesOfBoxes(oracle),
              ElementsAre(HasSubstr("takes the half extents of a box for its edges")));
}

TEST(CheckOracle, NamesEdgesTakenForHalfExtents) {
  Mistaken oracle(Right());
  oracle.asks = [](ContactQuery& query) { ForEachBox(query, 2); };
  EXPECT_THAT(MistakesOf(oracle, ShapeKind::kSphere, ShapeKind::kBox),
              ElementsAre(HasSubstr("takes the edges of a box for its half extents")));
}

TEST(CheckOracle, NamesTheOrderOfAQuaternion) {
  Mistaken oracle(Right());
  oracle.asks = [](ContactQuery& query) {
    Misread(query.A.X_WB);
    Misread(query.B.X_WB);
  };
  EXPECT_THAT(MistakesOfBoxes(oracle),
              ElementsAre(HasSubstr("reads the quaternion w, x, y, z as x, y, z, w")));
}

TEST(CheckOracle, NamesAnAnswerInTheFrameOfABody) {
  Mistaken oracle(Right());
  oracle.answers = [](const ContactQuery& query, ContactAnswer& answer) {
    const Pose& X_WA = query.A.X_WB;
    const auto in_A = [&](const Vector3d& p) {
      return Vector3d(X_WA.R_WB.transpose() * (p - X_WA.p_WB));
    };
    if (answer.n_AB_W) answer.n_AB_W = X_WA.R_WB.transpose() * *answer.n_AB_W;
    for (ContactPoint& point : answer.points) point.p_WC = in_A(point.p_WC);
  };
  EXPECT_THAT(MistakesOfBoxes(oracle),
              ElementsAre(HasSubstr("normal and points are in the frame of A")));
}

TEST(CheckOracle, NamesAPositionThatIsThatOfACorner) {
  Mistaken oracle(Right());
  oracle.asks = [](ContactQuery& query) {
    for (Body* body : {&query.A, &query.B}) {
      if (const auto* box = std::get_if<Box>(&body->shape))
        body->X_WB.p_WB += body->X_WB.R_WB * box->half_extents;
    }
  };
  EXPECT_THAT(MistakesOfBoxes(oracle), ElementsAre(HasSubstr("that of a corner")));
}

TEST(CheckOracle, NamesTheAxisOfCapsules) {
  if (!Exists("bullet")) GTEST_SKIP() << "no engine here has capsules";
  Mistaken oracle(Right("bullet"));
  oracle.asks = [](ContactQuery& query) {
    for (Body* body : {&query.A, &query.B}) {
      if (!std::holds_alternative<Capsule>(body->shape)) continue;
      // About x by −90°: what was along z is along y.
      const Eigen::AngleAxisd turn(-std::numbers::pi / 2, Vector3d::UnitX());
      body->X_WB = Pose::FromMatrix(body->X_WB.p_WB, body->X_WB.R_WB * turn.matrix());
    }
  };
  EXPECT_THAT(MistakesOf(oracle, ShapeKind::kSphere, ShapeKind::kCapsule),
              ElementsAre(HasSubstr("is y; expected z")));
}

TEST(CheckOracle, NamesTwoMistakesAtOnce) {
  Mistaken oracle(Right());
  oracle.asks = [](ContactQuery& query) { ForEachBox(query, 0.5); };
  oracle.answers = [](const ContactQuery&, ContactAnswer& answer) {
    if (answer.n_AB_W) answer.n_AB_W = -*answer.n_AB_W;
  };
  EXPECT_THAT(
      MistakesOfBoxes(oracle),
      ElementsAre(testing::AllOf(HasSubstr("from B to A"), HasSubstr("for its edges"))));
}

TEST(CheckOracle, BlamesNoAdapterForAFaultOfAnEngine) {
  Mistaken oracle(Right());
  oracle.answers = [](const ContactQuery&, ContactAnswer& answer) {
    if (answer.separation) answer.separation = 0.8 * *answer.separation;
  };
  EXPECT_TRUE(MistakesOf(oracle, ShapeKind::kSphere, ShapeKind::kSphere).empty());
}

TEST(CheckOracle, NamesAnswersThatDependOnEarlierQuestions) {
  Mistaken oracle(Right());
  auto asked = std::make_shared<std::atomic<int>>(0);
  oracle.answers = [asked](const ContactQuery&, ContactAnswer& answer) {
    if (answer.separation) *answer.separation += 1e-15 * (*asked)++;
  };
  EXPECT_THAT(CheckRepeatability(oracle),
              HasSubstr("has another answer when it is asked again"));
}

// The mistakes that every world finds in which something is wrong.
std::vector<std::string> MistakesInWorlds(const Oracle& oracle) {
  std::vector<std::string> common;
  bool is_first = true;
  for (const WorldCheck& world : CheckWorlds(oracle, Right())) {
    if (world.wrong.empty()) continue;
    if (is_first) common = world.mistakes;
    is_first = false;
    std::erase_if(common, [&](const std::string& mistake) {
      return std::ranges::find(world.mistakes, mistake) == world.mistakes.end();
    });
  }
  EXPECT_FALSE(is_first) << "nothing is wrong";
  return common;
}

void ForEachState(Trajectory& motion, const std::function<void(BodyState&)>& change) {
  for (WorldState& sample : motion.samples) {
    for (BodyState& body : sample.bodies) change(body);
  }
}

TEST(CheckOracle, NamesASpinInDegrees) {
  Mistaken oracle(Right());
  oracle.simulates = [](World& world) {
    for (RigidBody& body : world.bodies) body.w_WB *= std::numbers::pi / 180;
  };
  EXPECT_THAT(MistakesInWorlds(oracle), ElementsAre(HasSubstr("for degrees a second")));

  Mistaken other(Right());
  other.moves = [](const World&, Trajectory& motion) {
    ForEachState(motion, [](BodyState& body) { body.w_WB *= 180 / std::numbers::pi; });
  };
  EXPECT_THAT(MistakesInWorlds(other), ElementsAre(HasSubstr("its spin is in degrees")));
}

TEST(CheckOracle, NamesTheOrderOfTheQuaternionsOfAMotion) {
  Mistaken oracle(Right());
  oracle.moves = [](const World&, Trajectory& motion) {
    ForEachState(motion, [](BodyState& body) {
      const Quaterniond q = body.q_WB;
      body.q_WB = Quaterniond(q.x(), q.y(), q.z(), q.w());
    });
  };
  EXPECT_THAT(MistakesInWorlds(oracle),
              ElementsAre(HasSubstr("orientations are x, y, z, w")));
}

TEST(CheckOracle, NamesASpinInTheFrameOfTheBody) {
  Mistaken oracle(Right());
  oracle.moves = [](const World&, Trajectory& motion) {
    ForEachState(motion,
                 [](BodyState& body) { body.w_WB = body.q_WB.conjugate() * body.w_WB; });
  };
  EXPECT_THAT(MistakesInWorlds(oracle),
              ElementsAre(HasSubstr("spin is in the frame of the body")));
}

TEST(CheckOracle, NamesAPositionOfAMotionThatIsThatOfACorner) {
  Mistaken oracle(Right());
  oracle.moves = [](const World& world, Trajectory& motion) {
    for (WorldState& sample : motion.samples) {
      for (std::size_t i = 0; i < sample.bodies.size(); ++i) {
        BodyState& body = sample.bodies[i];
        if (const auto* box = std::get_if<Box>(&world.bodies[i].placed.shape))
          body.p_WB -= body.q_WB * box->half_extents;
      }
    }
  };
  EXPECT_THAT(MistakesInWorlds(oracle),
              ElementsAre(HasSubstr("positions are those of a corner")));
}

TEST(CheckOracle, NamesInertiaAlongTheAxesOfTheWorld) {
  Mistaken oracle(Right());
  // An engine that starts every body with the moments along the world's axes: it
  // simulates a body that is not turned, and turns it afterwards.
  oracle.simulates = [](World& world) {
    for (RigidBody& body : world.bodies)
      body.placed.X_WB = Pose::FromQuaternion(body.placed.X_WB.p_WB, {1, 0, 0, 0});
  };
  oracle.moves = [](const World& world, Trajectory& motion) {
    for (WorldState& sample : motion.samples) {
      for (std::size_t i = 0; i < sample.bodies.size(); ++i)
        sample.bodies[i].q_WB = sample.bodies[i].q_WB * *world.bodies[i].placed.X_WB.q_WB;
    }
  };
  EXPECT_THAT(
      MistakesInWorlds(oracle),
      ElementsAre(HasSubstr("moments of inertia are along the axes of the world")));
}

TEST(CheckOracle, NamesTheGyroscopicTorqueThatIsLeftOut) {
  Mistaken oracle(Right());
  oracle.simulates = [](World& world) {
    for (RigidBody& body : world.bodies)
      body.inertia = Vector3d::Constant(InertiaOf(body).sum() / 3);
    world.pushes.clear();
  };
  const std::vector<WorldCheck> worlds = CheckWorlds(oracle, Right());
  const auto spinning =
      std::ranges::find(worlds, "a box spins without torque", &WorldCheck::world);
  ASSERT_NE(spinning, worlds.end());
  EXPECT_THAT(spinning->mistakes,
              ElementsAre(HasSubstr("leaves out the gyroscopic torque")));
}

TEST(CheckOracle, LooksAtNoWorldsOfAnOracleWithoutThem) {
  EXPECT_TRUE(CheckWorlds(Right("cookbook/batch"), Right()).empty());
}

TEST(CheckOracle, NamesATouchingThatHasTheWrongSignToo) {
  Mistaken oracle(Right());
  oracle.answers = [](const ContactQuery&, ContactAnswer& answer) {
    answer.touching = !answer.touching;
    if (answer.separation) answer.separation = -*answer.separation;
    for (ContactPoint& point : answer.points) point.separation = -point.separation;
  };
  EXPECT_THAT(MistakesOf(oracle, ShapeKind::kSphere, ShapeKind::kSphere),
              ElementsAre(HasSubstr("and `touching` with it")));
}

// One wrong answer is no evidence, and a refusal is no wrong answer.
TEST(CheckOracle, NamesNoMistakeByOneAnswer) {
  Mistaken oracle(Right());
  auto asked = std::make_shared<int>(0);
  oracle.answers = [asked](const ContactQuery&, ContactAnswer& answer) {
    const int i = (*asked)++ % 24;
    if (i == 3 && answer.n_AB_W) answer.n_AB_W = -*answer.n_AB_W;
    if (i == 4) {
      answer = {};
      answer.reason = "not today";
    }
  };
  const PairCheck pair = CheckContacts(oracle).front();
  EXPECT_EQ(pair.wrong, 1U);
  EXPECT_EQ(pair.unsupported, 1U);
  EXPECT_TRUE(pair.mistakes.empty());
}

}  // namespace
}  // namespace touchstone
