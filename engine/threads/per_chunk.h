#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cookbook {

/** One list for each chunk of a parallel loop, see ThreadPool::ParallelForIndexed().
 Chunks fill their lists at the same time; read in the order of chunks, the elements have
 the order of the loop's indices, whatever the number of threads. */
template <class Element>
class PerChunk {
 public:
  /** Empties all lists. `chunk_count`: ThreadPool::chunk_count(). */
  void Clear(std::size_t chunk_count) {
    lists_.resize(chunk_count);
    for (List& list : lists_) list.elements.clear();
  }

  /** Returns the list of a chunk. During the loop only that chunk may use it. */
  std::vector<Element>& operator[](std::size_t chunk) { return lists_[chunk].elements; }

  /** Appends the elements of all chunks to `all`. */
  void AppendTo(std::vector<Element>& all) const {
    for (const List& list : lists_) {
      all.insert(all.end(), list.elements.begin(), list.elements.end());
    }
  }

  /** Calls `visit(element)` for every element. */
  template <class Visit>
  void ForEach(const Visit& visit) const {
    for (const List& list : lists_) {
      for (const Element& element : list.elements) visit(element);
    }
  }

  /** Calls `visit(element)` for every element, the last one first. */
  template <class Visit>
  void ForEachBackwards(const Visit& visit) const {
    for (auto list = lists_.rbegin(); list != lists_.rend(); ++list) {
      std::for_each(list->elements.rbegin(), list->elements.rend(), visit);
    }
  }

 private:
  /** Fills whole cache lines, which prevents false sharing between threads. */
  struct alignas(64) List {
    std::vector<Element> elements;
  };

  std::vector<List> lists_;  ///< Indexed by chunk.
};

}  // namespace cookbook
