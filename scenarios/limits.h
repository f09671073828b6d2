#pragma once

#include <cstddef>

namespace touchstone {

/** The largest number of vertices of a hull. The slowest engines, and the referee, take
 time that grows faster than their number: two hulls of so many vertices are answered
 within the time limit of every engine, so that none is blamed for the size. */
inline constexpr std::size_t kMostVertices = 1000;

/** The largest number of levels of a key, "a.b.c" has three. The deepest key of a
 scenario file has four. Each level is a table in a table, and recursion over them must
 fit the stack. */
inline constexpr int kMostKeyLevels = 16;

}  // namespace touchstone
