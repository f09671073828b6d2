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

void Validate(const Settings& s) {
  for (const double g : s.gravity_W) {
    Expect(std::isfinite(g), "gravity_W", g, "finite numbers");
  }
  Expect(s.impulse_iterations > 0, "impulse_iterations", s.impulse_iterations,
         "at least 1");
  Expect(s.iteration_budget >= 0, "iteration_budget", s.iteration_budget, "at least 0");
  Expect(s.residual >= 0, "residual", s.residual, "at least 0");
  Expect(s.joint_rounds > 0, "joint_rounds", s.joint_rounds, "at least 1");
  Expect(s.restitution_threshold_factor >= 0 &&
             std::isfinite(s.restitution_threshold_factor),
         "restitution_threshold_factor", s.restitution_threshold_factor,
         "a finite number >= 0");
  Expect(s.contact_frequency > 0, "contact_frequency", s.contact_frequency,
         "a positive number or infinity");
  Expect(s.contact_retardation > 0 && std::isfinite(s.contact_retardation),
         "contact_retardation", s.contact_retardation, "a positive finite number");
  Expect(s.position_correction_fraction > 0 && s.position_correction_fraction <= 1,
         "position_correction_fraction", s.position_correction_fraction,
         "a number in (0, 1]");
  const double slop = s.penetration_slop.value_or(0);
  Expect(slop >= 0 && std::isfinite(slop), "penetration_slop", slop,
         "a finite number >= 0");
  const double margin = s.speculative_margin.value_or(0);
  Expect(margin >= 0 && std::isfinite(margin), "speculative_margin", margin,
         "a finite number >= 0");
  Expect(s.position_iterations > 0, "position_iterations", s.position_iterations,
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
