#include "engine/dynamics/solver/elastic_foundation.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/engine/dynamics/random.h"

namespace cookbook {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector = ElasticFoundation::Vector;

constexpr double kFriction = 0.6;

/** Bodies with loads and contacts. It has the contacts twice, so that the impulses can be
 summed without the code under test. */
class Structure {
 public:
  int AddBody(const Vector3d& centre, const Vector3d& load,
              const Vector3d& moment = Vector3d::Zero()) {
    Vector required;
    required << -load, -moment;
    bodies_.push_back({centre, -load, -moment});
    return foundation_.AddBody(required);
  }

  /** Adds a pair with contacts at `points`; `n` points out of A, −1 is static. */
  void AddPair(int A, int B, const Vector3d& n, const std::vector<Vector3d>& points) {
    Matrix3d axes;
    axes.col(0) = n;
    axes.col(1) = n.unitOrthogonal();
    axes.col(2) = n.cross(axes.col(1));
    const auto centre = [&](int body) {
      return body < 0 ? Vector3d::Zero().eval()
                      : bodies_[static_cast<std::size_t>(body)].centre;
    };
    foundation_.AddPair(A, B, centre(B) - centre(A), axes, kFriction);
    for (const Vector3d& point : points) {
      foundation_.AddContact(point - centre(B >= 0 ? B : A));
      contacts_.push_back({A, B, point, axes});
    }
  }

  bool Solve() { return foundation_.Solve(); }
  const Vector3d& impulse(std::size_t k) const { return foundation_.impulse(k); }
  std::size_t contact_count() const { return contacts_.size(); }

  /** Expects that the impulses are in their cones and stop each body, up to some
   roundings of their sum. */
  void ExpectBalance() const {
    std::vector<Body> remaining = bodies_;
    std::vector<double> scale;
    for (const Body& body : bodies_) scale.push_back(body.linear.norm());
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const Vector3d& impulse = foundation_.impulse(k);
      const double rounding = 1e-15 * impulse.norm();
      EXPECT_GE(impulse[0], -rounding);
      EXPECT_LE(impulse.tail<2>().norm(), kFriction * impulse[0] + rounding);
      const auto act = [&](int index, const Vector3d& J_W) {
        if (index < 0) return;
        Body& body = remaining[static_cast<std::size_t>(index)];
        body.linear -= J_W;
        body.angular -= (contacts_[k].point - body.centre).cross(J_W);
        scale[static_cast<std::size_t>(index)] += J_W.norm();
      };
      act(contacts_[k].A, -contacts_[k].axes * impulse);
      act(contacts_[k].B, contacts_[k].axes * impulse);
    }
    for (std::size_t i = 0; i < remaining.size(); ++i) {
      EXPECT_LE(remaining[i].linear.norm(), 2e-14 * scale[i]);
      EXPECT_LE(remaining[i].angular.norm(), 1e-13 * scale[i]);
    }
  }

 private:
  struct Body {
    Vector3d centre;
    Vector3d linear;
    Vector3d angular;
  };
  struct Contact {
    int A;
    int B;
    Vector3d point;
    Matrix3d axes;
  };

  ElasticFoundation foundation_;
  std::vector<Body> bodies_;
  std::vector<Contact> contacts_;
};

/** A block of 1 × 1 × 2 `half_height` m on a floor, whose load leans by `slope`. */
Structure Block(double half_height, double slope) {
  Structure structure;
  structure.AddBody({0, 0, half_height}, {slope, 0, -1});
  structure.AddPair(-1, 0, Vector3d::UnitZ(),
                    {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}});
  return structure;
}

TEST(ElasticFoundation, SpreadsALoadLinearlyOverAFace) {
  Structure block = Block(1, 0.25);
  ASSERT_TRUE(block.Solve());
  block.ExpectBalance();
  // Half of the load times its offset of 1/4 m: (1 ± 4/4 · 1/2)/4.
  for (std::size_t k = 0; k < 4; ++k) {
    const double expected = k == 1 || k == 2 ? 0.375 : 0.125;
    EXPECT_NEAR(block.impulse(k)[0], expected, 1e-15) << k;
  }
}

TEST(ElasticFoundation, ABlockSlipsBeyondItsFriction) {
  for (const double fraction : {0.0, 0.9, 1 - 1e-9, 1 + 1e-9, 1.1, 3.0}) {
    Structure block = Block(0.2, fraction * kFriction);
    EXPECT_EQ(block.Solve(), fraction < 1) << fraction;
    if (fraction < 1) block.ExpectBalance();
  }
}

TEST(ElasticFoundation, ABlockTopplesBeyondItsEdge) {
  // The load meets the floor at half_height × slope = 1/2 m.
  for (const double fraction : {0.9, 1 - 1e-9, 1 + 1e-9, 1.1}) {
    Structure block = Block(2, 0.25 * fraction);
    EXPECT_EQ(block.Solve(), fraction < 1) << fraction;
    if (fraction < 1) block.ExpectBalance();
  }
}

/** A ladder of 2 m from a floor to a wall, `angle` from the vertical. */
Structure Ladder(double angle) {
  Structure ladder;
  const double x = 2 * std::sin(angle);
  const double z = 2 * std::cos(angle);
  ladder.AddBody({x / 2, 0, z / 2}, {0, 0, -1});
  ladder.AddPair(-1, 0, Vector3d::UnitZ(), {{x, -0.3, 0}, {x, 0.3, 0}});
  ladder.AddPair(-1, 0, Vector3d::UnitX(), {{0, -0.3, z}, {0, 0.3, z}});
  return ladder;
}

TEST(ElasticFoundation, ALadderSlipsBeyondTheFrictionOfFloorAndWall) {
  // With friction μ at both ends: tan φ <= 2 μ/(1 − μ²).
  const double steepest = std::atan(2 * kFriction / (1 - kFriction * kFriction));
  for (const double fraction : {0.1, 0.5, 0.8, 1.001, 1.2}) {
    Structure ladder = Ladder(fraction * steepest);
    EXPECT_EQ(ladder.Solve(), fraction < 1) << fraction;
    if (fraction < 1) ladder.ExpectBalance();
  }
}

TEST(ElasticFoundation, WallsDoNotHoldWhatNothingPressesOnThem) {
  Structure box;
  box.AddBody({0, 0, 0}, {0, 0, -1});
  for (const double x : {-0.5, 0.5}) {
    box.AddPair(-1, 0, {x < 0 ? 1.0 : -1.0, 0, 0},
                {{x, -0.5, -0.5}, {x, 0.5, -0.5}, {x, 0.5, 0.5}, {x, -0.5, 0.5}});
  }
  EXPECT_FALSE(box.Solve());
}

// Walls of bricks in up to seven layers, each brick on one or two others, with masses
// over two decades and some push each. Most contacts of a few walls are open: these are
// not solved.
TEST(ElasticFoundation, WhatItFindsForRandomWallsBalances) {
  Random random(3);
  int solved = 0;
  constexpr int kWalls = 300;
  for (int trial = 0; trial < kWalls; ++trial) {
    Structure wall;
    const int layers = 2 + trial % 6;
    const int columns = layers + trial % 3;
    std::vector<int> below;
    for (int layer = 0; layer < layers; ++layer) {
      std::vector<int> bricks;
      for (int k = 0; k < columns - layer; ++k) {
        const double mass = random.LogUniform(0.1, 10);
        const Vector3d centre(1.02 * k + 0.51 * layer, random.Uniform(-0.05, 0.05),
                              0.3 + 0.6 * layer);
        const Vector3d push(random.Uniform(-0.02, 0.02), random.Uniform(-0.02, 0.02), 0);
        bricks.push_back(wall.AddBody(centre, mass * (push - Vector3d::UnitZ())));
        const auto stand = [&](int other, double from, double to) {
          const double x = centre.x();
          const double z = 0.6 * layer;
          wall.AddPair(other, bricks.back(), Vector3d::UnitZ(),
                       {{x + from, -0.2, z},
                        {x + to, -0.2, z},
                        {x + to, 0.2, z},
                        {x + from, 0.2, z}});
        };
        if (layer == 0) {
          stand(-1, -0.5, 0.5);
        } else {
          const auto left = static_cast<std::size_t>(k);
          stand(below[left], -0.5, -0.01);
          stand(below[left + 1], 0.01, 0.5);
        }
      }
      below = bricks;
    }
    if (!wall.Solve()) continue;
    ++solved;
    wall.ExpectBalance();
  }
  EXPECT_GT(solved, kWalls * 4 / 5);
}

}  // namespace
}  // namespace cookbook
