#include "tests/engine/random_boxes.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "tests/engine/quad_boxes.h"

namespace cookbook::test {
namespace {

Box AnyBox(Random& random) {
  return {{random.Between(0.1, 2), random.Between(0.1, 2), random.Between(0.1, 2)}};
}

/** Returns an offset from A to B of up to 0.8 of the sum of their half diagonals. */
Eigen::Vector3d Nearby(Random& random, const Box& A, const Box& B) {
  const double reach = A.half_extents.norm() + B.half_extents.norm();
  return random.Within(0.8) * reach;
}

BoxQuestion NearlyParallel(Random& random) {
  BoxQuestion question = AnyBoxes(random);
  const double angle = std::pow(10, -random.Between(0, 16));
  const int axis = random.Below(6);  // Half the time an axis of A, else any.
  const Eigen::Vector3d about =
      axis < 3 ? Eigen::Vector3d::Unit(axis) : random.Direction();
  // The labels of B's axes are permuted as well, so that a_i may be near any b_j.
  Eigen::Matrix3d labels = Eigen::Matrix3d::Identity();
  const int shift = random.Below(3);
  for (int k = 0; k < 3; ++k) labels.col(k) = Eigen::Vector3d::Unit((k + shift) % 3);
  question.X_WB.R_WB = question.X_WA.R_WB * Turn(about, angle) * labels;
  return question;
}

BoxQuestion SharedAxisExactly(Random& random) {
  BoxQuestion question = AnyBoxes(random);
  const double angle = random.Between(0, 3);
  question.X_WB.R_WB =
      question.X_WA.R_WB * Turn(Eigen::Vector3d::Unit(random.Below(3)), angle);
  if (random.Below(2) == 0) question.X_WB.R_WB = question.X_WA.R_WB;
  return question;
}

BoxQuestion Contained(Random& random) {
  BoxQuestion question = AnyBoxes(random);
  question.B.half_extents *= 0.05;
  question.X_WB.p_WB =
      question.X_WA.p_WB +
      question.X_WA.R_WB *
          Eigen::Vector3d(question.A.half_extents.cwiseProduct(random.InCube()));
  if (random.Below(8) == 0) question.X_WB.p_WB = question.X_WA.p_WB;
  return question;
}

/** Puts B where the greatest gap is ±10⁻ᵘ, u between 1 and 17. */
BoxQuestion NearlyTouching(Random& random) {
  BoxQuestion question = AnyBoxes(random);
  if (random.Below(3) == 0) question = NearlyParallel(random);
  const Eigen::Vector3d direction = random.Direction();
  const double size = std::pow(10, -random.Between(1, 17));
  const double wanted = random.Below(2) == 0 ? -size : size;
  question.X_WB.p_WB =
      question.X_WA.p_WB + direction * DistanceForGap({question.A, question.X_WA},
                                                      {question.B, question.X_WB},
                                                      direction, wanted);
  return question;
}

BoxQuestion SlabsAndNeedles(Random& random) {
  BoxQuestion question = AnyBoxes(random);
  for (Box* box : {&question.A, &question.B}) {
    for (int k = 0; k < 3; ++k) {
      if (random.Below(2) == 0) box->half_extents[k] *= 1e-4;
    }
  }
  if (random.Below(2) == 0) question.X_WB.R_WB = NearlyParallel(random).X_WB.R_WB;
  question.X_WB.p_WB =
      question.X_WA.p_WB +
      question.X_WA.R_WB *
          Eigen::Vector3d(question.A.half_extents.cwiseProduct(random.Direction()));
  return question;
}

BoxQuestion Scaled(BoxQuestion question, double scale) {
  question.A.half_extents *= scale;
  question.B.half_extents *= scale;
  question.X_WA.p_WB *= scale;
  question.X_WB.p_WB *= scale;
  return question;
}

BoxQuestion Small(Random& random) {
  return Scaled(AnyBoxes(random), 1e-3);
}
BoxQuestion Large(Random& random) {
  return Scaled(NearlyParallel(random), 1e3);
}

BoxQuestion FarFromOrigin(Random& random) {
  BoxQuestion question = NearlyParallel(random);
  const Eigen::Vector3d away = random.Direction() * 1e6;
  question.X_WA.p_WB += away;
  question.X_WB.p_WB += away;
  return question;
}

}  // namespace

double Random::Between(double low, double high) {
  return low + (high - low) * (static_cast<double>(generator_() >> 11) * 0x1p-53);
}

double Random::LogBetween(double low, double high) {
  return std::exp(Between(std::log(low), std::log(high)));
}

int Random::Below(int count) {
  return static_cast<int>(generator_() % static_cast<std::uint64_t>(count));
}

Eigen::Vector3d Random::InCube() {
  const double z = Between(-1, 1);
  const double y = Between(-1, 1);
  const double x = Between(-1, 1);
  return {x, y, z};
}

Eigen::Vector3d Random::Within(double reach) {
  const double distance = Between(0, reach);
  return distance * Direction();
}

Eigen::Vector3d Random::Direction() {
  for (;;) {
    const Eigen::Vector3d v = InCube();
    const double squared = v.squaredNorm();
    if (squared > 0.01 && squared <= 1) return v / std::sqrt(squared);
  }
}

Eigen::Matrix3d Random::Rotation() {
  // Shoemake, Uniform random rotations, Graphics Gems III, 1992.
  const double u = Between(0, 1);
  const double v = Between(0, 2 * std::numbers::pi);
  const double w = Between(0, 2 * std::numbers::pi);
  Eigen::Quaterniond q(std::sqrt(u) * std::cos(w), std::sqrt(1 - u) * std::sin(v),
                       std::sqrt(1 - u) * std::cos(v), std::sqrt(u) * std::sin(w));
  return q.normalized().toRotationMatrix();
}

Eigen::Matrix3d Turn(const Eigen::Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

BoxQuestion AnyBoxes(Random& random) {
  BoxQuestion question;
  question.A = AnyBox(random);
  question.B = AnyBox(random);
  question.X_WA.R_WB = random.Rotation();
  question.X_WB.R_WB = random.Rotation();
  question.X_WA.p_WB = random.Within(3);
  question.X_WB.p_WB = question.X_WA.p_WB + Nearby(random, question.A, question.B);
  return question;
}

const std::vector<Family>& Families() {
  static const std::vector<Family> families = {
      {"Any", AnyBoxes},
      {"NearlyParallel", NearlyParallel},
      {"SharedAxis", SharedAxisExactly},
      {"Contained", Contained},
      {"NearlyTouching", NearlyTouching},
      {"SlabsAndNeedles", SlabsAndNeedles},
      {"Small", Small},
      {"Large", Large},
      {"FarFromOrigin", FarFromOrigin},
  };
  return families;
}

}  // namespace cookbook::test
