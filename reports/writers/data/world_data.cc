#include "reports/writers/data/world_data.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/worlds/study/curves.h"
#include "reports/worlds/study/universal_claims.h"
#include "reports/writers/data/contact_data.h"
#include "reports/writers/data/kept_samples.h"
#include "reports/writers/data/track.h"

namespace touchstone {
namespace {

constexpr int kDigits = 9;

/** Returns n such that every n-th sample of a motion is kept. */
std::size_t ThinningOf(const World& world, std::size_t samples) {
  constexpr std::size_t kMost = 240;
  constexpr std::size_t kLeast = 48;
  constexpr std::size_t kMostOfAll = 3000;
  const auto moving = static_cast<std::size_t>(std::ranges::count_if(
      world.bodies, [](const RigidBody& body) { return body.mass > 0; }));
  std::size_t points = world.particles.size();
  for (const Cloth& cloth : world.cloths)
    points += static_cast<std::size_t>(cloth.n * cloth.n);
  // A point has 3 channels where a body has 13.
  const std::size_t bodies = std::max<std::size_t>(1, moving + points / 4);
  const std::size_t kept = std::clamp(kMostOfAll / bodies, kLeast, kMost);
  return std::max<std::size_t>(1, (samples + kept - 1) / kept);
}

/** Returns the elements of `all` at the indices `kept`, as far as it has them. */
template <typename T>
std::vector<T> At(std::span<const std::size_t> kept, std::span<const T> all) {
  std::vector<T> values;
  for (const std::size_t i : kept) {
    if (i < all.size()) values.push_back(all[i]);
  }
  return values;
}

/** Returns the moments that the proofs of faults are about. [s] */
std::vector<double> MomentsOf(const WorldDataInput& world) {
  std::vector<double> moments;
  for (const std::span<const Finding> findings : world.findings) {
    for (const Finding& finding : findings) {
      if (finding.cited.time && finding.verdict != Verdict::kPass)
        moments.push_back(*finding.cited.time);
    }
  }
  return moments;
}

/** Returns the longest list of sample times of the world's motions. */
std::vector<double> TimesOf(const WorldResult& result) {
  const Trajectory* longest = nullptr;
  for (const Trajectory& trajectory : result.trajectories) {
    if (!longest || trajectory.samples.size() > longest->samples.size())
      longest = &trajectory;
  }
  if (!longest) return {};
  return {longest->times.begin(),
          longest->times.begin() + static_cast<std::ptrdiff_t>(longest->samples.size())};
}

/** Returns the finding of a measure that a law has judged; null if there is none. */
const Finding* FindingOf(std::span<const Finding> findings, MeasureKind measure) {
  const auto found = std::ranges::find_if(findings, [&](const Finding& finding) {
    return finding.measure == measure && finding.reference == "law" &&
           finding.verdict != Verdict::kUnsupported;
  });
  return found == findings.end() ? nullptr : &*found;
}

/** Returns the step to which positions of a motion are rounded. [m] */
double PositionStep(std::span<const Finding> findings, double size) {
  const Finding* judged = FindingOf(findings, MeasureKind::kPositionError);
  if (!judged) return 1e-5 * size;
  return std::clamp(judged->tolerance / 10, 1e-6 * size, 1e-4 * size);
}

DataJson MotionData(const World& world, const Trajectory& trajectory,
                    double position_step, std::span<const std::size_t> kept,
                    std::string& blob) {
  constexpr double kRotationStep = 1e-4;
  // A motion that diverges ends far faster than it began, and its start is shown, too.
  const double velocity_share = trajectory.diverged_at_step > 0 ? 1e-6 : 1e-3;
  DataJson data;
  data["status"] = NameOf(trajectory.status);
  data["reason"] = trajectory.reason;
  if (trajectory.diverged_at_step > 0)
    data["diverged_at_step"] = trajectory.diverged_at_step;
  data["bodies"] = DataJson::array();
  std::vector<const WorldState*> states;
  for (const std::size_t i : kept) {
    if (i < trajectory.samples.size()) states.push_back(&trajectory.samples[i]);
  }
  double speed = 0;
  double spin = 0;
  for (const WorldState* state : states) {
    for (const BodyState& body : state->bodies) {
      speed = std::max(speed, body.v_WB.norm());
      spin = std::max(spin, body.w_WB.norm());
    }
  }
  const auto sampled = [&](double step, auto value) {
    Channel channel{.values = {}, .step = step};
    for (const WorldState* state : states) channel.values.push_back(value(*state));
    return channel;
  };
  // A body that moves little beside others is drawn as smoothly as they are.
  const auto smooth = [&](double step, auto value) {
    constexpr double kLeast = 1e-2;
    Channel channel = sampled(step, value);
    channel.step = SmoothStep(channel.values, step, kLeast * step);
    return channel;
  };
  for (std::size_t b = 0; b < world.bodies.size(); ++b) {
    if (world.bodies[b].mass == 0 || states.empty()) {
      data["bodies"].push_back(nullptr);
      continue;
    }
    std::vector<Channel> channels;
    channels.reserve(13);  // position, rotation, velocity and spin
    for (int axis = 0; axis < 3; ++axis)
      channels.push_back(smooth(position_step, [=](const WorldState& state) {
        return state.bodies[b].p_WB[axis];
      }));
    // Eigen stores x, y, z, w.
    for (const int part : {3, 0, 1, 2})
      channels.push_back(sampled(kRotationStep, [=](const WorldState& state) {
        return state.bodies[b].q_WB.coeffs()[part];
      }));
    for (int axis = 0; axis < 3; ++axis)
      channels.push_back(smooth(velocity_share * speed, [=](const WorldState& state) {
        return state.bodies[b].v_WB[axis];
      }));
    for (int axis = 0; axis < 3; ++axis)
      channels.push_back(smooth(velocity_share * spin, [=](const WorldState& state) {
        return state.bodies[b].w_WB[axis];
      }));
    data["bodies"].push_back(AddTrack(channels, blob));
  }
  if (states.empty()) return data;
  std::vector<Channel> points;
  points.reserve(3 * (states.front()->particles.size() + states.front()->nodes.size()));
  for (std::size_t i = 0; i < states.front()->particles.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      points.push_back(sampled(position_step, [=](const WorldState& state) {
        return state.particles[i].p_W[axis];
      }));
  }
  for (std::size_t i = 0; i < states.front()->nodes.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      points.push_back(sampled(position_step, [=](const WorldState& state) {
        return state.nodes[i].p_W[axis];
      }));
  }
  if (!points.empty()) data["points"] = AddTrack(points, blob);
  return data;
}

/** The impulses of one pair of bodies in one kept interval. */
struct PairImpulse {
  Eigen::Vector3d J = Eigen::Vector3d::Zero();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();  ///< Sum of |J| p.
  Eigen::Vector3d n = Eigen::Vector3d::Zero();  ///< Sum of |J| n.
  double weight = 0;                            ///< Sum of |J|.
  double separation = 0;                        ///< The deepest.
};

/** Returns the impulses of a motion, one for each pair of bodies and kept interval, as a
 track of the channels that docs/report_data.md lists; null if there are none. */
DataJson ImpulseData(const World& world, const Trajectory& trajectory, double size,
                     std::span<const std::size_t> kept, std::string& blob) {
  using Key = std::tuple<std::size_t, int, int>;
  std::map<Key, PairImpulse> pairs;
  const auto every = static_cast<std::size_t>(world.sample_every);
  for (const ContactImpulse& impulse : trajectory.impulses) {
    // Steps 1 to `every` end in the interval before sample 1.
    const std::size_t end = (static_cast<std::size_t>(impulse.step) + every - 1) / every;
    const auto sample =
        static_cast<std::size_t>(std::ranges::lower_bound(kept, end) - kept.begin());
    const double weight = impulse.J_B_W.norm();
    if (!std::isfinite(weight) || weight == 0) continue;
    PairImpulse& pair = pairs[{sample, impulse.A, impulse.B}];
    pair.separation = pair.weight == 0 ? impulse.separation
                                       : std::min(pair.separation, impulse.separation);
    pair.J += impulse.J_B_W;
    pair.p += weight * impulse.p_WC;
    pair.n += weight * impulse.n_AB_W;
    pair.weight += weight;
  }
  if (pairs.empty()) return nullptr;
  double largest = 0;
  for (const auto& [key, pair] : pairs) largest = std::max(largest, pair.J.norm());
  constexpr double kShare = 1e-3;
  std::vector<Channel> channels(13);
  for (Channel& channel : channels) channel.step = 1;
  for (std::size_t i = 3; i < 6; ++i) channels[i].step = kShare * size;
  for (std::size_t i = 6; i < 9; ++i) channels[i].step = kShare;
  for (std::size_t i = 9; i < 12; ++i) channels[i].step = kShare * largest;
  channels[12].step = kShare * kShare * size;
  for (const auto& [key, pair] : pairs) {
    const auto [sample, A, B] = key;
    channels[0].values.push_back(static_cast<double>(sample));
    channels[1].values.push_back(A);
    channels[2].values.push_back(B);
    const Eigen::Vector3d p = pair.p / pair.weight;
    const Eigen::Vector3d n = pair.n.stableNormalized();
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      channels[3 + i].values.push_back(p[axis]);
      channels[6 + i].values.push_back(n[axis]);
      channels[9 + i].values.push_back(pair.J[axis]);
    }
    channels[12].values.push_back(pair.separation);
  }
  return AddTrack(channels, blob);
}

/** Returns the first time at which `curve` is beyond `tolerance` of the truth. */
std::optional<double> FirstBeyond(const Curve& curve, const Curve& truth,
                                  double tolerance) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < curve.values.size(); ++i) {
    const double t = curve.times[i];
    while (at + 2 < truth.times.size() && truth.times[at + 1] < t) ++at;
    double expected = truth.values[at];
    if (at + 1 < truth.times.size()) {
      const double span = truth.times[at + 1] - truth.times[at];
      const double share =
          span > 0 ? std::clamp((t - truth.times[at]) / span, 0.0, 1.0) : 0;
      expected += share * (truth.values[at + 1] - expected);
    }
    // Written so that a NaN is beyond.
    if (!(std::abs(curve.values[i] - expected) <= tolerance)) return t;
  }
  return std::nullopt;
}

/** Returns the truth at `times`. It is given at every sample, or constant. */
std::vector<double> TruthAt(const Curve& truth, std::span<const double> times) {
  std::vector<double> values;
  for (const double t : times) {
    const auto next = std::ranges::lower_bound(truth.times, t);
    values.push_back(
        next == truth.times.end()
            ? truth.values.back()
            : truth.values[static_cast<std::size_t>(next - truth.times.begin())]);
  }
  return values;
}

double RangeOf(const CurveSet& set) {
  double lo = HUGE_VAL;
  double hi = -HUGE_VAL;
  for (const Curve& curve : set.of_oracle) {
    for (const double value : curve.values) {
      if (!std::isfinite(value)) continue;
      lo = std::min(lo, value);
      hi = std::max(hi, value);
    }
  }
  return hi > lo ? hi - lo : 1;
}

/** Returns one curve, and adds the moments at which motions leave its band. */
DataJson CurveData(const WorldDataInput& world, const CurveSet& set,
                   std::span<const double> times, std::span<const std::size_t> kept,
                   std::vector<Moment>& moments, std::string& blob) {
  DataJson json;
  json["quantity"] = set.title;
  json["unit"] = set.unit;
  double step = 1e-4 * RangeOf(set);
  std::optional<double> band;
  std::optional<std::size_t> shown;
  DataJson breaks = DataJson::array();
  DataJson shows = DataJson::array();
  for (std::size_t o = 0; set.truth && o < world.findings.size(); ++o) {
    const Finding* finding = FindingOf(world.findings[o], set.measure);
    std::optional<double> time;
    if (finding && std::isfinite(finding->tolerance)) {
      if (!band) band = finding->tolerance;
      if (finding->tolerance > 0) step = std::min(step, finding->tolerance / 10);
      if (!(finding->value <= finding->tolerance)) {
        time = FirstBeyond(set.of_oracle[o], *set.truth, finding->tolerance);
        const std::size_t index =
            world.first_finding[o] +
            static_cast<std::size_t>(finding - world.findings[o].data());
        if (time) moments.push_back({index, *time});
        if (time && !shown) shown = index;
      }
    }
    breaks.push_back(time ? ToData(*time, 6) : DataJson(nullptr));
    shows.push_back(
        finding ? DataJson(world.first_finding[o] +
                           static_cast<std::size_t>(finding - world.findings[o].data()))
                : DataJson(nullptr));
  }
  if (set.truth)
    json["truth"] =
        AddTrack({{.values = TruthAt(*set.truth, times), .step = step}}, blob);
  if (band) json["tolerance"] = ToData(*band, 4);
  if (shown) json["finding"] = *shown;
  if (set.truth) {
    json["breaks"] = std::move(breaks);
    json["shows"] = std::move(shows);
  }
  json["motions"] = DataJson::array();
  for (const Curve& curve : set.of_oracle) {
    if (curve.values.empty()) {
      json["motions"].push_back(nullptr);
      continue;
    }
    // One motion that diverges leaves the others no steps of the common range.
    std::vector<double> values = At(kept, std::span(curve.values));
    const double own = SmoothStep(values, step, 1e-9 * step);
    json["motions"].push_back(
        AddTrack({{.values = std::move(values), .step = own}}, blob));
  }
  return json;
}

DataJson ClaimsData(const WorldScenario& scenario) {
  DataJson claims = DataJson::array();
  for (const Claim& claim : scenario.claims) {
    claims.push_back(claim.about.empty() ? claim.law
                                         : fmt::format("{} of {}", claim.law,
                                                       fmt::join(claim.about, ", ")));
  }
  for (const Claim& claim : UniversalClaims(scenario))
    claims.push_back(claim.law + " (of every motion)");
  return claims;
}

/** Returns the index of an anchor's body; particles follow the bodies; −1: the world. */
int IndexOf(const World& world, const Anchor& anchor) {
  if (anchor.on == AnchorKind::kWorld) return -1;
  return anchor.index +
         (anchor.on == AnchorKind::kParticle ? static_cast<int>(world.bodies.size()) : 0);
}

/** Returns the ends of a spring or a joint. */
template <typename Link>
DataJson EndsOf(const World& world, const Link& link) {
  return {{"A", IndexOf(world, link.A)},
          {"B", IndexOf(world, link.B)},
          {"pA", ToData(link.A.point, kDigits)},
          {"pB", ToData(link.B.point, kDigits)}};
}

/** Returns what a world consists of. */
DataJson SceneData(const WorldScenario& scenario) {
  const World& world = scenario.world;
  DataJson data;
  data["dt"] = ToData(world.dt, kDigits);
  data["steps"] = world.steps;
  data["gravity"] = ToData(world.gravity_W, kDigits);
  for (const char* list : {"bodies", "particles", "springs", "joints", "cloths"})
    data[list] = DataJson::array();
  for (const RigidBody& body : world.bodies) {
    const Eigen::Quaterniond q(body.placed.X_WB.R_WB);
    data["bodies"].push_back(
        {{"name", body.name},
         {"shape", ShapeData(body.placed.shape)},
         {"fixed", body.mass == 0},
         {"start",
          {{"p", ToData(body.placed.X_WB.p_WB, kDigits)}, {"q", ToData(q, kDigits)}}}});
  }
  for (const Particle& particle : world.particles)
    data["particles"].push_back({{"name", particle.name}, {"radius", 0}});
  for (const Spring& spring : world.springs)
    data["springs"].push_back(EndsOf(world, spring));
  for (const DistanceJoint& joint : world.joints) {
    data["joints"].push_back(EndsOf(world, joint));
    data["joints"].back()["kind"] = "distance";
  }
  for (const Cloth& cloth : world.cloths)
    data["cloths"].push_back({{"rows", cloth.n}, {"columns", cloth.n}});
  data["claims"] = ClaimsData(scenario);
  return data;
}

}  // namespace

DataJson DataOf(const WorldDataInput& world, std::vector<Moment>& moments,
                std::string& blob) {
  const WorldScenario& scenario = world.result.scenario;
  const std::vector<double> all_times = TimesOf(world.result);
  const std::size_t thinned = ThinningOf(scenario.world, all_times.size());
  std::vector<std::size_t> lengths;
  lengths.reserve(world.result.trajectories.size());
  for (const Trajectory& trajectory : world.result.trajectories)
    lengths.push_back(trajectory.samples.size());
  const std::vector<std::size_t> kept =
      KeptSamples(all_times, thinned,
                  thinned > 1 ? MomentsOf(world) : std::vector<double>(), lengths);
  const std::vector<double> times = At(kept, std::span<const double>(all_times));
  DataJson data = SceneData(scenario);
  data["times"] = DataJson::array();
  for (const double t : times) data["times"].push_back(ToData(t, 7));
  data["thinned"] = thinned;
  data["motions"] = DataJson::array();
  for (std::size_t o = 0; o < world.result.trajectories.size(); ++o) {
    const Trajectory& trajectory = world.result.trajectories[o];
    if (!world.simulates[o]) {
      data["motions"].push_back(
          {{"status", "not asked"}, {"reason", ""}, {"bodies", DataJson::array()}});
      continue;
    }
    DataJson motion = MotionData(scenario.world, trajectory,
                                 PositionStep(world.findings[o], world.size), kept, blob);
    DataJson impulses = ImpulseData(scenario.world, trajectory, world.size, kept, blob);
    if (!impulses.is_null()) motion["impulses"] = std::move(impulses);
    data["motions"].push_back(std::move(motion));
  }
  data["curves"] = DataJson::array();
  for (const CurveSet& set : CurvesOf(world.result))
    data["curves"].push_back(CurveData(world, set, times, kept, moments, blob));
  return data;
}

}  // namespace touchstone
