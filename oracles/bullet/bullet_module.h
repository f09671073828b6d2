#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "oracles/contact_answer.h"
#include "oracles/trajectory.h"
#include "scenarios/contact_query.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** Which of Bullet's algorithms answers. */
enum class BulletPath { kWorldDispatch, kClosestPoints };

/** How contacts of worlds are solved and stabilised. */
enum class BulletConstraints {
  kRigid,      ///< Until nothing changes; overlap is not pushed out.
  kAsShipped,  ///< Bullet's defaults.
};

class BulletWorld;  // Known to the module alone.

/** What a Bullet module offers.

 Plain functions and no classes with virtual functions: program and module each have their
 own type information, which would make them two types to a checker. Questions and answers
 cross as they are, so both sides must come from the same headers and compiler flags. */
struct BulletModule {
  std::size_t query_size;  ///< sizeof(ContactQuery), to refuse a module of another build.
  std::size_t answer_size;   ///< sizeof(ContactAnswer), likewise.
  std::size_t world_size;    ///< sizeof(World), likewise.
  std::size_t state_size;    ///< sizeof(BodyState), likewise.
  std::size_t impulse_size;  ///< sizeof(ContactImpulse), likewise.
  int version;               ///< What the library says: 324 is 3.24.
  double unit_roundoff;      ///< Of btScalar.

  /** Writes the answer to *queries[i] into *answers[i], for `count` supported queries. */
  void (*answer)(BulletPath path, const ContactQuery* const* queries,
                 ContactAnswer* const* answers, std::size_t count);

  /** Returns shapes and poses of `count` supported queries in Bullet's form, for run().
   */
  void* (*prepare)(BulletPath path, const ContactQuery* queries, std::size_t count);

  /** Asks every question of `batch` once; NaN where Bullet reports nothing. [m] */
  void (*run)(void* batch, double* separations);

  /** Frees what prepare() returned. */
  void (*discard)(void* batch);

  /** Returns `world` at its start; the others are the functions of Simulation. */
  BulletWorld* (*begin)(const World& world, const std::vector<Eigen::Vector3d>& inertias,
                        BulletConstraints constraints);
  void (*push)(BulletWorld* world, int body, const Eigen::Vector3d& p_W,
               const Eigen::Vector3d& J_W);
  void (*step)(BulletWorld* world);
  void (*read)(const BulletWorld* world, WorldState& state);
  void (*read_impulses)(const BulletWorld* world, std::vector<ContactImpulse>& impulses);

  /** Frees what begin() returned. */
  void (*end)(BulletWorld* world);
};

/** The one symbol a module exports, of type `const BulletModule* ()`. */
inline constexpr char kBulletModuleSymbol[] = "TouchstoneBulletModule";

}  // namespace touchstone
