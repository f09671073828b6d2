/** Jolt Physics in single precision, from its npm package.
 *
 * - contact(): TransformedShape.CollideShape(), the closest or deepest points of two shapes.
 * - worlds: JoltInterface.Step(), one thread.
 *
 * Jolt's capsule, cylinder and tapered cylinder have the axis y. */

import * as common from "../node/adapter.mjs";
import { about } from "./about.mjs";

const loaded = await common.load("jolt-physics/dist/jolt-physics.wasm-compat.js");
const Jolt = await loaded.default({ print: console.error, printErr: console.error });

/** Collision layers: static bodies, moving bodies, and bodies that pass through everything. */
const LAYERS = { still: 0, moving: 1, ghost: 2 };

/** Returns an engine without bodies. The first one also registers the types of shapes. */
function newEngine() {
  const pairs = new Jolt.ObjectLayerPairFilterTable(3);
  pairs.EnableCollision(LAYERS.moving, LAYERS.moving);
  pairs.EnableCollision(LAYERS.moving, LAYERS.still);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(3, 3);
  for (const layer of Object.values(LAYERS)) {
    const broad_phase_layer = new Jolt.BroadPhaseLayer(layer);
    layers.MapObjectToBroadPhaseLayer(layer, broad_phase_layer);
    Jolt.destroy(broad_phase_layer);
  }
  const settings = new Jolt.JoltSettings();
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter =
    new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 3, pairs, 3);
  const engine = new Jolt.JoltInterface(settings); // It owns the three filters.
  Jolt.destroy(settings);
  return engine;
}

Jolt.destroy(newEngine());

// Objects that this adapter made for a call and must free after it.
const temporary = [];
const make = (Class, ...inputs) => {
  temporary.push(new Class(...inputs));
  return temporary.at(-1);
};
const freeTemporary = () => temporary.splice(0).forEach((object) => Jolt.destroy(object));

const toVec3 = ([x, y, z]) => make(Jolt.Vec3, x, y, z);
const toRVec3 = ([x, y, z]) => make(Jolt.RVec3, x, y, z);
const toQuat = ([w, x, y, z]) => make(Jolt.Quat, x, y, z, w);
const fromVec3 = (v) => [v.GetX(), v.GetY(), v.GetZ()];
const fromQuat = (q) => [q.GetW(), q.GetX(), q.GetY(), q.GetZ()];

/** Returns the settings of a shape whose origin is that of the body. [m] */
function settingsOf(body, convex_radius) {
  switch (body.shape) {
    case "sphere":
      return new Jolt.SphereShapeSettings(body.radius);
    case "box":
      return new Jolt.BoxShapeSettings(toVec3(body.half_extents), convex_radius);
    case "capsule":
      return new Jolt.CapsuleShapeSettings(body.half_length, body.radius);
    case "cylinder":
      return new Jolt.CylinderShapeSettings(body.half_length, body.radius, convex_radius);
    case "cone":
      return new Jolt.TaperedCylinderShapeSettings(body.half_height, 0, body.radius, 0);
    case "convex_hull": {
      common.requireVertices(body, 3);
      const settings = new Jolt.ConvexHullShapeSettings();
      body.vertices.forEach((vertex) => settings.mPoints.push_back(toVec3(vertex)));
      settings.mMaxConvexRadius = convex_radius;
      settings.mHullTolerance = 0;
      return settings;
    }
    default:
      return new Jolt.PlaneShapeSettings(make(Jolt.Plane, toVec3([0, 0, 1]), 0));
  }
}

/** Returns the shape of settings, with a reference that the caller must release. */
function shapeOf(settings) {
  settings.AddRef(); // The last reference to the settings deletes them.
  try {
    const result = settings.Create();
    if (result.HasError()) throw new Error(`Jolt: ${result.GetError().c_str()}`);
    const shape = result.Get();
    shape.AddRef();
    return shape;
  } finally {
    settings.Release();
  }
}

const rotationOf = (body) => toQuat(common.turnedToAxis(body, common.Y_TO_Z));

/** Returns the deepest hit of B by A among those within a distance, or null. [m] */
function collide(A, B, placed_A, placed_B, distance) {
  const settings = make(Jolt.CollideShapeSettings);
  settings.mMaxSeparationDistance = distance;
  const collector = make(Jolt.CollideShapeCollectorJS);
  let deepest = null;
  collector.Reset = () => {};
  collector.OnBody = () => {};
  collector.AddHit = (pointer) => {
    const hit = Jolt.wrapPointer(pointer, Jolt.CollideShapeResult);
    const separation = -hit.mPenetrationDepth;
    if (deepest && deepest.separation <= separation) return;
    deepest = {
      separation,
      p_A: fromVec3(hit.mContactPointOn1),
      p_B: fromVec3(hit.mContactPointOn2),
      normal: common.unit(fromVec3(hit.mPenetrationAxis)),
    };
  };
  placed_B.CollideShape(placed_A.mShape, toVec3([1, 1, 1]), placed_A.GetCenterOfMassTransform(),
    settings, toRVec3([0, 0, 0]), collector, make(Jolt.ShapeFilter));
  return deepest;
}

function placed(body, shape) {
  const result = make(Jolt.TransformedShape);
  result.mShape = shape;
  result.SetWorldTransform(toRVec3(body.position), rotationOf(body), toVec3([1, 1, 1]));
  return result;
}

function contact(A, B) {
  const shapes = [];
  try {
    for (const body of [A, B]) shapes.push(shapeOf(settingsOf(body, 0)));
    const [placed_A, placed_B] = [placed(A, shapes[0]), placed(B, shapes[1])];
    const hit = collide(A, B, placed_A, placed_B, 0)
      ?? collide(A, B, placed_A, placed_B, common.farthestApart(A, B));
    if (!hit) return { touching: false };
    return common.fromWitnesses(hit.p_A, hit.p_B, hit.normal, hit.separation);
  } finally {
    freeTemporary();
    shapes.forEach((shape) => shape.Release());
  }
}

function begin(question, values) {
  const engine = newEngine();
  const system = engine.GetPhysicsSystem();
  system.SetGravity(toVec3(question.gravity));
  const settings = system.GetPhysicsSettings();
  settings.mNumVelocitySteps = values.velocity_steps;
  settings.mNumPositionSteps = values.position_steps;
  settings.mBaumgarte = values.baumgarte;
  settings.mPenetrationSlop = values.slop;
  settings.mSpeculativeContactDistance = values.speculative_distance;
  settings.mManifoldTolerance = values.manifold_tolerance;
  settings.mMinVelocityForRestitution = values.restitution_threshold;
  settings.mUseBodyPairContactCache = values.pair_cache !== 0;
  settings.mAllowSleeping = values.sleeping !== 0;
  system.SetPhysicsSettings(settings);
  const listener = minimumOfRestitutions();
  system.SetContactListener(listener);
  const bodies = question.bodies.map((body) => addBody(system, body, values));
  question.springs.forEach((spring) => connect(system, bodies, spring, spring.rest_length));
  question.joints.forEach((joint) => connect(system, bodies, joint, joint.length));
  freeTemporary();
  return {
    step() {
      bodies.forEach((body, i) => {
        const { force } = question.bodies[i];
        if (Math.hypot(...force) > 0) system.GetBodyInterface().AddForce(
          body.GetID(), toVec3(force), Jolt.EActivation_Activate); // Jolt clears it after the step.
      });
      engine.Step(question.dt, 1);
      freeTemporary();
    },
    push(i, point, impulse) {
      system.GetBodyInterface().AddImpulse(bodies[i].GetID(), toVec3(impulse), toRVec3(point));
      freeTemporary();
    },
    read: () => bodies.flatMap((body) => [
      ...fromVec3(body.GetCenterOfMassPosition()), ...fromQuat(body.GetRotation()),
      ...fromVec3(body.GetLinearVelocity()), ...fromVec3(body.GetAngularVelocity()),
    ]),
    end() {
      Jolt.destroy(engine);
      Jolt.destroy(listener);
    },
  };
}

/** Returns a listener that combines restitutions as the question does. */
function minimumOfRestitutions() {
  const listener = new Jolt.ContactListenerJS();
  const combine = (body_1, body_2, manifold, settings) => {
    const restitutions = [body_1, body_2]
      .map((pointer) => Jolt.wrapPointer(pointer, Jolt.Body).GetRestitution());
    Jolt.wrapPointer(settings, Jolt.ContactSettings).mCombinedRestitution =
      Math.min(...restitutions);
  };
  listener.OnContactValidate = () => Jolt.ValidateResult_AcceptAllContactsForThisBodyPair;
  listener.OnContactAdded = combine;
  listener.OnContactPersisted = combine;
  listener.OnContactRemoved = () => {};
  return listener;
}

function addBody(system, asked, values) {
  const moves = asked.mass > 0;
  const shape = bodyShape(asked, values.convex_radius);
  const settings = make(Jolt.BodyCreationSettings, shape, toRVec3(asked.position),
    toQuat(asked.quaternion), moves ? Jolt.EMotionType_Dynamic : Jolt.EMotionType_Static,
    !asked.collides ? LAYERS.ghost : moves ? LAYERS.moving : LAYERS.still);
  shape.Release();
  settings.mRestitution = asked.restitution;
  settings.mFriction = asked.friction;
  if (moves) {
    settings.mLinearDamping = values.linear_damping;
    settings.mAngularDamping = values.angular_damping;
    settings.mApplyGyroscopicForce = values.gyroscopic !== 0;
    settings.mMaxLinearVelocity = values.max_speed;
    settings.mMaxAngularVelocity = values.max_spin;
    settings.mMotionQuality =
      values.linear_cast ? Jolt.EMotionQuality_LinearCast : Jolt.EMotionQuality_Discrete;
    settings.mLinearVelocity = toVec3(asked.velocity);
    settings.mAngularVelocity = toVec3(asked.spin);
    settings.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
    settings.mMassPropertiesOverride.mMass = asked.mass;
    settings.mMassPropertiesOverride.mInertia =
      Jolt.Mat44.prototype.sScaleVec3(toVec3(asked.inertia));
  }
  const body = system.GetBodyInterface().CreateBody(settings);
  system.GetBodyInterface().AddBody(body.GetID(), Jolt.EActivation_Activate);
  return body;
}

/** Returns the shape of a body, along its axes and with its centre of mass at its origin. */
function bodyShape(asked, convex_radius) {
  const turned = () => {
    const settings = settingsOf(asked, convex_radius);
    return common.isRoundAboutZ(asked) ? new Jolt.RotatedTranslatedShapeSettings(
      toVec3([0, 0, 0]), toQuat(common.Y_TO_Z), settings) : settings;
  };
  const shape = shapeOf(turned());
  const centre = fromVec3(shape.GetCenterOfMass());
  if (Math.hypot(...centre) === 0) return shape;
  shape.Release();
  return shapeOf(new Jolt.OffsetCenterOfMassShapeSettings(
    toVec3(common.times(centre, -1)), turned()));
}

function connect(system, bodies, link, length) {
  const settings = make(Jolt.DistanceConstraintSettings);
  settings.mSpace = Jolt.EConstraintSpace_LocalToBodyCOM;
  settings.mPoint1 = toRVec3(link.A.point);
  settings.mPoint2 = toRVec3(link.B.point);
  settings.mMinDistance = length;
  settings.mMaxDistance = length;
  if (link.stiffness !== undefined) {
    if (link.stiffness === 0) {
      throw new common.Unsupported("Jolt takes a spring of stiffness 0 for a rigid rod");
    }
    settings.mLimitsSpringSettings.mMode = Jolt.ESpringMode_StiffnessAndDamping;
    settings.mLimitsSpringSettings.mStiffness = link.stiffness;
    settings.mLimitsSpringSettings.mDamping = link.damping;
  }
  const world = Jolt.JoltInterface.prototype.sGetFixedToWorldBody();
  const [A, B] = [link.A, link.B].map((end) => bodies[end.index] ?? world);
  system.AddConstraint(settings.Create(A, B));
}

common.serve({ about, contact, begin });
