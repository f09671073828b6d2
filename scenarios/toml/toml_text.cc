#include "scenarios/toml/toml_text.h"

#include <fmt/format.h>

namespace touchstone::toml_text {

std::string Number(double value) {
  std::string text = fmt::format("{}", value);
  // Without a point, TOML would read an integer, which loses the sign of -0.
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string Vector(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", Number(v[0]), Number(v[1]), Number(v[2]));
}

std::string Text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    switch (c) {
      case '"':
        quoted += "\\\"";
        break;
      case '\\':
        quoted += "\\\\";
        break;
      case '\n':
        quoted += "\\n";
        break;
      case '\r':
        quoted += "\\r";
        break;
      case '\t':
        quoted += "\\t";
        break;
      default: {
        const auto byte = static_cast<unsigned char>(c);
        const bool control = byte < 0x20 || byte == 0x7f;
        quoted += control ? fmt::format("\\u{:04X}", byte) : std::string(1, c);
      }
    }
  }
  return quoted + '"';
}

std::string Truth(bool value) {
  return value ? "true" : "false";
}

std::string Line(std::string_view key, std::string_view value) {
  return fmt::format("{} = {}\n", key, value);
}

std::string List(const std::vector<Eigen::Vector3d>& vectors) {
  std::string list = "[";
  for (const Eigen::Vector3d& v : vectors) list += fmt::format("\n  {},", Vector(v));
  return list + "\n]";
}

}  // namespace touchstone::toml_text
