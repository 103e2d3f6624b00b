//! Measured impacts through the kernel: reads the planar impacts of a dropped ellipse from a file, predicts each, and
//! prints what came out, bit for bit the same on a board and on the host.
//!
//! `--input FILE` (columns vx0, vy0, w0, Jn_w, Jt_w of an ellipse of 36.4 g with semi-axes of 35 and 25 mm),
//! `--mu 0.12`, `--restitution 0.537`, `--rows` to print every row.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;

use board::{Exit, LineReader};
use carom::impulse::{Impact, resolve_collision_with_friction};
use carom::{Body, Contact, MassProperties, Material, Scalar, Scaled, StateHash, UnitVec3, Vec3};
use numbers::{Job, Number, decimal};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Impacts)
}

struct Impacts;

impl Job for Impacts {
    fn run<S: Number>(&self) -> Exit {
        match predict::<S>() {
            Ok(()) => Exit::Success,
            Err(problem) => {
                board::println!("impacts: {problem}");
                Exit::Failure
            }
        }
    }
}

/// Where the columns stand in a row, in the order of [`NAMES`].
type Columns = [usize; 5];
const NAMES: [&str; 5] = ["vx0", "vy0", "w0", "Jn_w", "Jt_w"];

/// The units of the kernel's numbers: decimetres, seconds, and the ellipse's mass. Everything is of order one to a
/// hundred in them, which suits every format.
struct Units<T> {
    length: T,
}

fn predict<S: Number>() -> Result<(), &'static str> {
    let path = board::option("--input").ok_or("--input FILE is missing")?;
    let units = Units { length: S::Scaled::from_parts(10, 0) };
    let ellipse = ellipse::<S>().ok_or("the ellipse cannot be set up")?;
    let one = S::Scaled::ONE;
    let coefficient = |name, default| decimal::<S>(board::option(name).unwrap_or(default), one);
    let restitution = coefficient("--restitution", "0.537").ok_or("--restitution takes a number")?;
    let friction = coefficient("--mu", "0.12").ok_or("--mu takes a number")?;
    let material = Material::new(restitution, friction).map_err(|_| "restitution or friction is out of range")?;

    let mut file = board::open(path).map_err(|_| "the file cannot be opened")?;
    let columns = columns(&mut file)?;
    let every_row = board::args().any(|arg| arg == "--rows");
    let (mut rows, mut stuck, mut slid, mut apart) = (0u32, 0u32, 0u32, 0u32);
    let mut hash = StateHash::new();
    while let Some(line) = file.next_line().map_err(|_| "the file cannot be read")? {
        let (mut body, contact) = row::<S>(line, &columns, &units, &ellipse).ok_or("a row is not as it should be")?;
        let impact = kernel_impact(&mut Body::immovable(), &mut body, &contact, &material);
        use carom::impulse::Outcome::{Slid, Stuck};
        match impact.outcome {
            Stuck => stuck += 1,
            Slid => slid += 1,
            _ => apart += 1,
        }
        if impact.saturated {
            return Err("a result is beyond the format");
        }
        hash.add(impact.normal_impulse);
        hash.add_vec3(impact.friction_impulse);
        hash.add_body(&body);
        rows += 1;
        if every_row {
            let (v, w) = (body.linear_velocity, body.angular_velocity.z);
            let [jn, jt, vx, vy, w] = [impact.normal_impulse, impact.friction_impulse.x, v.x, v.y, w].map(S::bits);
            board::println!("{rows} {jn:x} {jt:x} {vx:x} {vy:x} {w:x}");
        }
        if rows % 100 == 0 {
            board::println!("{} {rows} impacts: state {:016x}", S::NAME, hash.get());
        }
    }
    board::println!("{rows} measured impacts: {stuck} stuck, {slid} slid, {apart} apart, state {:016x}", hash.get());
    if rows > 0 { Ok(()) } else { Err("the file has no rows") }
}

/// Mass one, and the inertia of a lamina: m b^2/4 about x, m a^2/4 about y, their sum about z.
fn ellipse<S: Number>() -> Option<Body<S>> {
    let quarter = |milli: i32| {
        let axis = S::Scaled::ratio(milli, 100);
        S::Scaled::ratio(1, 4) * axis * axis
    };
    let (x, y) = (quarter(25), quarter(35));
    let one = S::Scaled::ONE;
    let mass = MassProperties::from_inverses(one, [one / x, one / y, one / (x + y)]).ok()?;
    Some(Body::dynamic(mass))
}

fn columns(file: &mut LineReader) -> Result<Columns, &'static str> {
    let header = file.next_line().map_err(|_| "the file cannot be read")?.ok_or("the file is empty")?;
    let mut columns = [0; 5];
    for (column, name) in columns.iter_mut().zip(NAMES) {
        *column = header.split(',').position(|title| title.trim() == name).ok_or("a column is missing")?;
    }
    Ok(columns)
}

/// The body before the impact, and the contact: the ground is body A, and the normal points up.
fn row<S: Number>(
    line: &str,
    columns: &Columns,
    units: &Units<S::Scaled>,
    ellipse: &Body<S>,
) -> Option<(Body<S>, Contact<S>)> {
    let number = |index: usize, unit| decimal::<S>(line.split(',').nth(*columns.get(index)?)?.trim(), unit);
    let length = units.length;
    let mut body = *ellipse;
    body.linear_velocity = Vec3::new(number(0, length)?, number(1, length)?, S::ZERO);
    body.angular_velocity = Vec3::new(S::ZERO, S::ZERO, number(2, S::Scaled::ONE)?);
    // The rows of the contact's Jacobian are (0, 1, r_x) and (1, 0, -r_y).
    let r_b = Vec3::new(number(3, length)?, number(4, length)?.negated(), S::ZERO);
    Some((body, Contact { normal: UnitVec3::Y, r_a: Vec3::ZERO, r_b }))
}

#[inline(never)]
fn kernel_impact<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
) -> Impact<S> {
    resolve_collision_with_friction(a, b, contact, material)
}
