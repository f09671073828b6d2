// Compiled once against each build of Bullet, into a separate module.
#include "oracles/bullet/bullet_module.h"

#include <limits>
#include <memory>
#include <vector>

#include "oracles/bullet/bullet_world.h"
#include "oracles/bullet/closest_points.h"
#include "oracles/bullet/world_dispatch.h"
#include "oracles/stopwatch.h"

namespace touchstone {
namespace {

/* Creates the algorithm. Called for every batch, because a dispatcher that two threads
 share crashes. */
std::unique_ptr<BulletAlgorithm> AlgorithmOf(BulletPath path) {
  if (path == BulletPath::kWorldDispatch) return std::make_unique<WorldDispatch>();
  return std::make_unique<ClosestPoints>();
}

struct Batch {
  std::unique_ptr<BulletAlgorithm> algorithm;
  std::vector<std::unique_ptr<BulletPair>> pairs;
};

void Answer(BulletPath path, const ContactQuery* const* queries,
            ContactAnswer* const* answers, std::size_t count) {
  const std::unique_ptr<BulletAlgorithm> algorithm = AlgorithmOf(path);
  for (std::size_t i = 0; i < count; ++i) {
    const Stopwatch watch;
    *answers[i] = algorithm->Answer(BulletPair(*queries[i]));
    answers[i]->seconds = watch.seconds();
  }
}

void* Prepare(BulletPath path, const ContactQuery* queries, std::size_t count) {
  auto batch = std::make_unique<Batch>();
  batch->algorithm = AlgorithmOf(path);
  for (std::size_t i = 0; i < count; ++i) {
    batch->pairs.push_back(std::make_unique<BulletPair>(queries[i]));
  }
  return batch.release();
}

void Run(void* prepared, double* separations) {
  const auto* batch = static_cast<Batch*>(prepared);
  for (std::size_t i = 0; i < batch->pairs.size(); ++i) {
    separations[i] = batch->algorithm->Separation(*batch->pairs[i]);
  }
}

void Discard(void* prepared) {
  delete static_cast<Batch*>(prepared);
}

BulletWorld* Begin(const World& world, const std::vector<Eigen::Vector3d>& inertias,
                   const std::vector<double>& values) {
  return std::make_unique<BulletWorld>(world, inertias, values).release();
}

void PushBody(BulletWorld* world, int body, const Eigen::Vector3d& p_W,
              const Eigen::Vector3d& J_W) {
  world->Push(body, p_W, J_W);
}

void Step(BulletWorld* world) {
  world->Step();
}

void Read(const BulletWorld* world, WorldState& state) {
  world->Read(state);
}

void ReadImpulses(const BulletWorld* world, std::vector<ContactImpulse>& impulses) {
  world->ReadImpulses(impulses);
}

void End(BulletWorld* world) {
  delete world;
}

}  // namespace
}  // namespace touchstone

extern "C" __attribute__((visibility("default"))) const touchstone::BulletModule*
TouchstoneBulletModule() {
  using namespace touchstone;
  static const BulletModule kModule = {
      sizeof(ContactQuery),
      sizeof(ContactAnswer),
      sizeof(World),
      sizeof(BodyState),
      sizeof(ContactImpulse),
      btGetVersion(),
      std::numeric_limits<btScalar>::epsilon() / 2,
      &Answer,
      &Prepare,
      &Run,
      &Discard,
      &Begin,
      &PushBody,
      &Step,
      &Read,
      &ReadImpulses,
      &End,
  };
  return &kModule;
}
