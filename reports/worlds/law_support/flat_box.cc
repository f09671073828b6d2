#include "reports/worlds/law_support/flat_box.h"

#include <algorithm>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/citing.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/slop.h"

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

FlatBox::FlatBox(const Motion& motion, int body, const OnPlane& on)
    : motion_(motion),
      body_(body),
      half_width_(
          SoleOf(motion.world.bodies[static_cast<std::size_t>(body)], on).half_width),
      orientation_(
          MeasureKind::kOrientationError,
          WithSlop("1.5 × (1 + μ) of the settling distance, over the half width of the "
                   "sole; 1e-5 of the distance for the solver, and 64 roundings per step",
                   motion.oracle)),
      spin_(MeasureKind::kSpinError,
            "1.5 × (1 + μ) of the settling speed, over the half width of the sole; 1e-5 "
            "of the velocity for the solver, and 64 roundings per step") {
  const double h = motion.world.dt;
  const double settles = kSafety * (1 + on.plane.friction) / half_width_;
  settling_angle_ = settles * on.Settling(h);
  settling_spin_ = settles * on.SettlingSpeed(h);
}

void FlatBox::Take(std::size_t s, double speed) {
  const auto i = static_cast<std::size_t>(body_);
  const RigidBody& body = motion_.world.bodies[i];
  const BodyState& is = motion_.trajectory.samples[s].bodies[i];
  const double t = motion_.trajectory.times[s];
  const double rounding = RoundingOf(motion_.oracle, StepsBefore(motion_, s));
  const double left = (kSolverResidual + rounding) * speed / half_width_;
  const Eigen::Quaterniond q_WB(body.placed.X_WB.R_WB);
  const double angle = q_WB.angularDistance(is.q_WB.normalized());
  orientation_.Take(angle, settling_angle_ + left * t + rounding, [&] {
    return Citing("{} has {} turned by {:.6g} rad after {:.6g} s; nothing turns it",
                  motion_.oracle.name, CitedName{body.name}, angle, CitedTime{t});
  });
  spin_.Take(is.w_WB.norm(), settling_spin_ + left, [&] {
    return Citing("{} has {} spinning at {} after {:.6g} s; nothing turns it",
                  motion_.oracle.name, CitedName{body.name}, FormatVector(is.w_WB, 9),
                  CitedTime{t});
  });
}

}  // namespace touchstone
