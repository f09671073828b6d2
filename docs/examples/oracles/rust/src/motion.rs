use crate::{answer, Refusal, Vector, World};
use serde_json::{json, Value};

/// A motion that reaches this position, speed or spin has diverged. [m, m/s, rad/s]
const MOST_REACHED: f64 = 1e12;

/// The state of a rigid body. World frame.
#[derive(Clone, Copy, Debug)]
pub struct BodyState {
    /// Of the centre of mass. [m]
    pub position: Vector,
    /// Orientation: w, x, y, z.
    pub quaternion: [f64; 4],
    /// Of the centre of mass. [m/s]
    pub velocity: Vector,
    /// Angular velocity. [rad/s]
    pub spin: Vector,
}

impl BodyState {
    /// Appends these numbers to a row of the protocol.
    pub fn append_to(&self, row: &mut Vec<f64>) {
        row.extend(self.position);
        row.extend(self.quaternion);
        row.extend(self.velocity);
        row.extend(self.spin);
    }
}

/// A running simulation of one world.
pub trait Simulation {
    /// Applies an impulse [N s] to a body at a point [m], both in the world frame. It is
    /// called only if the oracle supports `"push"`.
    fn push(&mut self, _body: usize, _point: Vector, _impulse: Vector) {}

    /// Advances by one step of [`World::dt`].
    fn step(&mut self) -> Result<(), Refusal>;

    /// Returns the row of numbers of the protocol: those of a [`BodyState`] for each body,
    /// static ones included, then position and velocity of each particle and node.
    fn read(&self) -> Vec<f64>;
}

/// A whole motion: the start, and the state after every `sample_every` steps.
#[derive(Clone, Debug, Default)]
pub struct Motion {
    /// From 0. [s]
    pub times: Vec<f64>,
    /// The row of numbers for each time.
    pub samples: Vec<Vec<f64>>,
    /// The 16 numbers of each contact in each step, if the engine gives them.
    pub impulses: Option<Vec<[f64; 16]>>,
    /// First step that reached a number that is not finite. The samples end before it.
    pub diverged_at_step: Option<u64>,
}

impl Motion {
    pub(crate) fn to_json(&self) -> Value {
        let rows = self.samples.iter().map(|row| answer::numbers(row));
        let mut json = json!({
            "times": answer::numbers(&self.times),
            "samples": rows.collect::<Value>(),
        });
        if let Some(impulses) = &self.impulses {
            json["impulses"] = impulses.iter().map(|row| answer::numbers(row)).collect();
        }
        if let Some(step) = self.diverged_at_step {
            json["diverged_at_step"] = json!(step);
        }
        json
    }
}

/// Runs a simulation from start to end, with its pushes and samples.
pub(crate) fn run_to_end(
    simulation: &mut dyn Simulation,
    world: &World,
) -> Result<Motion, Refusal> {
    let mut state = simulation.read();
    let mut motion = Motion { times: vec![0.0], samples: vec![state.clone()], ..Motion::default() };
    for step in 1..=world.steps {
        for push in world.pushes.iter().filter(|push| push.after_steps == step - 1) {
            let point = to_world(&state, push.body, push.point)?;
            simulation.push(push.body, point, push.impulse);
        }
        simulation.step()?;
        state = simulation.read();
        // Written so that a NaN ends the motion.
        if !state.iter().all(|number| number.abs() < MOST_REACHED) {
            motion.diverged_at_step = Some(step);
            break;
        }
        if step % world.sample_every == 0 {
            motion.times.push(step as f64 * world.dt);
            motion.samples.push(state.clone());
        }
    }
    Ok(motion)
}

fn to_world(state: &[f64], body: usize, point: Vector) -> Result<Vector, Refusal> {
    let Some(&[x, y, z, qw, qx, qy, qz]) = state.get(13 * body..13 * body + 7) else {
        return Err(Refusal::Error(format!("read() returned {} numbers", state.len())));
    };
    let u = [qx, qy, qz];
    let t = cross(u, point).map(|number| 2.0 * number);
    let s = cross(u, t);
    let turned = |i: usize| point[i] + qw * t[i] + s[i];
    Ok([x + turned(0), y + turned(1), z + turned(2)])
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
