#include "scenarios/toml/world_names.h"

#include <algorithm>
#include <array>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scenarios/schema/nearest_name.h"
#include "scenarios/toml/values.h"

namespace touchstone {
namespace {

constexpr std::array<std::string_view, 3> kTables = {"bodies", "particles", "cloths"};

}  // namespace

std::vector<NamedTable> InFileOrder(const toml::table& file, std::string_view key) {
  std::vector<NamedTable> named;
  if (const toml::table* tables = file[key].as_table()) {
    for (const auto& [name, node] : *tables) named.push_back({&name, node.as_table()});
  }
  std::sort(named.begin(), named.end(), [](const NamedTable& a, const NamedTable& b) {
    const toml::source_position& at_a = a.key->source().begin;
    const toml::source_position& at_b = b.key->source().begin;
    return std::tie(at_a.line, at_a.column) < std::tie(at_b.line, at_b.column);
  });
  return named;
}

WorldNames::WorldNames(const toml::table& file, FileLog& log) : log_(log) {
  for (std::size_t kind = 0; kind < kTables.size(); ++kind) {
    int index = 0;
    for (const NamedTable& named : InFileOrder(file, kTables[kind])) {
      const std::string name(named.key->str());
      const auto [first, is_new] =
          named_.emplace(name, Named{static_cast<Kind>(kind), index++});
      if (is_new) continue;
      log_.Add(named.key->source(),
               fmt::format("{}.{} has the name of {}.{}", kTables[kind], name,
                           kTables[static_cast<std::size_t>(first->second.kind)], name),
               "a unique name");
    }
  }
}

std::optional<WorldNames::Named> WorldNames::Find(const toml::node* node,
                                                  std::string_view where, Kind last,
                                                  std::string_view wanted) {
  const auto* name = node ? node->as_string() : nullptr;
  if (!name) return std::nullopt;
  const auto found = named_.find(name->get());
  if (found != named_.end() && found->second.kind <= last) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [known, named] : named_) {
    if (named.kind <= last) names.push_back(known);
  }
  const std::string_view nearest = NearestName(name->get(), names);
  log_.Add(node->source(),
           fmt::format("{} is \"{}\", which is not a {}", where, name->get(), wanted),
           !nearest.empty() ? fmt::format("\"{}\"", nearest)
           : names.empty()  ? fmt::format("a {} of the world", wanted)
                            : fmt::format("one of {}", fmt::join(names, ", ")));
  return std::nullopt;
}

std::optional<Anchor> WorldNames::AnchorFrom(const toml::node* node,
                                             std::string_view where) {
  Anchor anchor;
  if (AreNumbers(node, 3)) {
    anchor.point = VectorFrom(node, anchor.point);
    return anchor;
  }
  const toml::table* table = node ? node->as_table() : nullptr;
  const std::optional<Named> named =
      table ? Find(table->get("on"), fmt::format("{}.on", where), Kind::kParticle,
                   "body or particle")
            : Find(node, where, Kind::kParticle, "body or particle");
  if (!named) return std::nullopt;
  anchor.on = named->kind == Kind::kBody ? AnchorKind::kBody : AnchorKind::kParticle;
  anchor.index = named->index;
  if (table) anchor.point = VectorFrom(table->get("point"), anchor.point);
  return anchor;
}

std::optional<int> WorldNames::BodyFrom(const toml::node* node, std::string_view where) {
  const std::optional<Named> named = Find(node, where, Kind::kBody, "body");
  return named ? std::optional(named->index) : std::nullopt;
}

std::optional<std::string> WorldNames::AnyFrom(const toml::node* node,
                                               std::string_view where) {
  if (!Find(node, where, Kind::kCloth, "body, particle or cloth")) return std::nullopt;
  return node->as_string()->get();
}

}  // namespace touchstone
