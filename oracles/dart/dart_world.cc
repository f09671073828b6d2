#include "oracles/dart/dart_world.h"

#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

#include <dart/collision/CollisionObject.hpp>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>
#include <fmt/format.h>

#include "oracles/dart/dart_shape.h"
#include "oracles/dart/dart_surfaces.h"

namespace touchstone {
namespace {

using dart::constraint::ContactConstraint;
using dart::dynamics::BodyNode;
using dart::dynamics::FreeJoint;
using dart::dynamics::Skeleton;
using Eigen::Vector3d;

// Indices of the parameters.
enum Parameter : std::size_t {
  kContactErp,
  kMaxErrorReductionVelocity,
  kConstraintForceMixing,
  kParameters,
};

class DartSimulation final : public Simulation {
 public:
  DartSimulation(const World& world, std::span<const double> values)
      : question_(world), values_(values.begin(), values.end()), surfaces_(world) {
    world_->setTimeStep(world.dt);
    world_->setGravity(world.gravity_W);
    dart::constraint::ConstraintSolver& solver = *world_->getConstraintSolver();
    solver.setCollisionDetector(dart::collision::DARTCollisionDetector::create());
    solver.getCollisionOption().maxNumContacts = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < world.bodies.size(); ++i) Add(i);
  }

  void Push(int body, const Vector3d& p_W, const Vector3d& J_W) override {
    FreeJoint* const joint = joints_[static_cast<std::size_t>(body)];
    if (joint == nullptr) return;
    // DART has no impulses, only forces, and a bounce ignores a force that acts during
    // the same step. So the velocities are set.
    const RigidBody& asked = question_.bodies[static_cast<std::size_t>(body)];
    const BodyNode& node = *joint->getChildBodyNode();
    const Eigen::Isometry3d& X_WB = node.getWorldTransform();
    const Eigen::Matrix3d R_WB = X_WB.linear();
    const Vector3d r_W = p_W - X_WB.translation();
    SetVelocity(
        *joint, node.getLinearVelocity() + J_W / asked.mass,
        node.getAngularVelocity() +
            R_WB * (R_WB.transpose() * r_W.cross(J_W)).cwiseQuotient(InertiaOf(asked)));
  }

  void Step() override {
    // These are global variables: another simulation may have changed them.
    ContactConstraint::setErrorReductionParameter(values_[kContactErp]);
    ContactConstraint::setMaxErrorReductionVelocity(values_[kMaxErrorReductionVelocity]);
    ContactConstraint::setConstraintForceMixing(values_[kConstraintForceMixing]);
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (joints_[i] != nullptr)
        joints_[i]->getChildBodyNode()->addExtForce(question_.bodies[i].force_W);
    }
    world_->step();
  }

  void Read(WorldState& state) const override {
    state.bodies.resize(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (joints_[i] == nullptr) {
        const Pose& X_WB = question_.bodies[i].placed.X_WB;
        state.bodies[i] = {X_WB.p_WB,
                           X_WB.q_WB ? *X_WB.q_WB : Eigen::Quaterniond(X_WB.R_WB),
                           Vector3d::Zero(), Vector3d::Zero()};
        continue;
      }
      const BodyNode& node = *joints_[i]->getChildBodyNode();
      const Eigen::Isometry3d& X_WB = node.getWorldTransform();
      state.bodies[i] = {X_WB.translation(), Eigen::Quaterniond(X_WB.linear()),
                         node.getLinearVelocity(), node.getAngularVelocity()};
    }
  }

  void ReadImpulses(std::vector<ContactImpulse>& impulses) const override {
    const dart::collision::CollisionResult& result = world_->getLastCollisionResult();
    for (std::size_t i = 0; i < result.getNumContacts(); ++i) {
      const dart::collision::Contact& contact = result.getContact(i);
      ContactImpulse impulse;
      impulse.A = IndexOf(*contact.collisionObject1);
      impulse.B = IndexOf(*contact.collisionObject2);
      if (joints_[static_cast<std::size_t>(impulse.A)] == nullptr &&
          joints_[static_cast<std::size_t>(impulse.B)] == nullptr) {
        continue;
      }
      impulse.p_WC = contact.point;
      impulse.n_AB_W = -contact.normal;
      impulse.J_B_W = -question_.dt * contact.force;
      impulse.separation = -contact.penetrationDepth;
      impulses.push_back(impulse);
    }
  }

  bool GivesImpulses() const override { return true; }

 private:
  static void SetVelocity(FreeJoint& joint, const Vector3d& v_W, const Vector3d& w_W) {
    Eigen::Matrix<double, 6, 1> velocity;
    velocity << w_W, v_W;
    joint.setSpatialVelocity(velocity, dart::dynamics::Frame::World(),
                             dart::dynamics::Frame::World());
  }

  int IndexOf(const dart::collision::CollisionObject& object) const {
    const dart::dynamics::ShapeNode* const shape = object.getShapeFrame()->asShapeNode();
    return indices_.at(shape->getBodyNodePtr().get());
  }

  void Add(std::size_t i) {
    const RigidBody& asked = question_.bodies[i];
    const Eigen::Isometry3d X_WB = ToDart(asked.placed.X_WB);
    const dart::dynamics::SkeletonPtr skeleton = Skeleton::create(asked.name);
    BodyNode* node = nullptr;
    if (asked.mass > 0) {
      const auto pair = skeleton->createJointAndBodyNodePair<FreeJoint>();
      node = pair.second;
      joints_.push_back(pair.first);
      // The joint's own coordinates start at zero, so no angle is rounded by a logarithm.
      pair.first->setTransformFromParentBodyNode(X_WB);
      const Eigen::Matrix3d moments = InertiaOf(asked).asDiagonal();
      node->setInertia(dart::dynamics::Inertia(asked.mass, Vector3d::Zero(), moments));
      SetVelocity(*pair.first, asked.v_WB, asked.w_WB);
    } else {
      const auto pair = skeleton->createJointAndBodyNodePair<dart::dynamics::WeldJoint>();
      node = pair.second;
      joints_.push_back(nullptr);
      pair.first->setTransformFromParentBodyNode(X_WB);
    }
    indices_[node] = static_cast<int>(i);
    if (asked.collides) {
      auto* const shape = node->createShapeNodeWith<dart::dynamics::CollisionAspect,
                                                    dart::dynamics::DynamicsAspect>(
          ToDart(asked.placed.shape));
      shape->getDynamicsAspect()->setFrictionCoeff(surfaces_.FrictionOf(asked));
      shape->getDynamicsAspect()->setRestitutionCoeff(surfaces_.RestitutionOf(asked));
    }
    world_->addSkeleton(skeleton);
  }

  World question_;
  std::vector<double> values_;  // Values of the parameters.
  DartSurfaces surfaces_;
  dart::simulation::WorldPtr world_ = dart::simulation::World::create();
  std::vector<FreeJoint*> joints_;  // Indexed by body; null for static bodies.
  std::unordered_map<const BodyNode*, int> indices_;
};

// Returns why DART does not simulate `feature`; empty if it does.
std::string WhyNot(WorldFeature feature) {
  switch (feature) {
    case WorldFeature::kCapsule:
    case WorldFeature::kCylinder:
    case WorldFeature::kCone:
    case WorldFeature::kConvexHull:
    case WorldFeature::kStaticCapsule:
    case WorldFeature::kStaticCylinder:
    case WorldFeature::kStaticCone:
    case WorldFeature::kStaticConvexHull:
    case WorldFeature::kStaticHalfSpace:
      return fmt::format(
          "DART's own collision detector has no {}; its others turn "
          "spheres into polyhedra",
          NameOf(feature));
    case WorldFeature::kParticle:
    case WorldFeature::kCloth:
      return "DART has no point masses that bounce";
    case WorldFeature::kSpring:
      return "DART has springs along its joints but none between two points";
    case WorldFeature::kDistanceJoint:
      return "DART has no distance joint between two points";
    default:
      return "";
  }
}

std::vector<WorldParameter> Parameters() {
  std::vector<WorldParameter> parameters(kParameters);
  parameters[kContactErp] = {
      .name = "contact_erp",
      .here = 0,
      .shipped = 0.01,
      .least = 0,
      .most = 1,
      .whole = false,
      .what =
          "fraction of an overlap that a step removes; "
          "ContactConstraint::setErrorReductionParameter",
      .why =
          "Overlap is not pushed out, which would add energy: bodies rest at the "
          "depth at which they were found."};
  parameters[kMaxErrorReductionVelocity] = {
      .name = "max_erv",
      .here = 1e-3,
      .shipped = 1e-3,
      .least = 0,
      .most = 1e3,
      .whole = false,
      .what =
          "greatest speed in m/s at which overlap is removed; "
          "ContactConstraint::setMaxErrorReductionVelocity",
      .why = ""};
  parameters[kConstraintForceMixing] = {
      .name = "contact_cfm",
      .here = 1e-9,
      .shipped = 1e-5,
      .least = 1e-9,
      .most = 1,
      .whole = false,
      .what =
          "softness of contacts as a fraction of the diagonal, unlike ODE's; "
          "ContactConstraint::setConstraintForceMixing",
      .why = "The smallest value that DART allows."};
  return parameters;
}

}  // namespace

std::unique_ptr<Simulation> DartWorld(const World& world,
                                      std::span<const double> values) {
  return std::make_unique<DartSimulation>(world, values);
}

void DescribeDartWorlds(OracleInfo& info) {
  info.simulates = true;
  for (int i = 0; i < kWorldFeatures; ++i) {
    const std::string reason = WhyNot(static_cast<WorldFeature>(i));
    info.world_capabilities[static_cast<std::size_t>(i)] = {reason.empty(), reason};
  }
  const std::vector<Setting> settings = {
      {"world: solver", "BoxedLcpConstraintSolver: Dantzig, PGS if that fails",
       "DART's default."},
      {"world: integrator", "semi-implicit Euler, rotation by the exponential map",
       "There is no other."},
      {"world: collision detector", "DARTCollisionDetector",
       "The default, fcl on meshes, turns spheres into polyhedra."},
      {"world: contacts", "any number",
       "DART's default of 1000 would drop contacts of a pile."},
      {"world: bounce rule", "the velocity after gravity is reflected",
       "DART integrates velocities before it solves contacts."},
      {"world: restitution", "product of coefficients that yield min(e_A, e_B)",
       "Possible if all moving bodies have one e; other worlds are unsupported."},
      {"world: restitution velocity threshold", "0.1 m/s after the bounce; e > 0.001",
       "Fixed in ContactConstraint.cpp."},
      {"world: friction", "smaller of coefficients that yield sqrt(mu_A mu_B)",
       "Possible if all moving bodies have one mu and no static body has more, or if one "
       "body moves; other worlds are unsupported. DART treats "
       "friction up to 0.001 as 0."},
      {"world: friction cone", "box",
       "Coulomb's law along each of two fixed directions: a square, not a circle."},
      {"world: push", "velocities set", "DART has no impulses."},
      {"world: gyroscopic term", "on, explicit", "BodyNode's default."},
      {"world: damping, sleeping", "0, none", "DART's default."},
      {"world: impulses", "Contact::force times the step",
       "It acts on the first body: negated."},
  };
  info.settings.insert(info.settings.end(), settings.begin(), settings.end());
  info.parameters = Parameters();
}

}  // namespace touchstone
