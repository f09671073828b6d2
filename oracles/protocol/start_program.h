#pragma once

#include <sys/types.h>

#include "oracles/isolation/unique_fd.h"
#include "oracles/protocol/command.h"

namespace touchstone {

/** A program that runs, and our ends of its standard streams, which do not block. */
struct StartedProgram {
  pid_t pid;          ///< Also the number of its process group.
  UniqueFd input;     ///< A socket.
  UniqueFd output;    ///< A pipe.
  UniqueFd messages;  ///< A pipe: its standard error.
};

/** Starts `command` by /bin/sh in a process group of its own. A single program is killed
 when this process ends, however it ends; of several, e.g. "cd x && ./y", those that read
 their standard input end at its end. Libraries of linear algebra are told to use one
 thread, unless the environment says otherwise: two of our threads ask two programs.
 @throws std::system_error if the system provides no process, socket or pipe, or after
 EndChildren(). */
StartedProgram Start(const Command& command);

}  // namespace touchstone
