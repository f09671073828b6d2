#include "tests/fuzz/protocol_property.h"

#include <algorithm>
#include <vector>

#include "oracles/protocol/answer_message.h"
#include "oracles/protocol/hello_message.h"
#include "oracles/protocol/message.h"
#include "oracles/protocol/query_message.h"
#include "oracles/protocol/trajectory_message.h"
#include "oracles/protocol/world_message.h"

namespace touchstone {
namespace {

// As much as a fuzzer gives.
constexpr std::size_t kMost = std::size_t{1} << 20;

Message MessageFrom(std::string_view bytes) {
  const std::size_t end = std::min(bytes.find('\n'), bytes.size());
  Message message{LineFrom(bytes.substr(0, end)), {}};
  const std::size_t size = FrameSizeOf(message.line, kMost);
  const std::string_view rest = bytes.substr(std::min(end + 1, bytes.size()));
  message.frame = FrameFrom(rest.substr(0, std::min(size, rest.size() / 8 * 8)));
  return message;
}

// Calls `read`, and returns whether it has refused the message.
template <typename Read>
bool Refuses(Read read) {
  try {
    read();
    return false;
  } catch (const ProtocolError&) {
    return true;
  }
}

std::string FaultOfQueries(const Message& message) {
  std::vector<ContactQuery> queries;
  if (Refuses([&] { queries = QueriesFrom(message); })) return "";
  for (const bool in_frame : {false, true}) {
    Message again;
    PutQueries(queries, in_frame, again);
    if (queries.empty() && in_frame) continue;  // There is no empty frame.
    if (QueriesFrom(MessageFrom(BytesOf(again))).size() != queries.size())
      return "other queries when they are read again";
  }
  return "";
}

std::string FaultOfAnswers(const Message& message) {
  for (std::size_t count = 0; count < 3; ++count) {
    std::vector<ContactAnswer> answers;
    if (Refuses([&] { answers = AnswersFrom(message, count); })) continue;
    if (answers.size() != count) return "another number of answers";
    for (const bool in_frame : {false, true}) {
      if (count == 0 && in_frame) continue;
      Message again;
      PutAnswers(answers, in_frame, again);
      const std::vector<ContactAnswer> read =
          AnswersFrom(MessageFrom(BytesOf(again)), count);
      for (std::size_t i = 0; i < count; ++i) {
        // A reason that is not UTF-8 is changed once, and NaNs have many forms.
        if (read[i].status != answers[i].status) return "another status";
        if (read[i].points.size() != answers[i].points.size()) return "other points";
      }
    }
  }
  return "";
}

std::string FaultOfWorld(const Message& message) {
  const Received line(message.line, "message");
  World world;
  if (Refuses([&] { world = WorldFrom(line["world"]); })) return "";
  const std::string text = OneLine(ToJson(world));
  const Json json = Json::parse(text);
  if (OneLine(ToJson(WorldFrom(Received(json, "world")))) != text)
    return "another world when it is read again";
  return "";
}

World BallWorld() {
  World world;
  world.bodies.resize(1);
  world.steps = 2;
  return world;
}

std::string FaultOfMotion(const Message& message) {
  static const World kWorld = BallWorld();
  Trajectory motion;
  if (Refuses([&] { motion = TrajectoryFrom(message, kWorld); })) return "";
  if (motion.samples.empty() || motion.times.size() != motion.samples.size())
    return "a motion without its start";
  for (const bool in_frame : {false, true}) {
    Message again;
    PutTrajectory(motion, in_frame, again);
    const Trajectory read = TrajectoryFrom(MessageFrom(BytesOf(again)), kWorld);
    if (read.samples.size() != motion.samples.size()) return "other samples";
    if (read.diverged_at_step != motion.diverged_at_step) return "another divergence";
  }
  return "";
}

std::string FaultOfHello(const Message& message) {
  Hello hello;
  if (Refuses([&] { hello = HelloFrom(message); })) return "";
  Message again;
  PutHello(hello.info, hello.frames, again);
  std::string fault;
  if (Refuses([&] { HelloFrom(MessageFrom(BytesOf(again))); }))
    fault = "refuses the description that it has read";
  return fault;
}

}  // namespace

std::string FaultOfReadingProtocol(std::string_view bytes) {
  Message message;
  if (Refuses([&] { message = MessageFrom(bytes); })) return "";
  for (const auto& fault_of :
       {FaultOfHello, FaultOfQueries, FaultOfAnswers, FaultOfWorld, FaultOfMotion}) {
    std::string fault = fault_of(message);
    if (!fault.empty()) return fault;
  }
  return "";
}

}  // namespace touchstone
