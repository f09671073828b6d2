#include "oracles/ode/ode_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>

#include <ode/ode.h>

#include "oracles/ode/ode_geom.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

// The maximum number of points that ODE returns for a pair of boxes.
constexpr int kMaxContacts = 8;

// Indices of the parameters. Only QuickStep has kIterations.
enum Parameter : std::size_t {
  kContactErp,
  kJointErp,
  kConstraintForceMixing,
  kRestitutionThreshold,
  kSurfaceLayer,
  kMaxCorrectingVelocity,
  kGyroscopic,
  kFiniteRotation,
  kRollingFriction,
  kSpinningFriction,
  kIterations,
};

struct Destroy {
  void operator()(dxThreadingImplementation* x) const { dThreadingFreeImplementation(x); }
  void operator()(dxWorld* x) const { dWorldDestroy(x); }
  void operator()(dxSpace* x) const { dSpaceDestroy(x); }
  void operator()(dxJointGroup* x) const { dJointGroupDestroy(x); }
};

template <typename T>
using Owned = std::unique_ptr<T, Destroy>;

Vector3d FromOde(const dReal* v) {
  return {v[0], v[1], v[2]};
}

// Replaces ODE's global random seed by that of a world during a scope. So the result of
// QuickStep does not depend on other worlds.
class OwnRandom {
 public:
  explicit OwnRandom(unsigned long& seed) : seed_(seed), others_(dRandGetSeed()) {
    dRandSetSeed(seed_);
  }
  ~OwnRandom() {
    seed_ = dRandGetSeed();
    dRandSetSeed(others_);
  }
  OwnRandom(const OwnRandom&) = delete;
  OwnRandom& operator=(const OwnRandom&) = delete;

 private:
  unsigned long& seed_;
  unsigned long others_;
};

class OdeSimulation final : public Simulation {
 public:
  OdeSimulation(const World& world, OdeStepper stepper, std::span<const double> values)
      : question_(world),
        stepper_(stepper),
        values_(values.begin(), values.end()),
        threading_(dThreadingAllocateSelfThreadedImplementation()),
        world_(dWorldCreate()),
        contact_joints_(dJointGroupCreate(0)),
        space_(dHashSpaceCreate(nullptr)) {
    // The default threading is global: stepping two worlds at once would abort.
    dWorldSetStepThreadingImplementation(
        world_.get(), dThreadingImplementationGetFunctions(threading_.get()),
        threading_.get());
    dSpaceSetCleanup(space_.get(), 0);  // geoms_ owns the geoms.
    const Vector3d& g = world.gravity_W;
    dWorldSetGravity(world_.get(), g.x(), g.y(), g.z());
    dWorldSetERP(world_.get(), values[kJointErp]);
    dWorldSetCFM(world_.get(), values[kConstraintForceMixing]);
    dWorldSetContactSurfaceLayer(world_.get(), values[kSurfaceLayer]);
    dWorldSetContactMaxCorrectingVel(world_.get(), values[kMaxCorrectingVelocity]);
    if (stepper == OdeStepper::kQuickStep) {
      dWorldSetQuickStepNumIterations(world_.get(),
                                      static_cast<int>(values[kIterations]));
    }
    geoms_.reserve(world.bodies.size());
    for (const RigidBody& body : world.bodies) Add(body);
    for (const DistanceJoint& joint : world.joints)
      Connect(joint.A, joint.B, joint.length);
    for (const Spring& spring : world.springs) Add(spring);
  }

  void Push(int body, const Vector3d& p_W, const Vector3d& J_W) override {
    const dBodyID pushed = bodies_[static_cast<std::size_t>(body)];
    if (pushed == nullptr) return;
    // ODE has no impulses, only forces, and a bounce ignores a force that acts during the
    // same step. So the velocities are set.
    const RigidBody& asked = question_.bodies[static_cast<std::size_t>(body)];
    const Eigen::Matrix3d R_WB = Orientation(pushed).toRotationMatrix();
    const Vector3d r_W = p_W - FromOde(dBodyGetPosition(pushed));
    const Vector3d v = FromOde(dBodyGetLinearVel(pushed)) + J_W / asked.mass;
    const Vector3d w =
        FromOde(dBodyGetAngularVel(pushed)) +
        R_WB * (R_WB.transpose() * r_W.cross(J_W)).cwiseQuotient(InertiaOf(asked));
    dBodySetLinearVel(pushed, v.x(), v.y(), v.z());
    dBodySetAngularVel(pushed, w.x(), w.y(), w.z());
  }

  void Step() override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Vector3d& f = question_.bodies[i].force_W;
      if (bodies_[i] != nullptr) dBodyAddForce(bodies_[i], f.x(), f.y(), f.z());
    }
    dJointGroupEmpty(contact_joints_.get());
    contacts_.clear();
    dSpaceCollide(space_.get(), this, [](void* self, dGeomID a, dGeomID b) {
      static_cast<OdeSimulation*>(self)->Collide(a, b);
    });
    if (stepper_ == OdeStepper::kStep) {
      dWorldStep(world_.get(), question_.dt);
    } else {
      const OwnRandom random(seed_);
      dWorldQuickStep(world_.get(), question_.dt);
    }
  }

  void Read(WorldState& state) const override {
    state.bodies.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (bodies_[i] == nullptr) {
        const Pose& X_WB = question_.bodies[i].placed.X_WB;
        state.bodies[i] = {X_WB.p_WB,
                           X_WB.q_WB ? *X_WB.q_WB : Eigen::Quaterniond(X_WB.R_WB),
                           Vector3d::Zero(), Vector3d::Zero()};
      } else {
        state.bodies[i] = {FromOde(dBodyGetPosition(bodies_[i])), Orientation(bodies_[i]),
                           FromOde(dBodyGetLinearVel(bodies_[i])),
                           FromOde(dBodyGetAngularVel(bodies_[i]))};
      }
    }
  }

  void ReadImpulses(std::vector<ContactImpulse>& impulses) const override {
    for (const Contact& contact : contacts_) {
      const dContactGeom& geom = contact.geom;
      ContactImpulse& impulse = impulses.emplace_back();
      impulse.A = IndexOf(geom.g1);
      impulse.B = IndexOf(geom.g2);
      impulse.p_WC = FromOde(geom.pos);
      impulse.n_AB_W = -FromOde(geom.normal);
      // f1 acts on the first body of the joint: A, or B if A is static.
      const bool moves_A = bodies_[static_cast<std::size_t>(impulse.A)] != nullptr;
      impulse.J_B_W =
          (moves_A ? -question_.dt : question_.dt) * FromOde(contact.feedback.f1);
      impulse.separation = -geom.depth;
    }
  }

  bool GivesImpulses() const override { return true; }

 private:
  struct Contact {
    dContactGeom geom;
    dJointFeedback feedback;
  };

  static Eigen::Quaterniond Orientation(dBodyID body) {
    const dReal* q = dBodyGetQuaternion(body);
    return {q[0], q[1], q[2], q[3]};
  }

  static int IndexOf(dGeomID geom) {
    return static_cast<int>(reinterpret_cast<std::ptrdiff_t>(dGeomGetData(geom)));
  }

  void Add(const RigidBody& asked) {
    const auto index = static_cast<std::ptrdiff_t>(bodies_.size());
    dBodyID& body = bodies_.emplace_back(nullptr);
    const Pose& X_WB = asked.placed.X_WB;
    if (asked.mass > 0) {
      body = dBodyCreate(world_.get());
      dMass mass;
      const Vector3d I = InertiaOf(asked);
      dMassSetParameters(&mass, asked.mass, 0, 0, 0, I.x(), I.y(), I.z(), 0, 0, 0);
      dBodySetMass(body, &mass);
      dBodySetGyroscopicMode(body, values_[kGyroscopic] != 0 ? 1 : 0);
      dBodySetFiniteRotationMode(body, values_[kFiniteRotation] != 0 ? 1 : 0);
      const Eigen::Matrix3d& R = X_WB.R_WB;
      const dMatrix3 rows = {R(0, 0), R(0, 1), R(0, 2), 0,  //
                             R(1, 0), R(1, 1), R(1, 2), 0,  //
                             R(2, 0), R(2, 1), R(2, 2), 0};
      dBodySetRotation(body, rows);
      dBodySetPosition(body, X_WB.p_WB.x(), X_WB.p_WB.y(), X_WB.p_WB.z());
      dBodySetLinearVel(body, asked.v_WB.x(), asked.v_WB.y(), asked.v_WB.z());
      dBodySetAngularVel(body, asked.w_WB.x(), asked.w_WB.y(), asked.w_WB.z());
    }
    if (!asked.collides) return;
    OdeGeom& geom = geoms_.emplace_back(asked.placed);
    if (body != nullptr) geom.AttachTo(body);
    // ODE's user pointer stores the index here. NOLINTNEXTLINE(*-no-int-to-ptr)
    dGeomSetData(geom.get(), reinterpret_cast<void*>(index));
    dSpaceAdd(space_.get(), geom.get());
  }

  // Creates a rod between two points. Returns null if neither of them can move.
  dJointID Connect(Anchor A, Anchor B, double length) {
    // ODE swaps the bodies of a joint whose first body is null.
    if (BodyOf(A) == nullptr) std::swap(A, B);
    if (BodyOf(A) == nullptr) return nullptr;
    const dJointID joint = dJointCreateDBall(world_.get(), nullptr);
    dJointAttach(joint, BodyOf(A), BodyOf(B));
    const Vector3d a_W = Place(A);
    const Vector3d b_W = Place(B);
    dJointSetDBallAnchor1(joint, a_W.x(), a_W.y(), a_W.z());
    dJointSetDBallAnchor2(joint, b_W.x(), b_W.y(), b_W.z());
    dJointSetDBallDistance(joint, length);
    return joint;
  }

  // Adds a spring as a soft rod: ODE manual, "How to use ERP and CFM".
  void Add(const Spring& spring) {
    const double h = question_.dt;
    const double hk_plus_b = h * spring.stiffness + spring.damping;
    if (hk_plus_b == 0) return;
    const dJointID joint = Connect(spring.A, spring.B, spring.rest_length);
    if (joint == nullptr) return;
    dJointSetDBallParam(joint, dParamERP, h * spring.stiffness / hk_plus_b);
    dJointSetDBallParam(joint, dParamCFM, 1 / hk_plus_b);
  }

  dBodyID BodyOf(const Anchor& anchor) const {
    return anchor.on == AnchorKind::kBody
               ? bodies_[static_cast<std::size_t>(anchor.index)]
               : nullptr;
  }

  // The position of the anchor at the start. World frame, [m].
  Vector3d Place(const Anchor& anchor) const {
    if (anchor.on == AnchorKind::kWorld) return anchor.point;
    return question_.bodies[static_cast<std::size_t>(anchor.index)].placed.X_WB *
           anchor.point;
  }

  void Collide(dGeomID a, dGeomID b) {
    const dBodyID body_a = dGeomGetBody(a);
    const dBodyID body_b = dGeomGetBody(b);
    if (body_a == nullptr && body_b == nullptr) return;
    std::array<dContactGeom, kMaxContacts> geoms;
    const int count = dCollide(a, b, kMaxContacts, geoms.data(), sizeof(dContactGeom));
    if (count == 0) return;
    const RigidBody& A = question_.bodies[static_cast<std::size_t>(IndexOf(a))];
    const RigidBody& B = question_.bodies[static_cast<std::size_t>(IndexOf(b))];
    dContact contact{};
    contact.surface.mode = dContactBounce | dContactApprox1 | dContactSoftERP;
    contact.surface.mu = std::sqrt(A.friction * B.friction);
    contact.surface.bounce = std::min(A.restitution, B.restitution);
    contact.surface.bounce_vel = values_[kRestitutionThreshold];
    contact.surface.soft_erp = values_[kContactErp];
    if (values_[kRollingFriction] > 0 || values_[kSpinningFriction] > 0) {
      contact.surface.mode |= dContactRolling;
      contact.surface.rho = values_[kRollingFriction];
      contact.surface.rho2 = values_[kRollingFriction];
      contact.surface.rhoN = values_[kSpinningFriction];
    }
    for (int i = 0; i < count; ++i) {
      contact.geom = geoms[static_cast<std::size_t>(i)];
      const dJointID joint =
          dJointCreateContact(world_.get(), contact_joints_.get(), &contact);
      dJointAttach(joint, dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
      contacts_.push_back({contact.geom, {}});
      dJointSetFeedback(joint, &contacts_.back().feedback);
    }
  }

  World question_;
  OdeStepper stepper_;
  std::vector<double> values_;  // Values of the parameters.
  unsigned long seed_ = 0;
  Owned<dxThreadingImplementation> threading_;
  Owned<dxWorld> world_;
  Owned<dxJointGroup> contact_joints_;
  Owned<dxSpace> space_;
  std::vector<OdeGeom> geoms_;
  std::vector<dBodyID> bodies_;   // Null for static bodies.
  std::deque<Contact> contacts_;  // Contacts of the last step; ODE has pointers to them.
};

// Returns why ODE does not simulate `feature`; empty if it does.
std::string WhyNot(WorldFeature feature) {
  switch (feature) {
    case WorldFeature::kCone:
    case WorldFeature::kStaticCone:
      return "ODE has no cone";
    case WorldFeature::kParticle:
    case WorldFeature::kCloth:
      return "ODE has no point masses";
    default:
      return "";
  }
}

std::vector<WorldParameter> ParametersOf(OdeStepper stepper) {
  std::vector<WorldParameter> parameters(kIterations);
  parameters[kContactErp] = {
      .name = "contact_erp",
      .here = 0,
      .shipped = 0.2,
      .least = 0,
      .most = 1,
      .whole = false,
      .what = "fraction of an overlap that a step removes; dSurfaceParameters::soft_erp",
      .why =
          "Overlap is not pushed out, which would add energy: bodies rest at the "
          "depth at which they were found. A body that starts one rounding away from "
          "a contact may then make the direct solver fail; with ODE's default it "
          "does not."};
  parameters[kJointErp] = {
      .name = "joint_erp",
      .here = 0.2,
      .shipped = 0.2,
      .least = 0,
      .most = 1,
      .whole = false,
      .what = "fraction of a joint's error that a step removes; dWorldSetERP",
      .why = ""};
  parameters[kConstraintForceMixing] = {
      .name = "cfm",
      .here = 1e-12,
      .shipped = 1e-10,
      .least = 0,
      .most = 1,
      .whole = false,
      .what = "softness of contacts and joints in m/(N s); dWorldSetCFM",
      .why =
          "With 0, faces make the direct solver's matrix singular. A kilogram sinks "
          "at 1e-11 m/s."};
  const auto like_ode = [&](std::size_t index, std::string name, double shipped,
                            double most, bool whole, std::string what) {
    parameters[index] = {.name = std::move(name),
                         .here = shipped,
                         .shipped = shipped,
                         .least = 0,
                         .most = most,
                         .whole = whole,
                         .what = std::move(what),
                         .why = ""};
  };
  like_ode(kRestitutionThreshold, "restitution_threshold", 0, 1e3, false,
           "approach in m/s below which nothing bounces; dSurfaceParameters::bounce_vel");
  like_ode(kSurfaceLayer, "surface_layer", 0, 1e3, false,
           "depth in m to which bodies may sink; dWorldSetContactSurfaceLayer");
  like_ode(kMaxCorrectingVelocity, "max_correcting_velocity", 1e18, 1e18, false,
           "greatest speed in m/s at which overlap is removed, without limit as shipped; "
           "dWorldSetContactMaxCorrectingVel");
  like_ode(kGyroscopic, "gyroscopic", 1, 1, true,
           "whether the gyroscopic term acts; dBodySetGyroscopicMode");
  like_ode(kFiniteRotation, "finite_rotation", 0, 1, true,
           "whether a step turns a body by its whole angle, not by Euler's step; "
           "dBodySetFiniteRotationMode");
  like_ode(kRollingFriction, "rolling_friction", 0, 1e3, false,
           "lever in m of the torque that brakes rolling; dSurfaceParameters::rho");
  like_ode(kSpinningFriction, "spinning_friction", 0, 1e3, false,
           "lever in m of the torque that brakes spin about the normal; "
           "dSurfaceParameters::rhoN");
  if (stepper == OdeStepper::kStep) return parameters;
  parameters.push_back({.name = "iterations",
                        .here = 200,
                        .shipped = 20,
                        .least = 1,
                        .most = 1'000'000,
                        .whole = true,
                        .what = "iterations a step; dWorldSetQuickStepNumIterations",
                        .why = "ODE's default leaves a residual that would hide its "
                               "contact law."});
  return parameters;
}

}  // namespace

std::string WhyNoOdeWorld(const World& world) {
  const bool all_fit = std::ranges::all_of(world.bodies, [](const RigidBody& body) {
    return !body.collides || OdeGeom(body.placed);
  });
  return all_fit ? "" : kNoFlatHull;
}

std::unique_ptr<Simulation> OdeWorld(const World& world, OdeStepper stepper,
                                     std::span<const double> values) {
  return std::make_unique<OdeSimulation>(world, stepper, values);
}

void DescribeOdeWorlds(OdeStepper stepper, OracleInfo& info) {
  info.simulates = true;
  info.softness = "cfm";
  for (int i = 0; i < kWorldFeatures; ++i) {
    const std::string reason = WhyNot(static_cast<WorldFeature>(i));
    info.world_capabilities[static_cast<std::size_t>(i)] = {reason.empty(), reason};
  }
  const std::vector<Setting> settings = {
      stepper == OdeStepper::kStep
          ? Setting{"world: solver", "dWorldStep", "A direct solver, without iterations."}
          : Setting{"world: solver", "dWorldQuickStep",
                    "The random order is reset for each world."},
      {"world: integrator",
       "semi-implicit Euler, rotation by Euler's step of a quaternion",
       "ODE's finite rotation mode is off, as it is by default."},
      {"world: contacts", "dHashSpace, up to 8 points a pair",
       "The maximum for box on box."},
      {"world: convex hull",
       "faces computed here, geom moved inside if the origin is not",
       "dCreateConvex takes planes and polygons; MPR starts from the geom's origin."},
      {"world: restitution", "min(e_A, e_B)",
       "Set per contact: ODE leaves the rule to the user."},
      {"world: friction", "sqrt(mu_A mu_B)", "Set per contact."},
      {"world: friction cone", "dContactApprox1",
       "Coulomb's law along each of two fixed directions: a square, not a circle."},
      {"world: distance joint", "dJointTypeDBall", "A rod between two points."},
      {"world: spring", "dJointTypeDBall, ERP = hk/(hk+b), CFM = 1/(hk+b)",
       "The formulas of ODE's manual: an implicit step."},
      {"world: push", "velocities set", "ODE has no impulses."},
      {"world: damping, sleeping", "0, off", "ODE's default."},
      {"world: impulses", "force of dJointFeedback times the step", ""},
  };
  info.settings.insert(info.settings.end(), settings.begin(), settings.end());
  info.parameters = ParametersOf(stepper);
}

}  // namespace touchstone
