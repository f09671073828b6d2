#include "oracles/bullet/closest_points.h"

#include <limits>

#include <BulletCollision/CollisionShapes/btConvexShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

namespace touchstone {
namespace {

/** Stores the point that the detector reports, if it reports one. */
struct ReportedPoint : btDiscreteCollisionDetectorInterface::Result {
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal_on_B, const btVector3& point_on_B,
                       btScalar signed_distance) override {
    reported = true;
    n_BA_W = normal_on_B;
    p_WCb = point_on_B;
    distance = signed_distance;
  }

  bool reported = false;
  btVector3 n_BA_W{0, 0, 0};
  btVector3 p_WCb{0, 0, 0};
  btScalar distance = std::numeric_limits<btScalar>::quiet_NaN();
};

ReportedPoint Detect(const BulletPair& pair) {
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(static_cast<const btConvexShape*>(pair.A.shape()),
                             static_cast<const btConvexShape*>(pair.B.shape()), &simplex,
                             &depth);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = pair.A.X_WB();
  input.m_transformB = pair.B.X_WB();
  ReportedPoint point;
  detector.getClosestPoints(input, point, nullptr);
  return point;
}

}  // namespace

ContactAnswer ClosestPoints::Answer(const BulletPair& pair) {
  ContactAnswer answer;
  answer.status = AnswerStatus::kAnswered;
  const ReportedPoint point = Detect(pair);
  if (!point.reported) return answer;  // Bullet itself takes no point as no contact.
  const double separation = point.distance;
  const Eigen::Vector3d n_BA_W = FromBullet(point.n_BA_W);
  const Eigen::Vector3d p_WCb = FromBullet(point.p_WCb);
  answer.touching = separation <= 0;
  answer.n_AB_W = -n_BA_W;
  answer.separation = separation;
  answer.witnesses = WitnessPoints{p_WCb + n_BA_W * separation, p_WCb};
  return answer;
}

double ClosestPoints::Separation(const BulletPair& pair) {
  return Detect(pair).distance;
}

}  // namespace touchstone
