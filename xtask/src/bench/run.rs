//! One run of the firmware on a board, and what it printed.

use super::bound::{Sample, Work};
use super::figures::Stages;
use crate::boards::{Board, Scalar};
use crate::qemu;
use anyhow::{Context, Result, bail};
use std::path::Path;
use std::time::Duration;

/// An instruction takes 256 ns of virtual time: three ticks of SysTick or more on every board.
const SHIFT: u32 = 8;
/// A run takes a second.
const LIMIT: Duration = Duration::from_secs(120);

/// What one call costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cost {
    pub instructions: u32,
    pub stack: u32,
}

/// All that a run found out.
#[derive(Debug, Default)]
pub struct Found {
    /// Instructions between two readings of the counter with nothing between them; already subtracted.
    pub empty: u32,
    pub operations: Vec<(String, Cost)>,
    /// For each impact its cost without friction and with it; `None` where the number type cannot hold it.
    pub rows: Vec<Option<[Cost; 2]>>,
    /// After the first impact, without friction (`resolve`) and with it.
    pub results: Vec<(String, Words)>,
    /// Other libraries on the first impact.
    pub peers: Vec<Peer>,
    pub scenes: Vec<Played>,
    /// Steps to find a bound in.
    pub samples: Vec<Sample>,
    /// The stages of a step, scene by scene.
    pub stages: Vec<(String, Stages)>,
}

/// The bits of v_a, w_a, v_b, w_b.
pub type Words = [u32; 12];

/// What another library took.
#[derive(Debug, PartialEq)]
pub struct Peer {
    pub name: String,
    pub operation: String,
    pub cost: Cost,
    pub result: Words,
}

/// A scene that was played to its end.
#[derive(Debug, PartialEq)]
pub struct Played {
    pub by: String,
    pub name: String,
    /// Of the last steps the mean; the most stack.
    pub cost: Cost,
    pub min: u32,
    pub max: u32,
    /// The step of the maximum.
    pub worst: u32,
    /// Bytes of the world.
    pub ram: u32,
    /// The bits of what came of it.
    pub outcome: u32,
}

/// Runs the firmware in one number type over the input.
pub fn run(elf: &Path, board: Board, scalar: Scalar, input: &Path) -> Result<Found> {
    let arguments = ["--input".to_owned(), input.display().to_string()];
    let run =
        qemu::Run { example: "bench", elf, board, scalar, arguments: &arguments, limit: LIMIT, icount: Some(SHIFT) };
    let (status, text) = run.capture()?;
    let text = String::from_utf8(text).context("the firmware printed no text")?;
    if !status.success() {
        bail!("the firmware failed on {board} in {scalar}: {}", text.lines().last().unwrap_or("no output"));
    }
    parse(&text).with_context(|| format!("reading what {board} in {scalar} printed"))
}

fn parse(text: &str) -> Result<Found> {
    let mut found = Found::default();
    for line in text.lines() {
        let words: Vec<&str> = line.split(' ').collect();
        let is_number = |word: &&str| word.bytes().all(|byte| byte.is_ascii_digit());
        let (names, numbers) = words.split_at(words.iter().position(is_number).unwrap_or(words.len()));
        let numbers: Vec<u32> =
            numbers.iter().map(|word| word.parse()).collect::<Result<_, _>>().with_context(|| format!("`{line}`"))?;
        let name = |at: usize| names[at].to_owned();
        let cost = |at: usize| Cost { instructions: numbers[at], stack: numbers[at + 1] };
        let last = numbers.last_chunk().copied();
        match (names, numbers.len(), last) {
            (["counter"], 2, _) => found.empty = numbers[0],
            (["operation", _], 2, _) => found.operations.push((name(1), cost(0))),
            (["result", _], 12, Some(result)) => found.results.push((name(1), result)),
            (["peer", _, _], 14, Some(result)) => {
                found.peers.push(Peer { name: name(1), operation: name(2), cost: cost(0), result });
            }
            (["scene", _, _], 7, _) => found.scenes.push(Played {
                by: name(1),
                name: name(2),
                cost: Cost { instructions: numbers[0], stack: numbers[4] },
                min: numbers[1],
                max: numbers[2],
                worst: numbers[3],
                ram: numbers[5],
                outcome: numbers[6],
            }),
            (["stages", _], 6, _) => {
                let &[broad, narrow, prepare, solve, integrate, keep] = &numbers[..] else {
                    unreachable!("there are six")
                };
                found.stages.push((name(1), Stages { broad, narrow, prepare, solve, integrate, keep }));
            }
            (["bound", _, _], 5, _) => {
                let &[sub_steps, bodies, pairs, points, instructions] = &numbers[..] else {
                    unreachable!("there are five")
                };
                let work = Work { sub_steps, bodies, pairs, points };
                found.samples.push(Sample { kind: name(1), scene: name(2), work, instructions });
            }
            (["row"], 5, _) => found.rows.push(Some([cost(1), cost(3)])),
            (["skip"], 1, _) => found.rows.push(None),
            _ => bail!("`{line}` is nothing that is expected"),
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_firmware_prints() {
        let found = parse("counter 1 6400\noperation dot 28 32\nskip 0\nrow 1 2 3 4 5\n").expect("it is right");
        assert_eq!(found.empty, 1);
        assert_eq!(found.operations, [("dot".to_owned(), Cost { instructions: 28, stack: 32 })]);
        assert_eq!(found.rows[0], None);
        assert_eq!(found.rows[1], Some([(2, 3), (4, 5)].map(|(instructions, stack)| Cost { instructions, stack })));
        let found = parse("scene x spheres_8 1 2 3 4 5 6 7\nstages spheres_8 1 2 3 4 5 6\n").expect("it is right");
        let cost = Cost { instructions: 1, stack: 5 };
        let (by, name) = ("x".to_owned(), "spheres_8".to_owned());
        assert_eq!(found.scenes, [Played { by, name, cost, min: 2, max: 3, worst: 4, ram: 6, outcome: 7 }]);
        assert_eq!(found.stages[0].1.all(), [1, 2, 3, 4, 5, 6]);
        assert!(parse("row 1 2 3").is_err());
        assert!(parse("row 1 2 3 4 x").is_err());
    }
}
