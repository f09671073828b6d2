#include "reports/adapter_check/world_mistakes.h"

#include <numbers>
#include <utility>

#include <Eigen/Geometry>

namespace touchstone {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180;

using BodyChange = std::function<void(RigidBody&)>;
using StateChange = std::function<void(const RigidBody&, BodyState&)>;

// A mistake with each body of a world.
WorldMistake OfBodies(std::string sentence, const BodyChange& change) {
  return {std::move(sentence),
          [change](const World& world) -> std::optional<World> {
            World simulated = world;
            for (RigidBody& body : simulated.bodies) change(body);
            return simulated;
          },
          {}};
}

WorldMistake OfGravity(std::string sentence,
                       const std::function<Vector3d(const Vector3d&)>& change) {
  return {std::move(sentence),
          [change](const World& world) -> std::optional<World> {
            if (world.gravity_W.isZero()) return std::nullopt;
            World simulated = world;
            simulated.gravity_W = change(world.gravity_W);
            return simulated;
          },
          {}};
}

WorldMistake OfPushes(std::string sentence, const std::function<void(World&)>& change) {
  return {std::move(sentence),
          [change](const World& world) -> std::optional<World> {
            if (world.pushes.empty()) return std::nullopt;
            World simulated = world;
            change(simulated);
            return simulated;
          },
          {}};
}

// A mistake with each state of a motion. `undo` gets the state with the mistake.
WorldMistake OfStates(std::string sentence, const StateChange& undo) {
  return {std::move(sentence), {}, [undo](const World& world, Trajectory& motion) {
            for (WorldState& sample : motion.samples) {
              for (std::size_t i = 0; i < sample.bodies.size(); ++i)
                undo(world.bodies[i], sample.bodies[i]);
            }
          }};
}

void Turn(RigidBody& body, const Matrix3d& R_WB) {
  body.placed.X_WB = Pose::FromMatrix(body.placed.X_WB.p_WB, R_WB);
}

Quaterniond OrientationOf(const RigidBody& body) {
  const Pose& X_WB = body.placed.X_WB;
  return X_WB.q_WB ? *X_WB.q_WB : Quaterniond(X_WB.R_WB).normalized();
}

// From the least corner of a box to its centre. Zero for other shapes.
Vector3d HalfOf(const RigidBody& body) {
  const auto* box = std::get_if<Box>(&body.placed.shape);
  return box == nullptr ? Vector3d::Zero() : box->half_extents;
}

void ScaleBox(RigidBody& body, double factor) {
  if (std::holds_alternative<Box>(body.placed.shape))
    body.placed.shape = Resized(body.placed.shape, factor);
}

std::vector<WorldMistake> MistakesWithAnswers() {
  std::vector<WorldMistake> mistakes;
  mistakes.push_back(OfStates("its orientations are x, y, z, w; expected w, x, y, z",
                              [](const RigidBody&, BodyState& state) {
                                const Quaterniond q = state.q_WB;
                                state.q_WB = Quaterniond(q.z(), q.w(), q.x(), q.y());
                              }));
  mistakes.push_back(OfStates(
      "its orientations are inverse; expected body to world",
      [](const RigidBody&, BodyState& state) { state.q_WB = state.q_WB.conjugate(); }));
  mistakes.push_back(OfStates(
      "its velocity and its spin are exchanged",
      [](const RigidBody&, BodyState& state) { std::swap(state.v_WB, state.w_WB); }));
  mistakes.push_back(OfStates(
      "its spin is in the frame of the body; expected the world's",
      [](const RigidBody&, BodyState& state) { state.w_WB = state.q_WB * state.w_WB; }));
  mistakes.push_back(OfStates(
      "its velocity is in the frame of the body; expected the world's",
      [](const RigidBody&, BodyState& state) { state.v_WB = state.q_WB * state.v_WB; }));
  mistakes.push_back(
      OfStates("its spin is in degrees a second; expected radians",
               [](const RigidBody&, BodyState& state) { state.w_WB *= kDegree; }));
  mistakes.push_back(
      OfStates("its positions are those of a corner; expected the centre of mass",
               [](const RigidBody& body, BodyState& state) {
                 state.p_WB += state.q_WB * HalfOf(body);
               }));
  return mistakes;
}

std::vector<WorldMistake> MistakesWithQuestions() {
  std::vector<WorldMistake> mistakes;
  mistakes.push_back(OfGravity("it leaves out gravity", [](const Vector3d&) {
    return Vector3d(Vector3d::Zero());
  }));
  mistakes.push_back(OfGravity("its gravity points up: it has the other sign",
                               [](const Vector3d& g) { return Vector3d(-g); }));
  mistakes.push_back(OfGravity(
      "its gravity is along −y whatever the world says",
      [](const Vector3d& g) { return Vector3d(-g.norm() * Vector3d::UnitY()); }));
  mistakes.push_back(OfGravity(
      "its gravity is along −z whatever the world says",
      [](const Vector3d& g) { return Vector3d(-g.norm() * Vector3d::UnitZ()); }));
  mistakes.push_back(OfBodies("it leaves out the initial velocity",
                              [](RigidBody& body) { body.v_WB.setZero(); }));
  mistakes.push_back(OfBodies("it leaves out the initial spin",
                              [](RigidBody& body) { body.w_WB.setZero(); }));
  mistakes.push_back(OfBodies("it takes the spin for degrees a second; it is in radians",
                              [](RigidBody& body) { body.w_WB *= kDegree; }));
  mistakes.push_back(OfBodies(
      "it turns the spin from radians into degrees; radians are expected by its engine",
      [](RigidBody& body) { body.w_WB /= kDegree; }));
  mistakes.push_back(
      OfBodies("it takes the spin for one in the frame of the body; it is in the world's",
               [](RigidBody& body) { body.w_WB = body.placed.X_WB.R_WB * body.w_WB; }));
  mistakes.push_back(OfBodies(
      "it takes the velocity for one in the frame of the body; it is in the world's",
      [](RigidBody& body) { body.v_WB = body.placed.X_WB.R_WB * body.v_WB; }));
  mistakes.push_back(
      OfBodies("it reads the quaternion w, x, y, z as x, y, z, w", [](RigidBody& body) {
        const Quaterniond q = OrientationOf(body);
        Turn(body, Quaterniond(q.z(), q.w(), q.x(), q.y()).toRotationMatrix());
      }));
  mistakes.push_back(OfBodies(
      "it gives its engine the quaternion as x, y, z, w, which reads it as w, x, y, z",
      [](RigidBody& body) {
        const Quaterniond q = OrientationOf(body);
        Turn(body, Quaterniond(q.x(), q.y(), q.z(), q.w()).toRotationMatrix());
      }));
  mistakes.push_back(
      OfBodies("it turns bodies by the inverse rotation",
               [](RigidBody& body) { Turn(body, body.placed.X_WB.R_WB.transpose()); }));
  mistakes.push_back(OfBodies("it does not turn bodies at all",
                              [](RigidBody& body) { Turn(body, Matrix3d::Identity()); }));
  mistakes.push_back(OfBodies(
      "it takes the half extents of a box for its edges: its boxes are half as large",
      [](RigidBody& body) { ScaleBox(body, 0.5); }));
  mistakes.push_back(OfBodies(
      "it takes the edges of a box for its half extents: its boxes are twice as large",
      [](RigidBody& body) { ScaleBox(body, 2); }));
  mistakes.push_back(OfBodies(
      "it takes the position for that of a corner; expected that of the centre of mass",
      [](RigidBody& body) {
        body.placed.X_WB.p_WB += body.placed.X_WB.R_WB * HalfOf(body);
      }));
  mistakes.push_back(OfBodies(
      "it leaves out the gyroscopic torque: the spin stays as it is, whatever the "
      "moments "
      "of inertia; switch the torque on, or make it a parameter with its shipped default",
      [](RigidBody& body) {
        if (body.mass > 0) body.inertia = Vector3d::Constant(InertiaOf(body).maxCoeff());
      }));
  mistakes.push_back(
      OfPushes("it leaves out pushes", [](World& world) { world.pushes.clear(); }));
  mistakes.push_back(
      OfPushes("it pushes at the centre of mass, whatever the point", [](World& world) {
        for (Push& push : world.pushes) push.p_BoP.setZero();
      }));
  mistakes.push_back(OfPushes(
      "it takes the point of a push for one in the axes of the world; it is in the "
      "frame of the body",
      [](World& world) {
        for (Push& push : world.pushes) {
          const RigidBody& body = world.bodies[static_cast<std::size_t>(push.body)];
          push.p_BoP = body.placed.X_WB.R_WB.transpose() * push.p_BoP;
        }
      }));
  return mistakes;
}

// The moments of inertia along the axes of the world at the start, in place of those of
// the body: the motion of a body that is not turned, which is turned afterwards.
WorldMistake InertiaAlongWorldAxes() {
  return {
      "its moments of inertia are along the axes of the world at the start; expected the "
      "axes of the body",
      [](const World& world) -> std::optional<World> {
        World simulated = world;
        for (RigidBody& body : simulated.bodies) {
          if (body.mass > 0) Turn(body, Matrix3d::Identity());
        }
        return simulated;
      },
      [](const World& world, Trajectory& motion) {
        for (WorldState& sample : motion.samples) {
          for (std::size_t i = 0; i < sample.bodies.size(); ++i) {
            if (world.bodies[i].mass == 0) continue;
            sample.bodies[i].q_WB =
                sample.bodies[i].q_WB * OrientationOf(world.bodies[i]).conjugate();
          }
        }
      }};
}

}  // namespace

const std::vector<WorldMistake>& WorldMistakes() {
  static const std::vector<WorldMistake> kMistakes = [] {
    std::vector<WorldMistake> mistakes = MistakesWithAnswers();
    for (WorldMistake& mistake : MistakesWithQuestions())
      mistakes.push_back(std::move(mistake));
    mistakes.push_back(InertiaAlongWorldAxes());
    return mistakes;
  }();
  return kMistakes;
}

}  // namespace touchstone
