#include "reports/reproduce/drift_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace touchstone {

std::string EnergyText(std::span<const int> bodies) {
  return fmt::format(R"(
// The state of the table, before the engine has rounded it.
[[maybe_unused]] WorldState Start() {{
  WorldState state;
  for (const Body& body : kBodies) state.push_back({{body.p, body.R, body.v, body.w}});
  return state;
}}

// The energy of motion, and that of gravity and the constant forces.
double EnergyOf(const WorldState& state) {{
  double energy = 0;
  for (const int i : {{{}}}) {{
    const Body& body = kBodies[i];
    const State& at = state[i];
    for (int k = 0; k < 3; ++k) {{
      const double w = at.R[k] * at.w[0] + at.R[k + 3] * at.w[1] + at.R[k + 6] * at.w[2];
      energy += (body.mass * at.v[k] * at.v[k] + body.I[k] * w * w) / 2;
      energy -= (body.mass * kGravity[k] + body.force[k]) * at.p[k];
    }}
  }}
  return energy;
}}
)",
                     fmt::join(bodies, ", "));
}

std::string MomentumText(std::span<const int> bodies) {
  return fmt::format(R"(
// The sum of m v.
Vector MomentumOf(const WorldState& state) {{
  Vector sum{{}};
  for (const int i : {{{}}})
    for (int k = 0; k < 3; ++k) sum[k] += kBodies[i].mass * state[i].v[k];
  return sum;
}}
)",
                     fmt::join(bodies, ", "));
}

}  // namespace touchstone
