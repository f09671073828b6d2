use crate::{Parameters, Vector};
use serde_json::Value;

/// A shape, centred on the origin of its body, with its axis along z. Sizes are in m.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    Sphere {
        radius: f64,
    },
    Box {
        half_extents: Vector,
    },
    /// `half_length` is half of the segment, without the caps.
    Capsule {
        radius: f64,
        half_length: f64,
    },
    Cylinder {
        radius: f64,
        half_length: f64,
    },
    /// The apex is at z = +half_height.
    Cone {
        radius: f64,
        half_height: f64,
    },
    ConvexHull {
        vertices: Vec<Vector>,
    },
    /// The solid z <= 0.
    HalfSpace,
}

/// A shape at a place in the world.
#[derive(Clone, Debug)]
pub struct Body {
    pub shape: Shape,
    /// World frame. [m]
    pub position: Vector,
    /// Rows of the matrix from body to world coordinates. These numbers are the question.
    pub rotation: [Vector; 3],
    /// The same rotation, for engines that take a quaternion: w, x, y, z.
    pub quaternion: [f64; 4],
}

/// A rigid body at the start of a motion. Vectors are in the world frame.
#[derive(Clone, Debug)]
pub struct RigidBody {
    pub placed: Body,
    pub name: String,
    /// 0: it never moves. [kg]
    pub mass: f64,
    /// Principal moments about the centre, along the body's axes. [kg m²]
    pub inertia: Vector,
    /// [m/s]
    pub velocity: Vector,
    /// Angular velocity. [rad/s]
    pub spin: Vector,
    /// The smaller value of the two bodies counts.
    pub restitution: f64,
    /// The root of the product of the two bodies' values counts.
    pub friction: f64,
    /// Constant force through the centre, in addition to gravity. [N]
    pub force: Vector,
    /// False: it passes through everything.
    pub collides: bool,
}

/// An impulse on a body between two steps.
#[derive(Clone, Debug)]
pub struct Push {
    /// Index into [`World::bodies`].
    pub body: usize,
    /// Number of steps before it.
    pub after_steps: u64,
    /// Point of application, body frame. [m]
    pub point: Vector,
    /// World frame. [N s]
    pub impulse: Vector,
}

/// The start of a motion, and what acts on it.
#[derive(Clone, Debug)]
pub struct World {
    /// [m/s²]
    pub gravity: Vector,
    /// Length of a step. [s]
    pub dt: f64,
    pub steps: u64,
    /// Steps between two samples.
    pub sample_every: u64,
    pub bodies: Vec<RigidBody>,
    pub pushes: Vec<Push>,
    /// The whole world as it was sent: also its particles, springs, joints and cloths.
    pub json: Value,
}

/// What is wrong with a message.
pub(crate) type Malformed = String;

pub(crate) fn number(json: &Value) -> Result<f64, Malformed> {
    match json {
        Value::Null => Ok(f64::NAN),
        // The strings "NaN", "Infinity" and "-Infinity" of the protocol are among these.
        Value::String(text) => text.parse().map_err(|_| format!("{text}; expected a number")),
        _ => json.as_f64().ok_or_else(|| format!("{json}; expected a number")),
    }
}

fn numbers<const N: usize>(json: &Value) -> Result<[f64; N], Malformed> {
    let items = items(json)?.iter().map(number).collect::<Result<Vec<_>, _>>()?;
    <[f64; N]>::try_from(items).map_err(|_| format!("{json}; expected {N} numbers"))
}

pub(crate) fn items(json: &Value) -> Result<&Vec<Value>, Malformed> {
    json.as_array().ok_or_else(|| format!("{json}; expected a list"))
}

fn whole(json: &Value) -> Result<u64, Malformed> {
    json.as_u64().ok_or_else(|| format!("{json}; expected a whole number"))
}

fn shape(json: &Value) -> Result<Shape, Malformed> {
    let size = |key: &str| number(&json[key]);
    Ok(match json["shape"].as_str() {
        Some("sphere") => Shape::Sphere { radius: size("radius")? },
        Some("box") => Shape::Box { half_extents: numbers(&json["half_extents"])? },
        Some("capsule") => {
            Shape::Capsule { radius: size("radius")?, half_length: size("half_length")? }
        }
        Some("cylinder") => {
            Shape::Cylinder { radius: size("radius")?, half_length: size("half_length")? }
        }
        Some("cone") => Shape::Cone { radius: size("radius")?, half_height: size("half_height")? },
        Some("convex_hull") => {
            let vertices = items(&json["vertices"])?.iter().map(numbers).collect::<Result<_, _>>();
            Shape::ConvexHull { vertices: vertices? }
        }
        Some("half_space") => Shape::HalfSpace,
        _ => return Err(format!("shape {}; expected the name of a shape", json["shape"])),
    })
}

pub(crate) fn body(json: &Value) -> Result<Body, Malformed> {
    let rows = &json["rotation"];
    Ok(Body {
        shape: shape(json)?,
        position: numbers(&json["position"])?,
        rotation: [numbers(&rows[0])?, numbers(&rows[1])?, numbers(&rows[2])?],
        quaternion: numbers(&json["quaternion"])?,
    })
}

fn rigid_body(json: &Value) -> Result<RigidBody, Malformed> {
    Ok(RigidBody {
        placed: body(json)?,
        name: json["name"].as_str().unwrap_or_default().into(),
        mass: number(&json["mass"])?,
        inertia: numbers(&json["inertia"])?,
        velocity: numbers(&json["velocity"])?,
        spin: numbers(&json["spin"])?,
        restitution: number(&json["restitution"])?,
        friction: number(&json["friction"])?,
        force: numbers(&json["force"])?,
        collides: json["collides"].as_bool().unwrap_or(true),
    })
}

fn push(json: &Value) -> Result<Push, Malformed> {
    Ok(Push {
        body: whole(&json["body"])? as usize,
        after_steps: whole(&json["after_steps"])?,
        point: numbers(&json["point"])?,
        impulse: numbers(&json["impulse"])?,
    })
}

pub(crate) fn world(json: &Value) -> Result<World, Malformed> {
    Ok(World {
        gravity: numbers(&json["gravity"])?,
        dt: number(&json["dt"])?,
        steps: whole(&json["steps"])?,
        sample_every: whole(&json["sample_every"])?,
        bodies: items(&json["bodies"])?.iter().map(rigid_body).collect::<Result<_, _>>()?,
        pushes: items(&json["pushes"])?.iter().map(push).collect::<Result<_, _>>()?,
        json: json.clone(),
    })
}

pub(crate) fn parameters(json: &Value) -> Result<Parameters, Malformed> {
    let Some(values) = json.as_object() else { return Ok(Parameters::new()) };
    values.iter().map(|(name, value)| Ok((name.clone(), number(value)?))).collect()
}
