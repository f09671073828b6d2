#include "reports/worlds/law_support/flat_box.h"

#include <algorithm>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/prediction.h"

namespace touchstone {
namespace {

/** The face of a box that lies on a plane. [m] */
struct Sole {
  double height;      ///< Height of the centre above it.
  double half_width;  ///< Its smaller half width.
};

Sole SoleOf(const RigidBody& box, const OnPlane& on) {
  const Eigen::Vector3d half = std::get<Box>(box.placed.shape).half_extents;
  const Eigen::Vector3d n_B = box.placed.X_WB.R_WB.transpose() * on.plane.n_W;
  int up = 0;
  n_B.cwiseAbs().maxCoeff(&up);
  return {half[up], std::min(half[(up + 1) % 3], half[(up + 2) % 3])};
}

}  // namespace

bool Tips(const RigidBody& box, const OnPlane& on, double grip) {
  const Sole sole = SoleOf(box, on);
  return grip * sole.height > on.press * sole.half_width;
}

std::vector<Worst> JudgeFlatBox(const Motion& motion, int index, const OnPlane& on,
                                const std::function<double(double t)>& speed) {
  const RigidBody& body = motion.world.bodies[static_cast<std::size_t>(index)];
  const double h = motion.world.dt;
  const double half_width = SoleOf(body, on).half_width;
  const double settles = (1 + on.plane.friction) / half_width;
  const AllowedWords angle_words = {
      .scheme = "(1 + μ) of the settling distance, over the half width of the sole",
      .solved = "the distance",
      .slop = true};
  const AllowedWords spin_words = {
      .scheme = "(1 + μ) of the settling speed, over the half width of the sole",
      .solved = "the velocity"};
  Worst orientation(MeasureKind::kOrientationError, angle_words.Because(motion.oracle));
  Worst spin(MeasureKind::kSpinError, spin_words.Because(motion.oracle));
  const Eigen::Quaterniond q_WB(body.placed.X_WB.R_WB);
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const BodyState& is =
        motion.trajectory.samples[s].bodies[static_cast<std::size_t>(index)];
    const double t = motion.trajectory.times[s];
    const double steps = StepsBefore(motion, s);
    const double turned = speed(t) / half_width;
    const double angle = q_WB.angularDistance(is.q_WB.normalized());
    const Allowed of_angle = {
        .scheme = settles * on.Settling(h), .solved = turned * t, .computed = 1};
    orientation.Take(angle, ToleranceOf(of_angle, motion.oracle, steps), [&] {
      return Citing("{} has {} turned by {:.6g} rad after {:.6g} s; nothing turns it",
                    motion.oracle.name, CitedName{body.name}, angle, CitedTime{t});
    });
    const Allowed of_spin = {.scheme = settles * on.SettlingSpeed(h), .solved = turned};
    spin.Take(is.w_WB.norm(), ToleranceOf(of_spin, motion.oracle, steps), [&] {
      return Citing("{} has {} spinning at {} after {:.6g} s; nothing turns it",
                    motion.oracle.name, CitedName{body.name}, FormatVector(is.w_WB, 9),
                    CitedTime{t});
    });
  }
  return {orientation, spin};
}

}  // namespace touchstone
