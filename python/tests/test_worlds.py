"""Worlds: pushes, samples, divergence, parameters and impulses."""

import json
import unittest

import numpy as np
from conversation import IDENTITY, ask

from touchstone_oracle import (
    BodyState,
    ContactImpulse,
    Motion,
    Oracle,
    PointState,
    Simulation,
    Unsupported,
    WorldState,
)

# Turns x into y.
QUARTER = [0.5**0.5, 0.0, 0.0, 0.5**0.5]


def rigid_body(name, mass=1.0, velocity=(0.0, 0.0, 0.0), quaternion=(1.0, 0.0, 0.0, 0.0)):
    return {
        "name": name,
        "shape": "sphere",
        "radius": 1.0,
        "position": [1.0, 2.0, 3.0],
        "rotation": IDENTITY,
        "quaternion": list(quaternion),
        "mass": mass,
        "inertia": [0.4, 0.4, 0.4],
        "velocity": list(velocity),
        "spin": [0.0, 0.0, 0.0],
        "restitution": 1.0,
        "friction": 0.0,
        "force": [0.0, 0.0, 0.0],
        "collides": True,
    }


def world(**changed):
    return {
        "gravity": [0.0, -9.82, 0.0],
        "dt": 0.25,
        "steps": 4,
        "sample_every": 2,
        "bodies": [rigid_body("ball")],
        "particles": [],
        "springs": [],
        "joints": [],
        "cloths": [],
        "pushes": [],
        **changed,
    }


class Flight(Simulation):
    """Bodies that fly without forces."""

    def __init__(self, world, growth):
        self.world, self.growth = world, growth
        self.states = [
            BodyState(b.position.copy(), b.quaternion, b.velocity.copy(), b.spin)
            for b in world.bodies
        ]

    def push(self, body, point, impulse):
        self.states[body].velocity += impulse / self.world.bodies[body].mass
        self.states[body].spin = point  # The test looks at it.

    def step(self):
        for at in self.states:
            at.position += self.world.dt * at.velocity
            at.velocity *= self.growth

    def read(self):
        return self.states


class Engine(Oracle):
    supports = ["sphere", "push"]

    def __init__(self, frames=True):
        self.frames = frames

    def begin(self, world, parameters):
        self.parameters = parameters
        return Flight(world, parameters.get("growth", 1.0))


def motion(oracle, asked, parameters=None):
    """Returns times, rows of samples, and the line of the answer in either form."""
    message = {"id": 2, "method": "world", "in_frame": oracle.frames, "world": asked}
    if parameters is not None:
        message["parameters"] = parameters
    line, frame = ask(oracle, message)
    if "sample_count" not in line:
        return np.array(line.get("times", [])), np.array(line.get("samples", [])), line
    impulses = 16 * line.get("impulse_count", 0)
    rows = frame[: len(frame) - impulses].reshape(line["sample_count"], -1)
    return rows[:, 0], rows[:, 1:], {**line, "last": frame[len(frame) - impulses :].tolist()}


class Worlds(unittest.TestCase):
    def test_have_their_start_and_a_sample_every_few_steps(self):
        asked = world(bodies=[rigid_body("a"), rigid_body("b", velocity=(4.0, 0.0, 0.0))])
        for frames in (True, False):
            times, samples, line = motion(Engine(frames), asked)
            self.assertEqual(times.tolist(), [0.0, 0.5, 1.0])
            self.assertEqual(samples.shape, (3, 26))
            self.assertEqual(samples[:, 13].tolist(), [1.0, 3.0, 5.0])
            self.assertEqual(samples[0, :13].tolist(), [1, 2, 3, 1, 0, 0, 0] + 6 * [0])
            self.assertNotIn("diverged_at_step", line)
            self.assertNotIn("impulse_count", line)
            self.assertNotIn("impulses", line)

    def test_are_pushed_after_their_steps_at_points_of_the_world(self):
        push = {"body": 0, "after_steps": 2, "time": 0.5}
        push.update(point=[1.0, 0.0, 0.0], impulse=[0.0, 8.0, 0.0])
        ball = rigid_body("ball", mass=2.0, quaternion=QUARTER)
        _, samples, _ = motion(Engine(), world(bodies=[ball], pushes=[push]))
        self.assertEqual(samples[:, 1].tolist(), [2.0, 2.0, 4.0])
        np.testing.assert_allclose(samples[2, 10:], [1.0, 3.0, 3.0], rtol=1e-15)

    def test_end_before_they_diverge(self):
        asked = world(bodies=[rigid_body("ball", velocity=(1.0, 0.0, 0.0))])
        for growth in (1e20, float("nan")):
            for frames in (True, False):
                parameters = {"growth": growth if growth == growth else "NaN"}
                times, samples, line = motion(Engine(frames), asked, parameters)
                self.assertEqual((times.tolist(), line["diverged_at_step"]), ([0.0], 1))
        times, _, line = motion(Engine(), asked, {"growth": 1e5})
        self.assertEqual((times.tolist(), line["diverged_at_step"]), ([0.0, 0.5], 3))

    def test_have_the_values_of_all_parameters(self):
        engine = Engine()
        motion(engine, world(), {"growth": 1.0, "margin": "Infinity"})
        self.assertEqual(engine.parameters, {"growth": 1.0, "margin": float("inf")})
        motion(engine, world())
        self.assertEqual(engine.parameters, {})

    def test_are_unsupported_or_fail_with_the_reason(self):
        class Refuses(Engine):
            def begin(self, world, parameters):
                raise Unsupported("too large")

        _, _, line = motion(Refuses(), world())
        self.assertEqual(line, {"id": 2, "unsupported": "too large"})

        class Short(Engine):
            def begin(self, world, parameters):
                simulation = super().begin(world, parameters)
                simulation.states.pop()
                return simulation

        _, _, line = motion(Short(), world())
        self.assertEqual(line["error"], "read() returned bodies: 0 states; expected 1")

        class Nothing(Engine):
            def begin(self, world, parameters):
                return None

        _, _, line = motion(Nothing(), world())
        self.assertEqual(line["error"], "begin() returned NoneType; expected a Simulation")

    def test_may_have_impulses(self):
        class Hit(Flight):
            def read_impulses(self):
                normal = np.array([0.0, 1.0, 0.0])
                return [ContactImpulse(0, 0, [1, 2, 3], normal, 2 * normal, -0.5)]

        class Hits(Engine):
            def begin(self, world, parameters):
                return Hit(world, 1.0)

        row = [0, 0, 1, 2, 3, 0, 1, 0, 0, 2, 0, -0.5, 0, 0, 0]
        expected = [[step] + row for step in (1, 2, 3, 4)]
        _, _, line = motion(Hits(), world())
        self.assertEqual(line["last"], sum(expected, []))
        _, _, line = motion(Hits(frames=False), world())
        self.assertEqual(line["impulses"], expected)

    def test_may_be_simulated_as_a_whole(self):
        class Whole(Oracle):
            def simulate(self, world, parameters):
                rows = np.arange(39.0).reshape(3, 13)
                return Motion(times=np.array([0.0, 0.5, 1.0]), samples=rows)

        times, samples, _ = motion(Whole(), world())
        self.assertEqual(times.tolist(), [0.0, 0.5, 1.0])
        self.assertEqual(samples.ravel().tolist(), list(range(39)))

    def test_have_particles_springs_joints_and_cloths(self):
        springs = {"stiffness": 1.0, "damping": 0.0}
        anchor = {"on": "world", "point": [0.0, 0.0, 0.0]}
        other = {"on": "particle", "index": 0, "point": [0.0, 0.0, 0.0]}
        particle = {"name": "p", "position": [1.0, 0.0, 0.0], "velocity": [0.0, 0.0, 0.0]}
        particle.update(mass=1.0, damping=0.0, bounce=0.7)
        cloth = {"name": "c", "n": 3, "spacing": 1.0, "centre": [0.0, 0.0, 0.0]}
        cloth.update(node_mass=1.0, damping=0.0, bounce=0.0, pinned=[[0, 2]])
        cloth.update(structural=springs, shear=springs, bend=springs)
        asked = world(
            bodies=[],
            particles=[particle],
            springs=[{"A": anchor, "B": other, **springs, "rest_length": 2.0}],
            joints=[{"A": anchor, "B": other, "length": 1.0}],
            cloths=[cloth],
        )

        class Net(Oracle):
            def begin(self, world, parameters):
                self.world = world
                nodes = [PointState([i, 0, 0], [0, 0, 0]) for i in range(world.nodes)]
                still = Flight(world, 1.0)
                still.read = lambda: WorldState([], [PointState([1, 0, 0], [0, 0, 0])], nodes)
                return still

        net = Net()
        _, samples, _ = motion(net, json.loads(json.dumps(asked)))
        self.assertEqual(samples.shape, (3, 60))
        self.assertEqual(samples[0, 6::6].tolist(), list(range(9)))
        self.assertEqual(net.world.springs[0].rest_length, 2.0)
        self.assertEqual(net.world.springs[0].A.index, -1)
        self.assertEqual(net.world.joints[0].B.on, "particle")
        self.assertEqual(net.world.cloths[0].bend.stiffness, 1.0)
        self.assertEqual(net.world.cloths[0].pinned, [(0, 2)])


if __name__ == "__main__":
    unittest.main()
