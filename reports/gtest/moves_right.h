#pragma once

#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "reports/gtest/world_complaint.h"

namespace touchstone {

/** Returns whether `subject` moves the worlds of a file or folder as the laws that they
 claim predict. A failure shows the first wrong motion with its proof, next to those of
 `references`, and the file:
      EXPECT_TRUE(MovesRight(*mine, "worlds/bouncing_ball.toml", {ode}));
 A world that the subject does not simulate is left out; at least one has to be verified.
 A wrong reference is shown as wrong, and does not make the subject fail. */
inline testing::AssertionResult MovesRight(
    const Oracle& subject, const std::filesystem::path& file_or_folder,
    const std::vector<const Oracle*>& references = {}) {
  const std::string complaint = ComplaintAboutWorlds(subject, file_or_folder, references);
  if (complaint.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << complaint;
}

/** The same for a world that the test builds itself. */
inline testing::AssertionResult MovesRight(
    const Oracle& subject, const WorldScenario& world,
    const std::vector<const Oracle*>& references = {}) {
  const std::string complaint = ComplaintAboutWorlds(subject, {&world, 1}, references);
  if (complaint.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << complaint;
}

}  // namespace touchstone
