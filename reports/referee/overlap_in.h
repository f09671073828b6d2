#pragma once

#include <Eigen/Core>

#include "reports/referee/support.h"
#include "reports/referee/vector.h"

namespace touchstone::referee {

/** Returns Overlap() (referee.h) as evaluated in `Real`. [m]
 @pre Neither body is a half-space. */
template <typename Real>
Enclosure OverlapIn(const ContactQuery& query, const Eigen::Vector3d& n_W) {
  return ((SupportOf<Real>(query.A, n_W) + SupportOf<Real>(query.B, -n_W)) /
          Norm(Exactly<Bounded<Real>>(n_W)))
      .enclosure();
}

}  // namespace touchstone::referee
