#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

#include "reports/referee/contact_truth.h"

namespace touchstone {

/** The angle from the certificate's direction beyond which a normal without excess is a
 different normal, not the same one rounded. With an excess of at most e = 1e-14 of the
 scene's size, a smooth body could turn its normal so far only about a curvature of 2 e /
 0.01² = 2e-10 of the size. [rad] */
inline constexpr double kOtherNormal = 0.01;

/** Returns a sentence if `n_W`, whose excess is within tolerance, is another direction as
 good as the certificate's; otherwise nothing. */
std::optional<std::string> TieOf(const ContactTruth& truth, const Eigen::Vector3d& n_W);

}  // namespace touchstone
