#include "cli/commands/merge_command.h"

#include "cli/input_error.h"
#include "reports/sweep/merge.h"

namespace touchstone {

int MergeCommand(const MergeArguments& arguments) try {
  std::vector<SweepFile> parts;
  for (const std::filesystem::path& part : arguments.parts)
    parts.push_back(SweepFile::Open(part));
  WriteMerged(parts, arguments.out);
  return 0;
} catch (const SweepFileError& error) {
  throw InputError(error.what());
}

}  // namespace touchstone
