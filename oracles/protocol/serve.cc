#include "oracles/protocol/serve.h"

#include <array>
#include <cerrno>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "oracles/protocol/answer_message.h"
#include "oracles/protocol/hello_message.h"
#include "oracles/protocol/message.h"
#include "oracles/protocol/query_message.h"
#include "oracles/protocol/trajectory_message.h"
#include "oracles/protocol/world_message.h"

namespace touchstone {
namespace {

// The longest line or frame that is taken. [bytes]
constexpr std::size_t kLongest = std::size_t{1} << 30;

/** Messages from a descriptor. */
class Reader {
 public:
  explicit Reader(int input) : input_(input) {}

  /** Returns the next line, without its end; nothing at the end of the input. */
  std::optional<std::string> Line() {
    while (true) {
      const std::size_t end = bytes_.find('\n');
      if (end != std::string::npos) {
        std::string line = bytes_.substr(0, end);
        bytes_.erase(0, end + 1);
        return line;
      }
      if (bytes_.size() > kLongest || !More()) return std::nullopt;
    }
  }

  /** Returns the next `size` bytes; nothing if the input ends before. */
  std::optional<std::string> Bytes(std::size_t size) {
    while (bytes_.size() < size) {
      if (!More()) return std::nullopt;
    }
    std::string bytes = bytes_.substr(0, size);
    bytes_.erase(0, size);
    return bytes;
  }

 private:
  bool More() {
    std::array<char, 1 << 16> part;
    ssize_t count = 0;
    do {
      count = read(input_, part.data(), part.size());
    } while (count < 0 && errno == EINTR);
    if (count <= 0) return false;
    bytes_.append(part.data(), static_cast<std::size_t>(count));
    return true;
  }

  int input_;
  std::string bytes_;
};

bool Write(int output, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(output, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void AnswerContacts(const Oracle& oracle, const Message& asked, Message& answer) {
  const std::vector<ContactQuery> queries = QueriesFrom(asked);
  std::vector<ContactAnswer> answers(queries.size());
  oracle.Answer(queries, answers);
  PutAnswers(answers, asked.line.contains("count"), answer);
}

void AnswerWorld(const Oracle& oracle, const Message& asked, Message& answer) {
  const Received line(asked.line, "message");
  const World world = WorldFrom(line["world"]);
  std::unique_ptr<Oracle> set_up;
  const Oracle* asked_oracle = &oracle;
  if (const auto parameters = line.Find("parameters")) {
    set_up = oracle.SetUp(SetupFrom(*parameters, oracle.info().parameters));
    asked_oracle = set_up.get();
  }
  const Trajectory trajectory = asked_oracle->Simulate(world);
  if (trajectory.status == AnswerStatus::kUnsupported)
    answer.line["unsupported"] = trajectory.reason;
  else if (trajectory.status != AnswerStatus::kAnswered)
    answer.line["error"] = trajectory.reason;
  else
    PutTrajectory(trajectory, asked.line.value("in_frame", Json()) == true, answer);
}

// Adds the answer to `asked` to `answer`.
void AnswerMessage(const Oracle& oracle, const Message& asked, Message& answer) {
  const Received method = Received(asked.line, "message")["method"];
  const std::string name = method.Text();
  if (name == "hello")
    PutHello(oracle.info(), true, answer);
  else if (name == "contact")
    AnswerContacts(oracle, asked, answer);
  else if (name == "world")
    AnswerWorld(oracle, asked, answer);
  else
    method.Fail("\"hello\", \"contact\", \"world\" or \"bye\"");
}

Json IdOf(const Json& line) {
  const auto found = line.find("id");
  return found == line.end() ? Json() : *found;
}

}  // namespace

bool Serve(const Oracle& oracle, int input, int output) {
  Reader reader(input);
  while (const std::optional<std::string> text = reader.Line()) {
    Message answer;
    answer.line = {{"id", nullptr}};
    try {
      Message asked{LineFrom(*text), {}};
      answer.line["id"] = IdOf(asked.line);
      if (const std::size_t size = FrameSizeOf(asked.line, kLongest)) {
        const std::optional<std::string> bytes = reader.Bytes(size);
        if (!bytes) return true;
        asked.frame = FrameFrom(*bytes);
      }
      if (asked.line.value("method", Json()) == "bye") return true;
      AnswerMessage(oracle, asked, answer);
    } catch (const std::exception& error) {
      answer = {{{"id", answer.line["id"]}, {"error", error.what()}}, {}};
    }
    if (!Write(output, BytesOf(std::move(answer)))) return false;
  }
  return true;
}

}  // namespace touchstone
