#include "oracles/protocol/trajectory_message.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "oracles/simulation.h"

namespace touchstone {
namespace {

constexpr std::size_t kBodyNumbers = 13;
constexpr std::size_t kPointNumbers = 6;
constexpr std::size_t kImpulseNumbers = 16;

std::size_t NodesOf(const World& world) {
  std::size_t nodes = 0;
  for (const Cloth& cloth : world.cloths)
    nodes += static_cast<std::size_t>(cloth.n) * static_cast<std::size_t>(cloth.n);
  return nodes;
}

std::size_t SampleNumbers(const World& world) {
  return kBodyNumbers * world.bodies.size() +
         kPointNumbers * (world.particles.size() + NodesOf(world));
}

std::vector<double> NumbersOf(const WorldState& state) {
  std::vector<double> numbers;
  for (const BodyState& body : state.bodies) {
    Append(numbers, body.p_WB);
    numbers.insert(numbers.end(),
                   {body.q_WB.w(), body.q_WB.x(), body.q_WB.y(), body.q_WB.z()});
    Append(numbers, body.v_WB);
    Append(numbers, body.w_WB);
  }
  for (const std::vector<PointState>* points : {&state.particles, &state.nodes}) {
    for (const PointState& point : *points) {
      Append(numbers, point.p_W);
      Append(numbers, point.v_W);
    }
  }
  return numbers;
}

std::vector<double> NumbersOf(const ContactImpulse& impulse) {
  std::vector<double> numbers = {static_cast<double>(impulse.step),
                                 static_cast<double>(impulse.A),
                                 static_cast<double>(impulse.B)};
  Append(numbers, impulse.p_WC);
  Append(numbers, impulse.n_AB_W);
  Append(numbers, impulse.J_B_W);
  numbers.push_back(impulse.separation);
  Append(numbers, impulse.t_W);
  return numbers;
}

PointState PointFrom(FrameReader& numbers) {
  PointState point;
  point.p_W = numbers.Vector();
  point.v_W = numbers.Vector();
  return point;
}

// No engine's rounding changes the length of a quaternion by a thousandth. One that is
// not filled in, or is in degrees, must not pass for an orientation.
void ExpectUnit(const Eigen::Quaterniond& q_WB, std::size_t body) {
  constexpr double kSlack = 1e-3;
  const double length = q_WB.coeffs().stableNorm();
  if (!std::isfinite(length) || std::abs(length - 1) <= kSlack) return;
  throw ProtocolError(fmt::format(
      "an orientation of body {} has the length {}; expected a unit quaternion", body,
      length));
}

WorldState StateFrom(std::span<const double> all, const World& world) {
  FrameReader numbers(all);
  WorldState state;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    BodyState& body = state.bodies.emplace_back();
    body.p_WB = numbers.Vector();
    const std::span<const double> q = numbers.Numbers(4);
    body.q_WB = {q[0], q[1], q[2], q[3]};
    ExpectUnit(body.q_WB, i);
    body.v_WB = numbers.Vector();
    body.w_WB = numbers.Vector();
  }
  for (std::size_t i = 0; i < world.particles.size(); ++i)
    state.particles.push_back(PointFrom(numbers));
  for (std::size_t i = 0; i < NodesOf(world); ++i)
    state.nodes.push_back(PointFrom(numbers));
  return state;
}

// Returns the whole number from `least` to `most` that `number` is.
int WholeFrom(double number, int least, int most, const char* what) {
  if (number >= least && number <= most && number == std::floor(number))
    return static_cast<int>(number);
  throw ProtocolError(
      fmt::format("{} {} of an impulse; expected a whole number from {} "
                  "to {}",
                  what, number, least, most));
}

ContactImpulse ImpulseFrom(std::span<const double> all, const World& world) {
  FrameReader numbers(all);
  const int last = static_cast<int>(world.bodies.size()) - 1;
  ContactImpulse impulse;
  impulse.step = WholeFrom(numbers.Number(), 1, world.steps, "step");
  impulse.A = WholeFrom(numbers.Number(), 0, last, "A");
  impulse.B = WholeFrom(numbers.Number(), 0, last, "B");
  impulse.p_WC = numbers.Vector();
  impulse.n_AB_W = numbers.Vector();
  impulse.J_B_W = numbers.Vector();
  impulse.separation = numbers.Number();
  impulse.t_W = numbers.Vector();
  return impulse;
}

/** A motion as rows of numbers, the same for both forms of a message. */
struct Rows {
  std::vector<double> times;
  std::vector<std::vector<double>> samples;
  std::optional<std::vector<std::vector<double>>> impulses;
};

std::vector<double> RowFrom(const Received& json, std::size_t count) {
  std::vector<double> row;
  row.reserve(count);
  for (const Received& number : json.Items(count)) row.push_back(number.Number());
  return row;
}

Rows RowsFromLine(const Received& line, const World& world) {
  Rows rows;
  for (const Received& time : line["times"].Items()) rows.times.push_back(time.Number());
  for (const Received& sample : line["samples"].Items(rows.times.size()))
    rows.samples.push_back(RowFrom(sample, SampleNumbers(world)));
  if (const auto impulses = line.Find("impulses")) {
    rows.impulses.emplace();
    for (const Received& impulse : impulses->Items())
      rows.impulses->push_back(RowFrom(impulse, kImpulseNumbers));
  }
  return rows;
}

Rows RowsFromFrame(const Message& message, const World& world) {
  const Received line(message.line, "answer");
  const int most = static_cast<int>(message.frame.size());
  const int samples = line["sample_count"].Whole(0, most);
  FrameReader frame(message.frame);
  Rows rows;
  for (int i = 0; i < samples; ++i) {
    rows.times.push_back(frame.Number());
    const std::span<const double> numbers = frame.Numbers(SampleNumbers(world));
    rows.samples.emplace_back(numbers.begin(), numbers.end());
  }
  if (const auto impulses = line.Find("impulse_count")) {
    rows.impulses.emplace();
    const int count = impulses->Whole(0, most);
    for (int i = 0; i < count; ++i) {
      const std::span<const double> numbers = frame.Numbers(kImpulseNumbers);
      rows.impulses->emplace_back(numbers.begin(), numbers.end());
    }
  }
  frame.ExpectEnd();
  return rows;
}

// The step that ends with sample `index`.
int StepOf(std::size_t index, const World& world) {
  return static_cast<int>(index) * world.sample_every;
}

// The samples of a motion are those that the world asks for, and only a motion that has
// diverged has fewer.
void ExpectSamples(const Rows& rows, const World& world, int diverged_at_step) {
  const int last = diverged_at_step == 0 ? world.steps : diverged_at_step - 1;
  const auto expected = static_cast<std::size_t>(last / world.sample_every) + 1;
  if (rows.times.size() != expected) {
    throw ProtocolError(
        fmt::format("{} samples; expected {}: the start, and one every {} of {} steps{}",
                    rows.times.size(), expected, world.sample_every, last,
                    diverged_at_step == 0 ? "" : " before the divergence"));
  }
  for (std::size_t i = 0; i < rows.times.size(); ++i) {
    const double time = StepOf(i, world) * world.dt;
    // Half a step cannot be a rounding; a wrong unit or a missing sample is more.
    if (std::abs(rows.times[i] - time) <= world.dt / 2) continue;
    throw ProtocolError(
        fmt::format("times[{}]: {} s; expected {} s", i, rows.times[i], time));
  }
}

// Lowers `diverged_at_step` to the first step of which a number is not sane.
void FindDivergence(const std::vector<WorldState>& states,
                    const std::vector<ContactImpulse>& impulses, const World& world,
                    int& diverged_at_step) {
  const auto lower = [&](int step) {
    if (diverged_at_step == 0 || step < diverged_at_step) diverged_at_step = step;
  };
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!IsSane(states[i])) lower(StepOf(i, world));
  }
  for (const ContactImpulse& impulse : impulses) {
    if (!IsSane(impulse)) lower(impulse.step);
  }
}

}  // namespace

void PutTrajectory(const Trajectory& trajectory, bool in_frame, Message& message) {
  Json& line = message.line;
  if (trajectory.diverged_at_step != 0)
    line["diverged_at_step"] = trajectory.diverged_at_step;
  if (!trajectory.complaint.empty()) line["complaint"] = trajectory.complaint;
  if (in_frame) {
    line["sample_count"] = trajectory.samples.size();
    if (trajectory.gives_impulses) line["impulse_count"] = trajectory.impulses.size();
    const auto append = [&](const std::vector<double>& numbers) {
      message.frame.insert(message.frame.end(), numbers.begin(), numbers.end());
    };
    for (std::size_t i = 0; i < trajectory.samples.size(); ++i) {
      message.frame.push_back(trajectory.times[i]);
      append(NumbersOf(trajectory.samples[i]));
    }
    for (const ContactImpulse& impulse : trajectory.impulses) append(NumbersOf(impulse));
    return;
  }
  const auto row = [](const std::vector<double>& numbers) {
    Json json = Json::array();
    for (const double number : numbers) json.push_back(ToJson(number));
    return json;
  };
  line["times"] = row(trajectory.times);
  Json& samples = line["samples"] = Json::array();
  for (const WorldState& sample : trajectory.samples)
    samples.push_back(row(NumbersOf(sample)));
  if (!trajectory.gives_impulses) return;
  Json& impulses = line["impulses"] = Json::array();
  for (const ContactImpulse& impulse : trajectory.impulses)
    impulses.push_back(row(NumbersOf(impulse)));
}

Trajectory TrajectoryFrom(const Message& message, const World& world) {
  const Received line(message.line, "answer");
  const bool in_frame = line.Find("sample_count").has_value();
  const Rows rows = in_frame ? RowsFromFrame(message, world) : RowsFromLine(line, world);
  Trajectory trajectory;
  trajectory.status = AnswerStatus::kAnswered;
  if (const auto step = line.Find("diverged_at_step"))
    trajectory.diverged_at_step = step->Whole(0, world.steps);
  if (const auto complaint = line.Find("complaint"))
    trajectory.complaint = complaint->Text();
  ExpectSamples(rows, world, trajectory.diverged_at_step);
  std::vector<ContactImpulse> impulses;
  if (rows.impulses) {
    trajectory.gives_impulses = true;
    for (const std::vector<double>& numbers : *rows.impulses)
      impulses.push_back(ImpulseFrom(numbers, world));
  }
  // The order of contacts in a step is the program's own, that of steps is not.
  std::ranges::stable_sort(impulses, {}, &ContactImpulse::step);
  std::vector<WorldState> states;
  for (const std::vector<double>& numbers : rows.samples)
    states.push_back(StateFrom(numbers, world));
  if (!IsSane(states.front()))
    throw ProtocolError("samples[0]: not finite; expected the start of the world");
  FindDivergence(states, impulses, world, trajectory.diverged_at_step);
  const int end = trajectory.diverged_at_step;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (end != 0 && StepOf(i, world) >= end) break;
    trajectory.times.push_back(StepOf(i, world) * world.dt);
    trajectory.samples.push_back(std::move(states[i]));
  }
  for (const ContactImpulse& impulse : impulses) {
    if (end == 0 || impulse.step <= end) trajectory.impulses.push_back(impulse);
  }
  return trajectory;
}

std::size_t MostBytesOf(const World& world) {
  constexpr std::size_t kNumber = 32;  // More than any double in JSON. [bytes]
  const auto steps = static_cast<std::size_t>(world.steps);
  const std::size_t samples = steps / static_cast<std::size_t>(world.sample_every) + 1;
  const std::size_t impulses = 16 * (world.bodies.size() + 1) * kImpulseNumbers;
  // As much memory as an isolated oracle may use (IsolationLimits).
  constexpr std::size_t kMost = std::size_t{4} << 30;
  return std::min(kMost,
                  kNumber * (samples * (SampleNumbers(world) + 1) + steps * impulses));
}

}  // namespace touchstone
