// Compiled once against each build of Bullet, into a module of its own.
#include "oracles/bullet/bullet_module.h"

#include <limits>
#include <memory>
#include <vector>

#include "oracles/bullet/closest_points.h"
#include "oracles/bullet/world_dispatch.h"

namespace touchstone {
namespace {

/* Made anew for every batch: shared by two threads, a dispatcher crashes. */
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
    *answers[i] = algorithm->Answer(BulletPair(*queries[i]));
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

}  // namespace
}  // namespace touchstone

extern "C" __attribute__((visibility("default"))) const touchstone::BulletModule*
TouchstoneBulletModule() {
  using namespace touchstone;
  static const BulletModule kModule = {
      sizeof(ContactQuery),
      sizeof(ContactAnswer),
      btGetVersion(),
      std::numeric_limits<btScalar>::epsilon() / 2,
      &Answer,
      &Prepare,
      &Run,
      &Discard,
  };
  return &kModule;
}
