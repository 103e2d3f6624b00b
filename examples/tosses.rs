//! Measured tosses of a cube, replayed by the solver from their first frame: how far off is it, and does it end on the same
//! face? Bit for bit the same on a board and on the host.
//!
//! `--input FILE` (columns toss, px, py, pz, qw, qx, qy, qz, vx, vy, vz, wbx, wby, wbz in SI units at 148 Hz, the last three
//! in the cube's frame), `--tosses 10`. The parameters are those of the cube that was tossed.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;
mod scenes;

use board::{Exit, LineReader};
use carom::{Quat, Scalar, Scaled, StateHash, Vec3};
use numbers::{Job, Number, decimal};
use scenes::make::square;
use scenes::toss::{Cube, Setup};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Tosses)
}

struct Tosses;

impl Job for Tosses {
    fn run<S: Number>(&self) -> Exit {
        match replay::<S>() {
            Ok(()) => Exit::Success,
            Err(problem) => {
                board::println!("tosses: {problem}");
                Exit::Failure
            }
        }
    }
}

const COLUMNS: usize = 14;
const NAMES: [&str; COLUMNS] =
    ["toss", "px", "py", "pz", "qw", "qx", "qy", "qz", "vx", "vy", "vz", "wbx", "wby", "wbz"];
/// The most columns that a file may have.
const WIDEST: usize = 24;

/// Where the cube is, as it was recorded.
struct Frame<S: Scalar> {
    position: Vec3<S>,
    orientation: Quat<S>,
}

/// A toss in the making.
struct Toss<S: Scalar> {
    number: u32,
    cube: Cube<S>,
    frames: u32,
    /// Of the distances between the recorded cube and this one.
    sum: S::Scaled,
    same_face: bool,
}

fn replay<S: Number>() -> Result<(), &'static str> {
    let path = board::option("--input").ok_or("--input FILE is missing")?;
    let most: u32 = board::option("--tosses").unwrap_or("10").parse().map_err(|_| "--tosses takes a number")?;
    let mut file = board::open(path).map_err(|_| "the file cannot be opened")?;
    let columns = columns(&mut file)?;
    let mut current: Option<Toss<S>> = None;
    let (mut tosses, mut same, mut sum) = (0u32, 0u32, S::Scaled::ZERO);
    let mut hash = StateHash::new();
    loop {
        let line = file.next_line().map_err(|_| "the file cannot be read")?;
        let cells = line.map(|line| cells(line, &columns));
        let number = match &cells {
            Some([number, ..]) => Some(number.parse().map_err(|_| "a row has no number of its toss")?),
            None => None,
        };
        if let Some(toss) = current.take_if(|toss| Some(toss.number) != number) {
            let error = toss.sum / S::Scaled::from_parts(toss.frames.max(1) as i32, 0);
            let word = if toss.same_face { "the same face" } else { "another face" };
            let parts = parts_of_side::<S>(error);
            board::println!(
                "toss {:3}: {:3} frames, off by {parts:4} thousandths of a side, {word}",
                toss.number,
                toss.frames
            );
            same = same.wrapping_add(u32::from(toss.same_face));
            sum = sum + error;
            tosses = tosses.wrapping_add(1);
        }
        let (Some(cells), Some(number)) = (cells, number) else { break };
        if tosses >= most {
            break;
        }
        let frame = frame::<S>(&cells).ok_or("a row is not as it should be")?;
        match &mut current {
            None => {
                let cube = cube(&cells, &frame).ok_or("a first row is not as it should be")?;
                current = Some(Toss { number, cube, frames: 1, sum: S::Scaled::ZERO, same_face: true });
            }
            Some(toss) => {
                kernel_frame(&mut toss.cube);
                toss.compare(&frame);
            }
        }
        if let Some(toss) = &current {
            hash.add_body(toss.cube.body());
        }
    }
    if tosses == 0 {
        return Err("the file has no rows");
    }
    let mean = parts_of_side::<S>(sum / S::Scaled::from_parts(tosses as i32, 0));
    board::println!("{}: {tosses} tosses, off by {mean} thousandths of a side, {same} end on the same face", S::NAME);
    board::println!("state {:016x}", hash.get());
    Ok(())
}

impl<S: Number> Toss<S> {
    fn compare(&mut self, frame: &Frame<S>) {
        let body = self.cube.body();
        self.frames = self.frames.wrapping_add(1);
        self.sum = self.sum + square(body.position - frame.position).sqrt();
        // Less than 45 degrees between the two: |p . q| above the cosine of half of that.
        let [p, q] = [body.orientation(), frame.orientation].map(Quat::to_array);
        let dot = p.into_iter().zip(q).fold(S::Scaled::ZERO, |sum, (p, q)| sum + p.to_scaled() * q.to_scaled());
        self.same_face = dot.max(-dot) > S::Scaled::ratio(92_388, 100_000);
    }
}

/// Metres as thousandths of the cube's side, 104.8 mm.
fn parts_of_side<S: Number>(metres: S::Scaled) -> i32 {
    S::from_scaled(metres * S::Scaled::ratio(10_000, 1048)).0.milli()
}

#[inline(never)]
fn kernel_frame<S: Scalar>(cube: &mut Cube<S>) {
    cube.frame();
}

fn columns(file: &mut LineReader) -> Result<[usize; COLUMNS], &'static str> {
    let header = file.next_line().map_err(|_| "the file cannot be read")?.ok_or("the file is empty")?;
    let mut columns = [0; COLUMNS];
    for (column, name) in columns.iter_mut().zip(NAMES) {
        let mut titles = header.split(',').take(WIDEST);
        *column = titles.position(|title| title.trim() == name).ok_or("a column is missing")?;
    }
    Ok(columns)
}

/// The cells of a row in the order of [`NAMES`].
fn cells<'a>(line: &'a str, columns: &[usize; COLUMNS]) -> [&'a str; COLUMNS] {
    let mut all = [""; WIDEST];
    for (cell, text) in all.iter_mut().zip(line.split(',')) {
        *cell = text.trim();
    }
    columns.map(|column| all.get(column).copied().unwrap_or(""))
}

fn vector<S: Scalar>([x, y, z]: [&str; 3]) -> Option<Vec3<S>> {
    let number = |text| decimal::<S>(text, S::Scaled::ONE);
    Some(Vec3::new(number(x)?, number(y)?, number(z)?))
}

fn frame<S: Number>(cells: &[&str; COLUMNS]) -> Option<Frame<S>> {
    let [_, px, py, pz, qw, qx, qy, qz, ..] = *cells;
    let unit = |text| decimal::<S::Unit>(text, S::Scaled::ONE);
    let orientation = Quat::normalize(unit(qw)?, unit(qx)?, unit(qy)?, unit(qz)?).ok()?;
    Some(Frame { position: vector([px, py, pz])?, orientation })
}

fn cube<S: Number>(cells: &[&str; COLUMNS], frame: &Frame<S>) -> Option<Cube<S>> {
    let [.., vx, vy, vz, wx, wy, wz] = *cells;
    Cube::new(&Setup::nominal()?, frame.position, frame.orientation, vector([vx, vy, vz])?, vector([wx, wy, wz])?)
}
