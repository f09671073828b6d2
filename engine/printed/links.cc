#include "engine/printed/links.h"

#include "engine/printed/body_motion.h"

namespace cookbook::printed {
namespace {

/** An end of a spring or a joint, at its current position. */
class End {
 public:
  End(const Anchor& anchor, const Things& things, const Errata& errata)
      : errata_(errata), p_W_(anchor.point) {
    const auto index = static_cast<std::size_t>(anchor.index);
    if (anchor.on == Anchor::On::kBody) {
      body_ = &things.bodies[index];
      p_W_ = body_->p_WB + body_->q_WB * anchor.point;
    } else if (anchor.on == Anchor::On::kParticle) {
      particle_ = &things.particles[index];
      p_W_ = particle_->p_W;
    }
  }

  const Eigen::Vector3d& position() const { return p_W_; }

  Eigen::Vector3d velocity() const {
    if (body_) return VelocityAt(*body_, p_W_);
    if (particle_) return particle_->v_W;
    return Eigen::Vector3d::Zero();
  }

  /** Returns the change of velocity along `n` per impulse along it. [1/kg] */
  double Response(const Eigen::Vector3d& n) const {
    if (particle_) return particle_->mass == 0 ? 0 : 1 / particle_->mass;
    if (!body_) return 0;
    const Eigen::Vector3d r = p_W_ - body_->p_WB;
    return InverseMass(*body_) +
           n.dot((InverseInertia(*body_, errata_) * r.cross(n)).cross(r));
  }

  void GiveImpulse(const Eigen::Vector3d& J_W) {
    if (body_) Give(*body_, p_W_, J_W, errata_);
    if (particle_ && particle_->mass != 0) particle_->v_W += J_W / particle_->mass;
  }

  /** Moves the end as the velocity change of an impulse `J_W` would in one second. [kg
   m] */
  void Displace(const Eigen::Vector3d& J_W) {
    if (particle_ && particle_->mass != 0) particle_->p_W += J_W / particle_->mass;
    if (!body_ || body_->mass == 0) return;
    const Eigen::Vector3d r = p_W_ - body_->p_WB;
    body_->p_WB += InverseMass(*body_) * J_W;
    Turn(*body_, InverseInertia(*body_, errata_) * r.cross(J_W), errata_);
  }

  /** Moves the end by `way_W`, whatever the mass. [m] */
  void Carry(const Eigen::Vector3d& way_W) {
    if (particle_) particle_->p_W += way_W;
    if (body_) body_->p_WB += way_W;
  }

 private:
  const Errata& errata_;
  Body* body_ = nullptr;
  Particle* particle_ = nullptr;
  Eigen::Vector3d p_W_;
};

}  // namespace

void Pull(const Spring& spring, const Things& things, double dt, const Errata& errata) {
  End A(spring.A, things, errata);
  End B(spring.B, things, errata);
  const Eigen::Vector3d p_AB = B.position() - A.position();
  const double length = p_AB.norm();
  if (length == 0) return;  // No direction to pull in.
  const Eigen::Vector3d u = p_AB / length;
  const Eigen::Vector3d v_AB = B.velocity() - A.velocity();
  const double rate = errata.Has(Erratum::kE17) ? v_AB.norm() : v_AB.dot(u);
  const double force =
      spring.stiffness * (length - spring.rest_length) + spring.damping * rate;
  const Eigen::Vector3d J_W = (errata.Has(Erratum::kE18) ? 1 : dt) * force * u;
  A.GiveImpulse(J_W);
  B.GiveImpulse(-J_W);
}

void Satisfy(const DistanceJoint& joint, const Things& things, const Errata& errata) {
  End A(joint.A, things, errata);
  End B(joint.B, things, errata);
  const Eigen::Vector3d p_AB = B.position() - A.position();
  const double length = p_AB.norm();
  if (errata.Has(Erratum::kE22)) {
    const Eigen::Vector3d half = 0.5 * (length - joint.length) / length * p_AB;
    A.Carry(half);
    B.Carry(-half);
    return;
  }
  if (length == 0) return;  // No direction to push in.
  const Eigen::Vector3d n = p_AB / length;
  const double response = A.Response(n) + B.Response(n);
  if (response == 0) return;
  const Eigen::Vector3d v_AB = B.velocity() - A.velocity();
  const Eigen::Vector3d J_W = v_AB.dot(n) / response * n;
  A.GiveImpulse(J_W);
  B.GiveImpulse(-J_W);
  const Eigen::Vector3d shift = (length - joint.length) / response * n;
  A.Displace(shift);
  B.Displace(-shift);
}

}  // namespace cookbook::printed
