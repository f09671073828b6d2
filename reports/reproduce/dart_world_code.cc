#include <algorithm>

#include <fmt/format.h>

#include "reports/reproduce/cpp_text.h"
#include "reports/reproduce/dart_text.h"
#include "reports/reproduce/world_code.h"

namespace touchstone {
namespace {

constexpr const char* kIncludes =
    "#include <limits>\n"
    "\n"
    "#include <dart/collision/dart/DARTCollisionDetector.hpp>\n"
    "#include <dart/constraint/ConstraintSolver.hpp>\n"
    "#include <dart/constraint/ContactConstraint.hpp>\n"
    "#include <dart/dynamics/BodyNode.hpp>\n"
    "#include <dart/dynamics/BoxShape.hpp>\n"
    "#include <dart/dynamics/FreeJoint.hpp>\n"
    "#include <dart/dynamics/Skeleton.hpp>\n"
    "#include <dart/dynamics/SphereShape.hpp>\n"
    "#include <dart/dynamics/WeldJoint.hpp>\n"
    "#include <dart/simulation/World.hpp>\n";

constexpr const char* kSurfaces = R"(
// DART takes the product of two bodies' restitutions and the smaller friction. The
// coefficients below make these the smaller restitution, and the root of the product of
// the frictions. This works because all moving bodies have the same coefficients.
constexpr double kRestitution = {restitution}, kFriction = {friction};  // Of moving bodies.
constexpr bool kOnlyOneMoves = {only_one_moves};
double RestitutionOf(const Body& body) {{
  if (kRestitution == 0) return 0;
  return std::min(body.restitution, kRestitution) / std::sqrt(kRestitution);
}}
double FrictionOf(const Body& body) {{
  if (body.mass == 0) return std::sqrt(kFriction * body.friction);
  // The static body's then decides, even if it is larger.
  return kOnlyOneMoves ? std::numeric_limits<double>::max() : kFriction;
}}

Eigen::Vector3d ToEigen(const Vector& v) {{ return {{v[0], v[1], v[2]}}; }}
Vector FromEigen(const Eigen::Vector3d& v) {{ return {{v[0], v[1], v[2]}}; }}
)";

constexpr const char* kMake =
    R"(  const dart::simulation::WorldPtr world = dart::simulation::World::create();
  world->setTimeStep(kStep);
  world->setGravity(ToEigen(kGravity));
  dart::constraint::ConstraintSolver& solver = *world->getConstraintSolver();
  // The default, fcl on meshes, turns spheres into polyhedra.
  solver.setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  // The default of 1000 would drop contacts of a pile.
  solver.getCollisionOption().maxNumContacts = std::numeric_limits<int>::max();
)";

constexpr const char* kBodies = R"(
  dart::dynamics::BodyNode* bodies[kCount] = {};
  for (int i = 0; i < kCount; ++i) {
    const Body& asked = kBodies[i];
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = Eigen::Matrix3d(asked.R.data()).transpose();
    X.translation() = ToEigen(asked.p);
    const dart::dynamics::SkeletonPtr skeleton =
        dart::dynamics::Skeleton::create(asked.name);
    if (asked.mass > 0) {
      const auto pair =
          skeleton->createJointAndBodyNodePair<dart::dynamics::FreeJoint>();
      bodies[i] = pair.second;
      // The joint's own coordinates start at zero.
      pair.first->setTransformFromParentBodyNode(X);
      const Eigen::Matrix3d moments = ToEigen(asked.I).asDiagonal();
      bodies[i]->setInertia(
          dart::dynamics::Inertia(asked.mass, Eigen::Vector3d::Zero(), moments));
      Eigen::Matrix<double, 6, 1> velocity;
      velocity << ToEigen(asked.w), ToEigen(asked.v);
      pair.first->setSpatialVelocity(velocity, dart::dynamics::Frame::World(),
                                     dart::dynamics::Frame::World());
    } else {
      const auto pair =
          skeleton->createJointAndBodyNodePair<dart::dynamics::WeldJoint>();
      bodies[i] = pair.second;
      pair.first->setTransformFromParentBodyNode(X);
    }
    if (asked.collides) {
      auto* const shape =
          bodies[i]
              ->createShapeNodeWith<dart::dynamics::CollisionAspect,
                                    dart::dynamics::DynamicsAspect>(shapes[i]);
      shape->getDynamicsAspect()->setFrictionCoeff(FrictionOf(asked));
      shape->getDynamicsAspect()->setRestitutionCoeff(RestitutionOf(asked));
    }
    world->addSkeleton(skeleton);
  }
)";

constexpr const char* kStep = R"(      for (int i = 0; i < kCount; ++i)
        if (kBodies[i].mass > 0) bodies[i]->addExtForce(ToEigen(kBodies[i].force));
      world->step();
)";

constexpr const char* kRead =
    R"(      const Eigen::Isometry3d& X = bodies[i]->getWorldTransform();
      const Eigen::Quaterniond q(X.linear());
      state[i] = {FromEigen(X.translation()), Rotation(q.w(), q.x(), q.y(), q.z()),
                  FromEigen(bodies[i]->getLinearVelocity()),
                  FromEigen(bodies[i]->getAngularVelocity())};
)";

/** Returns the definitions of the bodies' coefficients. */
std::string SurfacesText(const World& world) {
  const auto moves = [](const RigidBody& body) { return body.collides && body.mass > 0; };
  const auto first = std::ranges::find_if(world.bodies, moves);
  const bool any = first != world.bodies.end();
  const bool is_only = std::ranges::count_if(world.bodies, moves) == 1;
  return fmt::format(kSurfaces,
                     fmt::arg("restitution", Literal(any ? first->restitution : 0)),
                     fmt::arg("friction", Literal(any ? first->friction : 0)),
                     fmt::arg("only_one_moves", is_only));
}

}  // namespace

EngineCode DartWorldCode(const World& world, const OracleInfo& oracle) {
  const auto set = [&](const char* name, const char* setter) {
    return Explained(oracle, name,
                     fmt::format("dart::constraint::ContactConstraint::{}({});", setter,
                                 Literal(ValueOf(oracle, name))));
  };
  SimulationText text;
  text.set_up = kMake + set("contact_erp", "setErrorReductionParameter") +
                set("max_erv", "setMaxErrorReductionVelocity") +
                set("contact_cfm", "setConstraintForceMixing") +
                "  const dart::dynamics::ShapePtr shapes[kCount] = {\n";
  for (const RigidBody& body : world.bodies)
    text.set_up += fmt::format("      {},\n",
                               body.collides ? DartShape(body.placed.shape) : "nullptr");
  text.set_up += fmt::format("  }};\n{}", kBodies);
  text.step = kStep;
  text.read = kRead;
  EngineCode code;
  code.includes = kIncludes;
  code.definitions = SurfacesText(world);
  code.ask = SimulateText(text);
  code.find = FindDart();
  code.call = "dart::simulation::World::step with DARTCollisionDetector";
  code.package = "libdart-dev";
  return code;
}

}  // namespace touchstone
