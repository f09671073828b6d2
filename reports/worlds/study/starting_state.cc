#include "reports/worlds/study/starting_state.h"

#include <algorithm>
#include <string_view>
#include <utility>

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
  explicit Comparison(const OracleInfo& oracle)
      : oracle_(oracle.name), rounding_(RoundingOf(oracle, 0)) {}

  void HoldPosition(std::string_view name, const Eigen::Vector3d& is,
                    const Eigen::Vector3d& said, double size) {
    Hold(name, "position", is, said, size,
         [](const Eigen::Vector3d& p_W) { return CitedPoint{p_W}; });
  }

  /** Compares a velocity or a spin, which is no point. */
  void HoldRate(std::string_view name, std::string_view what, const Eigen::Vector3d& is,
                const Eigen::Vector3d& said, double size) {
    Hold(name, what, is, said, size,
         [](const Eigen::Vector3d& rate_W) { return FormatVector(rate_W, 9); });
  }

  void HoldTurn(std::string_view name, const Eigen::Quaterniond& is,
                const Eigen::Quaterniond& said) {
    const double angle = said.angularDistance(is.normalized());
    if (IsFound() || angle <= rounding_) return;
    Found(Citing("{} starts with {} turned by {:.3g} rad from what the world says",
                 oracle_, CitedName{name}, angle));
  }

  void HoldPoint(std::string_view name, const PointState& is, const PointState& said,
                 double size) {
    HoldPosition(name, is.p_W, said.p_W, size);
    HoldRate(name, "velocity", is.v_W, said.v_W, said.v_W.norm());
  }

  const CitingProof& proof() const { return proof_; }

 private:
  bool IsFound() const { return !proof_.sentence.empty(); }

  template <typename ShownAs>
  void Hold(std::string_view name, std::string_view what, const Eigen::Vector3d& is,
            const Eigen::Vector3d& said, double size, ShownAs shown_as) {
    // Written so that a NaN differs.
    if (IsFound() || (is - said).norm() <= rounding_ * size) return;
    Found(Citing("{} starts with the {} of {} at {}; the world says {}", oracle_, what,
                 CitedName{name}, shown_as(is), shown_as(said)));
  }

  void Found(CitingProof proof) {
    proof_ = std::move(proof);
    proof_.cited.time = 0;
  }

  std::string_view oracle_;
  double rounding_;
  CitingProof proof_;
};

}  // namespace

CitingProof DeviationFromStart(const World& world, const OracleInfo& oracle,
                               const Trajectory& trajectory) {
  const WorldState said = StateAtStart(world);
  if (trajectory.samples.empty())
    return Citing("{} has no state at the start", oracle.name);
  const WorldState& is = trajectory.samples.front();
  if (is.bodies.size() != said.bodies.size() ||
      is.particles.size() != said.particles.size() ||
      is.nodes.size() != said.nodes.size())
    return Citing("{} starts with other bodies or points than the world has",
                  oracle.name);
  Trajectory start;
  start.samples = {said};
  const double size = SizeOf(world, start);
  Comparison comparison(oracle);
  for (std::size_t i = 0; i < said.bodies.size(); ++i) {
    const std::string& name = world.bodies[i].name;
    const BodyState& body = said.bodies[i];
    const double fast = body.v_WB.norm() + body.w_WB.norm() * size;
    comparison.HoldPosition(name, is.bodies[i].p_WB, body.p_WB,
                            std::max(size, body.p_WB.norm()));
    comparison.HoldTurn(name, is.bodies[i].q_WB, body.q_WB);
    comparison.HoldRate(name, "velocity", is.bodies[i].v_WB, body.v_WB, fast);
    comparison.HoldRate(name, "spin", is.bodies[i].w_WB, body.w_WB, body.w_WB.norm());
  }
  for (std::size_t i = 0; i < said.particles.size(); ++i)
    comparison.HoldPoint(world.particles[i].name, is.particles[i], said.particles[i],
                         size);
  for (std::size_t i = 0; i < said.nodes.size(); ++i)
    comparison.HoldPoint(fmt::format("node {}", i), is.nodes[i], said.nodes[i], size);
  return comparison.proof();
}

}  // namespace touchstone
