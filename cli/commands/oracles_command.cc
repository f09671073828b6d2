#include "cli/commands/oracles_command.h"

#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include <fmt/format.h>

namespace touchstone {
namespace {

std::string GivesOf(const Capability& capability) {
  std::string gives;
  const auto add = [&gives](bool given, const char* name) {
    if (given) gives += (gives.empty() ? "" : ", ") + std::string(name);
  };
  add(capability.depth, "depth");
  add(capability.distance, "distance");
  add(capability.normal, "normal");
  add(capability.manifold, "manifold");
  add(capability.witnesses, "witnesses");
  return gives.empty() ? "touching only" : gives;
}

std::string HeadingOf(const Capability& capability) {
  if (!capability.supported) return fmt::format("unsupported: {}", capability.reason);
  return fmt::format("{}: {}", capability.family, GivesOf(capability));
}

// Prints `words` in lines that fit a terminal of 80 columns.
void PrintWrapped(const std::string& words, std::size_t indent) {
  constexpr std::size_t kColumns = 80;
  std::istringstream in(words);
  std::string line;
  for (std::string word; in >> word;) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > kColumns) {
      std::cout << std::string(indent, ' ') << line << '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  std::cout << std::string(indent, ' ') << line << '\n';
}

// Prints the shape pairs, those with the same capability under one heading, e.g. "sat:
// depth, normal". A pair with the same capability in both orders is printed once.
void PrintCapabilities(const OracleInfo& info) {
  std::map<std::string, std::string> pairs_by_heading;
  for (int a = 0; a < kShapeKinds; ++a) {
    for (int b = 0; b < kShapeKinds; ++b) {
      const ShapeKind A = static_cast<ShapeKind>(a);
      const ShapeKind B = static_cast<ShapeKind>(b);
      const std::string heading = HeadingOf(info.For(A, B));
      if (a > b && heading == HeadingOf(info.For(B, A))) continue;
      pairs_by_heading[heading] += fmt::format("{}-{} ", NameOf(A), NameOf(B));
    }
  }
  for (const auto& [heading, pairs] : pairs_by_heading) {
    PrintWrapped(heading, 4);
    PrintWrapped(pairs_by_heading.size() > 1 ? pairs : "every pair of shapes", 8);
  }
}

void PrintWorldCapabilities(const OracleInfo& info) {
  if (!info.simulates) return;
  std::map<std::string, std::string> features_by_heading;
  for (int i = 0; i < kWorldFeatures; ++i) {
    const WorldFeature feature = static_cast<WorldFeature>(i);
    const WorldCapability& capability = info.For(feature);
    std::string& features =
        features_by_heading[capability.supported
                                ? "simulates worlds with"
                                : fmt::format("unsupported: {}", capability.reason)];
    features += (features.empty() ? "" : ", ") + std::string(NameOf(feature));
  }
  for (const auto& [heading, features] : features_by_heading) {
    PrintWrapped(heading, 4);
    PrintWrapped(features, 8);
  }
}

}  // namespace

int OraclesCommand(const Session& session, bool settings) {
  for (const Oracle* oracle : session.registry.All()) {
    const OracleInfo& info = oracle->info();
    std::cout << fmt::format("{}  {} {}, {} precision{}\n", info.name, info.library,
                             info.version,
                             info.unit_roundoff > 0x1p-40 ? "single" : "double",
                             info.isolated ? ", in a child process" : "");
    if (settings) {
      for (const Setting& setting : info.settings) {
        std::cout << fmt::format("    {} = {}  ({})\n", setting.name, setting.value,
                                 setting.why);
      }
      for (const WorldParameter& parameter : info.parameters) {
        std::cout << fmt::format("    --set {}:{}={}  {} as shipped: {}.{}{}\n",
                                 info.name, parameter.name, parameter.here,
                                 parameter.shipped, parameter.what,
                                 parameter.why.empty() ? "" : " ", parameter.why);
      }
    } else {
      PrintCapabilities(info);
      PrintWorldCapabilities(info);
    }
    std::cout << '\n';
  }
  for (const MissingOracle& missing : session.registry.missing()) {
    std::cout << fmt::format("{}  not available: {}\n", missing.name, missing.how_to_get);
  }
  return 0;
}

}  // namespace touchstone
