// The tail of every SIMD kernel: calls it as compiled for the best target of the
// processor.
//
//   #if HWY_ONCE
//   namespace cookbook {
//   double Sum(std::span<const double> terms) {
//     return COOKBOOK_DISPATCH(SumAll)(terms);  // HWY_NAMESPACE::SumAll()
//   }
//   }  // namespace cookbook
//   #endif

#pragma once

#include <atomic>
#include <utility>

#include <hwy/highway.h>
#include <hwy/targets.h>

namespace cookbook {

/** Highway's record of the chosen SIMD target; null before the first call. */
inline std::atomic<const hwy::ChosenTarget*> chosen_target = nullptr;

template <auto& kernels, class... Arguments>
HWY_NOINLINE decltype(auto) ChooseTargetAndCall(Arguments&&... arguments) {
  hwy::ChosenTarget& chosen = hwy::GetChosenTarget();
  if (!chosen.IsInitialized()) chosen.Update(hwy::SupportedTargets());
  chosen_target.store(&chosen, std::memory_order_relaxed);
  return kernels[chosen.GetIndex()](std::forward<Arguments>(arguments)...);
}

/** Calls the one of `kernels` that is compiled for the chosen target. They are indexed by
 hwy::ChosenTarget::GetIndex(). */
template <auto& kernels, class... Arguments>
HWY_INLINE decltype(auto) CallOnTarget(Arguments&&... arguments) {
  if constexpr ((HWY_TARGETS & (HWY_TARGETS - 1)) == 0) {
    return kernels[0](std::forward<Arguments>(arguments)...);
  } else {
    const hwy::ChosenTarget* chosen = chosen_target.load(std::memory_order_relaxed);
    // Tail calls only: they compile to jumps and save no registers.
    if (chosen == nullptr) [[unlikely]]
      return ChooseTargetAndCall<kernels>(std::forward<Arguments>(arguments)...);
    return kernels[chosen->GetIndex()](std::forward<Arguments>(arguments)...);
  }
}

/** The function KERNEL of HWY_NAMESPACE for the chosen SIMD target. It replaces
 HWY_EXPORT() and HWY_DYNAMIC_DISPATCH() for two reasons. KERNEL may be an instance of a
 function template. And Highway's record of the target is looked up only once: a look-up
 in every call takes 2 ns, and colliding a box and a sphere takes 11 ns in all (EPYC, Zen
 4). The first element of the table is never called: the target is chosen before. */
#define COOKBOOK_DISPATCH(KERNEL)                                          \
  [](auto&&... arguments) -> decltype(auto) {                              \
    static constexpr decltype(&HWY_STATIC_DISPATCH(KERNEL)) kKernels[] = { \
        HWY_CHOOSE_FALLBACK(KERNEL), HWY_CHOOSE_TARGET_LIST(KERNEL),       \
        HWY_CHOOSE_FALLBACK(KERNEL)};                                      \
    return cookbook::CallOnTarget<kKernels>(                               \
        std::forward<decltype(arguments)>(arguments)...);                  \
  }

/** Instantiates the function template FUNCTION for both precisions. */
#define COOKBOOK_INSTANTIATE(FUNCTION)                  \
  template decltype(FUNCTION<double>) FUNCTION<double>; \
  template decltype(FUNCTION<float>) FUNCTION<float>

}  // namespace cookbook
