//! An oracle for two spheres: how deep they overlap, or how far they are apart.

use touchstone_oracle::{
    json, serve, Body, Contact, ContactPoint, Oracle, Refusal, Shape, Value, Vector,
};

struct Balls;

impl Oracle for Balls {
    fn about(&self) -> Value {
        json!({
            "name": "balls",
            "library": "balls.rs",
            "version": env!("CARGO_PKG_VERSION"),
            "precision": "double",
            "subtracts_first": true,
            "contact": [{
                "pairs": [["sphere", "sphere"]],
                "family": "closed_form",
                "gives": ["depth", "distance", "normal", "manifold"],
            }],
        })
    }

    fn contact(&self, a: &Body, b: &Body) -> Result<Contact, Refusal> {
        let (Shape::Sphere { radius: r_a }, Shape::Sphere { radius: r_b }) = (&a.shape, &b.shape)
        else {
            return Err(Refusal::Unsupported("two spheres only".into()));
        };
        let d: Vector = std::array::from_fn(|i| b.position[i] - a.position[i]);
        // Unlike the root of the sum of squares, hypot() never overflows or underflows.
        let distance = d[0].hypot(d[1]).hypot(d[2]);
        let separation = distance - (r_a + r_b);
        // Every direction is equally right for two balls with one centre.
        let normal = if distance > 0.0 { d.map(|x| x / distance) } else { [0.0, 0.0, 1.0] };
        let mut contact = Contact {
            touching: separation <= 0.0,
            separation: Some(separation),
            normal: Some(normal),
            ..Contact::default()
        };
        if contact.touching {
            // Midway between the two surfaces.
            let reach = r_a + separation / 2.0;
            let position = std::array::from_fn(|i| a.position[i] + reach * normal[i]);
            contact.points = vec![ContactPoint { position, separation, normal: None }];
        }
        Ok(contact)
    }
}

fn main() -> std::io::Result<()> {
    serve(&Balls)
}
