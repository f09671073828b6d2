#include "cli/body_text.h"

#include <array>
#include <charconv>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cli/did_you_mean.h"
#include "cli/input_error.h"
#include "reports/text/counted.h"

namespace touchstone {
namespace {

std::vector<std::string_view> WordsOf(std::string_view text) {
  constexpr std::string_view kSeparators = " \t\n,";
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_not_of(kSeparators, at);
    if (begin == std::string_view::npos) break;
    at = std::min(text.find_first_of(kSeparators, begin), text.size());
    words.push_back(text.substr(begin, at - begin));
  }
  return words;
}

class BodyReader {
 public:
  explicit BodyReader(std::string_view text) : text_(text), words_(WordsOf(text)) {}

  Body Read() {
    Body body;
    body.shape = ReadShape();
    Eigen::Vector3d p_WB = Eigen::Vector3d::Zero();
    if (Skip("@")) {
      const std::vector<double> xyz = Numbers("@", "three numbers", 3);
      p_WB = Eigen::Vector3d(xyz[0], xyz[1], xyz[2]);
    }
    body.X_WB = ReadOrientation(p_WB);
    if (at_ < words_.size())
      Fail(fmt::format("has unexpected text at '{}'", words_[at_]));
    return body;
  }

 private:
  [[noreturn]] void Fail(const std::string& what) const {
    throw InputError(
        fmt::format("the body '{}' {}; expected\n{}", text_, what, kBodySyntax));
  }

  bool Skip(std::string_view word) {
    if (at_ == words_.size() || words_[at_] != word) return false;
    ++at_;
    return true;
  }

  // Returns all numbers up to the next word that is not a number.
  std::vector<double> Numbers() {
    std::vector<double> numbers;
    for (; at_ < words_.size(); ++at_) {
      const std::string_view word = words_[at_];
      double number = 0;
      const auto [end, error] =
          std::from_chars(word.data(), word.data() + word.size(), number);
      if (end != word.data() + word.size()) break;
      if (error == std::errc::result_out_of_range)
        Fail(fmt::format("has '{}', which is beyond the range of a double", word));
      if (error != std::errc()) break;
      numbers.push_back(number);
    }
    return numbers;
  }

  std::vector<double> Numbers(std::string_view of, std::string_view what,
                              std::size_t count) {
    std::vector<double> numbers = Numbers();
    if (numbers.size() != count) {
      Fail(fmt::format("has {} after '{}', which takes {}",
                       Counted(numbers.size(), "number"), of, what));
    }
    return numbers;
  }

  Shape ReadShape() {
    if (words_.empty()) Fail("is empty");
    const std::string_view name = words_[at_++];
    if (name == "sphere") return Sphere{Numbers(name, "a radius", 1)[0]};
    if (name == "box") {
      const std::vector<double> h = Numbers(name, "three half extents", 3);
      return Box{{h[0], h[1], h[2]}};
    }
    if (name == "capsule") {
      const std::vector<double> sizes = Numbers(name, "a radius and a half length", 2);
      return Capsule{sizes[0], sizes[1]};
    }
    if (name == "cylinder") {
      const std::vector<double> sizes = Numbers(name, "a radius and a half length", 2);
      return Cylinder{sizes[0], sizes[1]};
    }
    if (name == "cone") {
      const std::vector<double> sizes = Numbers(name, "a radius and a half height", 2);
      return Cone{sizes[0], sizes[1]};
    }
    if (name == "half_space") return HalfSpace{};
    if (name == "convex_hull") return ReadHull();
    FailOnShape(name);
  }

  Shape ReadHull() {
    const std::vector<double> numbers = Numbers();
    if (numbers.empty() || numbers.size() % 3 != 0) {
      Fail(fmt::format("has {} after 'convex_hull', which takes three per vertex",
                       Counted(numbers.size(), "number")));
    }
    ConvexHull hull;
    for (std::size_t i = 0; i < numbers.size(); i += 3) {
      hull.vertices.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    }
    return hull;
  }

  [[noreturn]] void FailOnShape(std::string_view name) const {
    std::array<std::string_view, kShapeKinds> names;
    for (int i = 0; i < kShapeKinds; ++i) {
      names[static_cast<std::size_t>(i)] = NameOf(static_cast<ShapeKind>(i));
    }
    Fail(fmt::format("begins with '{}', which is not a shape{}", name,
                     DidYouMean(name, names)));
  }

  Pose ReadOrientation(const Eigen::Vector3d& p_WB) {
    if (Skip("q")) {
      const std::vector<double> wxyz = Numbers("q", "four numbers", 4);
      Eigen::Quaterniond q_WB(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
      // Squares of the components may overflow or vanish.
      const double largest = q_WB.coeffs().cwiseAbs().maxCoeff();
      if (!(largest > 0)) Fail("has a zero quaternion, which is not a rotation");
      q_WB.coeffs() /= largest;
      q_WB.normalize();
      return Pose::FromQuaternion(p_WB, q_WB);
    }
    if (Skip("R")) {
      const std::vector<double> rows = Numbers("R", "nine numbers", 9);
      Eigen::Matrix3d R_WB;
      R_WB << rows[0], rows[1], rows[2], rows[3], rows[4], rows[5], rows[6], rows[7],
          rows[8];
      return Pose::FromMatrix(p_WB, R_WB);
    }
    return Pose::FromQuaternion(p_WB, Eigen::Quaterniond::Identity());
  }

  std::string_view text_;
  std::vector<std::string_view> words_;
  std::size_t at_ = 0;
};

}  // namespace

Body ParseBody(std::string_view text) {
  return BodyReader(text).Read();
}

}  // namespace touchstone
