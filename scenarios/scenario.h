#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scenarios/contact_query.h"
#include "scenarios/file_places.h"
#include "scenarios/measure_kind.h"

namespace touchstone {

/** The answer that the author of a scenario derived by hand. Every field is optional. The
 given ones are checked against the referee before any engine is judged, so that a wrong
 derivation is found. */
struct ContactExpectation {
  std::optional<bool> touching;
  std::optional<double> separation;  ///< < 0 penetrating, 0 touching, > 0 apart. [m]
  /** Unit normals from A to B in the world frame; a tie has several, equally right. */
  std::vector<Eigen::Vector3d> normals;
  std::optional<int> contacts;  ///< Smallest number of points that span the patch.
};

/** An additional tolerance beyond rounding, with its reason. */
struct ToleranceOverride {
  double separation;    ///< Added to the derived tolerance. [m], > 0
  std::string because;  ///< The reason in one sentence, quoted in the report.
};

/** A report that an engine's fault shows in this scenario; the suite checks it. */
struct Indictment {
  std::string oracle;  ///< Oracle name, e.g. "fcl/signed_distance".
  /** The measures that detect the fault; the suite must confirm each of them. */
  std::vector<MeasureKind> measures;
  std::string anomaly;  ///< The failure in the words of the source.
  /** False: fixed since, or a control; then the suite must confirm none of them. */
  bool reproduces;
};

/** A contact query with its provenance and what is known about its answer. */
struct Scenario {
  std::string id;      ///< A path, e.g. "contact/box_box/face_face_shallow".
  std::string title;   ///< One line that describes the scene.
  std::string source;  ///< A citation or a derivation.
  std::string name_A;  ///< Name of body A in the file.
  std::string name_B;  ///< Name of body B in the file.
  ContactQuery contact;
  ContactExpectation expect;
  std::optional<ToleranceOverride> tolerance;
  std::vector<Indictment> indicts;
  FilePlaces places;  ///< Positions in the file, for diagnostics.
};

}  // namespace touchstone
