#include "oracles/isolation/answer_wire.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "oracles/isolation/wire.h"

namespace touchstone {
namespace {

using Eigen::Vector3d;

constexpr std::uint8_t kVersion = 1;

// The one flag of a trajectory.
constexpr std::uint8_t kImpulsesFlag = 1;

enum Flags : std::uint8_t {
  kTouchingFlag = 1,
  kNormalFlag = 2,
  kSeparationFlag = 4,
  kWitnessesFlag = 8,
  kAllFlags = 15,
};

// The smallest encoding of a point: four doubles and a flag. [bytes]
constexpr std::size_t kSmallestPoint = 4 * sizeof(double) + 1;

// Sizes of the encoded states and impulses. [bytes]
constexpr std::size_t kBodyState = 13 * sizeof(double);
constexpr std::size_t kPointState = 6 * sizeof(double);
constexpr std::size_t kImpulse = 3 * sizeof(std::int32_t) + 13 * sizeof(double);

void Put(WireWriter& writer, const BodyState& body) {
  writer.Put(body.p_WB);
  for (const double x : body.q_WB.coeffs()) writer.Put(x);
  writer.Put(body.v_WB);
  writer.Put(body.w_WB);
}

void Put(WireWriter& writer, const PointState& point) {
  writer.Put(point.p_W);
  writer.Put(point.v_W);
}

void Put(WireWriter& writer, const ContactImpulse& impulse) {
  for (const int number : {impulse.step, impulse.A, impulse.B})
    writer.Put(static_cast<std::int32_t>(number));
  for (const Vector3d* v : {&impulse.p_WC, &impulse.n_AB_W, &impulse.J_B_W})
    writer.Put(*v);
  writer.Put(impulse.separation);
  writer.Put(impulse.t_W);
}

void Get(WireReader& reader, BodyState& body) {
  body.p_WB = reader.GetVector();
  for (double& x : body.q_WB.coeffs()) x = reader.Get<double>();
  body.v_WB = reader.GetVector();
  body.w_WB = reader.GetVector();
}

void Get(WireReader& reader, PointState& point) {
  point.p_W = reader.GetVector();
  point.v_W = reader.GetVector();
}

void Get(WireReader& reader, ContactImpulse& impulse) {
  for (int* number : {&impulse.step, &impulse.A, &impulse.B})
    *number = reader.Get<std::int32_t>();
  for (Vector3d* v : {&impulse.p_WC, &impulse.n_AB_W, &impulse.J_B_W})
    *v = reader.GetVector();
  impulse.separation = reader.Get<double>();
  impulse.t_W = reader.GetVector();
}

}  // namespace

std::string ToWire(const ContactAnswer& answer) {
  WireWriter writer;
  writer.Put(kVersion);
  writer.Put(static_cast<std::uint8_t>(answer.status));
  writer.Put(static_cast<std::uint8_t>((answer.touching ? kTouchingFlag : 0) |
                                       (answer.n_AB_W ? kNormalFlag : 0) |
                                       (answer.separation ? kSeparationFlag : 0) |
                                       (answer.witnesses ? kWitnessesFlag : 0)));
  writer.Put(std::string_view(answer.reason));
  if (answer.n_AB_W) writer.Put(*answer.n_AB_W);
  if (answer.separation) writer.Put(*answer.separation);
  if (answer.witnesses) {
    writer.Put(answer.witnesses->p_WCa);
    writer.Put(answer.witnesses->p_WCb);
  }
  writer.Put(static_cast<std::uint32_t>(answer.points.size()));
  for (const ContactPoint& point : answer.points) {
    writer.Put(point.p_WC);
    writer.Put(point.separation);
    writer.Put(static_cast<std::uint8_t>(point.n_AB_W ? 1 : 0));
    if (point.n_AB_W) writer.Put(*point.n_AB_W);
  }
  writer.Put(answer.seconds);
  return writer.Take();
}

std::optional<ContactAnswer> FromWire(std::string_view bytes) {
  WireReader reader(bytes);
  ContactAnswer answer;
  if (reader.Get<std::uint8_t>() != kVersion) return std::nullopt;
  const auto status = reader.Get<std::uint8_t>();
  if (status > static_cast<std::uint8_t>(AnswerStatus::kTimedOut)) return std::nullopt;
  answer.status = static_cast<AnswerStatus>(status);
  const auto flags = reader.Get<std::uint8_t>();
  if (flags > kAllFlags) return std::nullopt;
  answer.touching = (flags & kTouchingFlag) != 0;
  answer.reason = reader.GetText();
  if ((flags & kNormalFlag) != 0) answer.n_AB_W = reader.GetVector();
  if ((flags & kSeparationFlag) != 0) answer.separation = reader.Get<double>();
  if ((flags & kWitnessesFlag) != 0) {
    const Vector3d p_WCa = reader.GetVector();
    const Vector3d p_WCb = reader.GetVector();
    answer.witnesses = WitnessPoints{p_WCa, p_WCb};
  }
  const std::uint32_t count = reader.GetCount(kSmallestPoint);
  answer.points.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    ContactPoint point;
    point.p_WC = reader.GetVector();
    point.separation = reader.Get<double>();
    const auto has_normal = reader.Get<std::uint8_t>();
    if (has_normal > 1) return std::nullopt;
    if (has_normal == 1) point.n_AB_W = reader.GetVector();
    answer.points.push_back(point);
  }
  answer.seconds = reader.Get<double>();
  if (!reader.AtEndWithoutFailure()) return std::nullopt;
  return answer;
}

std::string ToWire(const Trajectory& trajectory) {
  WireWriter writer;
  writer.Put(kVersion);
  writer.Put(static_cast<std::uint8_t>(trajectory.status));
  writer.Put(trajectory.gives_impulses ? kImpulsesFlag : std::uint8_t{0});
  writer.Put(std::string_view(trajectory.reason));
  writer.Put(std::string_view(trajectory.complaint));
  writer.Put(static_cast<std::int32_t>(trajectory.diverged_at_step));
  const WorldState shape =
      trajectory.samples.empty() ? WorldState{} : trajectory.samples.front();
  writer.Put(static_cast<std::uint64_t>(shape.bodies.size()));
  writer.Put(static_cast<std::uint64_t>(shape.particles.size()));
  writer.Put(static_cast<std::uint64_t>(shape.nodes.size()));
  writer.Put(static_cast<std::uint64_t>(trajectory.samples.size()));
  for (std::size_t i = 0; i < trajectory.samples.size(); ++i) {
    const WorldState& sample = trajectory.samples[i];
    writer.Put(trajectory.times[i]);
    for (const BodyState& body : sample.bodies) Put(writer, body);
    for (const PointState& particle : sample.particles) Put(writer, particle);
    for (const PointState& node : sample.nodes) Put(writer, node);
  }
  writer.Put(static_cast<std::uint64_t>(trajectory.impulses.size()));
  for (const ContactImpulse& impulse : trajectory.impulses) Put(writer, impulse);
  writer.Put(trajectory.seconds);
  return writer.Take();
}

std::optional<Trajectory> TrajectoryFromWire(std::string_view bytes) {
  WireReader reader(bytes);
  Trajectory trajectory;
  if (reader.Get<std::uint8_t>() != kVersion) return std::nullopt;
  const auto status = reader.Get<std::uint8_t>();
  if (status > static_cast<std::uint8_t>(AnswerStatus::kTimedOut)) return std::nullopt;
  trajectory.status = static_cast<AnswerStatus>(status);
  const auto flags = reader.Get<std::uint8_t>();
  if (flags > kImpulsesFlag) return std::nullopt;
  trajectory.gives_impulses = flags == kImpulsesFlag;
  trajectory.reason = reader.GetText();
  trajectory.complaint = reader.GetText();
  trajectory.diverged_at_step = reader.Get<std::int32_t>();
  WorldState shape;
  const auto bodies = reader.GetCount<std::uint64_t>(kBodyState);
  const auto particles = reader.GetCount<std::uint64_t>(kPointState);
  const auto nodes = reader.GetCount<std::uint64_t>(kPointState);
  const std::uint64_t sample =
      sizeof(double) + bodies * kBodyState + (particles + nodes) * kPointState;
  shape.bodies.resize(bodies);
  shape.particles.resize(particles);
  shape.nodes.resize(nodes);
  const auto samples = reader.GetCount<std::uint64_t>(sample);
  if (samples == 0 && bodies + particles + nodes > 0) return std::nullopt;
  for (std::uint64_t i = 0; i < samples; ++i) {
    trajectory.times.push_back(reader.Get<double>());
    WorldState& state = trajectory.samples.emplace_back(shape);
    for (BodyState& body : state.bodies) Get(reader, body);
    for (PointState& particle : state.particles) Get(reader, particle);
    for (PointState& node : state.nodes) Get(reader, node);
  }
  const auto impulses = reader.GetCount<std::uint64_t>(kImpulse);
  trajectory.impulses.resize(impulses);
  for (ContactImpulse& impulse : trajectory.impulses) Get(reader, impulse);
  trajectory.seconds = reader.Get<double>();
  if (!reader.AtEndWithoutFailure()) return std::nullopt;
  return trajectory;
}

}  // namespace touchstone
