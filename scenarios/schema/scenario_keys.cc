#include "scenarios/schema/scenario_keys.h"

#include "scenarios/schema/world_keys.h"

namespace touchstone {
namespace {

constexpr Key kContactFileKeys[] = {
    {"id", ValueType::kId, true,
     "The scenario's name: its path in the catalogue, without .toml."},
    {"title", ValueType::kText, true, "One line that describes the scene."},
    {"source", ValueType::kText, true, "A citation or a derivation."},
    {"bodies", ValueType::kBodies, true, "The two bodies, each under a unique name."},
    {"contact", ValueType::kTable, true, "The contact query: do A and B touch, and how?",
     TableKind::kContact},
    {"expect", ValueType::kTable, false,
     "Values that the author derived by hand; checked against the certified truth.",
     TableKind::kExpect},
    {"tolerance", ValueType::kTable, false,
     "An additional tolerance beyond rounding, with its reason.", TableKind::kTolerance},
    {"indicts", ValueType::kTables, false,
     "Engine faults reported for this scenario; the suite checks each of them.",
     TableKind::kIndictment},
};

constexpr Key kContactKeys[] = {
    {"A", ValueType::kBodyName, true, "The body from which normals point."},
    {"B", ValueType::kBodyName, true, "The body to which normals point."},
};

constexpr Key kExpectKeys[] = {
    {"touching", ValueType::kBool, false,
     "Whether A and B share a point; zero separation counts."},
    {"separation", ValueType::kNumber, false,
     "The distance if separated, minus the depth if penetrating. [m]"},
    {"normals", ValueType::kUnitVectors, false,
     "Unit normals from A to B in the world frame; several if there is a tie."},
    {"contacts", ValueType::kCount, false,
     "The smallest number of contact points that span the contact patch."},
};

constexpr Key kToleranceKeys[] = {
    {"separation", ValueType::kLength, true, "Added to the derived tolerance. [m]"},
    {"because", ValueType::kText, true,
     "The reason in one sentence, quoted in the report."},
};

constexpr Key kIndictmentKeys[] = {
    {"oracle", ValueType::kText, true,
     "The oracle's name, e.g. \"fcl/signed_distance\"."},
    {"measures", ValueType::kMeasures, true,
     "The measures that detect the fault; the suite must confirm each of them."},
    {"anomaly", ValueType::kText, true, "The failure in the words of the source."},
    {"reproduces", ValueType::kBool, true,
     "False: fixed since, or a control; then the suite must confirm none of the "
     "measures."},
};

constexpr Key kBodyKeys[] = {
    {"shape", ValueType::kShape, true,
     "The kind of shape, centred on the body's origin."},
    {"position", ValueType::kPoint, false,
     "The body's origin in the world frame; the world's origin by default. [m]"},
    {"quaternion", ValueType::kQuaternion, false,
     "The body's orientation as a unit quaternion w x y z; the world's axes by default."},
    {"rotation", ValueType::kRotation, false,
     "The body's orientation as a matrix of three rows; instead of a quaternion."},
};

constexpr Key kSphereKeys[] = {
    {"radius", ValueType::kLength, true, "Radius of the ball. [m]"},
};
constexpr Key kBoxKeys[] = {
    {"half_extents", ValueType::kLengths, true,
     "Half the edge lengths along the body's x, y and z axes. [m]"},
};
constexpr Key kCapsuleKeys[] = {
    {"radius", ValueType::kLength, true, "Radius of the caps and the tube. [m]"},
    {"half_length", ValueType::kLength, true,
     "Half the length of the segment on the body's z axis, without the caps. [m]"},
};
constexpr Key kCylinderKeys[] = {
    {"radius", ValueType::kLength, true, "Radius of the discs. [m]"},
    {"half_length", ValueType::kLength, true,
     "Half the length along the body's z axis. [m]"},
};
constexpr Key kConeKeys[] = {
    {"radius", ValueType::kLength, true,
     "Radius of the base disc, at z = -half_height. [m]"},
    {"half_height", ValueType::kLength, true,
     "Half the height; the apex is at z = +half_height. [m]"},
};
constexpr Key kConvexHullKeys[] = {
    {"vertices", ValueType::kPoints, true,
     "Points in the body frame whose convex hull is the shape. [m]"},
};

}  // namespace

std::span<const Key> KeysOf(TableKind table) {
  switch (table) {
    case TableKind::kContactFile:
      return kContactFileKeys;
    case TableKind::kContact:
      return kContactKeys;
    case TableKind::kExpect:
      return kExpectKeys;
    case TableKind::kTolerance:
      return kToleranceKeys;
    case TableKind::kIndictment:
      return kIndictmentKeys;
    default:
      return KeysOfWorldTable(table);
  }
}

std::span<const std::string_view> KeysOfWorldsOnly() {
  static constexpr std::string_view kKeys[] = {"particles", "springs", "joints",
                                               "cloths",    "pushes",  "claims",
                                               "ensemble",  "horizon"};
  return kKeys;
}

std::span<const Key> BodyKeys() {
  return kBodyKeys;
}

std::span<const Key> ShapeKeys(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kSphere:
      return kSphereKeys;
    case ShapeKind::kBox:
      return kBoxKeys;
    case ShapeKind::kCapsule:
      return kCapsuleKeys;
    case ShapeKind::kCylinder:
      return kCylinderKeys;
    case ShapeKind::kCone:
      return kConeKeys;
    case ShapeKind::kConvexHull:
      return kConvexHullKeys;
    case ShapeKind::kHalfSpace:
      return {};
  }
  return {};
}

std::string_view ExpectationOf(ValueType type) {
  switch (type) {
    case ValueType::kText:
      return "a non-empty string";
    case ValueType::kMeasures:
      return "a list of measures, e.g. [\"separation_error\"]";
    case ValueType::kId:
      return "a string: levels of a-z, 0-9 and _ joined by slashes";
    case ValueType::kWord:
      return "a string of a-z, 0-9 and _";
    case ValueType::kBodyName:
      return "the name of a body";
    case ValueType::kNames:
      return "a list of names of bodies, particles or cloths";
    case ValueType::kShape:
      return "one of sphere, box, capsule, cylinder, cone, convex_hull, half_space";
    case ValueType::kBool:
      return "true or false";
    case ValueType::kCount:
      return "a count, 0 or more";
    case ValueType::kPositiveCount:
      return "a count, 1 or more";
    case ValueType::kSeed:
      return "an integer from 0 to 4294967295";
    case ValueType::kNumber:
      return "a finite number";
    case ValueType::kNotNegative:
      return "a finite number >= 0";
    case ValueType::kPositive:
      return "a finite number > 0";
    case ValueType::kLength:
      return "a finite length > 0";
    case ValueType::kShare:
      return "a number from 0 to 1";
    case ValueType::kPoint:
      return "three finite numbers";
    case ValueType::kLengths:
      return "three finite lengths > 0";
    case ValueType::kMoments:
      return "three finite moments > 0";
    case ValueType::kPoints:
      return "a list of points, three numbers each";
    case ValueType::kUnitVectors:
      return "a list of unit vectors, three numbers each";
    case ValueType::kNodes:
      return "a list of nodes, [row, column] each";
    case ValueType::kQuaternion:
      return "four numbers w, x, y, z";
    case ValueType::kRotation:
      return "three rows of three numbers";
    case ValueType::kAnchor:
      return "the name of a body or a particle, a point of the world, or a table with on "
             "and point";
    case ValueType::kNumbers:
      return "a table of numbers";
    case ValueType::kTable:
      return "a table";
    case ValueType::kBodies:
      return "two bodies, each a table under its name";
    case ValueType::kMovingBodies:
    case ValueType::kNamedTables:
      return "tables, each under its name";
    case ValueType::kTables:
      return "a list of tables";
  }
  return {};
}

}  // namespace touchstone
