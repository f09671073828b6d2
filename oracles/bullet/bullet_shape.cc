#include "oracles/bullet/bullet_shape.h"

#include <algorithm>
#include <variant>

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>

namespace touchstone {
namespace {

/* Returns a shape whose margin is within its half extents, and at most a tenth of them,
 as Bullet's constructors have it. Bullet stores half extents minus the margin, and adds
 the margin back when it changes. This round trip loses digits of a small shape, so the
 half extents are set once more. */
template <typename BulletShape>
std::unique_ptr<btCollisionShape> Rounded(const btVector3& half_extents,
                                          btScalar margin) {
  auto shape = std::make_unique<BulletShape>(half_extents);
  const btScalar least = half_extents[half_extents.minAxis()];
  const btScalar inner = std::min(margin, btScalar(0.1) * least);
  shape->setMargin(inner);
  shape->setImplicitShapeDimensions(half_extents - btVector3(inner, inner, inner));
  return shape;
}

struct MakeShape {
  using Result = std::unique_ptr<btCollisionShape>;

  btScalar margin;

  Result operator()(const Sphere& sphere) const {
    return std::make_unique<btSphereShape>(ToBullet(sphere.radius));
  }
  Result operator()(const Box& box) const {
    return Rounded<btBoxShape>(ToBullet(box.half_extents), margin);
  }
  Result operator()(const Capsule& capsule) const {
    return std::make_unique<btCapsuleShapeZ>(ToBullet(capsule.radius),
                                             ToBullet(2 * capsule.half_length));
  }
  Result operator()(const Cylinder& cylinder) const {
    const btVector3 half_extents(ToBullet(cylinder.radius), ToBullet(cylinder.radius),
                                 ToBullet(cylinder.half_length));
    return Rounded<btCylinderShapeZ>(half_extents, margin);
  }
  Result operator()(const Cone& cone) const {
    auto shape = std::make_unique<btConeShapeZ>(ToBullet(cone.radius),
                                                ToBullet(2 * cone.half_height));
    shape->setMargin(margin);
    return shape;
  }
  Result operator()(const ConvexHull& hull) const {
    auto shape = std::make_unique<btConvexHullShape>();
    for (const Eigen::Vector3d& vertex : hull.vertices) {
      shape->addPoint(ToBullet(vertex), false);
    }
    shape->setMargin(margin);
    shape->recalcLocalAabb();
    return shape;
  }
  Result operator()(const HalfSpace&) const {
    auto shape = std::make_unique<btStaticPlaneShape>(btVector3(0, 0, 1), btScalar(0));
    shape->setMargin(0);
    return shape;
  }
};

}  // namespace

btTransform ToBullet(const Pose& X_WB) {
  const Eigen::Matrix3d& R = X_WB.R_WB;
  const btMatrix3x3 basis(ToBullet(R(0, 0)), ToBullet(R(0, 1)), ToBullet(R(0, 2)),
                          ToBullet(R(1, 0)), ToBullet(R(1, 1)), ToBullet(R(1, 2)),
                          ToBullet(R(2, 0)), ToBullet(R(2, 1)), ToBullet(R(2, 2)));
  return btTransform(basis, ToBullet(X_WB.p_WB));
}

std::unique_ptr<btCollisionShape> ToBullet(const Shape& shape, btScalar margin) {
  return std::visit(MakeShape{margin}, shape);
}

BulletBody::BulletBody(const Body& body) : shape_(ToBullet(body.shape, 0)) {
  object_.setCollisionShape(shape_.get());
  object_.setWorldTransform(ToBullet(body.X_WB));
}

}  // namespace touchstone
