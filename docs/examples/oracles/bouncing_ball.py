"""A world engine: balls that bounce on static half-spaces. It has no friction, and moving
balls pass through each other; `supports` says so."""

from touchstone_oracle import BodyState, HalfSpace, Oracle, Simulation, serve

import numpy as np


class BouncingBalls(Simulation):
    def __init__(self, world):
        self.world = world
        self.grounds = [body for body in world.bodies if isinstance(body.shape, HalfSpace)]
        self.states = [
            BodyState(body.position, body.quaternion, body.velocity, body.spin)
            for body in world.bodies
        ]

    def push(self, body, point, impulse):
        at = self.states[body]
        at.velocity = at.velocity + impulse / self.world.bodies[body].mass
        lever = point - at.position
        at.spin = at.spin + np.cross(lever, impulse) / self.world.bodies[body].inertia[0]

    def step(self):
        dt = self.world.dt
        for ball, at in zip(self.world.bodies, self.states):
            if ball.mass == 0:
                continue  # It is static.
            # A bounce between two halves of gravity's impulse neither gains nor loses energy.
            at.velocity = at.velocity + dt / 2 * self.world.gravity
            for ground in self.grounds:
                bounce(ball, ground, at, min(ball.restitution, ground.restitution))
            at.velocity = at.velocity + dt / 2 * self.world.gravity
            # Without this, gravity's second half would sink a ball that rests.
            for ground in self.grounds:
                bounce(ball, ground, at, 0.0)
            at.position = at.position + dt * at.velocity
            at.quaternion = turned(at.quaternion, dt * at.spin)

    def read(self):
        return self.states


def bounce(ball, ground, at, restitution):
    """Reflects a ball that is in the ground and moves deeper."""
    normal = ground.rotation[:, 2]
    gap = normal @ (at.position - ground.position) - ball.shape.radius
    speed = normal @ at.velocity
    if gap <= 0 and speed < 0 and ball.collides and ground.collides:
        at.velocity = at.velocity - (1 + restitution) * speed * normal


def turned(q, rotation):
    """Turns a quaternion by a rotation vector of the world frame, in radians."""
    angle = np.linalg.norm(rotation)
    if angle == 0:
        return q
    w, u = np.cos(angle / 2), np.sin(angle / 2) / angle * rotation
    turn = np.array([w * q[0] - u @ q[1:], *(w * q[1:] + q[0] * u + np.cross(u, q[1:]))])
    return turn / np.linalg.norm(turn)


class BouncingBall(Oracle):
    name = "bouncing_ball"
    library = "bouncing_ball.py"
    version = "1.0"
    supports = ["sphere", "static half-space", "restitution", "unequal friction", "push"]

    def begin(self, world, parameters):
        return BouncingBalls(world)


serve(BouncingBall())
