use crate::{question, Oracle, Refusal};
use serde_json::{json, Value};
use std::any::Any;
use std::io::{self, BufRead, Write};
use std::panic::{catch_unwind, AssertUnwindSafe};

/// The version of the protocol that this crate speaks.
const PROTOCOL: u64 = 1;

/// Answers the questions of Touchstone until "bye" or the end of the input. A panic in a
/// method of the oracle is a failure of that question only.
pub fn serve(oracle: &dyn Oracle) -> io::Result<()> {
    let mut output = io::BufWriter::new(io::stdout().lock());
    for line in io::stdin().lock().lines() {
        let message: Value = serde_json::from_str(&line?).unwrap_or_default();
        if message["method"] == "bye" {
            break;
        }
        let mut answer = match answer(oracle, &message) {
            Ok(answer) => answer,
            Err(refusal) => refusal.to_json(),
        };
        answer["id"] = message["id"].clone();
        writeln!(output, "{answer}")?;
        output.flush()?;
    }
    Ok(())
}

fn answer(oracle: &dyn Oracle, message: &Value) -> Result<Value, Refusal> {
    match message["method"].as_str() {
        Some("hello") => {
            let mut about = oracle.about();
            about["protocol"] = json!(PROTOCOL);
            Ok(about)
        }
        Some("contact") => Ok(json!({ "answers": contacts(oracle, message)? })),
        Some("world") => {
            let world = question::world(&message["world"]).map_err(Refusal::Error)?;
            let parameters =
                question::parameters(&message["parameters"]).map_err(Refusal::Error)?;
            Ok(guarded(|| oracle.simulate(&world, &parameters))?.to_json())
        }
        _ => Err(Refusal::Error("expected a line of JSON with a known method".into())),
    }
}

fn contacts(oracle: &dyn Oracle, message: &Value) -> Result<Vec<Value>, Refusal> {
    let mut answers = Vec::new();
    for query in question::items(&message["queries"]).map_err(Refusal::Error)? {
        let a = question::body(&query["A"]).map_err(Refusal::Error)?;
        let b = question::body(&query["B"]).map_err(Refusal::Error)?;
        answers.push(match guarded(|| oracle.contact(&a, &b)) {
            Ok(contact) => contact.to_json(),
            Err(refusal) => refusal.to_json(),
        });
    }
    Ok(answers)
}

// Turns a panic into a refusal. The standard hook has written it to standard error.
fn guarded<T>(ask: impl FnOnce() -> Result<T, Refusal>) -> Result<T, Refusal> {
    // An oracle answers from the question alone, so a panic leaves nothing behind.
    catch_unwind(AssertUnwindSafe(ask))
        .unwrap_or_else(|panic| Err(Refusal::Error(format!("panic: {}", text_of(&*panic)))))
}

fn text_of(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("without a message")
}
