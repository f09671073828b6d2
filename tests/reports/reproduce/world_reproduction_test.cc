#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/reproduce/engine_code.h"
#include "reports/reproduce/reproduction.h"

namespace touchstone {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

WorldParameter Parameter(std::string name, double here) {
  return {.name = std::move(name),
          .here = here,
          .shipped = 0.5,
          .least = 0,
          .most = 1,
          .whole = false,
          .what = "softness; dSomething",
          .why = "A reason."};
}

// A ball at rest, 0.1 m deep in a fixed one, at the only step of its world.
class WorldReproductionTest : public testing::Test {
 protected:
  WorldReproductionTest() {
    World& world = result_.scenario.world;
    world.dt = 0.25;
    world.steps = 1;
    world.gravity_W = {0, 0, -9.81};
    world.bodies.resize(2);
    world.bodies[0].name = "lower";
    world.bodies[0].mass = 0;
    world.bodies[0].placed.shape = Sphere{0.5};
    world.bodies[1].name = "upper {count}";
    world.bodies[1].placed.shape = Sphere{0.5};
    world.bodies[1].placed.X_WB.p_WB.z() = 0.9;
    Trajectory& trajectory = result_.trajectories.emplace_back();
    for (const double time : {0.0, 0.25}) {
      trajectory.times.push_back(time);
      WorldState& state = trajectory.samples.emplace_back();
      for (const RigidBody& body : world.bodies)
        state.bodies.push_back({body.placed.X_WB.p_WB, Eigen::Quaterniond::Identity(),
                                body.v_WB, body.w_WB});
    }
    oracle_.name = "ode";
    oracle_.library = "ODE";
    oracle_.parameters = {Parameter("contact_erp", 0.125), Parameter("joint_erp", 0.5),
                          Parameter("cfm", 0.75), Parameter("iterations", 20)};
    for (const char* name :
         {"restitution_threshold", "surface_layer", "max_correcting_velocity",
          "gyroscopic", "finite_rotation", "rolling_friction", "spinning_friction"}) {
      oracle_.parameters.push_back(Parameter(name, 0.5));  // As shipped.
    }
    finding_.measure = MeasureKind::kPenetration;
    finding_.law = "never_penetrates";
    finding_.universal = true;
    finding_.verdict = Verdict::kFail;
    finding_.value = 1 - 0.9;
    finding_.tolerance = 1e-9;
    finding_.cited.time = 0.25;
  }

  std::string Program() const { return Reproduce(result_, oracle_, finding_).program; }

  /** Returns the reason why no program can be written. */
  std::string Reason() const {
    try {
      return "none: " + Program();
    } catch (const CannotReproduce& error) {
      return error.what();
    }
  }

  World& world() { return result_.scenario.world; }
  BodyState& upper() { return result_.trajectories.front().samples.back().bodies.back(); }

  WorldResult result_;
  OracleInfo oracle_;
  Finding finding_;
};

TEST_F(WorldReproductionTest, SetsTheEngineUpWithTheParametersInForce) {
  EXPECT_THAT(Program(),
              AllOf(HasSubstr("contact.surface.soft_erp = 0.125;"),
                    HasSubstr("dWorldSetERP(world, 0.5);"),
                    HasSubstr("dWorldSetCFM(world, 0.75);"),
                    HasSubstr("dWorldStep(world, kStep);"), HasSubstr("kStep = 0.25;"),
                    HasSubstr("kGravity = {0.0, 0.0, -9.81};")));
  oracle_.setup.chosen["cfm"] = 0.625;
  EXPECT_THAT(Program(), HasSubstr("dWorldSetCFM(world, 0.625);"));
}

TEST_F(WorldReproductionTest, ExplainsAChangedParameterOnly) {
  const std::string program = Program();
  EXPECT_THAT(program, HasSubstr("// Softness; dSomething. Default: 0.5. A reason.\n"
                                 "  dWorldSetCFM"));
  EXPECT_THAT(program, HasSubstr("// Softness; dSomething. Default: 0.5.\n"
                                 "  dWorldSetERP"));
}

TEST_F(WorldReproductionTest, SetsWhatHasItsDefaultHereOnlyWhereItIsChosen) {
  EXPECT_THAT(Program(), AllOf(Not(HasSubstr("dContactRolling;")),
                               Not(HasSubstr("dBodySetGyroscopicMode"))));
  oracle_.setup.chosen = {{"gyroscopic", 0}, {"rolling_friction", 0.125}};
  EXPECT_THAT(Program(), AllOf(HasSubstr("contact.surface.mode |= dContactRolling;"),
                               HasSubstr("contact.surface.rho2 = 0.125;"),
                               HasSubstr("dBodySetGyroscopicMode(body, 0);")));
}

TEST_F(WorldReproductionTest, RefusesAProgramOfAUserThatHasTheSameLibrary) {
  oracle_.name = "ode@2";
  oracle_.external = true;
  EXPECT_THAT(Reason(), HasSubstr("is a program of its own"));
}

TEST_F(WorldReproductionTest, StepsQuickStepFromTheSameSeed) {
  oracle_.name = "ode/quick";
  EXPECT_THAT(Program(), AllOf(HasSubstr("dWorldQuickStep(world, kStep);"),
                               HasSubstr("dRandSetSeed(0);"),
                               HasSubstr("dWorldSetQuickStepNumIterations(world, 20);")));
}

class MujocoWorldReproductionTest : public WorldReproductionTest {
 protected:
  MujocoWorldReproductionTest() {
    oracle_.name = "mujoco";
    oracle_.library = "MuJoCo";
    oracle_.parameters = {Parameter("contact_time", 0),
                          Parameter("least_impedance", 0.875),
                          Parameter("impedance", 0.75),
                          Parameter("elliptic_cone", 1),
                          Parameter("solver_tolerance", 0.25),
                          Parameter("iterations", 0.5),
                          Parameter("margin", 0),
                          Parameter("noslip_iterations", 0.5),
                          Parameter("impratio", 0.5)};
  }
};

TEST_F(MujocoWorldReproductionTest, SetsTheEngineUpWithTheParametersInForce) {
  oracle_.setup.chosen["iterations"] = 30;
  oracle_.setup.chosen["least_impedance"] = 0.625;
  EXPECT_THAT(Program(), AllOf(HasSubstr("option.cone = mjCONE_ELLIPTIC;"),
                               HasSubstr("option.tolerance = 0.25;"),
                               HasSubstr("option.iterations = 30;"),
                               HasSubstr("option.o_solimp[0] = 0.625;"),
                               HasSubstr("option.o_solimp[1] = 0.75;")));
  oracle_.setup.chosen["elliptic_cone"] = 0;
  EXPECT_THAT(Program(), HasSubstr("option.cone = mjCONE_PYRAMIDAL;"));
}

TEST_F(MujocoWorldReproductionTest, MakesContactsSpringsOnlyWithATimeConstant) {
  EXPECT_THAT(Program(), HasSubstr("option.o_solref[1] = -0.75 / kStep;"));
  oracle_.setup.chosen["contact_time"] = 0.125;
  EXPECT_THAT(Program(), AllOf(HasSubstr("option.o_solref[0] = 0.125;"),
                               HasSubstr("option.o_solref[1] = 1;")));
}

TEST_F(MujocoWorldReproductionTest, IntegratesAsTheOracleDoes) {
  EXPECT_THAT(Program(), HasSubstr("option.integrator = mjINT_EULER;"));
  oracle_.name = "mujoco/rk4";
  EXPECT_THAT(Program(), HasSubstr("option.integrator = mjINT_RK4;"));
}

TEST_F(MujocoWorldReproductionTest, MakesEveryShape) {
  RigidBody& third = world().bodies.emplace_back(world().bodies.back());
  third.name = "third";
  third.placed.shape = Capsule{0.5, 0.25};
  EXPECT_THAT(Program(), HasSubstr(R"(type="capsule" size="0.5 0.25")"));
  third.placed.shape = Cylinder{0.5, 0.75};
  EXPECT_THAT(Program(), AllOf(HasSubstr(R"(type="cylinder" size="0.5 0.75")"),
                               Not(HasSubstr("<asset>"))));
  third.placed.shape =
      ConvexHull{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  EXPECT_THAT(Program(), AllOf(HasSubstr(R"(type="mesh" mesh="m2")"),
                               HasSubstr(R"(<mesh name="m2" vertex="1 0 0  -1 0 0  )")));
}

TEST_F(MujocoWorldReproductionTest, NamesPairsOnlyIfFrictionsDiffer) {
  EXPECT_THAT(Program(), AllOf(HasSubstr("dynamic"), Not(HasSubstr("<pair"))));
  world().bodies[0].friction = 0.5;
  world().bodies[1].friction = 0.125;
  EXPECT_THAT(Program(), AllOf(HasSubstr("predefined"),
                               HasSubstr(R"(<pair geom1="g0" geom2="g1" condim="3" )"
                                         R"(friction="0.25 0.25 0 0 0"/>)")));
}

TEST_F(MujocoWorldReproductionTest, GivesFrictionlessContactsOneDimension) {
  EXPECT_THAT(Program(), HasSubstr(R"(condim="3" friction="0.6 0 0")"));
  for (RigidBody& body : world().bodies) body.friction = 0;
  EXPECT_THAT(Program(), AllOf(HasSubstr(R"(condim="1" friction="0 0 0")"),
                               Not(HasSubstr(R"(condim="3")"))));
}

TEST_F(MujocoWorldReproductionTest, GivesABodyThatDoesNotCollideNoGeom) {
  RigidBody& third = world().bodies.emplace_back(world().bodies.back());
  third.name = "third";
  third.collides = false;
  EXPECT_THAT(Program(),
              AllOf(HasSubstr(R"(<body name="b2")"), HasSubstr(R"(<geom name="g1")"),
                    Not(HasSubstr(R"(<geom name="g2")"))));
}

class DartWorldReproductionTest : public WorldReproductionTest {
 protected:
  DartWorldReproductionTest() {
    oracle_.name = "dart";
    oracle_.library = "DART";
    oracle_.parameters = {Parameter("contact_erp", 0.125), Parameter("max_erv", 0.25),
                          Parameter("contact_cfm", 0.75)};
    world().bodies[1].restitution = 0.25;
    world().bodies[1].friction = 0.5;
  }
};

TEST_F(DartWorldReproductionTest, SetsTheEngineUpWithTheParametersInForce) {
  oracle_.setup.chosen["contact_cfm"] = 0.625;
  EXPECT_THAT(Program(), AllOf(HasSubstr("setErrorReductionParameter(0.125);"),
                               HasSubstr("setMaxErrorReductionVelocity(0.25);"),
                               HasSubstr("setConstraintForceMixing(0.625);")));
}

TEST_F(DartWorldReproductionTest, BoundsFrictionByMovingBodiesUnlessOnlyOneMoves) {
  EXPECT_THAT(Program(),
              AllOf(HasSubstr("kRestitution = 0.25"), HasSubstr("kFriction = 0.5;"),
                    HasSubstr("kOnlyOneMoves = true;")));
  world().bodies.emplace_back(world().bodies.back()).name = "third";
  result_.trajectories.front().samples.back().bodies.push_back(upper());
  EXPECT_THAT(Program(), HasSubstr("kOnlyOneMoves = false;"));
}

TEST_F(DartWorldReproductionTest, IgnoresTheSurfaceOfABodyThatDoesNotCollide) {
  RigidBody ghost = world().bodies.back();
  ghost.name = "ghost";
  ghost.collides = false;
  ghost.restitution = 0.75;
  ghost.placed.shape = Cylinder{0.5, 0.5};
  ghost.inertia = Eigen::Vector3d(1, 1, 1);
  // It comes first, where the coefficients of all moving bodies are read.
  world().bodies.push_back(world().bodies[1]);
  world().bodies[1] = ghost;
  std::vector<BodyState>& states = result_.trajectories.front().samples.back().bodies;
  states.push_back(states.back());
  EXPECT_THAT(Program(),
              AllOf(HasSubstr("kRestitution = 0.25"), HasSubstr("kOnlyOneMoves = true;"),
                    HasSubstr("      nullptr,\n")));
}

TEST_F(WorldReproductionTest, KeepsTheProofInComments) {
  finding_.proof = "one */ two\n#error three";
  const std::string program = Program();
  std::istringstream lines(program);
  std::string line;
  while (std::getline(lines, line) && line.find("#include") != 0) {
    if (line.empty()) continue;
    EXPECT_THAT(line, StartsWith("//"));
  }
  EXPECT_THAT(program, Not(HasSubstr("\n#error")));
}

TEST_F(WorldReproductionTest, KeepsNamesWithBraces) {
  EXPECT_THAT(Program(), HasSubstr("\"upper {count}\""));
}

TEST_F(WorldReproductionTest, ComputesTheOverlapOfSpheresBoxesAndHalfSpaces) {
  upper().p_WB.z() = 0.95;
  world().bodies[0].placed.shape = Box{{0.5, 0.5, 0.5}};
  finding_.value = 1 - 0.95;
  EXPECT_THAT(Program(), HasSubstr("a sphere and a box"));
  world().bodies[1].placed.shape = Box{{0.5, 0.5, 0.5}};
  EXPECT_THAT(Program(), HasSubstr("overlap of two boxes"));
  world().bodies[0].placed.shape = HalfSpace{};
  upper().p_WB.z() = 0.25;
  finding_.value = 0.25;
  EXPECT_THAT(Program(), HasSubstr("a box and a half-space"));
  world().bodies[1].placed.shape = Sphere{0.5};
  EXPECT_THAT(Program(), HasSubstr("a sphere and a half-space"));
}

TEST_F(WorldReproductionTest, RefusesTheOverlapOfOtherShapes) {
  world().bodies[0].placed.shape = Cylinder{0.5, 0.5};
  finding_.value = 0.1;
  EXPECT_THAT(Reason(), HasSubstr("expected spheres, boxes and half-spaces"));
}

TEST_F(WorldReproductionTest, RefusesANumberThatIsNotOfTheMotion) {
  finding_.value = 0.3;
  EXPECT_THAT(Reason(), HasSubstr("cannot compute penetration"));
}

TEST_F(WorldReproductionTest, ComputesTheWayOfASphereThroughWhatIsFixed) {
  upper().p_WB = {0, 0.25, -3};
  result_.trajectories.front().samples.front().bodies.back().p_WB = {0, 0.25, 3};
  finding_.measure = MeasureKind::kPassage;
  finding_.value = 1 - 0.25;
  EXPECT_THAT(Program(), AllOf(HasSubstr("Passage(states.at(0), states.at(1))"),
                               HasSubstr("return 0.5 + 0.5 - std::hypot(")));
  world().bodies[0].placed.shape = Box{{0.5, 0.75, 0.5}};
  finding_.value = 0.5 + 0.5;
  EXPECT_THAT(Program(), HasSubstr("half = {0.5, 0.75, 0.5};"));
  world().bodies[0].mass = 1;
  EXPECT_THAT(Reason(), HasSubstr("passes through a fixed sphere or box"));
}

TEST_F(WorldReproductionTest, RefusesMeasuresWithoutACheck) {
  finding_.measure = MeasureKind::kRestMotion;
  EXPECT_THAT(Reason(), AllOf(HasSubstr("cannot check rest_motion"),
                              HasSubstr("it can check penetration, passage")));
}

TEST_F(WorldReproductionTest, RefusesACrash) {
  finding_.verdict = Verdict::kCrashed;
  EXPECT_THAT(Reason(), HasSubstr("the verdict is 'crashed'"));
}

TEST_F(WorldReproductionTest, RefusesOtherEngines) {
  oracle_.name = oracle_.library = "cookbook";
  EXPECT_THAT(Reason(), HasSubstr("expected an oracle of ODE, Bullet, MuJoCo or DART"));
}

TEST_F(WorldReproductionTest, RefusesAllButRigidBodies) {
  const World plain = world();
  const auto expect_refusal = [&](const char* what) {
    EXPECT_THAT(Reason(), AllOf(HasSubstr(std::string("the world has ") + what),
                                HasSubstr("expected rigid bodies alone")));
    world() = plain;
  };
  world().particles.emplace_back();
  expect_refusal("particles");
  world().springs.emplace_back();
  expect_refusal("springs");
  world().joints.emplace_back();
  expect_refusal("distance joints");
  world().cloths.emplace_back();
  expect_refusal("cloths");
  world().pushes.emplace_back();
  expect_refusal("pushes");
}

TEST_F(WorldReproductionTest, ComparesAVelocityWithWhatTheFileExpects) {
  upper().v_WB = {0, 0, -1};
  result_.scenario.expectations.push_back(
      {.body = "upper {count}",
       .time = 0.25,
       .tolerance = 0.125,
       .what = ExpectedVector{ExpectedVector::Of::kVelocity, {0, 0, -2.5}, {}},
       .because = ""});
  finding_.measure = MeasureKind::kVelocityError;
  finding_.value = 1.5;
  EXPECT_THAT(Program(), AllOf(HasSubstr("states.at(1)[1].v"),
                               HasSubstr("truth = {0.0, 0.0, -2.5};")));
  std::get<ExpectedVector>(result_.scenario.expectations.front().what).along = {
      Eigen::Vector3d(0, 0, 2)};
  EXPECT_THAT(Program(), HasSubstr("std::abs(0.0 * off[0] + 0.0 * off[1] + 1.0 * "));
}

TEST_F(WorldReproductionTest, ComparesAPositionWithTheClosedFormOfALaw) {
  result_.scenario.claims.push_back(
      {.law = "ballistic", .about = {}, .numbers = {}, .because = ""});
  finding_.measure = MeasureKind::kPositionError;
  finding_.law = "ballistic";
  finding_.universal = false;
  finding_.value = 9.81 / 2 * 0.0625;
  EXPECT_THAT(Program(), HasSubstr("states.at(1)[1].p"));
}

TEST_F(WorldReproductionTest, RefusesANumberThatNoLawStates) {
  finding_.measure = MeasureKind::kVelocityError;
  finding_.law = "ballistic";
  EXPECT_THAT(Reason(),
              HasSubstr("cannot compute velocity_error of the law 'ballistic'"));
}

TEST_F(WorldReproductionTest, ComparesTheEnergyOfTwoSteps) {
  upper().v_WB = {0, 0, 2};
  finding_.measure = MeasureKind::kEnergyDrift;
  finding_.law = "energy_never_rises";
  finding_.value = 2;
  EXPECT_THAT(Program(), AllOf(HasSubstr("EnergyOf(Start())"),
                               HasSubstr("const double error = (after - before);")));
}

TEST_F(WorldReproductionTest, ComparesTheMomentumWithThatOfTheStartAndTheLoads) {
  finding_.measure = MeasureKind::kMomentumDrift;
  finding_.law = "conserves_momentum";
  finding_.value = 9.81 * 0.25;
  EXPECT_THAT(Program(), HasSubstr("const Vector truth = {0.0, 0.0, -2.4525};"));
}

}  // namespace
}  // namespace touchstone
