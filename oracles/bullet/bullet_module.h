#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "oracles/trajectory.h"
#include "scenarios/contact_query.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** The collision algorithm of Bullet that answers. */
enum class BulletPath { kWorldDispatch, kClosestPoints };

/** Indices of the parameters of worlds. BulletOracleInfo() declares them. */
enum BulletParameter : std::size_t {
  kBulletIterations,
  kBulletResidual,
  kBulletErp,
  kBulletSplitImpulse,
  kBulletFrictionDirections,
  kBulletProcessingThreshold,
  kBulletRestitutionThreshold,
  kBulletMargin,
  kBulletSleeping,
  kBulletContinuous,
  kBulletSweptRadius,
  kBulletGyroscopic,
  kBulletRollingFriction,
  kBulletSpinningFriction,
  kBulletParameters,
};

class BulletWorld;  // Complete only inside the module.

/** The interface of a Bullet module.

 It has plain functions instead of a class with virtual functions: program and module each
 have their own type information, so a sanitizer would see two different types. Questions
 and answers are passed unchanged, so both sides must be built from the same headers with
 the same compiler flags. */
struct BulletModule {
  std::size_t query_size;  ///< sizeof(ContactQuery), to refuse a module of another build.
  std::size_t answer_size;   ///< sizeof(ContactAnswer), likewise.
  std::size_t world_size;    ///< sizeof(World), likewise.
  std::size_t state_size;    ///< sizeof(BodyState), likewise.
  std::size_t impulse_size;  ///< sizeof(ContactImpulse), likewise.
  int version;               ///< Version that the library reports: 324 is 3.24.
  double unit_roundoff;      ///< Unit roundoff of btScalar.

  /** Writes the answers to `count` supported queries, that to *queries[i] into
   *answers[i]. */
  void (*answer)(BulletPath path, const ContactQuery* const* queries,
                 ContactAnswer* const* answers, std::size_t count);

  /** Returns the shapes and poses of `count` supported queries in Bullet's types, for
   run(). */
  void* (*prepare)(BulletPath path, const ContactQuery* queries, std::size_t count);

  /** Runs every query of `batch` once; a separation is NaN if Bullet reports none. [m] */
  void (*run)(void* batch, double* separations);

  /** Frees the result of prepare(). */
  void (*discard)(void* batch);

  /** Returns `world` at its start, with a value for each BulletParameter. The next four
   correspond to the functions of Simulation. */
  BulletWorld* (*begin)(const World& world, const std::vector<Eigen::Vector3d>& inertias,
                        const std::vector<double>& values);
  void (*push)(BulletWorld* world, int body, const Eigen::Vector3d& p_W,
               const Eigen::Vector3d& J_W);
  void (*step)(BulletWorld* world);
  void (*read)(const BulletWorld* world, WorldState& state);
  void (*read_impulses)(const BulletWorld* world, std::vector<ContactImpulse>& impulses);

  /** Frees the result of begin(). */
  void (*end)(BulletWorld* world);
};

/** The only symbol that a module exports, of type `const BulletModule* ()`. */
inline constexpr char kBulletModuleSymbol[] = "TouchstoneBulletModule";

}  // namespace touchstone
