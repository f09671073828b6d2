#include "oracles/mujoco/mujoco_world.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "oracles/mujoco/mujoco_model.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

// The share of its error that a rod takes back in a step, as in ODE.
constexpr double kErrorReduction = 0.2;

// A constraint is solved for the acceleration −b v − d k r, of which it gets the share d,
// its impedance ("Solver parameters" in MuJoCo's documentation of its computations). With
// the highest d, b = 1/h and k = 0 it stops what approaches in one step, but for 1e-4 of
// it, and pushes nothing out. MuJoCo divides the b it is given by d, and k by d².
struct Stiffness {
  mjtNum solref[mjNREF];
  mjtNum solimp[mjNIMP];
};

Stiffness Rigid(double dt, double error_reduction) {
  constexpr double d = mjMAXIMP;
  return {{-error_reduction * d / (dt * dt), -d / dt}, {d, d, 1, 0.5, 1}};
}

Vector3d FromMujoco(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

class MujocoSimulation final : public Simulation {
 public:
  MujocoSimulation(const World& world, MujocoIntegrator integrator,
                   MujocoContacts contacts)
      : question_(world),
        integrator_(integrator),
        contacts_(contacts),
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
    // What has no room is dropped: taken again with twice the room.
    while (HasWarned({mjWARN_CONTACTFULL, mjWARN_CNSTRFULL})) {
      const int had = model_->nconmax;
      room_ *= 2;
      Make();
      if (model_->nconmax == had)
        throw std::runtime_error("MuJoCo has dropped contacts: its buffer is full");
      Restore();
      mj_step(model_.get(), data_.get());
    }
    // MuJoCo starts the world anew where a number is none or large.
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
      mjtNum force[6];  // Of A on B, along the axes of the contact.
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

  // What RK4 leaves are the forces of its last quarter.
  bool GivesImpulses() const override { return model_->opt.integrator == mjINT_EULER; }

 private:
  /** Where MuJoCo keeps a body: −1 for one that does not move. */
  struct BodyDofs {
    int body = -1;
    int position = -1;  // Into qpos: position, then quaternion.
    int velocity = -1;  // Into qvel: world frame, then body frame.
  };

  /** Makes the world as it starts, with room for `room_` contacts. */
  void Make() {
    model_ = Compile(ToMjcf(question_, room_));
    mjOption& option = model_->opt;
    option.timestep = question_.dt;
    Vector3d::Map(option.gravity) = question_.gravity_W;
    option.integrator = integrator_ == MujocoIntegrator::kEuler ? mjINT_EULER : mjINT_RK4;
    if (contacts_ == MujocoContacts::kRigid) MakeRigid();
    for (std::size_t i = 0; i < question_.joints.size(); ++i) {
      const int tendon = Find(mjOBJ_TENDON, 'j', i);
      if (tendon < 0) continue;
      mjtNum* const equality = model_->eq_data + mjNEQDATA * Find(mjOBJ_EQUALITY, 'j', i);
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

  /** Keeps what a step starts from. */
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

  void MakeRigid() {
    mjOption& option = model_->opt;
    option.cone = mjCONE_ELLIPTIC;
    option.tolerance = mjMINVAL;  // Until nothing improves.
    option.iterations = 1000;
    option.enableflags |= mjENBL_OVERRIDE;
    option.o_margin = 0;
    const Stiffness of_contacts = Rigid(option.timestep, 0);
    mju_copy(option.o_solref, of_contacts.solref, mjNREF);
    mju_copy(option.o_solimp, of_contacts.solimp, mjNIMP);
    const Stiffness of_rods = Rigid(option.timestep, kErrorReduction);
    for (std::ptrdiff_t i = 0; i < model_->neq; ++i) {
      mju_copy(model_->eq_solref + mjNREF * i, of_rods.solref, mjNREF);
      mju_copy(model_->eq_solimp + mjNIMP * i, of_rods.solimp, mjNIMP);
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

  /** What a step starts from. */
  struct Saved {
    mjtNum time = 0;
    std::vector<mjtNum> qpos;
    std::vector<mjtNum> qvel;
    std::vector<mjtNum> warm;
  };

  // Contacts that there is room for at first.
  static constexpr std::size_t kFewContacts = 100;
  static constexpr std::size_t kContactsOfBody = 6;

  World question_;
  MujocoIntegrator integrator_;
  MujocoContacts contacts_;
  std::size_t room_;
  bool was_reset_ = false;
  Saved saved_;
  MujocoModel model_;
  MujocoData data_;
  std::vector<BodyDofs> bodies_;
  std::vector<int> geoms_;  // Of each geom, the body that it is of.
};

// Empty for what MuJoCo does simulate.
std::string WhyNot(WorldFeature feature) {
  switch (feature) {
    case WorldFeature::kOtherShape:
    case WorldFeature::kStaticOtherShape:
      return "MuJoCo has no cone; of what it has, this adapter moves spheres and boxes";
    case WorldFeature::kRestitution:
      return "MuJoCo has no coefficient of restitution: its contacts are damped springs";
    case WorldFeature::kParticle:
    case WorldFeature::kCloth:
      return "MuJoCo has no point masses that bounce";
    default:
      return "";
  }
}

}  // namespace

std::unique_ptr<Simulation> MujocoWorld(const World& world, MujocoIntegrator integrator,
                                        MujocoContacts contacts) {
  return std::make_unique<MujocoSimulation>(world, integrator, contacts);
}

void DescribeMujocoWorlds(MujocoIntegrator integrator, OracleInfo& info) {
  info.simulates = true;
  for (int i = 0; i < kWorldFeatures; ++i) {
    const std::string reason = WhyNot(static_cast<WorldFeature>(i));
    info.world_capabilities[static_cast<std::size_t>(i)] = {reason.empty(), reason};
  }
  const std::vector<Setting> settings = {
      {"world: solver", "Newton, 1000 iterations, tolerance 1e-15",
       "Until nothing improves: MuJoCo's 1e-8 would be measured in place of its contact "
       "law."},
      integrator == MujocoIntegrator::kEuler
          ? Setting{"world: integrator", "Euler",
                    "Semi-implicit; rotation by the exponential map."}
          : Setting{"world: integrator", "RK4", "Runge and Kutta's of fourth order."},
      {"world: contact softness", "solref 0, -d/h; solimp d = 0.9999",
       "MuJoCo's contacts are damped springs. So stiff that one step stops what "
       "approaches, "
       "but for 1e-4 of it; nothing is pushed out, which would add energy. Its default "
       "is "
       "a spring that settles over 0.02 s at any step."},
      {"world: contact law", "convex",
       "MuJoCo's relaxation of Coulomb's law: what slides also lifts, at mu times the "
       "speed of its slip."},
      {"world: restitution", "none",
       "A world in which two bodies can bounce is "
       "unsupported."},
      {"world: friction", "sqrt(mu_A mu_B)",
       "By explicit pairs where bodies differ: MuJoCo takes the larger."},
      {"world: friction cone", "elliptic",
       "Coulomb's circle. MuJoCo's default is a pyramid inside it."},
      {"world: friction of spin and roll", "none", "condim 3; 1 where friction is 0."},
      {"world: contact margin", "0", "MuJoCo's default."},
      {"world: distance joint", "equality of a tendon's length",
       "Between two sites; a fifth of its error is taken back in a step, as in ODE."},
      {"world: spring", "tendon with stiffness, damping and spring length",
       "An explicit force, taken at the start of a step."},
      {"world: push", "velocities set", "MuJoCo has no impulses."},
      {"world: gyroscopic term", "on, explicit", "It cannot be switched off."},
      {"world: damping, sleeping", "0, none", "MuJoCo's default."},
      {"world: impulses",
       integrator == MujocoIntegrator::kEuler ? "mj_contactForce times the step" : "none",
       "RK4 keeps the forces of its last stage only."},
  };
  info.settings.insert(info.settings.end(), settings.begin(), settings.end());
}

}  // namespace touchstone
