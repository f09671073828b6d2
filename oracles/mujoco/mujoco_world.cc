#include "oracles/mujoco/mujoco_world.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "oracles/mujoco/mujoco_model.h"
#include "scenarios/worlds/solid.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

// The fraction of its error that a rod corrects in a step, as in ODE.
constexpr double kErrorReduction = 0.2;

// Indices of the parameters.
enum Parameter : std::size_t {
  kContactTime,
  kJointTime,
  kLeastImpedance,
  kImpedance,
  kEllipticCone,
  kIterations,
  kSolverTolerance,
  kMargin,
  kNoSlipIterations,
  kFrictionRatio,
  kParameters,
};

// The stiffness of a constraint. MuJoCo aims at the acceleration −b v − d k r and reaches
// the fraction d of it, the impedance ("Solver parameters" in MuJoCo's documentation of
// its computations). With the highest d, b = 1/h and k = 0, a contact stops an approach
// in one step except for 1e-4 of it, and pushes nothing out. MuJoCo divides the given b
// by d, and the given k by d².
struct Reference {
  mjtNum solref[mjNREF];
};

// The damped spring with the time constant `time`, critically damped; with time 0, the
// stiffest that a step of `dt` allows. [s]
Reference ReferenceOf(double time, double impedance, double dt, double error_reduction) {
  if (time > 0) return {{time, 1}};
  return {{-error_reduction * impedance / (dt * dt), -impedance / dt}};
}

Vector3d FromMujoco(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

class MujocoSimulation final : public Simulation {
 public:
  MujocoSimulation(const World& world, MujocoIntegrator integrator,
                   std::span<const double> values)
      : question_(world),
        integrator_(integrator),
        values_(values.begin(), values.end()),
        room_(kFewContacts + kContactsOfBody * world.bodies.size()),
        bodies_(world.bodies.size()) {
    Make();
  }

  void Push(int body, const Vector3d& p_W, const Vector3d& J_W) override {
    const BodyDofs& dofs = bodies_[static_cast<std::size_t>(body)];
    if (dofs.body < 0) return;
    const RigidBody& asked = question_.bodies[static_cast<std::size_t>(body)];
    Eigen::Map<Vector3d> v_W(data_->qvel + dofs.velocity);
    Eigen::Map<Vector3d> w_B(data_->qvel + dofs.velocity + 3);
    const Eigen::Quaterniond q_WB = OrientationOf(dofs);
    const Vector3d r_W = p_W - FromMujoco(data_->qpos + dofs.position);
    v_W += J_W / asked.mass;
    w_B += (q_WB.conjugate() * r_W.cross(J_W)).cwiseQuotient(InertiaOf(asked));
  }

  void Step() override {
    Save();
    mj_step(model_.get(), data_.get());
    // MuJoCo drops contacts that do not fit. The step is then repeated with twice the
    // space.
    while (HasWarned({mjWARN_CONTACTFULL, mjWARN_CNSTRFULL})) {
      const int had = model_->nconmax;
      room_ *= 2;
      Make();
      if (model_->nconmax == had)
        throw std::runtime_error("MuJoCo has dropped contacts: its buffer is full");
      Restore();
      mj_step(model_.get(), data_.get());
    }
    // MuJoCo resets the world if a number is NaN or too large.
    was_reset_ |= HasWarned({mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC});
  }

  void Read(WorldState& state) const override {
    state.bodies.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const BodyDofs& dofs = bodies_[i];
      BodyState& body = state.bodies[i];
      if (dofs.body < 0) {
        const Pose& X_WB = question_.bodies[i].placed.X_WB;
        body = {X_WB.p_WB, X_WB.q_WB ? *X_WB.q_WB : Eigen::Quaterniond(X_WB.R_WB),
                Vector3d::Zero(), Vector3d::Zero()};
        continue;
      }
      body.p_WB = FromMujoco(data_->qpos + dofs.position);
      body.q_WB = OrientationOf(dofs);
      body.v_WB = FromMujoco(data_->qvel + dofs.velocity);
      body.w_WB = body.q_WB * FromMujoco(data_->qvel + dofs.velocity + 3);
      if (was_reset_) body.p_WB.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }

  void ReadImpulses(std::vector<ContactImpulse>& impulses) const override {
    if (!GivesImpulses()) return;
    for (int i = 0; i < data_->ncon; ++i) {
      const mjContact& contact = data_->contact[i];
      if (contact.efc_address < 0) continue;
      mjtNum force[6];  // Force and torque of A on B, along the axes of the contact.
      mj_contactForce(model_.get(), data_.get(), i, force);
      const Eigen::Map<const Eigen::Matrix3d> axes_W(contact.frame);
      ContactImpulse& impulse = impulses.emplace_back();
      impulse.A = geoms_[static_cast<std::size_t>(contact.geom1)];
      impulse.B = geoms_[static_cast<std::size_t>(contact.geom2)];
      impulse.p_WC = FromMujoco(contact.pos);
      impulse.n_AB_W = axes_W.col(0);
      impulse.J_B_W = question_.dt * (axes_W * FromMujoco(force));
      impulse.separation = contact.dist;
    }
  }

  // RK4 leaves only the forces of its last stage.
  bool GivesImpulses() const override { return model_->opt.integrator == mjINT_EULER; }

 private:
  /** MuJoCo's indices of a body; −1 for a static body. */
  struct BodyDofs {
    int body = -1;
    int position = -1;  // Index into qpos: position, then quaternion.
    int velocity = -1;  // Index into qvel: velocity in the world frame, then angular
                        // velocity in the body frame.
  };

  /** Creates the world in its initial state, with space for `room_` contacts. */
  void Make() {
    model_ = Compile(ToMjcf(question_, room_));
    mjOption& option = model_->opt;
    option.timestep = question_.dt;
    Vector3d::Map(option.gravity) = question_.gravity_W;
    option.integrator = integrator_ == MujocoIntegrator::kEuler ? mjINT_EULER : mjINT_RK4;
    SetStiffness();
    for (std::size_t i = 0; i < question_.joints.size(); ++i) {
      const int tendon = Find(mjOBJ_TENDON, 'j', i);
      if (tendon < 0) continue;
      mjtNum* const equality =
          model_->eq_data + std::ptrdiff_t{mjNEQDATA} * Find(mjOBJ_EQUALITY, 'j', i);
      equality[0] = question_.joints[i].length - model_->tendon_length0[tendon];
    }
    data_.reset(mj_makeData(model_.get()));
    if (data_ == nullptr) throw std::runtime_error("MuJoCo has no memory for this world");
    for (std::size_t i = 0; i < question_.bodies.size(); ++i) Start(i);
    geoms_.resize(static_cast<std::size_t>(model_->ngeom));
    for (std::size_t i = 0; i < question_.bodies.size(); ++i) {
      const int geom = Find(mjOBJ_GEOM, 'g', i);
      if (geom >= 0) geoms_[static_cast<std::size_t>(geom)] = static_cast<int>(i);
    }
  }

  bool HasWarned(std::initializer_list<mjtWarning> kinds) const {
    return std::any_of(kinds.begin(), kinds.end(), [this](mjtWarning kind) {
      return data_->warning[kind].number > 0;
    });
  }

  /** Saves the state from which a step starts. */
  void Save() {
    saved_.time = data_->time;
    saved_.qpos.assign(data_->qpos, data_->qpos + model_->nq);
    saved_.qvel.assign(data_->qvel, data_->qvel + model_->nv);
    saved_.warm.assign(data_->qacc_warmstart, data_->qacc_warmstart + model_->nv);
  }
  void Restore() {
    data_->time = saved_.time;
    std::copy(saved_.qpos.begin(), saved_.qpos.end(), data_->qpos);
    std::copy(saved_.qvel.begin(), saved_.qvel.end(), data_->qvel);
    std::copy(saved_.warm.begin(), saved_.warm.end(), data_->qacc_warmstart);
  }

  int Find(mjtObj kind, char prefix, std::size_t i) const {
    return mj_name2id(model_.get(), kind, fmt::format("{}{}", prefix, i).c_str());
  }

  Eigen::Quaterniond OrientationOf(const BodyDofs& dofs) const {
    const mjtNum* const q = data_->qpos + dofs.position + 3;
    return {q[0], q[1], q[2], q[3]};
  }

  void SetStiffness() {
    mjOption& option = model_->opt;
    option.cone = values_[kEllipticCone] != 0 ? mjCONE_ELLIPTIC : mjCONE_PYRAMIDAL;
    option.tolerance = values_[kSolverTolerance];
    option.iterations = static_cast<int>(values_[kIterations]);
    option.enableflags |= mjENBL_OVERRIDE;
    option.o_margin = values_[kMargin];
    option.noslip_iterations = static_cast<int>(values_[kNoSlipIterations]);
    option.impratio = values_[kFrictionRatio];
    const double d = values_[kImpedance];
    option.o_solimp[0] = values_[kLeastImpedance];  // The others keep MuJoCo's defaults.
    option.o_solimp[1] = d;
    const Reference of_contacts =
        ReferenceOf(values_[kContactTime], d, option.timestep, 0);
    mju_copy(option.o_solref, of_contacts.solref, mjNREF);
    const Reference of_rods =
        ReferenceOf(values_[kJointTime], d, option.timestep, kErrorReduction);
    for (std::ptrdiff_t i = 0; i < model_->neq; ++i) {
      mju_copy(model_->eq_solref + mjNREF * i, of_rods.solref, mjNREF);
      mju_copy(model_->eq_solimp + mjNIMP * i, option.o_solimp, mjNIMP);
    }
  }

  void Start(std::size_t i) {
    BodyDofs& dofs = bodies_[i];
    dofs.body = Find(mjOBJ_BODY, 'b', i);
    if (dofs.body < 0) return;
    const int joint = model_->body_jntadr[dofs.body];
    dofs.position = model_->jnt_qposadr[joint];
    dofs.velocity = model_->jnt_dofadr[joint];
    const RigidBody& asked = question_.bodies[i];
    Vector3d::Map(data_->xfrc_applied + std::ptrdiff_t{6} * dofs.body) = asked.force_W;
    Vector3d::Map(data_->qvel + dofs.velocity) = asked.v_WB;
    Vector3d::Map(data_->qvel + dofs.velocity + 3) =
        OrientationOf(dofs).conjugate() * asked.w_WB;
  }

  /** The state from which a step starts. */
  struct Saved {
    mjtNum time = 0;
    std::vector<mjtNum> qpos;
    std::vector<mjtNum> qvel;
    std::vector<mjtNum> warm;
  };

  // The initial space for contacts: a fixed number and a number per body.
  static constexpr std::size_t kFewContacts = 100;
  static constexpr std::size_t kContactsOfBody = 6;

  World question_;
  MujocoIntegrator integrator_;
  std::vector<double> values_;  // Values of the parameters.
  std::size_t room_;
  bool was_reset_ = false;
  Saved saved_;
  MujocoModel model_;
  MujocoData data_;
  std::vector<BodyDofs> bodies_;
  std::vector<int> geoms_;  // Index of the body, indexed by geom.
};

// Returns why MuJoCo does not simulate `feature`; empty if it does.
std::string WhyNot(WorldFeature feature) {
  switch (feature) {
    case WorldFeature::kCone:
    case WorldFeature::kStaticCone:
      return "MuJoCo has no cone";
    case WorldFeature::kRestitution:
      return "MuJoCo has no coefficient of restitution: its contacts are damped springs";
    case WorldFeature::kParticle:
    case WorldFeature::kCloth:
      return "MuJoCo has no point masses that bounce";
    default:
      return "";
  }
}

std::vector<WorldParameter> Parameters() {
  std::vector<WorldParameter> parameters(kParameters);
  parameters[kContactTime] = {
      .name = "contact_time",
      .here = 0,
      .shipped = 0.02,
      .least = 0,
      .most = 1e3,
      .whole = false,
      .what =
          "time constant of contacts in s, critically damped, solref; 0: solref 0, "
          "-d/h, the stiffest damper that a step allows",
      .why =
          "MuJoCo's contacts are damped springs. With 0 one step stops an approach "
          "except for 1e-4 of it, and nothing is pushed out, which would add energy. "
          "The default settles over 0.02 s at any step."};
  parameters[kJointTime] = {
      .name = "joint_time",
      .here = 0,
      .shipped = 0.02,
      .least = 0,
      .most = 1e3,
      .whole = false,
      .what =
          "time constant of distance joints in s, critically damped, solref; 0: a "
          "fifth of an error is removed in a step",
      .why = "As for contacts."};
  parameters[kLeastImpedance] = {.name = "least_impedance",
                                 .here = mjMAXIMP,
                                 .shipped = 0.9,
                                 .least = mjMINIMP,
                                 .most = mjMAXIMP,
                                 .whole = false,
                                 .what =
                                     "impedance d of a constraint without error, "
                                     "solimp[0]",
                                 .why = "The highest that MuJoCo allows."};
  parameters[kImpedance] = {.name = "impedance",
                            .here = mjMAXIMP,
                            .shipped = 0.95,
                            .least = mjMINIMP,
                            .most = mjMAXIMP,
                            .whole = false,
                            .what =
                                "impedance d of a constraint that is violated by 1 mm "
                                "or more, solimp[1]",
                            .why = "The highest that MuJoCo allows."};
  parameters[kEllipticCone] = {.name = "elliptic_cone",
                               .here = 1,
                               .shipped = 0,
                               .least = 0,
                               .most = 1,
                               .whole = true,
                               .what = "friction cone: 1 elliptic, 0 pyramidal",
                               .why =
                                   "Coulomb's circle. MuJoCo's default is a pyramid "
                                   "inside it."};
  parameters[kIterations] = {.name = "iterations",
                             .here = 1000,
                             .shipped = 100,
                             .least = 1,
                             .most = 1'000'000,
                             .whole = true,
                             .what = "most iterations of the solver",
                             .why = "It iterates until nothing improves."};
  parameters[kSolverTolerance] = {.name = "solver_tolerance",
                                  .here = mjMINVAL,
                                  .shipped = 1e-8,
                                  .least = 0,
                                  .most = 1,
                                  .whole = false,
                                  .what = "improvement at which the solver stops",
                                  .why =
                                      "The residual of MuJoCo's default would hide its "
                                      "contact law."};
  const auto like_mujoco = [&](Parameter index, std::string name, double shipped,
                               double least, double most, bool whole, std::string what) {
    parameters[index] = {.name = std::move(name),
                         .here = shipped,
                         .shipped = shipped,
                         .least = least,
                         .most = most,
                         .whole = whole,
                         .what = std::move(what),
                         .why = ""};
  };
  like_mujoco(kMargin, "margin", 0, 0, 1e3, false,
              "distance in m at which contacts begin to act; mjOption::o_margin");
  like_mujoco(
      kNoSlipIterations, "noslip_iterations", 0, 0, 1e6, true,
      "iterations of the solver that suppresses slip; mjOption::noslip_iterations");
  like_mujoco(kFrictionRatio, "impratio", 1, 1e-3, 1e6, false,
              "ratio of the impedance of friction to that of normal forces, in elliptic "
              "cones; mjOption::impratio");
  return parameters;
}

}  // namespace

std::string WhyNoMujocoWorld(const World& world) {
  const bool all_fit = std::ranges::all_of(world.bodies, [](const RigidBody& body) {
    if (!body.collides || KindOf(body.placed.shape) != ShapeKind::kConvexHull)
      return true;
    const std::optional<Solid> solid = UniformSolid(body.placed.shape, body.mass);
    return solid && solid->volume > mjMINVAL;
  });
  return all_fit ? "" : "MuJoCo refuses hulls of less than 1e-15 m³";
}

std::unique_ptr<Simulation> MujocoWorld(const World& world, MujocoIntegrator integrator,
                                        std::span<const double> values) {
  return std::make_unique<MujocoSimulation>(world, integrator, values);
}

void DescribeMujocoWorlds(MujocoIntegrator integrator, OracleInfo& info) {
  info.simulates = true;
  for (int i = 0; i < kWorldFeatures; ++i) {
    const std::string reason = WhyNot(static_cast<WorldFeature>(i));
    info.world_capabilities[static_cast<std::size_t>(i)] = {reason.empty(), reason};
  }
  const std::vector<Setting> settings = {
      {"world: solver", "Newton", "MuJoCo's default."},
      integrator == MujocoIntegrator::kEuler
          ? Setting{"world: integrator", "Euler",
                    "Semi-implicit; rotation by the exponential map."}
          : Setting{"world: integrator", "RK4", "Fourth-order Runge-Kutta method."},
      {"world: contact law", "convex",
       "MuJoCo's relaxation of Coulomb's law: a sliding body also lifts off, at mu times "
       "its slip velocity."},
      {"world: restitution", "none",
       "A world in which two bodies can bounce is unsupported."},
      {"world: friction", "sqrt(mu_A mu_B)",
       "Set by explicit pairs if bodies differ: MuJoCo's default is the larger one."},
      {"world: friction of spin and roll", "none", "condim 3; 1 where friction is 0."},
      {"world: convex hull", "mesh", "MuJoCo stores its vertices in single precision."},
      {"world: distance joint", "equality of a tendon's length",
       "Between two sites; with joint_time 0 a fifth of its error is corrected in a "
       "step, as in ODE. A rod of length L whose end moves across it at speed v is too "
       "long by v² T² / L, because MuJoCo leaves out the derivative of the constraint's "
       "Jacobian. T is the time constant; with joint_time 0, T² is 5 h². The error of "
       "RK4 with rods is therefore of second order in the step h."},
      {"world: spring", "tendon with stiffness, damping and spring length",
       "An explicit force, evaluated at the start of a step."},
      {"world: push", "velocities set", "MuJoCo has no impulses."},
      {"world: gyroscopic term", "on, explicit", "It cannot be switched off."},
      {"world: damping, sleeping", "0, none", "MuJoCo's default."},
      {"world: impulses",
       integrator == MujocoIntegrator::kEuler ? "mj_contactForce times the step" : "none",
       "RK4 keeps the forces of its last stage only."},
  };
  info.settings.insert(info.settings.end(), settings.begin(), settings.end());
  info.parameters = Parameters();
}

}  // namespace touchstone
