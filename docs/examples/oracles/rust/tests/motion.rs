//! A simulation is run to its end with its pushes, its samples, and its divergence.

use touchstone_oracle::{
    Body, BodyState, Oracle, Parameters, Push, Refusal, RigidBody, Shape, Simulation, Value,
    Vector, World,
};

/// One ball. Each step moves it by `dt * velocity`, and multiplies that by `growth`.
struct Ball {
    state: BodyState,
    dt: f64,
    growth: f64,
}

impl Simulation for Ball {
    fn push(&mut self, _body: usize, point: Vector, impulse: Vector) {
        self.state.velocity = impulse;
        self.state.spin = point; // The test looks at it.
    }

    fn step(&mut self) -> Result<(), Refusal> {
        for i in 0..3 {
            self.state.position[i] += self.dt * self.state.velocity[i];
            self.state.velocity[i] *= self.growth;
        }
        Ok(())
    }

    fn read(&self) -> Vec<f64> {
        let mut row = Vec::new();
        self.state.append_to(&mut row);
        row
    }
}

struct Engine;

impl Oracle for Engine {
    fn about(&self) -> Value {
        Value::Null
    }

    fn begin(&self, world: &World, values: &Parameters) -> Result<Box<dyn Simulation>, Refusal> {
        let Body { position, quaternion, .. } = world.bodies[0].placed;
        let (velocity, spin) = (world.bodies[0].velocity, world.bodies[0].spin);
        let state = BodyState { position, quaternion, velocity, spin };
        Ok(Box::new(Ball { state, dt: world.dt, growth: values["growth"] }))
    }
}

fn world() -> World {
    let turned = Body {
        shape: Shape::Sphere { radius: 1.0 },
        position: [1.0, 2.0, 3.0],
        rotation: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        quaternion: [0.5f64.sqrt(), 0.0, 0.0, 0.5f64.sqrt()],
    };
    let ball = RigidBody {
        placed: turned,
        name: "ball".into(),
        mass: 1.0,
        inertia: [0.4; 3],
        velocity: [0.0; 3],
        spin: [0.0; 3],
        restitution: 1.0,
        friction: 0.0,
        force: [0.0; 3],
        collides: true,
    };
    let push = Push { body: 0, after_steps: 2, point: [1.0, 0.0, 0.0], impulse: [0.0, 4.0, 0.0] };
    World {
        gravity: [0.0; 3],
        dt: 0.25,
        steps: 4,
        sample_every: 2,
        bodies: vec![ball],
        pushes: vec![push],
        json: Value::Null,
    }
}

#[test]
fn a_push_after_two_steps_moves_the_last_two() {
    let motion = Engine.simulate(&world(), &Parameters::from([("growth".into(), 1.0)])).unwrap();
    assert_eq!(motion.times, [0.0, 0.5, 1.0]);
    let heights: Vec<f64> = motion.samples.iter().map(|row| row[1]).collect();
    assert_eq!(heights, [2.0, 2.0, 4.0]);
    assert_eq!(motion.diverged_at_step, None);
}

#[test]
fn a_push_has_its_point_in_the_world_frame() {
    let motion = Engine.simulate(&world(), &Parameters::from([("growth".into(), 1.0)])).unwrap();
    // The body's x axis is the y axis of the world.
    for (found, expected) in motion.samples[2][10..].iter().zip([1.0, 3.0, 3.0]) {
        assert!((found - expected).abs() < 1e-15);
    }
}

#[test]
fn a_motion_ends_before_it_diverges() {
    let motion = Engine.simulate(&world(), &Parameters::from([("growth".into(), 1e13)])).unwrap();
    assert_eq!(motion.times, [0.0, 0.5]);
    assert_eq!(motion.diverged_at_step, Some(3));
}
