#include <algorithm>
#include <array>

#include "engine/dynamics/body/rotation.h"
#include "engine/dynamics/world/integrate.h"

#define HWY_TARGET_INCLUDE "engine/dynamics/world/integrate_simd.cc"
#include "engine/simd/foreach_target.h"
// After foreach_target.h.
#include "engine/dynamics/solver/solver_bodies_simd.h"

HWY_BEFORE_NAMESPACE();
namespace cookbook::HWY_NAMESPACE {
namespace {

// Sums and products are in Eigen's order, so that a body moves by the same bits here as
// in World::IntegrateBody().

HWY_INLINE Four SquaredLength(const Vec3<double>& a) {
  return a.x * a.x + (a.y * a.y + a.z * a.z);
}

struct Quaternions {
  Four x, y, z, w;
};

HWY_INLINE Quaternions Product(const Quaternions& a, const Quaternions& b) {
  return {(a.w * b.x + a.y * b.z) - (a.z * b.y - a.x * b.w),
          (a.w * b.y + a.y * b.w) + (a.z * b.x - a.x * b.z),
          (a.w * b.z - a.y * b.x) + (a.z * b.w + a.x * b.y),
          (a.w * b.w - a.y * b.y) - (a.z * b.z + a.x * b.x)};
}

HWY_INLINE Quaternions Normalized(const Quaternions& q) {
  const Four length = Sqrt((q.x * q.x + q.z * q.z) + (q.y * q.y + q.w * q.w));
  return {q.x / length, q.y / length, q.z / length, q.w / length};
}

/** Four times Exp(). */
HWY_INLINE Quaternions ExpFour(const Vec3<double>& phi) {
  const Four squared = SquaredLength(phi);
  Four s =
      Splat(0.5) + squared * (Splat(-1.0 / 48) +
                              squared * (Splat(1.0 / 3840) - squared / Splat(645120)));
  Four c =
      Splat(1) +
      squared * (Splat(-1.0 / 8) +
                 squared * (Splat(1.0 / 384) +
                            squared * (Splat(-1.0 / 46080) + squared / Splat(10321920))));
  Quaternions rotation{s * phi.x, s * phi.y, s * phi.z, c};
  const FourBits small = squared < Splat(kSmallAngleSquared);
  const unsigned is_small = Bits(small);
  for (std::size_t lane = 0; lane < 4 && is_small != 15; ++lane) {
    if ((is_small >> lane & 1) != 0) continue;
    const Eigen::Quaterniond exact = Exp({phi.x[lane], phi.y[lane], phi.z[lane]});
    rotation.x[lane] = exact.x();
    rotation.y[lane] = exact.y();
    rotation.z[lane] = exact.z();
    rotation.w[lane] = exact.w();
  }
  return rotation;
}

HWY_INLINE void Store3(Four v, Eigen::Vector3d& to) {
  to = {v[0], v[1], v[2]};
}

/** Translates four bodies by `displacement_W` and rotates them by `phi_W`. Fills `travel`
 with the Travel() of each and returns their positions. */
HWY_INLINE Vec3<double> Displace(const std::array<RigidBody*, 4>& body,
                                 const Vec3<double>& displacement_W,
                                 const Vec3<double>& phi_W, double* travel) {
  std::array<const double*, 4> p_WB;
  std::array<const double*, 4> q_WB;
  Four diameter;  // 0 for a sphere: rotation does not move its surface.
  for (std::size_t k = 0; k < 4; ++k) {
    p_WB[k] = body[k]->state.p_WB.data();
    q_WB[k] = body[k]->state.q_WB.coeffs().data();
    diameter[k] = body[k]->is_sphere ? 0 : 2 * body[k]->radius;
  }
  Four components[4];
  LoadTransposed(p_WB, components);
  const Vec3<double> p{components[0], components[1], components[2]};
  const Vec3<double> moved = Plus(p, displacement_W);
  LoadTransposed(q_WB, components);
  const Quaternions q = Normalized(Product(
      ExpFour(phi_W), {components[0], components[1], components[2], components[3]}));
  // A rotation by θ moves a point at r by at most 2 r sin(θ / 2).
  const Four sine = Min(Splat(0.5) * Sqrt(SquaredLength(phi_W)), Splat(1));
  Store(Sqrt(SquaredLength(Minus(moved, p))) + diameter * sine, travel);

  const Four zero{};
  const Four one = Splat(1);
  const Four tx = q.x + q.x;
  const Four ty = q.y + q.y;
  const Four tz = q.z + q.z;
  const Four twx = tx * q.w;
  const Four twy = ty * q.w;
  const Four twz = tz * q.w;
  const Four txx = tx * q.x;
  const Four txy = ty * q.x;
  const Four txz = tz * q.x;
  const Four tyy = ty * q.y;
  const Four tyz = tz * q.y;
  const Four tzz = tz * q.z;
  Four R_low[4] = {one - (tyy + tzz), txy + twz, txz - twy, txy - twz};
  Four R_high[4] = {one - (txx + tzz), tyz + twx, txz + twy, tyz - twx};
  const Four R_last = one - (txx + tyy);
  Four positions[4] = {moved.x, moved.y, moved.z, zero};
  Four orientations[4] = {q.x, q.y, q.z, q.w};
  for (Four* four : {R_low, R_high, positions, orientations}) {
    Transpose4(four[0], four[1], four[2], four[3]);
  }
  for (std::size_t k = 0; k < 4; ++k) {
    Store3(positions[k], body[k]->state.p_WB);
    Store(orientations[k], body[k]->state.q_WB.coeffs().data());
    double* R_WB = body[k]->R_WB.data();
    Store(R_low[k], R_WB);
    Store(R_high[k], R_WB + 4);
    R_WB[8] = R_last[k];
  }
  return moved;
}

/** Integrates four bodies. `travel` has four elements. Returns the same as
 IntegrateIsotropicBodies(). */
HWY_INLINE bool IntegrateFour(const Integration& integration, const int* indices,
                              double* travel) {
  std::array<RigidBody*, 4> body;
  Four radius;
  Four load_acceleration;
  Four touched{};
  Four is_sure_impact{};
  Four rested{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(indices[k]);
    body[k] = &integration.bodies[i];
    radius[k] = body[k]->radius;
    load_acceleration[k] =
        std::max(body[k]->load_acceleration, body[k]->island_load_acceleration);
    const ContactFlags& flags = integration.contact_flags[i];
    touched[k] = flags.bounced || flags.rested ? 1 : 0;
    is_sure_impact[k] = flags.bounced || !flags.steady ? 1 : 0;
    rested[k] = flags.rested ? 1 : 0;
  }
  const Four zero{};
  const Four half = Splat(0.5);
  const Four h = Splat(integration.h);
  const BodyVelocities<double> before = GatherFour(integration.before.data(), indices);
  const BodyVelocities<double> after = GatherFour(integration.solved.data(), indices);
  const Four change = Sqrt(SquaredLength(Minus(after.v, before.v))) +
                      radius * Sqrt(SquaredLength(Minus(after.w, before.w)));
  const FourBits has_impact =
      (touched > zero) &
      ((is_sure_impact > zero) |
       (change > Splat(kImpactFactor * integration.h) * load_acceleration));
  const auto choose = [&](const Vec3<double>& yes, const Vec3<double>& no) HWY_ATTR {
    return Vec3<double>{Select(has_impact, yes.x, no.x), Select(has_impact, yes.y, no.y),
                        Select(has_impact, yes.z, no.z)};
  };
  Vec3<double> impact_v = after.v;  // Mean velocity with an impact.
  Vec3<double> start_w = before.w;  // Angular velocity at the start.
  if (Bits(has_impact) != 0) {
    const BodyVelocities<double> free = GatherFour(integration.free.data(), indices);
    const Four fraction = Select(rested > zero, zero, half);
    impact_v = Minus(after.v, Times(fraction, Minus(free.v, before.v)));
    start_w = choose(Plus(before.w, Minus(after.w, free.w)), before.w);
  }
  const BodyVelocities<double> mean{
      choose(impact_v, Times(half, Plus(before.v, after.v))),
      choose(after.w, Times(half, Plus(before.w, after.w)))};
  const Vec3<double> k1 = Times(h, start_w);
  const Vec3<double> k4 = Times(h, after.w);
  const Vec3<double> cross = Cross(k1, k4);
  const Four twelve = Splat(12);
  const Vec3<double> phi = Minus(Times(half, Plus(k1, k4)),
                                 {cross.x / twelve, cross.y / twelve, cross.z / twelve});
  const Vec3<double> p = Displace(body, Times(h, mean.v), phi, travel);

  Four velocities[4] = {after.v.x, after.v.y, after.v.z, zero};
  Four angular_velocities[4] = {after.w.x, after.w.y, after.w.z, zero};
  Transpose4(velocities[0], velocities[1], velocities[2], velocities[3]);
  Transpose4(angular_velocities[0], angular_velocities[1], angular_velocities[2],
             angular_velocities[3]);
  for (std::size_t k = 0; k < 4; ++k) {
    Store3(velocities[k], body[k]->state.v_WB);
    Store3(angular_velocities[k], body[k]->state.w_WB);
  }
  ScatterFour(mean, indices, Splat(1), integration.mean.data());

  // Each number on its own, because a NaN has to fail the comparison.
  const Four bound = Splat(kDivergenceBound);
  FourBits below = Abs(p.x) < bound;
  for (const Four& x :
       {p.y, p.z, after.v.x, after.v.y, after.v.z, after.w.x, after.w.y, after.w.z}) {
    below &= Abs(x) < bound;
  }
  return Bits(below) == 15;
}

/** Corrects the positions of four bodies. `travel` has four elements. */
HWY_INLINE void CorrectFour(std::span<RigidBody> bodies, const Velocity* corrections,
                            const int* indices, double* travel) {
  std::array<RigidBody*, 4> body;
  for (std::size_t k = 0; k < 4; ++k)
    body[k] = &bodies[static_cast<std::size_t>(indices[k])];
  const BodyVelocities<double> correction = GatherFour(corrections, indices);
  Displace(body, correction.v, correction.w, travel);
}

/** Calls `work(indices, travel)` for four bodies at a time. */
template <class Work>
HWY_INLINE void ForEachFour(std::span<const int> bodies, std::span<double> travel,
                            const Work& work) {
  std::size_t k = 0;
  for (; k + 4 <= bodies.size(); k += 4) work(&bodies[k], &travel[k]);
  if (k == bodies.size()) return;
  // Lanes without a body repeat the last body and write the same values.
  std::array<int, 4> last;
  std::array<double, 4> last_travel;
  for (std::size_t lane = 0; lane < 4; ++lane) {
    last[lane] = bodies[std::min(k + lane, bodies.size() - 1)];
  }
  work(last.data(), last_travel.data());
  std::copy_n(last_travel.begin(), bodies.size() - k,
              travel.begin() + static_cast<std::ptrdiff_t>(k));
}

bool IntegrateAll(const Integration& integration, std::span<const int> bodies,
                  std::span<double> travel) {
  bool is_bounded = true;
  ForEachFour(bodies, travel, [&](const int* four, double* four_travel) HWY_ATTR {
    is_bounded &= IntegrateFour(integration, four, four_travel);
  });
  return is_bounded;
}

void CorrectAll(std::span<RigidBody> bodies, std::span<const Velocity> corrections,
                std::span<const int> corrected, std::span<double> travel) {
  ForEachFour(corrected, travel, [&](const int* four, double* four_travel) HWY_ATTR {
    CorrectFour(bodies, corrections.data(), four, four_travel);
  });
}

}  // namespace
}  // namespace cookbook::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cookbook {
bool IntegrateIsotropicBodies(const Integration& integration, std::span<const int> bodies,
                              std::span<double> travel) {
  return COOKBOOK_DISPATCH(IntegrateAll)(integration, bodies, travel);
}

void IntegratePositionCorrections(std::span<RigidBody> bodies,
                                  std::span<const Velocity> corrections,
                                  std::span<const int> corrected,
                                  std::span<double> travel) {
  COOKBOOK_DISPATCH(CorrectAll)(bodies, corrections, corrected, travel);
}
}  // namespace cookbook
#endif
