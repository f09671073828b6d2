#include "tests/reports/specimens.h"

#include <Eigen/Geometry>

namespace touchstone {
namespace {

constexpr double kHeight = 0.1;  // [m], height of A's upper face above its origin
const Eigen::Vector3d kHalfExtents(0.3, 0.2, kHeight);

/** The rounding of the specimens' doubles: 2^-48 is 32 roundings of a scene below 2 m.
 [m] */
constexpr double kRounded = 0x1p-48;

ContactTruth TruthOf(double depth, const Eigen::Vector3d& n_AB_W,
                     const Eigen::Vector3d& p_WC) {
  ContactTruth truth;
  truth.touching = depth > 0 ? Touching::kTouching : Touching::kApart;
  truth.separation = {-depth - kRounded, -depth + kRounded};
  truth.input_rounding = kRounded;
  truth.certificate = {n_AB_W, p_WC + n_AB_W * (depth / 2), p_WC - n_AB_W * (depth / 2)};
  truth.method = "drawing";
  return truth;
}

/** Returns an answer with every field, with contacts at the points `p_WCs` where
 touching. */
ContactAnswer AnswerOf(const ContactTruth& truth, double depth,
                       const std::vector<Eigen::Vector3d>& p_WCs) {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  answer.touching = depth > 0;
  answer.n_AB_W = truth.certificate.n_AB_W;
  answer.separation = -depth;
  if (depth > 0) {
    for (const Eigen::Vector3d& p_WC : p_WCs) answer.points.push_back({p_WC, -depth, {}});
  } else {
    answer.witnesses = {truth.certificate.p_WCa, truth.certificate.p_WCb};
  }
  return answer;
}

}  // namespace

Pose AwkwardPose() {
  return Pose::FromQuaternion({0.31, -0.47, 0.73},
                              Eigen::Quaterniond(0.77, -0.31, 0.41, 0.37).normalized());
}

Pose Placed(const Pose& pose, const Eigen::Vector3d& p_B, const Eigen::Matrix3d& R) {
  return Pose::FromMatrix(pose * p_B, pose.R_WB * R);
}

Specimen SphereInBoxFace(double depth) {
  constexpr double r = 1.0 / 3;
  const Pose X_WA = AwkwardPose();
  Specimen specimen;
  specimen.query.A = {Box{kHalfExtents}, X_WA};
  specimen.query.B = {Sphere{r}, Placed(X_WA, {0.07, -0.03, kHeight + r - depth})};
  const Eigen::Vector3d p_WC = X_WA * Eigen::Vector3d(0.07, -0.03, kHeight - depth / 2);
  specimen.truth = TruthOf(depth, X_WA.R_WB.col(2), p_WC);
  specimen.right = AnswerOf(specimen.truth, depth, {p_WC});
  return specimen;
}

Specimen BoxOnBoxFace(double depth) {
  const Eigen::Vector3d half(0.06, 0.05, 0.11);
  const Pose X_WA = AwkwardPose();
  const Eigen::Matrix3d yaw =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d p_A(0.07, -0.03, kHeight + half.z() - depth);
  Specimen specimen;
  specimen.query.A = {Box{kHalfExtents}, X_WA};
  specimen.query.B = {Box{half}, Placed(X_WA, p_A, yaw)};
  std::vector<Eigen::Vector3d> corners;
  for (const auto& [x, y] : {std::pair(1, 1), {-1, 1}, {-1, -1}, {1, -1}}) {
    const Eigen::Vector3d corner_B(x * half.x(), y * half.y(), depth / 2 - half.z());
    corners.push_back(X_WA * (p_A + yaw * corner_B));
  }
  specimen.truth = TruthOf(depth, X_WA.R_WB.col(2), corners.front());
  specimen.right = AnswerOf(specimen.truth, depth, corners);
  return specimen;
}

ContactPatch LowerFaceOf(const Specimen& box_on_box) {
  ContactPatch patch;
  for (const ContactPoint& contact : box_on_box.right.points)
    patch.vertices_W.push_back(contact.p_WC);
  patch.least_contacts = 4;
  return patch;
}

Specimen SphereInHalfSpace(double depth) {
  constexpr double r = 1.0 / 3;
  const Pose X_WA = AwkwardPose();
  Specimen specimen;
  specimen.query.A = {HalfSpace{}, X_WA};
  specimen.query.B = {Sphere{r}, Placed(X_WA, {0.7, -0.3, r - depth})};
  const Eigen::Vector3d p_WC = X_WA * Eigen::Vector3d(0.7, -0.3, -depth / 2);
  specimen.truth = TruthOf(depth, X_WA.R_WB.col(2), p_WC);
  specimen.right = AnswerOf(specimen.truth, depth, {p_WC});
  return specimen;
}

}  // namespace touchstone
