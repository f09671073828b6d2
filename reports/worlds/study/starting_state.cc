#include "reports/worlds/study/starting_state.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "reports/text/format_vector.h"
#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/study/world_size.h"
#include "reports/worlds/truth/mechanics.h"

namespace touchstone {
namespace {

/** Compares vectors with those of the world one by one and keeps a description of the
 first that differs. */
class Comparison {
 public:
  explicit Comparison(double rounding) : rounding_(rounding) {}

  void Hold(std::string_view name, std::string_view what, const Eigen::Vector3d& is,
            const Eigen::Vector3d& said, double size) {
    // Written so that a NaN differs.
    if (!text_.empty() || (is - said).norm() <= rounding_ * size) return;
    text_ = fmt::format("starts with {} of {} at {}; the world says {}", what, name,
                        FormatVector(is, 9), FormatVector(said, 9));
  }

  void HoldTurn(std::string_view name, const Eigen::Quaterniond& is,
                const Eigen::Quaterniond& said) {
    const double angle = said.angularDistance(is.normalized());
    if (!text_.empty() || angle <= rounding_) return;
    text_ = fmt::format("starts with {} turned by {:.3g} rad from what the world says",
                        name, angle);
  }

  void HoldPoint(std::string_view name, const PointState& is, const PointState& said,
                 double size) {
    Hold(name, "the position", is.p_W, said.p_W, size);
    Hold(name, "the velocity", is.v_W, said.v_W, said.v_W.norm());
  }

  const std::string& text() const { return text_; }

 private:
  double rounding_;
  std::string text_;
};

}  // namespace

std::string DeviationFromStart(const World& world, const OracleInfo& oracle,
                               const Trajectory& trajectory) {
  const WorldState said = StateAtStart(world);
  if (trajectory.samples.empty()) return "has no state at the start";
  const WorldState& is = trajectory.samples.front();
  if (is.bodies.size() != said.bodies.size() ||
      is.particles.size() != said.particles.size() ||
      is.nodes.size() != said.nodes.size())
    return "starts with other bodies or points than the world has";
  Trajectory start;
  start.samples = {said};
  const double size = SizeOf(world, start);
  Comparison comparison(RoundingOf(oracle, 0));
  for (std::size_t i = 0; i < said.bodies.size(); ++i) {
    const std::string& name = world.bodies[i].name;
    const BodyState& body = said.bodies[i];
    const double fast = body.v_WB.norm() + body.w_WB.norm() * size;
    comparison.Hold(name, "the position", is.bodies[i].p_WB, body.p_WB,
                    std::max(size, body.p_WB.norm()));
    comparison.HoldTurn(name, is.bodies[i].q_WB, body.q_WB);
    comparison.Hold(name, "the velocity", is.bodies[i].v_WB, body.v_WB, fast);
    comparison.Hold(name, "the spin", is.bodies[i].w_WB, body.w_WB, body.w_WB.norm());
  }
  for (std::size_t i = 0; i < said.particles.size(); ++i)
    comparison.HoldPoint(world.particles[i].name, is.particles[i], said.particles[i],
                         size);
  for (std::size_t i = 0; i < said.nodes.size(); ++i)
    comparison.HoldPoint(fmt::format("node {}", i), is.nodes[i], said.nodes[i], size);
  return comparison.text();
}

}  // namespace touchstone
