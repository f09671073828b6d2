#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "oracles/oracle.h"
#include "scenarios/worlds/world_scenario.h"

namespace touchstone {

/** Returns the faults of `subject` in the worlds, written for a person; empty where there
 are none. It names every world that the subject fails. For the first of them it shows
 every motion with its proof, and the file. It is a fault too if nothing of the subject
 was verified, and if a claim does not fit its world. The motions of `references` are
 shown next to the subject's. */
std::string ComplaintAboutWorlds(const Oracle& subject,
                                 std::span<const WorldScenario> worlds,
                                 std::span<const Oracle* const> references = {});

/** The same for the worlds of a file, or of a folder and all folders below it. An error
 in a file, and a place without worlds, is a fault. */
std::string ComplaintAboutWorlds(const Oracle& subject,
                                 const std::filesystem::path& file_or_folder,
                                 std::span<const Oracle* const> references = {});

}  // namespace touchstone
