#include "engine/dynamics/solver/iteration_acceleration.h"

#include <algorithm>
#include <cstddef>

namespace cookbook {
namespace {

/** Calls `visit(number)` for all impulses and velocities, in one order. */
template <class Visit>
void ForEachNumber(const ConstraintView<double>& constraints,
                   std::span<Velocity> velocities, const Visit& visit) {
  for (ContactConstraintLanes<double>& contact : constraints.contacts) {
    for (Lanes<double>* impulses :
         {&contact.impulse, &contact.friction_impulse1, &contact.friction_impulse2}) {
      for (double& impulse : *impulses) visit(impulse);
    }
  }
  for (Velocity& velocity : velocities) {
    for (Eigen::Vector3d* part : {&velocity.v, &velocity.w}) {
      for (double& number : *part) visit(number);
    }
  }
}

}  // namespace

double IterationAcceleration::ChangeOfImpulses(
    const ConstraintView<double>& constraints) const {
  double sum = 0;
  std::size_t k = 0;
  const auto add = [&](const Lanes<double>& response) {
    for (const double each : response) {
      const double change = now_[k] - before_[k];
      sum += each * change * change;
      ++k;
    }
  };
  for (const ContactColdLanes<double>& contact : constraints.cold) {
    add(contact.normal_response);
    add(contact.slip_response);
    add(contact.slip_response);
  }
  return sum;
}

void IterationAcceleration::Extrapolate(const ConstraintView<double>& constraints,
                                        std::span<Velocity> velocities) {
  now_.clear();
  ForEachNumber(constraints, velocities, [&](double number) { now_.push_back(number); });
  if (++iterations_ == 1) {
    before_ = now_;
    direction_.assign(now_.size(), 0);
    return;
  }
  const double change = ChangeOfImpulses(constraints);
  const double beta = iterations_ == 2 ? 0 : change / last_change_;
  last_change_ = change;
  // Written so that a NaN starts again.
  const bool goes_on = beta > 0 && beta <= 1;
  std::size_t k = 0;
  ForEachNumber(constraints, velocities, [&](double& number) {
    const double along = goes_on ? beta * direction_[k] : 0;
    direction_[k] = along + now_[k] - before_[k];
    number += along;
    before_[k] = number;
    ++k;
  });
}

}  // namespace cookbook
