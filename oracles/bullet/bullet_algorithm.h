#pragma once

#include "oracles/bullet/bullet_shape.h"
#include "oracles/contact_answer.h"

namespace touchstone {

/** One of Bullet's ways to answer. Not for use by two threads at once. */
class BulletAlgorithm {
 public:
  virtual ~BulletAlgorithm() = default;

  /** Returns what Bullet says of `pair`, in the project's conventions. */
  virtual ContactAnswer Answer(const BulletPair& pair) = 0;

  /** Returns the least separation that Bullet reports for `pair`, NaN where it reports
   none. The work of Answer() without the translation, for timing. [m] */
  virtual double Separation(const BulletPair& pair) = 0;
};

}  // namespace touchstone
