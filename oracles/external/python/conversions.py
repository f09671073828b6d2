"""What several adapters convert: quaternions, places, and the surfaces of a pair of bodies."""

import numpy as np


def xyzw(quaternion):
    """Returns a quaternion w, x, y, z with w last."""
    return np.roll(quaternion, -1)


def wxyz(quaternion):
    """Returns a quaternion x, y, z, w with w first."""
    return np.roll(quaternion, 1)


def pose_matrix(body):
    """Returns the 4 x 4 matrix that takes points of the body frame to the world."""
    X_WB = np.eye(4)
    X_WB[:3, :3] = body.rotation
    X_WB[:3, 3] = body.position
    return X_WB


def can_touch(A, B):
    """Whether two bodies of a world may collide: static bodies do not meet each other."""
    return A.collides and B.collides and (A.mass > 0 or B.mass > 0)


def friction_of(A, B):
    """The coefficient of friction of a contact of A and B, as worlds define it."""
    return float(np.sqrt(A.friction * B.friction))


def restitution_of(A, B):
    """The coefficient of restitution of a contact of A and B, as worlds define it."""
    return min(A.restitution, B.restitution)


def is_moving_anchor(world, anchor):
    """Whether an end of a spring or a joint is on a body that moves."""
    return anchor.on == "body" and world.bodies[anchor.index].mass > 0


def start_of(world, anchor):
    """The position of an end of a spring or a joint at the start, in the world. [m]"""
    if anchor.on == "body":
        return world.bodies[anchor.index].to_world(anchor.point)
    return anchor.point


def spin_change(body, rotation, lever, impulse):
    """The change of spin by an impulse [N s] at a lever [m] from the centre, world frame.

    `rotation` takes coordinates of the body, now, to those of the world. [rad/s]
    """
    torque_B = rotation.T @ np.cross(lever, impulse)
    return rotation @ (torque_B / body.inertia)


def product_restitutions(world, why_not):
    """Returns a coefficient of restitution for each body, whose products are the smaller ones.

    That needs one coefficient of all moving bodies. Raises `why_not` otherwise.
    """
    moving = {b.restitution for b in world.bodies if b.collides and b.mass > 0}
    if len(moving) > 1:
        raise why_not
    e = moving.pop() if moving else 0.0
    return [min(b.restitution, e) / np.sqrt(e) if e > 0 else 0.0 for b in world.bodies]
