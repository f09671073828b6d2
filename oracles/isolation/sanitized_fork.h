#pragma once

namespace touchstone {

/** Makes fork() safe under the address sanitizer in a process with several threads. If
 another thread held the sanitizer's allocator during the fork, the child would wait for
 it for ever. Later calls, and calls without the sanitizer, do nothing. From LLVM 17 on,
 the sanitizer's runtime does the same itself (asan_posix.cpp, InstallAtForkHandler). */
void AllowForkUnderSanitizer();

}  // namespace touchstone
