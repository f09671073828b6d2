#pragma once

#include <string>

namespace touchstone {

/** Returns the #include lines of a program that calls MuJoCo. */
std::string MujocoIncludes();

/** Returns the definition, at namespace scope, of

     mjModel* Load(const std::string& mjcf);

 which compiles a model from text in memory, and ends the program if MuJoCo refuses it. */
std::string LoadMujocoModel();

/** Returns the CMake lines that define the target `engine` as MuJoCo. */
std::string FindMujoco();

}  // namespace touchstone
