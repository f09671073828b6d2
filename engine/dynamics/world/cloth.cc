#include "engine/dynamics/world/cloth.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace cookbook {
namespace {

void Expect(bool holds, const char* what, double value, const char* expected) {
  if (holds) return;
  std::ostringstream sentence;
  sentence << "The " << what << " of a cloth is " << value << "; expected " << expected
           << ".";
  throw std::invalid_argument(sentence.str());
}

bool IsPositive(double value) {
  return value > 0 && std::isfinite(value);
}

bool IsNotNegative(double value) {
  return value >= 0 && std::isfinite(value);
}

void Validate(const Cloth& cloth) {
  Expect(cloth.n >= 3, "n", cloth.n, "at least 3 nodes along a side");
  Expect(IsPositive(cloth.spacing), "spacing", cloth.spacing, "a positive finite number");
  Expect(IsPositive(cloth.node_mass), "node mass", cloth.node_mass,
         "a positive finite number");
  Expect(IsNotNegative(cloth.drag), "drag", cloth.drag, "a finite number >= 0");
  Expect(cloth.bounce >= 0 && cloth.bounce <= 1, "bounce", cloth.bounce,
         "a number in [0, 1]");
  for (const double x : cloth.centre_W) {
    Expect(std::isfinite(x), "centre", x, "finite numbers");
  }
  for (const ClothSprings& springs : {cloth.structural, cloth.shear, cloth.bend}) {
    Expect(IsNotNegative(springs.stiffness), "stiffness", springs.stiffness,
           "a finite number >= 0");
    Expect(IsNotNegative(springs.damping), "damping", springs.damping,
           "a finite number >= 0");
  }
  for (const auto& [row, column] : cloth.pinned) {
    for (const int index : {row, column}) {
      Expect(index >= 0 && index < cloth.n, "pinned node", index,
             "a row and a column in [0, n)");
    }
  }
}

}  // namespace

int AddCloth(const Cloth& cloth, World& world) {
  Validate(cloth);
  const int n = cloth.n;
  const double middle = 0.5 * (n - 1);
  const auto index_of = [n](int row, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(n) +
           static_cast<std::size_t>(column);
  };
  std::vector<double> masses(index_of(n, 0), cloth.node_mass);
  for (const auto& [row, column] : cloth.pinned) masses[index_of(row, column)] = 0;
  const int first = world.body_count();
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      BodyDefinition node;
      node.shape = Point{};
      node.state.p_WB = cloth.centre_W +
                        cloth.spacing * Eigen::Vector3d(column - middle, 0, row - middle);
      node.mass = masses[index_of(row, column)];
      node.restitution = cloth.bounce;
      node.drag = cloth.drag;
      world.AddBody(node);
    }
  }
  const auto join = [&](const ClothSprings& springs, int row, int column, int down,
                        int right) {
    if (row + down >= n || column + right >= n || column + right < 0) return;
    Spring spring;
    spring.A.body = first + row * n + column;
    spring.B.body = first + (row + down) * n + column + right;
    spring.stiffness = springs.stiffness;
    spring.damping = springs.damping;
    spring.rest_length = cloth.spacing * std::hypot(down, right);
    world.AddSpring(spring);
  };
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      join(cloth.structural, row, column, 0, 1);
      join(cloth.structural, row, column, 1, 0);
      join(cloth.shear, row, column, 1, 1);
      join(cloth.shear, row, column, 1, -1);
      join(cloth.bend, row, column, 0, 2);
      join(cloth.bend, row, column, 2, 0);
    }
  }
  return first;
}

}  // namespace cookbook
