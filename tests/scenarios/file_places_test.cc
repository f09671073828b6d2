#include "scenarios/file_places.h"

#include <gtest/gtest.h>

#include "scenarios/scenario_file.h"

namespace touchstone {
namespace {

constexpr const char* kFile = R"(id = "mine/balls"
title = "Two balls"
source = "Centres 1.5 m apart"

[bodies.a]
shape = "sphere"
radius = 1

[bodies.b]
shape = "sphere"
radius = 1
position = [1.5, 0, 0]

[contact]
A = "a"
B = "b"

[expect]
separation = -0.5
normals = [[1, 0, 0]]

[[indicts]]
oracle = "ode"
measures = ["excess"]
anomaly = "It is off."
reproduces = true
)";

std::string PlaceOf(const std::string& path, bool of_key = false) {
  const FilePlaces places = ReadScenario(kFile, "f.toml").scenario->places;
  return ToString((of_key ? ErrorAtKey : ErrorAtValue)(places, path, "w", "e"));
}

TEST(FilePlaces, DistinguishKeysFromTheirValues) {
  EXPECT_EQ(PlaceOf("expect.separation"), "f.toml:19:14: w; expected e");
  EXPECT_EQ(PlaceOf("expect.separation", true), "f.toml:19:1: w; expected e");
  EXPECT_EQ(PlaceOf("expect.normals[0]"), "f.toml:20:12: w; expected e");
  EXPECT_EQ(PlaceOf("indicts[0].measures[0]"), "f.toml:24:13: w; expected e");
}

TEST(FilePlaces, UseTheParentForAMissingPath) {
  EXPECT_EQ(PlaceOf("indicts[0].because"), PlaceOf("indicts[0]"));
  EXPECT_EQ(PlaceOf("expect.normals[7]"), PlaceOf("expect.normals"));
}

TEST(FilePlaces, GiveNoLineForAnUnrecordedPath) {
  EXPECT_EQ(PlaceOf("bodies"), "f.toml: w; expected e");
}

}  // namespace
}  // namespace touchstone
