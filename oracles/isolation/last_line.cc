#include "oracles/isolation/last_line.h"

#include <algorithm>
#include <array>
#include <cerrno>

#include <sys/stat.h>
#include <unistd.h>

namespace touchstone {
namespace {

// The part of the file that is searched for the line. [bytes]
constexpr off_t kTail = 4096;

// Removes the program and the function from the message of assert(), which is "program:
// file:line: the function's whole signature: Assertion `…' failed.".
std::string ShortAssertion(std::string line) {
  const std::string program = std::string(program_invocation_short_name) + ": ";
  if (line.starts_with(program)) line.erase(0, program.size());
  const std::size_t place = line.find(": ");
  const std::size_t assertion = line.find("Assertion `");
  if (assertion != std::string::npos && place < assertion) {
    line.erase(place + 2, assertion - place - 2);
  }
  return line;
}

}  // namespace

std::string LastLineIn(std::string_view tail) {
  std::string text(tail);
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\n'; }, ' ');
  text.erase(text.find_last_not_of(" \n") + 1);
  text.erase(0, text.find_last_of('\n') + 1);
  return ShortAssertion(text);
}

std::string LastLineOf(int fd) {
  struct stat file {};
  if (fstat(fd, &file) != 0) return "";
  std::array<char, kTail> bytes;
  const ssize_t count =
      pread(fd, bytes.data(), bytes.size(), std::max<off_t>(0, file.st_size - kTail));
  return LastLineIn(
      {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count))});
}

}  // namespace touchstone
