// Tests of the referee against an exact computation that shares nothing with it. For each
// family the enclosure must always contain the exact value and be as narrow as promised.

#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "reports/referee/referee.h"
#include "tests/reports/referee/exact_separation.h"
#include "tests/reports/referee/random_scene.h"

namespace touchstone {
namespace {

double UlpOf(const ContactQuery& query) {
  return std::numeric_limits<double>::epsilon() * SceneSize(query);
}

/** Returns a rotation by a tiny angle about a random axis. */
Eigen::Quaterniond Tilt(RandomScene& random, double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, random.Point(1).normalized()));
}

/** Expects the exact value inside a narrow enclosure and returns the number of touching
 pairs. */
int ExpectExact(std::uint64_t seed, int pairs,
                const std::function<ContactQuery(RandomScene&)>& family) {
  RandomScene random(seed);
  int touching = 0;
  for (int i = 0; i < pairs; ++i) {
    const ContactQuery query = family(random);
    const ContactTruth truth = ComputeContactTruth(query);
    const ExactComparison exact = CompareExactly(query, truth.separation);
    EXPECT_TRUE(exact.lo_holds) << "pair " << i << ", lo " << truth.separation.lo;
    EXPECT_TRUE(exact.hi_holds) << "pair " << i << ", hi " << truth.separation.hi;
    EXPECT_LE(truth.separation.hi - truth.separation.lo, 8 * UlpOf(query))
        << "pair " << i;
    touching += exact.separation < 0;
  }
  return touching;
}

ContactQuery At(RandomScene& random, const Shape& A, const Shape& B, double distance) {
  const Eigen::Vector3d p = random.Point(1);
  return {{A, Pose::FromQuaternion(p, random.Rotation())},
          {B, Pose::FromQuaternion(p + random.Point(distance), random.Rotation())}};
}

TEST(ExactKernel, AgreesOnRandomBoxesAndHulls) {
  const int touching = ExpectExact(1, 40, [](RandomScene& random) {
    const Shape A = random.SomeHull(0.7, 9);
    return At(random, A, random.SomeBox(0.8), 1.2);
  });
  EXPECT_GT(touching, 10);
  EXPECT_LT(touching, 35);
}

TEST(ExactKernel, AgreesOnEdgesThatAreAlmostParallel) {
  ExpectExact(2, 40, [](RandomScene& random) {
    ContactQuery query = At(random, random.SomeBox(1), random.SomeBox(1), 1);
    const Eigen::Quaterniond q = *query.A.X_WB.q_WB * Tilt(random, random.Power(-17, -3));
    query.B.X_WB = Pose::FromQuaternion(query.B.X_WB.p_WB, q.normalized());
    return query;
  });
}

TEST(ExactKernel, AgreesOnBoxesOfOneOrientation) {
  ExpectExact(3, 20, [](RandomScene& random) {
    ContactQuery query = At(random, random.SomeBox(1), random.SomeBox(1), 1);
    query.B.X_WB = Pose::FromQuaternion(query.B.X_WB.p_WB, *query.A.X_WB.q_WB);
    return query;
  });
}

TEST(ExactKernel, AgreesWhereBodiesTouchToTheRounding) {
  ExpectExact(4, 40, [](RandomScene& random) {
    const Shape A = random.SomeHull(0.7, 8);
    ContactQuery query = At(random, A, random.SomeBox(1), 1);
    const ContactTruth truth = ComputeContactTruth(query);
    query.B.X_WB.p_WB -=
        (truth.separation.lo + random.Uniform(-1, 1) * random.Power(-17, -8)) *
        truth.certificate.n_AB_W;
    return query;
  });
}

TEST(ExactKernel, AgreesOnOneBodyDeepInsideTheOther) {
  ExpectExact(5, 20, [](RandomScene& random) {
    const Shape A = random.SomeHull(2, 10);
    return At(random, A, random.SomeBox(0.1), 0.1);
  });
}

TEST(ExactKernel, AgreesOnNeedlesAndSlabs) {
  ExpectExact(6, 40, [](RandomScene& random) {
    const Box slab{
        {random.Uniform(0.5, 1), random.Uniform(0.5, 1), random.Uniform(0.5, 1) * 1e-4}};
    const Box needle{{random.Uniform(0.5, 1) * 1e-4, random.Uniform(0.5, 1),
                      random.Uniform(0.5, 1) * 1e-4}};
    return At(random, slab, needle, 0.3);
  });
}

TEST(ExactKernel, AgreesAtEveryScale) {
  ExpectExact(7, 20, [](RandomScene& random) {
    const double scale = random.Power(-3, 3);
    const Shape A = random.SomeHull(scale, 7);
    return At(random, A, random.SomeBox(scale * random.Power(-2, 0)), scale);
  });
}

// The hulls have faces of many coplanar vertices, with one vertex inside and one
// repeated.
TEST(ExactKernel, AgreesOnHullsWithCoplanarRepeatedAndInteriorVertices) {
  ExpectExact(8, 20, [](RandomScene& random) {
    ConvexHull hull;
    for (int i = 0; i < 27; ++i) {
      hull.vertices.emplace_back(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    }
    hull.vertices.push_back(hull.vertices[0]);
    return At(random, hull, random.SomeBox(1), 2);
  });
}

// Tests the test itself: it must distinguish an enclosure that misses the exact value by
// less than an ulp of the scene from one that contains it.
TEST(ExactKernel, CatchesAnEnclosureThatIsOffByAnUlp) {
  RandomScene random(9);
  for (int i = 0; i < 10; ++i) {
    const ContactQuery query = At(random, random.SomeBox(1), random.SomeBox(1), 1);
    const Enclosure e = ComputeContactTruth(query).separation;
    const double off = 4 * UlpOf(query) + (e.hi - e.lo);
    EXPECT_FALSE(CompareExactly(query, {e.lo + off, e.hi + off}).lo_holds);
    EXPECT_FALSE(CompareExactly(query, {e.lo - off, e.hi - off}).hi_holds);
  }
}

// Without the edge crosses the candidates are incomplete: the exact kernel then proves
// the least overlap along face normals too large.
TEST(ExactKernel, CatchesCandidatesWithoutEdgeCrosses) {
  RandomScene random(10);
  int caught = 0;
  for (int i = 0; i < 30; ++i) {
    const ContactQuery query = At(random, random.SomeBox(1), random.SomeBox(1), 0.9);
    if (ComputeContactTruth(query).touching != Touching::kTouching) continue;
    Enclosure faces{std::numeric_limits<double>::infinity(), 0};
    for (const Body& body : {query.A, query.B}) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
          const Enclosure overlap = Overlap(query, sign * body.X_WB.R_WB.col(axis));
          if (overlap.lo < faces.lo) faces = overlap;
        }
      }
    }
    caught += !CompareExactly(query, {-faces.hi, -faces.lo}).hi_holds;
  }
  EXPECT_GT(caught, 0);
}

// If edges are parallel to rounding, their cross product in double is noise. It is still
// a valid axis: the overlap along it is never less than the depth.
TEST(ExactKernel, FindsNoAxisOfNoiseThatUndercutsTheDepth) {
  RandomScene random(11);
  for (int i = 0; i < 30; ++i) {
    ContactQuery query = At(random, random.SomeBox(1), random.SomeBox(1), 0.5);
    query.B.X_WB = Pose::FromQuaternion(
        query.B.X_WB.p_WB, (*query.A.X_WB.q_WB * Tilt(random, 1e-16)).normalized());
    const Enclosure separation = ComputeContactTruth(query).separation;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d noise =
          query.A.X_WB.R_WB.col(axis).cross(query.B.X_WB.R_WB.col(axis));
      if (noise.isZero(0)) continue;
      EXPECT_GE(Overlap(query, noise).hi, -separation.hi);
      EXPECT_GE(Overlap(query, -noise).hi, -separation.hi);
    }
  }
}

}  // namespace
}  // namespace touchstone
