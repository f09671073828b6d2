#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "reports/worlds/law_support/error_laws.h"
#include "reports/worlds/law_support/numbers.h"
#include "reports/worlds/law_support/prediction.h"
#include "reports/worlds/law_support/round_body.h"
#include "reports/worlds/law_support/subjects.h"
#include "reports/worlds/laws/every_law.h"
#include "reports/worlds/truth/row_of_balls.h"

namespace touchstone {
namespace {

/** Largest gap of balls that an author means to touch, and largest distance from the line
 of balls that are meant to be on it, over a radius; coordinates have nine digits. [-] */
constexpr double kOnLine = 1e-9;

/** Balls on the line x = p + s d. */
struct Row {
  std::vector<int> bodies;
  Eigen::Vector3d p_W;
  Eigen::Vector3d d_W;
  std::vector<RowBall> balls;
  std::vector<double> restitution;
  double radius = 0;  ///< Largest radius. [m]
  double speed = 0;   ///< Largest speed at the start. [m/s]

  RowOfBalls By(RowRule rule, double touching) const {
    return {balls, restitution, touching, rule};
  }
};

Row RowOf(const World& world, const std::vector<int>& bodies) {
  Row row;
  row.bodies = bodies;
  const auto body = [&](int index) -> const RigidBody& {
    return world.bodies[static_cast<std::size_t>(index)];
  };
  row.p_W = body(bodies.front()).placed.X_WB.p_WB;
  row.d_W = (body(bodies.back()).placed.X_WB.p_WB - row.p_W).normalized();
  for (const int i : bodies) {
    const double r = RadiusOf(body(i));
    row.balls.push_back({body(i).mass, r, row.d_W.dot(body(i).placed.X_WB.p_WB - row.p_W),
                         row.d_W.dot(body(i).v_WB)});
    row.radius = std::max(row.radius, r);
    row.speed = std::max(row.speed, body(i).v_WB.norm());
  }
  for (std::size_t i = 0; i + 1 < bodies.size(); ++i) {
    row.restitution.push_back(
        std::min(body(bodies[i]).restitution, body(bodies[i + 1]).restitution));
  }
  return row;
}

std::string WhyNoBall(const World& world, int index) {
  const RigidBody& body = world.bodies[static_cast<std::size_t>(index)];
  if (!std::holds_alternative<Sphere>(body.placed.shape) || !body.collides)
    return "is no sphere that collides";
  if (!body.w_WB.isZero(0) || !body.force_W.isZero(0)) return "spins or has a force";
  if (IsHeld(world, AnchorKind::kBody, index) || IsPushed(world, index))
    return "is held or pushed";
  return "";
}

std::vector<Fault> FaultsOfLine(const World& world, const Claim& claim, const Row& row) {
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < row.bodies.size(); ++i) {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(row.bodies[i])];
    const Eigen::Vector3d p_W = body.placed.X_WB.p_WB - row.p_W;
    std::string why;
    if (p_W.cross(row.d_W).norm() > kOnLine * row.radius)
      why = "is not on the line from the first to the last";
    else if (body.v_WB.cross(row.d_W).norm() > kOnLine * row.speed)
      why = "does not move along the row";
    else if (i > 0 && row.balls[i].x - row.balls[i - 1].x - row.balls[i].radius -
                              row.balls[i - 1].radius <
                          -kOnLine * row.radius)
      why = "is out of order, or inside its predecessor";
    if (why.empty()) continue;
    faults.push_back(FaultAbout(claim, body.name, why,
                                "spheres in the order of a line, moving along it"));
  }
  return faults;
}

/** The time intervals in which an engine that detects contacts once per step may apply an
 impact to a ball, so that the ball's velocity is uncertain.

 An impact is up to a step h late or early, and later still if the balls are behind. A
 ball is δ |Δv| behind after an impact that was δ late. A pair that closes at u is later
 by the sum of their lags over u. For equal elastic balls, which pass u on, the n-th
 impact is up to n h late. */
class Strikes {
 public:
  Strikes(const RowOfBalls& truth, double h) {
    const std::vector<RowOfBalls::Moment>& moments = truth.moments();
    std::vector<double> behind(moments.front().balls.size(), 0);
    of_ball_.resize(behind.size());
    for (std::size_t m = 1; m < moments.size(); ++m) {
      const std::vector<RowBall>& before = moments[m - 1].balls;
      const std::vector<RowBall>& after = moments[m].balls;
      const auto change = [&](std::size_t i) {
        return std::abs(after[i].v - before[i].v);
      };
      double late = h;
      for (std::size_t i = 0; i + 1 < before.size(); ++i) {
        const double closing = before[i].v - before[i + 1].v;
        if (change(i) > 0 && change(i + 1) > 0 && closing > 0)
          late = std::max(late, h + (behind[i] + behind[i + 1]) / closing);
      }
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (change(i) == 0) continue;
        behind[i] += late * change(i);
        // One step more: an engine applies an impact at the end of the step that contains
        // it.
        of_ball_[i].push_back({moments[m].time - late - h, moments[m].time + late + h});
      }
    }
  }

  /** Whether `ball` may have an impact at `t`. */
  bool May(std::size_t ball, double t) const {
    return std::any_of(of_ball_[ball].begin(), of_ball_[ball].end(),
                       [&](const Span& span) { return span.from < t && t < span.to; });
  }

  /** Whether `ball` has certainly had an impact before `t` and is in no other. */
  bool HasStruck(std::size_t ball, double t) const {
    return !of_ball_[ball].empty() && of_ball_[ball].front().to <= t && !May(ball, t);
  }

 private:
  struct Span {
    double from;
    double to;
  };
  std::vector<std::vector<Span>> of_ball_;
};

/** Whether any sample shows a ball after an impact. */
bool ShowsAnImpact(const World& world, const RowOfBalls& truth) {
  const Strikes strikes(truth, world.dt);
  for (int step = 0; step <= world.steps; step += world.sample_every) {
    for (std::size_t i = 0; i < truth.last().size(); ++i)
      if (strikes.HasStruck(i, step * world.dt)) return true;
  }
  return false;
}

std::vector<Fault> Faults(const World& world, const Claim& claim) {
  std::vector<Fault> faults = FaultsOfSubjects(world, claim, {.bodies = true});
  if (!faults.empty()) return faults;
  const std::vector<int> bodies = SubjectsOf(world, claim).bodies;
  if (bodies.size() < 2) return {{"about", "is one body", "two or more spheres"}};
  if (!world.gravity_W.isZero(0))
    return {{"about", "are in a world with gravity", "a world without gravity"}};
  for (const int i : bodies) {
    const std::string why = WhyNoBall(world, i);
    if (why.empty()) continue;
    faults.push_back(FaultAbout(claim, world.bodies[static_cast<std::size_t>(i)].name,
                                why, "a free sphere"));
  }
  if (!faults.empty()) return faults;
  const Row row = RowOf(world, bodies);
  faults = FaultsOfLine(world, claim, row);
  if (!faults.empty()) return faults;
  const double touching = kOnLine * row.radius;
  const RowOfBalls in_order = row.By(RowRule::kFromFirst, touching);
  if (in_order.PastAt(in_order.end()).moments == 0)
    return {{"about", "are spheres that never hit each other", "an impact"}};
  if (!ShowsAnImpact(world, in_order)) {
    return {{"about", "are spheres without a sample after an impact",
             "more steps, or more samples"}};
  }
  const RowOfBalls at_once = row.By(RowRule::kSimultaneous, touching);
  // The remaining velocity of a ball that stops is rounding; its author says 0.
  const auto velocity = [&](const RowBall& ball) {
    return std::abs(ball.v) <= kOnLine * row.speed ? 0 : ball.v;
  };
  return FaultsOfNumbers(
      claim, {{"expected_first_velocity", velocity(in_order.last().front())},
              {"expected_last_velocity", velocity(in_order.last().back())},
              {"expected_simultaneous_first_velocity", velocity(at_once.last().front())},
              {"expected_simultaneous_last_velocity", velocity(at_once.last().back())}});
}

/** Returns how a truth by that rule is stated: "… it moves at". */
std::string_view InWords(RowRule rule) {
  switch (rule) {
    case RowRule::kFromFirst:
      return "after its impacts";
    case RowRule::kFromLast:
      return "after its impacts, the last pair first,";
    case RowRule::kSimultaneous:
      return "after simultaneous impacts";
  }
  return "";
}

/** Returns how far a motion is from that of `row` if balls with at most that `gap` [m]
 touch. */
std::vector<Worst> JudgeBy(RowRule rule, double gap, const Motion& motion,
                           const Row& row) {
  const RowOfBalls truth = row.By(rule, gap);
  const double h = motion.world.dt;
  const Strikes strikes(truth, h);
  std::vector<std::vector<RowBall>> balls;
  std::vector<double> lag;  // By which the impacts so far may be late. [m]
  for (std::size_t s = 0; s < motion.trajectory.samples.size(); ++s) {
    const double t = motion.trajectory.times[s];
    balls.push_back(truth.At(t));
    const RowOfBalls::Past past = truth.PastAt(t + h);
    lag.push_back(past.moments * h * past.change);
  }
  std::vector<Prediction> predictions;
  for (std::size_t i = 0; i < row.bodies.size(); ++i) {
    const RigidBody& body = motion.world.bodies[static_cast<std::size_t>(row.bodies[i])];
    predictions.push_back(
        {body.name, StateOfBody(row.bodies[i]), [&, i](std::size_t s) {
           const double t = motion.trajectory.times[s];
           const RowBall& ball = balls[s][i];
           PredictedState predicted;
           predicted.position = {row.p_W + ball.x * row.d_W,
                                 {.scheme = lag[s],
                                  .solved = row.speed * t,
                                  .computed = row.p_W.norm() + std::abs(ball.x)}};
           if (!strikes.May(i, t))
             predicted.velocity = {ball.v * row.d_W, {.solved = row.speed}};
           return predicted;
         }});
  }
  return JudgePredictions(
      motion,
      {.position = {{.scheme = "n h Σ |Δv| for n impacts, each a step late",
                     .solved = "the distance"},
                    fmt::format("{} it is at", InWords(rule))},
       .velocity = {{.solved = "the fastest ball"},
                    fmt::format("{} it moves at", InWords(rule))}},
      predictions);
}

/** Returns the worst number over its tolerance, of all measures. [-] */
double ExcessOf(const std::vector<Worst>& judged) {
  double excess = 0;
  for (const Worst& worst : judged) excess = std::max(excess, worst.share());
  return excess;
}

std::vector<LawFinding> Judge(const Motion& motion, const Claim& claim) {
  const Row row = RowOf(motion.world, SubjectsOf(motion.world, claim).bodies);
  const double touching = kOnLine * row.radius;
  const std::vector<Worst> by_pairs = JudgeBy(RowRule::kFromFirst, touching, motion, row);
  if (!AnyBeyond(by_pairs)) return FindingsOf(by_pairs);
  // A motion that follows no rule is compared with the nearest.
  std::vector<Worst> nearest = by_pairs;
  // Balls that touch for an engine may still be apart by the distance covered in a step.
  for (const double gap : {touching, kSafety * row.speed * motion.world.dt}) {
    std::string_view recognised;
    for (const RowRule rule :
         {RowRule::kSimultaneous, RowRule::kFromLast, RowRule::kFromFirst}) {
      const std::vector<Worst> judged = JudgeBy(rule, gap, motion, row);
      if (!AnyBeyond(judged)) {
        recognised = rule == RowRule::kSimultaneous ? "simultaneous impacts"
                                                    : "sequential impacts";
      }
      if (ExcessOf(judged) < ExcessOf(nearest)) nearest = judged;
    }
    if (!recognised.empty()) return FindingsOf(by_pairs, recognised);
  }
  return FindingsOf(nearest);
}

constexpr std::array<std::string_view, 4> kNumbers = {
    "expected_first_velocity", "expected_last_velocity",
    "expected_simultaneous_first_velocity", "expected_simultaneous_last_velocity"};

}  // namespace

/** Spheres on a line hit each other along it; each pair leaves an impact with e times its
 closing speed (truth/row_of_balls.h). [m/s], [m]

 If several balls touch, sequential and simultaneous impacts are both legal. The first is
 the law's own truth; the other is recognised as "simultaneous impacts". Either is
 recognised too if gaps are shorter than the distance covered in a step, V h. Sequential
 impacts may have any order: they are tried from the first ball and from the last.

 Velocities are exact to the solver's residual, 1e-5 of the fastest, except around each
 ball's impacts: the n-th of a row is up to n h late, or more if slower balls have to make
 up for that. Positions are off by n h times the total velocity change by impacts, Σ |Δv|,
 × 1.5. 64 roundings per step are added.

 About: spheres in the order of the line, without gravity, force or spin. Numbers:
 expected_first_velocity and expected_last_velocity, along the line from the first to the
 last, after the last impact, for sequential impacts; expected_simultaneous_first_velocity
 and expected_simultaneous_last_velocity. */
constinit const Law kRowImpact = {
    .name = "row_impact",
    .documentation =
        "Spheres on a line hit each other, in sequential or "
        "simultaneous impacts; about names them in order.",
    .numbers = kNumbers,
    .faults = Faults,
    .judge = Judge,
};

}  // namespace touchstone
