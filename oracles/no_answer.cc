#include "oracles/no_answer.h"

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <memory>
#include <typeinfo>
#include <utility>

#include <cxxabi.h>

namespace touchstone {
namespace {

ContactAnswer WithReason(AnswerStatus status, std::string reason) {
  ContactAnswer answer;
  answer.status = status;
  answer.reason = std::move(reason);
  return answer;
}

std::string ReadableName(const std::type_info& type) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(type.name(), nullptr, nullptr, &status), &std::free);
  return name ? name.get() : type.name();
}

// The start of `text` on one line: FCL's exceptions describe the whole question.
std::string OneLine(const char* text) {
  constexpr std::size_t kLongest = 300;
  std::string line;
  for (; *text != '\0' && line.size() < kLongest; ++text) {
    const bool is_space = static_cast<unsigned char>(*text) <= ' ';
    if (!is_space) {
      line += *text;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  return *text == '\0' ? line : line + " ...";
}

}  // namespace

ContactAnswer UnsupportedAnswer(std::string reason) {
  return WithReason(AnswerStatus::kUnsupported, std::move(reason));
}

ContactAnswer CrashedAnswer(std::string reason) {
  return WithReason(AnswerStatus::kCrashed, std::move(reason));
}

ContactAnswer TimedOutAnswer(std::string reason) {
  return WithReason(AnswerStatus::kTimedOut, std::move(reason));
}

ContactAnswer CrashedByException() {
  try {
    throw;
  } catch (const std::exception& exception) {
    return CrashedAnswer("threw " + ReadableName(typeid(exception)) + ": " +
                         OneLine(exception.what()));
  } catch (...) {
    return CrashedAnswer("threw something that is not a std::exception");
  }
}

}  // namespace touchstone
