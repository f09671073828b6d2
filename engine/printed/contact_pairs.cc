#include "engine/printed/contact_pairs.h"

#include <algorithm>
#include <cmath>

#include "engine/printed/body_motion.h"

namespace cookbook::printed {
namespace {

/** The least friction impulse that is applied under E-25. [N s] */
constexpr double kLeastFriction = 0.005;

Pose PoseOf(const Body& body) {
  return {body.q_WB.toRotationMatrix(), body.p_WB};
}

Manifold CollideBodies(const Body& a, const Body& b, const Errata& errata) {
  return std::visit(
      [&](const auto& A, const auto& B) {
        return Collide(A, PoseOf(a), B, PoseOf(b), errata);
      },
      a.shape, b.shape);
}

/** Returns k(d): the change of relative velocity along `d` per impulse along it.
 [1/kg] */
double Response(const Body& a, const Body& b, const Eigen::Vector3d& p_W,
                const Eigen::Vector3d& d, const Errata& errata) {
  const Eigen::Vector3d r_A = p_W - a.p_WB;
  const Eigen::Vector3d r_B = p_W - b.p_WB;
  const Eigen::Vector3d turned = (InverseInertia(a, errata) * r_A.cross(d)).cross(r_A) +
                                 (InverseInertia(b, errata) * r_B.cross(d)).cross(r_B);
  return InverseMass(a) + InverseMass(b) + d.dot(turned);
}

void GiveBoth(Body& a, Body& b, const Eigen::Vector3d& p_W, const Eigen::Vector3d& J_W,
              const Errata& errata) {
  Give(a, p_W, -J_W, errata);
  Give(b, p_W, J_W, errata);
}

Eigen::Vector3d RelativeVelocity(const Body& a, const Body& b,
                                 const Eigen::Vector3d& p_W) {
  return VelocityAt(b, p_W) - VelocityAt(a, p_W);
}

/** A contact and its accumulated impulses. */
struct Contact {
  const ContactPair* pair;
  Eigen::Vector3d p_W;
  double aim = 0;  ///< Target normal velocity after the impact. [m/s]
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();      ///< Slip before any impulse. [m/s]
  double normal = 0;                                   ///< Total normal impulse. [N s]
  Eigen::Vector3d friction = Eigen::Vector3d::Zero();  ///< Total friction impulse. [N s]
};

class Sweeps {
 public:
  Sweeps(std::span<Body> bodies, std::span<const ContactPair> pairs, const Errata& errata)
      : bodies_(bodies), errata_(errata) {
    for (const ContactPair& pair : pairs) {
      for (const Eigen::Vector3d& p_W : pair.manifold.contacts_W) {
        Contact contact{&pair, p_W};
        const Eigen::Vector3d& n = pair.manifold.n_AB_W;
        const Eigen::Vector3d u = RelativeVelocity(A(contact), B(contact), p_W);
        contact.aim = std::max(0.0, -Restitution(contact) * u.dot(n));
        contact.slip = u - u.dot(n) * n;
        contacts_.push_back(contact);
      }
    }
  }

  void Sweep() {
    for (Contact& contact : contacts_) {
      if (errata_.Has(Erratum::kE12)) {
        ApplyShared(contact);
      } else {
        ApplyAccumulated(contact);
      }
    }
  }

  std::vector<ContactImpulse> Given() const {
    std::vector<ContactImpulse> given;
    for (const Contact& contact : contacts_) {
      const Manifold& manifold = contact.pair->manifold;
      given.push_back({contact.pair->A, contact.pair->B, contact.p_W, manifold.n_AB_W,
                       contact.normal * manifold.n_AB_W + contact.friction,
                       -manifold.depth});
    }
    return given;
  }

 private:
  Body& A(const Contact& c) { return bodies_[static_cast<std::size_t>(c.pair->A)]; }
  Body& B(const Contact& c) { return bodies_[static_cast<std::size_t>(c.pair->B)]; }

  double Restitution(const Contact& c) {
    return std::min(A(c).restitution, B(c).restitution);
  }
  double Friction(const Contact& c) { return std::sqrt(A(c).friction * B(c).friction); }

  /** Sequential impulses: the accumulated impulse is clamped, not each increment, so that
   a later iteration can take back the surplus of an earlier one. */
  void ApplyAccumulated(Contact& c) {
    Body& a = A(c);
    Body& b = B(c);
    const Eigen::Vector3d& n = c.pair->manifold.n_AB_W;
    const double approach = RelativeVelocity(a, b, c.p_W).dot(n);
    const double wanted =
        c.normal + (c.aim - approach) / Response(a, b, c.p_W, n, errata_);
    const double normal = std::max(wanted, 0.0);
    GiveBoth(a, b, c.p_W, (normal - c.normal) * n, errata_);
    c.normal = normal;
    const bool late = !errata_.Has(Erratum::kE23);
    const Eigen::Vector3d u = RelativeVelocity(a, b, c.p_W);
    const Eigen::Vector3d slip = late ? Eigen::Vector3d(u - u.dot(n) * n) : c.slip;
    if (slip.isZero(0)) return;
    const Eigen::Vector3d t = slip.normalized();
    const Eigen::Vector3d stop = -slip.norm() / Response(a, b, c.p_W, t, errata_) * t;
    if (errata_.Has(Erratum::kE25) && stop.norm() < kLeastFriction) return;
    // The current slip determines an increment; the slip before the impact, the total.
    Eigen::Vector3d friction = late ? Eigen::Vector3d(c.friction + stop) : stop;
    const double most = Friction(c) * c.normal;
    if (friction.norm() > most) friction *= most / friction.norm();
    GiveBoth(a, b, c.p_W, friction - c.friction, errata_);
    c.friction = friction;
  }

  /** The recipe as printed: every iteration applies restitution again, and each contact
   its share, one over the number of contacts. */
  void ApplyShared(Contact& c) {
    Body& a = A(c);
    Body& b = B(c);
    const Eigen::Vector3d& n = c.pair->manifold.n_AB_W;
    const Eigen::Vector3d before = RelativeVelocity(a, b, c.p_W);
    const double approach = before.dot(n);
    if (approach > 0) return;
    const double share = 1 / static_cast<double>(c.pair->manifold.contacts_W.size());
    const double j =
        -(1 + Restitution(c)) * approach / Response(a, b, c.p_W, n, errata_) * share;
    GiveBoth(a, b, c.p_W, j * n, errata_);
    c.normal += j;
    const Eigen::Vector3d u =
        errata_.Has(Erratum::kE23) ? before : RelativeVelocity(a, b, c.p_W);
    const Eigen::Vector3d slip = u - u.dot(n) * n;
    if (slip.isZero(0)) return;
    const Eigen::Vector3d t = slip.normalized();
    const double stop = slip.norm() / Response(a, b, c.p_W, t, errata_) * share;
    if (errata_.Has(Erratum::kE25) && stop < kLeastFriction) return;
    const Eigen::Vector3d friction = -std::min(stop, Friction(c) * j) * t;
    GiveBoth(a, b, c.p_W, friction, errata_);
    c.friction += friction;
  }

  std::span<Body> bodies_;
  const Errata& errata_;
  std::vector<Contact> contacts_;
};

/** The displacement of a body by the position correction, relative to its pose before. */
struct Displacement {
  Eigen::Vector3d moved = Eigen::Vector3d::Zero();   ///< [m]
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();  ///< [rad]

  Eigen::Vector3d At(const Eigen::Vector3d& r) const { return moved + turned.cross(r); }
};

}  // namespace

std::vector<ContactPair> TouchingPairs(std::span<const Body> bodies,
                                       const Errata& errata) {
  std::vector<ContactPair> pairs;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      if (!bodies[a].collides || !bodies[b].collides) continue;
      if (bodies[a].mass == 0 && bodies[b].mass == 0) continue;
      Manifold manifold = CollideBodies(bodies[a], bodies[b], errata);
      if (!manifold.touching) continue;
      pairs.push_back({static_cast<int>(a), static_cast<int>(b), std::move(manifold)});
    }
  }
  return pairs;
}

std::vector<ContactImpulse> ApplyImpulses(std::span<Body> bodies,
                                          std::span<const ContactPair> pairs,
                                          int iterations, const Errata& errata) {
  Sweeps sweeps(bodies, pairs, errata);
  for (int i = 0; i < iterations; ++i) sweeps.Sweep();
  return sweeps.Given();
}

void Project(std::span<Body> bodies, std::span<const ContactPair> pairs, double share,
             double tolerance, const Errata& errata) {
  for (const ContactPair& pair : pairs) {
    Body& a = bodies[static_cast<std::size_t>(pair.A)];
    Body& b = bodies[static_cast<std::size_t>(pair.B)];
    const Eigen::Vector3d& n = pair.manifold.n_AB_W;
    const double excess = std::max(pair.manifold.depth - tolerance, 0.0);
    if (errata.Has(Erratum::kE24)) {
      const double push = share * excess / (InverseMass(a) + InverseMass(b));
      a.p_WB -= push * InverseMass(a) * n;
      b.p_WB += push * InverseMass(b) * n;
      continue;
    }
    const Eigen::Vector3d p_WA = a.p_WB;
    const Eigen::Vector3d p_WB = b.p_WB;
    Displacement of_a;
    Displacement of_b;
    for (const Eigen::Vector3d& p_W : pair.manifold.contacts_W) {
      const Eigen::Vector3d r_A = p_W - p_WA;
      const Eigen::Vector3d r_B = p_W - p_WB;
      const double done = n.dot(of_b.At(r_B) - of_a.At(r_A));
      const double push =
          std::max(share * excess - done, 0.0) / Response(a, b, p_W, n, errata);
      of_a.moved -= push * InverseMass(a) * n;
      of_b.moved += push * InverseMass(b) * n;
      of_a.turned -= InverseInertia(a, errata) * r_A.cross(push * n);
      of_b.turned += InverseInertia(b, errata) * r_B.cross(push * n);
    }
    a.p_WB += of_a.moved;
    b.p_WB += of_b.moved;
    if (!of_a.turned.isZero(0)) Turn(a, of_a.turned, errata);
    if (!of_b.turned.isZero(0)) Turn(b, of_b.turned, errata);
  }
}

}  // namespace cookbook::printed
