use crate::Vector;
use serde_json::{json, Value};

/// One contact point, midway between the two surfaces.
#[derive(Clone, Debug)]
pub struct ContactPoint {
    /// World frame. [m]
    pub position: Vector,
    /// Signed gap there: < 0 penetrating, > 0 apart. [m]
    pub separation: f64,
    /// Unit vector from A to B, if it is not that of the [`Contact`].
    pub normal: Option<Vector>,
}

/// What an engine says about two bodies. NaN is passed on, and Touchstone reports it.
#[derive(Clone, Debug, Default)]
pub struct Contact {
    /// Whether A and B share a point.
    pub touching: bool,
    /// Signed: < 0 penetrating, 0 touching, > 0 apart. [m]
    pub separation: Option<f64>,
    /// Unit vector that points from A into B, world frame.
    pub normal: Option<Vector>,
    pub points: Vec<ContactPoint>,
    /// The point of A and the point of B that are nearest to each other, or deepest. [m]
    pub witnesses: Option<[Vector; 2]>,
}

/// Why there is no answer.
#[derive(Clone, Debug)]
pub enum Refusal {
    /// The engine cannot answer this question. It is counted, and is no failure.
    Unsupported(String),
    /// The engine can, and has failed. It is a finding.
    Error(String),
}

impl Refusal {
    pub(crate) fn to_json(&self) -> Value {
        match self {
            Refusal::Unsupported(why) => json!({ "unsupported": why }),
            Refusal::Error(why) => json!({ "error": why }),
        }
    }
}

impl Contact {
    pub(crate) fn to_json(&self) -> Value {
        let mut json = json!({ "touching": self.touching });
        if let Some(separation) = self.separation {
            json["separation"] = number(separation);
        }
        if let Some(normal) = self.normal {
            json["normal"] = numbers(&normal);
        }
        if !self.points.is_empty() {
            json["points"] = self.points.iter().map(ContactPoint::to_json).collect();
        }
        if let Some([of_a, of_b]) = self.witnesses {
            json["witnesses"] = json!([numbers(&of_a), numbers(&of_b)]);
        }
        json
    }
}

impl ContactPoint {
    fn to_json(&self) -> Value {
        let mut json = json!({
            "position": numbers(&self.position),
            "separation": number(self.separation),
        });
        if let Some(normal) = self.normal {
            json["normal"] = numbers(&normal);
        }
        json
    }
}

/// JSON has no NaN and no infinity: they are strings.
pub(crate) fn number(value: f64) -> Value {
    if value.is_finite() {
        json!(value)
    } else if value.is_nan() {
        json!("NaN")
    } else {
        json!(if value > 0.0 { "Infinity" } else { "-Infinity" })
    }
}

pub(crate) fn numbers(values: &[f64]) -> Value {
    values.iter().map(|value| number(*value)).collect()
}
