#include "oracles/protocol/answer_message.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "oracles/no_answer.h"

namespace touchstone {
namespace {

// The functions of this name below hide those of the headers.
using touchstone::ToJson;

using Eigen::Vector3d;

// The status of an answer in a frame.
constexpr double kAnswered = 0;
constexpr double kUnsupported = 1;
constexpr double kError = 2;

// The fields that an answer in a frame provides.
constexpr int kNormal = 1;
constexpr int kSeparation = 2;
constexpr int kWitnesses = 4;
constexpr int kAll = 7;

constexpr std::size_t kPointNumbers = 8;  // Of one point in a frame.

// The most witnesses of a pair.
constexpr std::size_t kBodies = 2;

Json ToJson(const ContactPoint& point) {
  Json json;
  json["position"] = ToJson(point.p_WC);
  json["separation"] = ToJson(point.separation);
  if (point.n_AB_W) json["normal"] = ToJson(*point.n_AB_W);
  return json;
}

Json ToJson(const ContactAnswer& answer) {
  if (answer.status == AnswerStatus::kUnsupported)
    return {{"unsupported", answer.reason}};
  if (answer.status != AnswerStatus::kAnswered) return {{"error", answer.reason}};
  Json json;
  json["touching"] = answer.touching;
  if (answer.n_AB_W) json["normal"] = ToJson(*answer.n_AB_W);
  if (answer.separation) json["separation"] = ToJson(*answer.separation);
  if (!answer.points.empty()) {
    Json& points = json["points"] = Json::array();
    for (const ContactPoint& point : answer.points) points.push_back(ToJson(point));
  }
  if (answer.witnesses) {
    json["witnesses"] =
        Json::array({ToJson(answer.witnesses->p_WCa), ToJson(answer.witnesses->p_WCb)});
  }
  return json;
}

ContactPoint PointFrom(const Received& json) {
  ContactPoint point;
  point.p_WC = json["position"].Vector();
  point.separation = json["separation"].Number();
  if (const auto normal = json.Find("normal")) point.n_AB_W = normal->Vector();
  return point;
}

ContactAnswer AnswerFrom(const Received& json) {
  if (const auto reason = json.Find("unsupported"))
    return UnsupportedAnswer(reason->Text());
  if (const auto reason = json.Find("error")) return CrashedAnswer(reason->Text());
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = json["touching"].Truth();
  if (const auto normal = json.Find("normal")) answer.n_AB_W = normal->Vector();
  if (const auto gap = json.Find("separation")) answer.separation = gap->Number();
  if (const auto points = json.Find("points")) {
    for (const Received& point : points->Items())
      answer.points.push_back(PointFrom(point));
  }
  if (const auto witnesses = json.Find("witnesses")) {
    const std::vector<Received> of = witnesses->Items(kBodies);
    answer.witnesses = WitnessPoints{of[0].Vector(), of[1].Vector()};
  }
  return answer;
}

double StatusNumber(AnswerStatus status) {
  if (status == AnswerStatus::kAnswered) return kAnswered;
  return status == AnswerStatus::kUnsupported ? kUnsupported : kError;
}

void AppendAnswer(std::vector<double>& frame, const ContactAnswer& answer) {
  frame.push_back(StatusNumber(answer.status));
  frame.push_back(answer.touching ? 1 : 0);
  frame.push_back((answer.n_AB_W ? kNormal : 0) + (answer.separation ? kSeparation : 0) +
                  (answer.witnesses ? kWitnesses : 0));
  const Vector3d none = Vector3d::Zero();
  Append(frame, answer.n_AB_W.value_or(none));
  frame.push_back(answer.separation.value_or(0));
  Append(frame, answer.witnesses ? answer.witnesses->p_WCa : none);
  Append(frame, answer.witnesses ? answer.witnesses->p_WCb : none);
  frame.push_back(static_cast<double>(answer.points.size()));
  for (const ContactPoint& point : answer.points) {
    Append(frame, point.p_WC);
    frame.push_back(point.separation);
    frame.push_back(point.n_AB_W ? 1 : 0);
    Append(frame, point.n_AB_W.value_or(none));
  }
}

bool Truth(FrameReader& frame) {
  const double number = frame.Number();
  if (number == 0 || number == 1) return number == 1;
  throw ProtocolError(
      fmt::format("frame: {} for true or false; expected 1 or 0", number));
}

ContactPoint PointFrom(FrameReader& frame) {
  ContactPoint point;
  point.p_WC = frame.Vector();
  point.separation = frame.Number();
  const bool has_normal = Truth(frame);
  const Vector3d normal = frame.Vector();
  if (has_normal) point.n_AB_W = normal;
  return point;
}

ContactAnswer AnswerFrom(FrameReader& frame, const std::string& reason) {
  ContactAnswer answer;
  const double status = frame.Number();
  answer.touching = Truth(frame);
  const double provided = frame.Number();
  const int fields = provided >= 0 && provided <= kAll ? static_cast<int>(provided) : -1;
  const Vector3d normal = frame.Vector();
  const double separation = frame.Number();
  const Vector3d p_WCa = frame.Vector();
  const Vector3d p_WCb = frame.Vector();
  const std::size_t points = frame.Count(kPointNumbers);
  for (std::size_t i = 0; i < points; ++i) answer.points.push_back(PointFrom(frame));
  if (status == kUnsupported) return UnsupportedAnswer(reason);
  if (status == kError) return CrashedAnswer(reason);
  if (status != kAnswered) {
    return CrashedAnswer(fmt::format(
        "answered with the status {} in its frame; expected 0, 1 or 2", status));
  }
  if (fields != provided) {
    return CrashedAnswer(fmt::format(
        "answered with the fields {} in its frame; expected a sum of 1, 2 and 4",
        provided));
  }
  answer.status = AnswerStatus::kAnswered;
  if ((fields & kNormal) != 0) answer.n_AB_W = normal;
  if ((fields & kSeparation) != 0) answer.separation = separation;
  if ((fields & kWitnesses) != 0) answer.witnesses = WitnessPoints{p_WCa, p_WCb};
  return answer;
}

std::vector<ContactAnswer> AnswersFromFrame(const Message& message, std::size_t count) {
  const Received line(message.line, "answer");
  line["count"].Whole(static_cast<int>(count), static_cast<int>(count));
  const std::optional<Received> reasons = line.Find("reasons");
  FrameReader frame(message.frame);
  std::vector<ContactAnswer> answers;
  for (std::size_t i = 0; i < count; ++i) {
    const auto reason = reasons ? reasons->Find(std::to_string(i)) : std::nullopt;
    answers.push_back(AnswerFrom(frame, reason ? reason->Text() : "it gave no reason"));
  }
  frame.ExpectEnd();
  return answers;
}

}  // namespace

void PutAnswers(std::span<const ContactAnswer> answers, bool in_frame, Message& message) {
  if (!in_frame) {
    Json& list = message.line["answers"] = Json::array();
    for (const ContactAnswer& answer : answers) list.push_back(ToJson(answer));
    return;
  }
  message.line["count"] = answers.size();
  for (std::size_t i = 0; i < answers.size(); ++i) {
    AppendAnswer(message.frame, answers[i]);
    if (answers[i].status != AnswerStatus::kAnswered)
      message.line["reasons"][std::to_string(i)] = answers[i].reason;
  }
}

std::vector<ContactAnswer> AnswersFrom(const Message& message, std::size_t count) {
  const Received line(message.line, "answer");
  if (line.Find("count")) return AnswersFromFrame(message, count);
  std::vector<ContactAnswer> answers;
  for (const Received& json : line["answers"].Items(count)) {
    try {
      answers.push_back(AnswerFrom(json));
    } catch (const ProtocolError& error) {
      answers.push_back(CrashedAnswer(error.what()));
    }
  }
  return answers;
}

}  // namespace touchstone
