//! A firmware from its start to its end.

use super::counter;
use crate::board;

/// Calibrates the counter and measures; prints what went wrong.
pub fn run(measure: fn() -> Result<(), &'static str>) -> board::Exit {
    match counter::start().then(measure).unwrap_or(Err("the counter does not count exactly")) {
        Ok(()) => board::Exit::Success,
        Err(problem) => {
            board::println!("error {problem}");
            board::Exit::Failure
        }
    }
}
