#pragma once

#include <atomic>
#include <iterator>

#include <hwy/highway.h>
#include <hwy/targets.h>

namespace cookbook {

/** Where Highway keeps which vectors are chosen; null before the first call. */
inline std::atomic<const hwy::ChosenTarget*> chosen_target = nullptr;

template <auto& table, class... Arguments>
HWY_NOINLINE void AskAndCall(Arguments&... arguments) {
  const hwy::ChosenTarget& chosen = hwy::GetChosenTarget();
  chosen_target.store(&chosen, std::memory_order_relaxed);
  table[chosen.GetIndex()](arguments...);
}

/** Calls the function of a HWY_DISPATCH_TABLE() that is for the vectors chosen, as
 HWY_DYNAMIC_DISPATCH() does, but asks Highway's library only once where it keeps them:
 to ask in every call takes 2 ns, and a box and a sphere take 11 in all (EPYC, Zen 4). */
template <auto& table, class... Arguments>
HWY_INLINE void CallOnTarget(Arguments&... arguments) {
  if constexpr (std::size(table) == 1) {
    table[0](arguments...);
  } else {
    const hwy::ChosenTarget* chosen = chosen_target.load(std::memory_order_relaxed);
    // Calls at the end only, which are jumps and save no registers.
    if (chosen == nullptr) [[unlikely]]
      return AskAndCall<table>(arguments...);
    table[chosen->GetIndex()](arguments...);
  }
}

}  // namespace cookbook
