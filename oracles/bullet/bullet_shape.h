#pragma once

#include <memory>

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/CollisionShapes/btCollisionShape.h>
#include <Eigen/Core>

#include "scenarios/contact_query.h"

namespace touchstone {

/** Returns `x` rounded to Bullet's scalar. */
inline btScalar ToBullet(double x) {
  return static_cast<btScalar>(x);
}

/** Returns `v` in Bullet's type, rounded. */
inline btVector3 ToBullet(const Eigen::Vector3d& v) {
  return {ToBullet(v.x()), ToBullet(v.y()), ToBullet(v.z())};
}

/** Returns the pose in Bullet's type, rounded. */
btTransform ToBullet(const Pose& X_WB);

/** Returns `shape` in Bullet's type. `margin` enlarges hulls and cones, and rounds boxes
 and cylinders within their size; 0 keeps every shape as it is. [m] */
std::unique_ptr<btCollisionShape> ToBullet(const Shape& shape, btScalar margin);

/** A body in Bullet's types. Its shape is exact up to rounding to btScalar: every margin
 that would round or enlarge it is 0. */
class BulletBody {
 public:
  explicit BulletBody(const Body& body);

  const btCollisionShape* shape() const { return shape_.get(); }
  const btTransform& X_WB() const { return object_.getWorldTransform(); }
  const btCollisionObject* object() const { return &object_; }

 private:
  std::unique_ptr<btCollisionShape> shape_;
  btCollisionObject object_;
};

/** The two bodies of a query in Bullet's types. */
struct BulletPair {
  explicit BulletPair(const ContactQuery& query) : A(query.A), B(query.B) {}

  BulletBody A;
  BulletBody B;
};

/** Returns `v` in the project's type. */
inline Eigen::Vector3d FromBullet(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace touchstone
