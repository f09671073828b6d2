#include "engine/dynamics/body/settings.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace cookbook {
namespace {

void Expect(bool holds, const char* setting, double value, const char* expected) {
  if (holds) return;
  std::ostringstream sentence;
  sentence << "The setting " << setting << " is " << value << "; expected " << expected
           << ".";
  throw std::invalid_argument(sentence.str());
}

}  // namespace

bool IsSmall(const Settings& settings, int contacts) {
  return (settings.impulse_iterations + 1) * contacts <= settings.patience;
}

void Validate(const Settings& s) {
  for (const double g : s.gravity_W) {
    Expect(std::isfinite(g), "gravity_W", g, "finite numbers");
  }
  Expect(s.impulse_iterations > 0, "impulse_iterations", s.impulse_iterations,
         "at least 1");
  Expect(s.patience >= 0, "patience", s.patience, "at least 0");
  Expect(s.residual >= 0, "residual", s.residual, "at least 0");
  Expect(s.joint_rounds > 0, "joint_rounds", s.joint_rounds, "at least 1");
  Expect(s.resting_speed >= 0 && std::isfinite(s.resting_speed), "resting_speed",
         s.resting_speed, "a finite number >= 0");
  Expect(s.projection_share > 0 && s.projection_share <= 1, "projection_share",
         s.projection_share, "a number in (0, 1]");
  const double slack = s.penetration_slack.value_or(0);
  Expect(slack >= 0 && std::isfinite(slack), "penetration_slack", slack,
         "a finite number >= 0");
  const double margin = s.contact_margin.value_or(0);
  Expect(margin >= 0 && std::isfinite(margin), "contact_margin", margin,
         "a finite number >= 0");
  Expect(s.projection_iterations > 0, "projection_iterations", s.projection_iterations,
         "at least 1");
  Expect(s.soft_frequency > 0 && std::isfinite(s.soft_frequency), "soft_frequency",
         s.soft_frequency, "a positive finite number");
  Expect(s.soft_damping_ratio >= 0 && std::isfinite(s.soft_damping_ratio),
         "soft_damping_ratio", s.soft_damping_ratio, "a finite number >= 0");
  const double sleep_after = s.sleep_after.value_or(1);
  Expect(sleep_after > 0 && std::isfinite(sleep_after), "sleep_after", sleep_after,
         "a positive finite number");
  Expect(s.sleep_speed > 0 && std::isfinite(s.sleep_speed), "sleep_speed", s.sleep_speed,
         "a positive finite number");
  Expect(s.threads > 0, "threads", s.threads, "at least 1");
  Expect(s.sub_steps > 0, "sub_steps", s.sub_steps, "at least 1");
}

}  // namespace cookbook
