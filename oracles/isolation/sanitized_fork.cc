#include "oracles/isolation/sanitized_fork.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TOUCHSTONE_ADDRESS_SANITIZER
#endif
#endif

#ifdef TOUCHSTONE_ADDRESS_SANITIZER

#include <pthread.h>

// The locks of the runtime that clang links statically. Null if the runtime is a shared
// library, which does not export them.
// NOLINTBEGIN(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)
namespace __lsan {
[[gnu::weak]] void LockThreadRegistry();
[[gnu::weak]] void UnlockThreadRegistry();
[[gnu::weak]] void LockAllocator();
[[gnu::weak]] void UnlockAllocator();
}  // namespace __lsan
// NOLINTEND(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp)

namespace touchstone {
namespace {

void Call(void (*function)()) {
  if (function != nullptr) function();
}

// Takes the locks in the same order as the runtime. Leaves out the locks of its stack
// depot: there are a million, a child needs one, and each is held for a few instructions.
void Lock() {
  Call(&__lsan::LockThreadRegistry);
  Call(&__lsan::LockAllocator);
}

void Unlock() {
  Call(&__lsan::UnlockAllocator);
  Call(&__lsan::UnlockThreadRegistry);
}

}  // namespace

void AllowForkUnderSanitizer() {
  [[maybe_unused]] static const int registered = pthread_atfork(&Lock, &Unlock, &Unlock);
}

}  // namespace touchstone

#else

void touchstone::AllowForkUnderSanitizer() {}

#endif
