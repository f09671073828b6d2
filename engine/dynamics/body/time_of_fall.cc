#include "engine/dynamics/body/time_of_fall.h"

#include <cmath>

namespace cookbook {

std::optional<double> TimeOfFall(double height, double speed, double acceleration) {
  // The root without cancellation, if it falls already (speed < 0) or is pulled back.
  const double discriminant = speed * speed - 2 * acceleration * height;
  if (discriminant < 0) return std::nullopt;
  const double root = std::sqrt(discriminant);
  if (speed < 0) return 2 * height / (root - speed);
  if (acceleration < 0) return (speed + root) / -acceleration;
  return std::nullopt;
}

}  // namespace cookbook
