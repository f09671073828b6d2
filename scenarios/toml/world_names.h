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

/** A table under a name of its own. */
struct NamedTable {
  const toml::key* key;
  const toml::table* table;  ///< Null where the value is none.
};

/** Returns what `file` has under `key` in the order of the file, which is that of
 World::bodies and so on: toml++ sorts by name. */
std::vector<NamedTable> InFileOrder(const toml::table& file, std::string_view key);

/** The names of a world's file. Finds what a value names, and logs where it names
 * nothing.
 */
class WorldNames {
 public:
  /** Takes the names of bodies, particles and cloths, and logs those used twice. */
  WorldNames(const toml::table& file, FileLog& log);

  /** Returns the anchor that `node` says; nothing where it is none. `where` is its path.
   */
  std::optional<Anchor> AnchorFrom(const toml::node* node, std::string_view where);

  /** Returns the index of the body that `node` names. */
  std::optional<int> BodyFrom(const toml::node* node, std::string_view where);

  /** Returns the string that `node` is, and logs where it names nothing of the world. */
  std::optional<std::string> AnyFrom(const toml::node* node, std::string_view where);

 private:
  enum class Kind { kBody, kParticle, kCloth };
  struct Named {
    Kind kind;
    int index;
  };

  /** Returns what `node` names, of a kind up to `last`; `wanted` describes those. */
  std::optional<Named> Find(const toml::node* node, std::string_view where, Kind last,
                            std::string_view wanted);

  FileLog& log_;
  std::map<std::string, Named, std::less<>> named_;
};

}  // namespace touchstone
