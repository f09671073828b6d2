#include "cli/commands/serve_command.h"

#include <unistd.h>

#include "cli/input_error.h"
#include "cli/select_oracles.h"
#include "oracles/protocol/serve.h"

namespace touchstone {

int ServeCommand(const Session& session, const std::string& name) {
  const Oracle& oracle = OracleNamed(session.registry, name);
  // The standard output is the protocol's: what an engine prints must not be in it.
  const int output = dup(STDOUT_FILENO);
  if (output < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    throw InputError("serve: no standard output; expected a program that reads it");
  return Serve(oracle, STDIN_FILENO, output) ? 0 : 1;
}

}  // namespace touchstone
