#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scenarios/toml/file_log.h"
#include "scenarios/worlds/world.h"

namespace touchstone {

/** A table with its name. */
struct NamedTable {
  const toml::key* key;
  const toml::table* table;  ///< Null if the value is not a table.
};

/** Returns the named tables under `key` in the order of the file, which is the order of
 World::bodies etc. (toml++ sorts by name). */
std::vector<NamedTable> InFileOrder(const toml::table& file, std::string_view key);

/** The names in a world's file. Looks up the part that a value names, and logs an unknown
 name. */
class WorldNames {
 public:
  /** Collects the names of bodies, particles and cloths, and logs those used twice. */
  WorldNames(const toml::table& file, FileLog& log);

  /** Returns the anchor in `node`; empty if it is invalid. `where` is its path. */
  std::optional<Anchor> AnchorFrom(const toml::node* node, std::string_view where);

  /** Returns the index of the body that `node` names; empty if there is none. */
  std::optional<int> BodyFrom(const toml::node* node, std::string_view where);

  /** Returns the string in `node` if it names a part of the world; logs an error if not.
   */
  std::optional<std::string> AnyFrom(const toml::node* node, std::string_view where);

 private:
  enum class Kind { kBody, kParticle, kCloth };
  struct Named {
    Kind kind;
    int index;
  };

  /** Returns the part that `node` names, of a kind up to `last`; `wanted` describes these
   kinds in messages. */
  std::optional<Named> Find(const toml::node* node, std::string_view where, Kind last,
                            std::string_view wanted);

  FileLog& log_;
  std::map<std::string, Named, std::less<>> named_;
};

}  // namespace touchstone
