#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scenarios/contact_query.h"
#include "scenarios/file_places.h"
#include "scenarios/measure_kind.h"

namespace touchstone {

/** What the author of a scenario derived by hand. Every field is optional; what is given
 is checked against the referee before any engine is judged, so a wrong derivation is
 found. */
struct ContactExpectation {
  std::optional<bool> touching;
  std::optional<double> separation;  ///< < 0 penetrating, 0 touching, > 0 apart. [m]
  /** Unit normals from A to B, each as good as the others (a tie has several); in the
   world frame. */
  std::vector<Eigen::Vector3d> normals;
  std::optional<int> contacts;  ///< The fewest points that span the contact patch.
};

/** How much error the author grants beyond rounding, and why. */
struct ToleranceOverride {
  double separation;    ///< Added to the derived tolerance. [m], > 0
  std::string because;  ///< One sentence, quoted in the report.
};

/** A claim that a fault of an engine shows in this scenario, to be found again. */
struct Indictment {
  std::string oracle;  ///< Oracle name, e.g. "fcl/signed_distance".
  /** The measures that find it: the suite must find every one of them again. */
  std::vector<MeasureKind> measures;
  std::string anomaly;  ///< What the source says goes wrong, in its words.
  /** False: fixed since, or a control; the suite must find none of the measures. */
  bool reproduces;
};

/** A question with its provenance and what is known of its answer. */
struct Scenario {
  std::string id;      ///< A path, e.g. "contact/box_box/face_face_shallow".
  std::string title;   ///< What is there, in one line.
  std::string source;  ///< A citation or a derivation.
  std::string name_A;  ///< The body names that the file uses.
  std::string name_B;
  ContactQuery contact;
  ContactExpectation expect;
  std::optional<ToleranceOverride> tolerance;
  std::vector<Indictment> indicts;
  FilePlaces places;  ///< Where it says so.
};

}  // namespace touchstone
