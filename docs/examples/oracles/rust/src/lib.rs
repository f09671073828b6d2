//! Makes an engine that Rust can call an oracle of Touchstone.
//!
//! Implement [`Oracle`] and pass it to [`serve`]; `examples/balls.rs` is a whole program.
//! `docs/oracle_protocol.md` defines shapes, signs and what an oracle says about itself.
//! Units are SI, frames are right-handed, quaternions are ordered w, x, y, z.
//!
//! Nothing but answers may be written to standard output. Rust's `println!` and C libraries
//! that print there must be silenced or redirected.

mod answer;
mod motion;
mod question;
mod serve;

pub use answer::{Contact, ContactPoint, Refusal};
pub use motion::{BodyState, Motion, Simulation};
pub use question::{Body, Push, RigidBody, Shape, World};
pub use serde_json::{json, Value};
pub use serve::serve;

use std::collections::BTreeMap;

/// A vector, or the coordinates of a point.
pub type Vector = [f64; 3];

/// The values in force of the parameters of an oracle, by name.
pub type Parameters = BTreeMap<String, f64>;

/// An engine that Touchstone asks. An answer must depend on the question alone.
pub trait Oracle {
    /// Returns the answer to hello without `protocol`: `name`, `library`, `version`,
    /// `precision`, and `contact` or `world` or both.
    fn about(&self) -> Value;

    /// Answers a contact question. Normals point from A to B, in the world frame.
    fn contact(&self, _a: &Body, _b: &Body) -> Result<Contact, Refusal> {
        Err(Refusal::Unsupported("it answers no contact questions".into()))
    }

    /// Returns a simulation at the start of `world`.
    fn begin(
        &self,
        _world: &World,
        _parameters: &Parameters,
    ) -> Result<Box<dyn Simulation>, Refusal> {
        Err(Refusal::Unsupported("it moves no worlds".into()))
    }

    /// Returns the whole motion of `world`. The default runs [`Oracle::begin`] to the end;
    /// an engine that does not move in steps replaces it.
    fn simulate(&self, world: &World, parameters: &Parameters) -> Result<Motion, Refusal> {
        motion::run_to_end(self.begin(world, parameters)?.as_mut(), world)
    }
}
