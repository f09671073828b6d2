#pragma once

#include "oracles/bullet/bullet_shape.h"
#include "oracles/contact_answer.h"

namespace touchstone {

/** One of Bullet's collision algorithms. Not thread safe. */
class BulletAlgorithm {
 public:
  virtual ~BulletAlgorithm() = default;

  /** Returns Bullet's answer for `pair`, in the project's conventions. */
  virtual ContactAnswer Answer(const BulletPair& pair) = 0;

  /** Returns the least separation that Bullet reports for `pair`, NaN if it reports none.
   For timing: the same work as Answer(), without the translation. [m] */
  virtual double Separation(const BulletPair& pair) = 0;
};

}  // namespace touchstone
