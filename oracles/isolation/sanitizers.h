#pragma once

// GCC before 14 has macros of its own for two sanitizers and none for the third.
#ifdef __has_feature
#define TOUCHSTONE_HAS_FEATURE(name) __has_feature(name)
#else
#define TOUCHSTONE_HAS_FEATURE(name) 0
#endif

namespace touchstone {

/** Whether the program is built with the address or the thread sanitizer. Both reserve
 terabytes of address space, so that it cannot be limited. */
#if TOUCHSTONE_HAS_FEATURE(address_sanitizer) ||                                 \
    TOUCHSTONE_HAS_FEATURE(thread_sanitizer) || defined(__SANITIZE_ADDRESS__) || \
    defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitizerReservesMemory = true;
#else
inline constexpr bool kSanitizerReservesMemory = false;
#endif

/** Whether the program is built with clang's undefined-behaviour sanitizer. It opens a
 pipe to check the type of an object of another library. */
inline constexpr bool kSanitizerOpensPipes =
    TOUCHSTONE_HAS_FEATURE(undefined_behavior_sanitizer);

}  // namespace touchstone

#undef TOUCHSTONE_HAS_FEATURE
