#pragma once

namespace touchstone {

/** Makes fork() safe in a process with several threads under the address sanitizer, whose
 allocator another thread may hold at that moment: the child would wait for it for ever.
 Later calls, and those without the sanitizer, do nothing. Its runtime does so itself from
 LLVM 17 on (asan_posix.cpp, InstallAtForkHandler). */
void AllowForkUnderSanitizer();

}  // namespace touchstone
