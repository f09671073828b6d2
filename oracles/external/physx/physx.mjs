/** PhysX in single precision, from its npm package.
 *
 * - contact(): PxGjkQuery::proximityInfo(), the closest or deepest points of two shapes.
 * - worlds: PxScene::simulate(), no threads.
 *
 * PhysX's capsule, cylinder and cone have the axis x, and its plane has the normal x. */

import { about, PAIR_FLAGS } from "./about.mjs";
import * as common from "../node/adapter.mjs";
import { loadPhysX } from "./load.mjs";

const PhysX = await loadPhysX();
const Px = PhysX.PxTopLevelFunctions.prototype; // Its functions are static.
const version = Px.PHYSICS_VERSION;
about.version = [version >> 24, (version >> 16) & 255, (version >> 8) & 255].join(".");

const foundation = Px.CreateFoundation(
  version, new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback());
const scale = new PhysX.PxTolerancesScale();
const physics = Px.CreatePhysics(version, foundation, scale);
Px.InitExtensions(physics);
const dispatcher = Px.DefaultCpuDispatcherCreate(0);
const filters = new PhysX.PassThroughFilterShaderImpl();

// Objects that this adapter made for a call and must free after it.
const temporary = [];
const make = (Class, ...inputs) => {
  temporary.push(new Class(...inputs));
  return temporary.at(-1);
};
const freeTemporary = () => temporary.splice(0).forEach((object) => PhysX.destroy(object));

const toVec3 = ([x, y, z]) => make(PhysX.PxVec3, x, y, z);
const toTransform = (p, [w, x, y, z]) =>
  make(PhysX.PxTransform, toVec3(p), make(PhysX.PxQuat, x, y, z, w));
const { fromXyz, fromXyzw } = common;

/** Returns the geometry of a body. `meshes` gets what the caller must release. */
function geometryOf(body, meshes) {
  const core = PhysX.PxConvexCoreGeometryFactory.prototype;
  switch (body.shape) {
    case "sphere":
      return make(PhysX.PxSphereGeometry, body.radius);
    case "box":
      return make(PhysX.PxBoxGeometry, ...body.half_extents);
    case "capsule":
      return make(PhysX.PxCapsuleGeometry, body.radius, body.half_length);
    case "cylinder":
      return core.createFromCylinder(
        make(PhysX.PxConvexCoreCylinder, 2 * body.half_length, body.radius), 0);
    case "cone":
      return core.createFromCone(
        make(PhysX.PxConvexCoreCone, 2 * body.half_height, body.radius), 0);
    case "convex_hull":
      common.requireVertices(body, 4);
      meshes.push(meshOf(body.vertices));
      return make(PhysX.PxConvexMeshGeometry, meshes.at(-1));
    default:
      return make(PhysX.PxPlaneGeometry);
  }
}

function meshOf(vertices) {
  const points = make(PhysX.PxArray_PxVec3);
  vertices.forEach((vertex) => points.pushBack(toVec3(vertex)));
  const description = make(PhysX.PxConvexMeshDesc);
  description.points.count = vertices.length;
  description.points.stride = 12;
  description.points.data = points.begin();
  description.flags.raise(PhysX.PxConvexFlagEnum.eCOMPUTE_CONVEX);
  const mesh = Px.CreateConvexMesh(make(PhysX.PxCookingParams, scale), description);
  if (!mesh || PhysX.getPointer(mesh) === 0) throw new Error("PhysX built no hull");
  return mesh;
}

const isAlongX = (body) => common.isRoundAboutZ(body) || body.shape === "half_space";

/** Returns the pose of the geometry of a body. */
function poseOf(body) {
  const q = isAlongX(body) ? common.product(body.quaternion, common.X_TO_Z) : body.quaternion;
  return toTransform(body.position, q);
}

function contact(A, B) {
  const meshes = [];
  try {
    const [support_A, support_B] = [A, B].map(
      (body) => make(PhysX.ConvexGeomSupport, geometryOf(body, meshes), 0));
    const result = make(PhysX.PxGjkQueryProximityInfoResult);
    const found = PhysX.PxGjkQuery.prototype.proximityInfo(
      support_A, support_B, poseOf(A), poseOf(B), common.farthestApart(A, B), 1, result);
    if (!found || !result.success) return { touching: false };
    return common.fromWitnesses(fromXyz(result.pointA), fromXyz(result.pointB),
      common.times(fromXyz(result.separatingAxis), -1), result.separation);
  } finally {
    freeTemporary();
    meshes.forEach((mesh) => mesh.release());
  }
}

function begin(question, values) {
  const description = make(PhysX.PxSceneDesc, scale);
  description.gravity = toVec3(question.gravity);
  description.cpuDispatcher = dispatcher;
  description.solverType = values.tgs ? PhysX.PxSolverTypeEnum.eTGS : PhysX.PxSolverTypeEnum.ePGS;
  description.bounceThresholdVelocity = values.bounce_threshold;
  description.frictionOffsetThreshold = values.friction_offset;
  description.frictionCorrelationDistance = values.friction_correlation;
  const setFlag = (flag, value) => description.flags[value ? "raise" : "clear"](flag);
  setFlag(PhysX.PxSceneFlagEnum.eENABLE_PCM, values.pcm);
  setFlag(PhysX.PxSceneFlagEnum.eENABLE_CCD, values.ccd);
  setFlag(PhysX.PxSceneFlagEnum.eENABLE_FRICTION_EVERY_ITERATION, values.friction_every_iteration);
  filters.filterShader = () => {
    filters.outputPairFlags = values.ccd ? PAIR_FLAGS.with_ccd : PAIR_FLAGS.discrete;
    return PhysX.PxFilterFlagEnum.eDEFAULT;
  };
  Px.setupPassThroughFilterShader(description, filters);
  const scene = physics.createScene(description);
  const meshes = [];
  const bodies = question.bodies.map((body) => addBody(scene, body, values, meshes));
  const connect = (link, length) => addDistanceJoint(bodies, link, length);
  const joints = [
    ...question.springs.map((spring) => connect(spring, spring.rest_length)),
    ...question.joints.map((joint) => connect(joint, joint.length)),
  ];
  freeTemporary();
  return {
    step() {
      bodies.forEach((body, i) => {
        const { mass, force } = question.bodies[i];
        if (mass > 0) body.addForce(toVec3(force)); // PhysX clears it after the step.
      });
      scene.simulate(question.dt);
      scene.fetchResults(true);
      freeTemporary();
    },
    push(i, point, impulse) {
      PhysX.PxRigidBodyExt.prototype.addForceAtPos(
        bodies[i], toVec3(impulse), toVec3(point), PhysX.PxForceModeEnum.eIMPULSE);
      freeTemporary();
    },
    read: () => bodies.flatMap((body, i) => {
      const { p, q } = body.getGlobalPose();
      const pose = [...fromXyz(p), ...fromXyzw(q)];
      if (!(question.bodies[i].mass > 0)) return [...pose, 0, 0, 0, 0, 0, 0];
      return [
        ...pose, ...fromXyz(body.getLinearVelocity()), ...fromXyz(body.getAngularVelocity()),
      ];
    }),
    end() {
      joints.forEach((joint) => joint.release());
      bodies.forEach((body) => body.release());
      scene.release();
      meshes.forEach((mesh) => mesh.release());
    },
  };
}

function addBody(scene, asked, values, meshes) {
  const pose = toTransform(asked.position, asked.quaternion);
  const moves = asked.mass > 0;
  const body = moves ? physics.createRigidDynamic(pose) : physics.createRigidStatic(pose);
  if (asked.collides) attachShape(body, asked, values, meshes);
  if (moves) {
    const flag = (bit, value) => body.setRigidBodyFlag(bit, value !== 0);
    flag(PhysX.PxRigidBodyFlagEnum.eENABLE_CCD, values.ccd);
    flag(PhysX.PxRigidBodyFlagEnum.eENABLE_SPECULATIVE_CCD, values.speculative_ccd);
    flag(1 << 10, values.gyroscopic); // eENABLE_GYROSCOPIC_FORCES, which the package does not name.
    body.setMass(asked.mass);
    body.setMassSpaceInertiaTensor(toVec3(asked.inertia));
    body.setLinearDamping(values.linear_damping);
    body.setAngularDamping(values.angular_damping);
    body.setMaxLinearVelocity(values.max_speed);
    body.setMaxAngularVelocity(values.max_spin);
    body.setMaxDepenetrationVelocity(values.max_depenetration_speed);
    body.setSolverIterationCounts(values.position_iterations, values.velocity_iterations);
    body.setSleepThreshold(values.sleep_threshold);
    body.setLinearVelocity(toVec3(asked.velocity));
    body.setAngularVelocity(toVec3(asked.spin));
  }
  scene.addActor(body);
  return body;
}

function attachShape(body, asked, values, meshes) {
  const friction = Math.sqrt(asked.friction);
  const material = physics.createMaterial(friction, friction, asked.restitution);
  material.setFrictionCombineMode(PhysX.PxCombineModeEnum.eMULTIPLY);
  material.setRestitutionCombineMode(PhysX.PxCombineModeEnum.eMIN);
  const shape = physics.createShape(geometryOf(asked, meshes), material, true);
  if (isAlongX(asked)) shape.setLocalPose(toTransform([0, 0, 0], common.X_TO_Z));
  shape.setContactOffset(values.contact_offset);
  shape.setRestOffset(values.rest_offset);
  body.attachShape(shape);
  shape.release();
  material.release();
}

/** Connects two ends by a rod of a length, or by a spring if the link has a stiffness. [m] */
function addDistanceJoint(bodies, link, length) {
  const frame = (end) => toTransform(end.point, [1, 0, 0, 0]);
  const [A, B] = [link.A, link.B].map((end) => bodies[end.index] ?? null); // null: the world.
  const joint = Px.DistanceJointCreate(physics, A, frame(link.A), B, frame(link.B));
  const flags = PhysX.PxDistanceJointFlagEnum;
  joint.setMinDistance(length);
  joint.setMaxDistance(length);
  joint.setTolerance(0);
  joint.setDistanceJointFlag(flags.eMIN_DISTANCE_ENABLED, true);
  joint.setDistanceJointFlag(flags.eMAX_DISTANCE_ENABLED, true);
  if (link.stiffness !== undefined) {
    joint.setDistanceJointFlag(flags.eSPRING_ENABLED, true);
    joint.setStiffness(link.stiffness);
    joint.setDamping(link.damping);
  }
  return joint;
}

common.serve({ about, contact, begin });
