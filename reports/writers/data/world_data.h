#pragma once

#include <span>
#include <string>
#include <vector>

#include "reports/finding/finding.h"
#include "reports/worlds/study/world_result.h"
#include "reports/writers/data/json_values.h"

namespace touchstone {

/** The input from which the data of a world are made. */
struct WorldDataInput {
  const WorldResult& result;
  double size;  ///< Extent of the smallest moving body, or of the motion. [m]
  std::vector<bool> simulates;                     ///< Indexed by oracle.
  std::vector<std::span<const Finding>> findings;  ///< Findings of this world, by oracle.
  /** Index of the first finding of each oracle in RunReport::findings. */
  std::vector<std::size_t> first_finding;
};

/** When the motion of a finding leaves its tolerance. */
struct Moment {
  std::size_t finding;  ///< Index into RunReport::findings.
  double time;          ///< [s]
};

/** Returns the data of a world, `World` of docs/report_data.md. Appends its tracks to
 `blob`, and to `moments` those of its findings.

 Motions: every n-th sample is kept, so that no world keeps more than 240 samples and
 3,000 samples of bodies and points, but 48 samples at least. Positions are rounded to a
 tenth of the tolerance of the oracle's position error, within 1e-6 to 1e-4 of `size`, and
 to 1e-5 of it without one. Rotations are rounded to 1e-4, velocities to 1e-3 of the
 largest of their motion, and to 1e-6 of it if the motion diverges.

 Curves are rounded to a tenth of their tolerance, without one to 1e-4 of their range. */
DataJson DataOf(const WorldDataInput& world, std::vector<Moment>& moments,
                std::string& blob);

}  // namespace touchstone
