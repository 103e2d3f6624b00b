//! The command line.

use std::ffi::OsString;
use std::io::Write;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

use super::error::Result;
use super::geometry::Geometry;
use super::impulses::Impulses;
use super::number::Number;
use super::planar::Planar;
use super::report::Report;
use super::tosses::Tosses;
use crate::scalars;

/// Holds the library against impacts and pairs of shapes whose results are known.
///
/// Prints errors by category and the verdict on each tolerance. Exit status: 0 where all tolerances are met, 1 where not
/// or where a file is bad (one line says where), 2 for a command line that makes no sense.
#[derive(Debug, Parser)]
#[command(name = "validate")]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Impacts of two bodies in space
    ///
    /// FILE is CSV with a header; its columns may stand in any order: id, cat, q16, the masses m1 m2 (0: immovable),
    /// principal moments I1x..., orientations q1w... (of any length), arms r1x..., velocities v1x... and w1x..., the normal
    /// nx ny nz from body 1 to body 2, e, mu; and the right results mode, Jx Jy Jz (on body 2), vp1x..., wp1x.... A file
    /// without results is held against a closed form in f64.
    Impulses(ImpulsesArgs),
    /// Impacts of one body on a fixed plane
    ///
    /// FILE is CSV with one of two headers. Measured impacts of an ellipse of 36.4 g with semi-axes of 35 and 25 mm: i,
    /// vx0, vy0, w0, the rows of the contact's Jacobian Jn_x Jn_y Jn_w and Jt_x Jt_y Jt_w, and the measured vx1, vy1, w1;
    /// the kernel is held against Newton's restitution with Coulomb's friction in closed form. Or impact laws: id, shape,
    /// m, I, rx, ry, mu, e, vx, vy, w, newton_jn, newton_jt, newton_mode; rows of mode threshold_mu are skipped.
    Planar(PlanarArgs),
    /// Signed distances and normals of pairs of shapes
    ///
    /// FILE is CSV with a header; its columns may stand in any order: id, the kinds A and B (sphere, box, capsule or plane),
    /// and of each size (radius; half extents; radius and half length along z; nothing), pos, quat (w x y z, of any length)
    /// with blanks between the numbers; and the right dist and normal, from A to B. Where shapes overlap, the distance is that
    /// of the least translation that parts them. A row has tied axes where another normal than the file's separates the
    /// shapes just as far; it is counted, and its distance compared.
    Geometry(GeometryArgs),
    /// Measured tosses of a cube onto a table, replayed from their first frame
    ///
    /// FILE is CSV with a header; its columns may stand in any order: toss, the rows of one standing together, 148 a second;
    /// px py pz (m), qw qx qy qz (body to world), vx vy vz (m/s), and in the body's frame wbx wby wbz (rad/s). The cube is the
    /// one of the ContactNets experiment: side 104.8 mm, 0.37 kg, friction 0.18, restitution 0.125. A step is a quarter of
    /// a frame.
    Tosses(TossesArgs),
}

#[derive(Debug, Args)]
struct Common {
    /// What to hold it against
    file: PathBuf,
    /// The number type the kernel computes in
    #[arg(long, value_enum, default_value_t = Number::F32)]
    scalar: Number,
    /// Write the kernel's results there, as CSV
    #[arg(long, value_name = "RESULTS.csv")]
    out: Option<PathBuf>,
}

#[derive(Debug, Args)]
struct ImpulsesArgs {
    #[command(flatten)]
    common: Common,
}

#[derive(Debug, Args)]
struct TossesArgs {
    #[command(flatten)]
    common: Common,
}

#[derive(Debug, Args)]
struct GeometryArgs {
    #[command(flatten)]
    common: Common,
    /// The same shapes a thousand times smaller, in units that suit the number type; errors in millimetres
    #[arg(long)]
    millimetres: bool,
    /// Boxes as convex hulls of their corners, planes as flat height fields
    #[arg(long)]
    disguised: bool,
}

#[derive(Debug, Args)]
struct PlanarArgs {
    #[command(flatten)]
    common: Common,
    /// Friction of the ellipse [default: 0.12]
    #[arg(long, value_parser = friction)]
    mu: Option<f64>,
    /// Restitution of the ellipse [default: 0.537]
    #[arg(long, value_name = "E", value_parser = restitution)]
    restitution: Option<f64>,
}

/// The program: its exit status.
pub fn run(
    arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
    out: &mut dyn Write,
    err: &mut dyn Write,
) -> u8 {
    let command = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli.command,
        Err(error) if error.use_stderr() => {
            let _ = writeln!(err, "validate: {}", one_line(&error.to_string()));
            return 2;
        }
        Err(help) => {
            let _ = write!(out, "{help}");
            return 0;
        }
    };
    match execute(command) {
        Ok(report) => {
            // A reader that has gone away takes nothing from the verdict.
            let _ = out.write_all(report.text.as_bytes()).and_then(|()| out.flush());
            if let Some(problem) = &report.problem {
                let _ = writeln!(err, "validate: {problem}");
            }
            u8::from(report.problem.is_some())
        }
        Err(error) => {
            let _ = writeln!(err, "validate: {error}");
            1
        }
    }
}

fn execute(command: Command) -> Result<Report> {
    match command {
        Command::Tosses(TossesArgs { common: Common { file, scalar, out } }) => {
            scalars::run(scalar, Tosses { file: &file, number: scalar, out: out.as_deref() })
        }
        Command::Impulses(ImpulsesArgs { common: Common { file, scalar, out } }) => {
            scalars::run(scalar, Impulses { file: &file, number: scalar, out: out.as_deref() })
        }
        Command::Planar(PlanarArgs { common: Common { file, scalar, out }, mu, restitution }) => {
            scalars::run(scalar, Planar { file: &file, number: scalar, out: out.as_deref(), mu, restitution })
        }
        Command::Geometry(GeometryArgs { common: Common { file, scalar, out }, millimetres, disguised }) => {
            scalars::run(
                scalar,
                Geometry { file: &file, number: scalar, out: out.as_deref(), millimetres, disguised: [disguised; 2] },
            )
        }
    }
}

fn restitution(text: &str) -> std::result::Result<f64, String> {
    let e: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    if (0.0..=1.0).contains(&e) { Ok(e) } else { Err("outside 0 to 1".to_owned()) }
}

fn friction(text: &str) -> std::result::Result<f64, String> {
    let mu: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    if mu >= 0.0 && mu.is_finite() { Ok(mu) } else { Err("negative or not finite".to_owned()) }
}

/// Clap's message without the usage below it.
fn one_line(message: &str) -> String {
    let lines = message.lines().map(str::trim).take_while(|line| !line.starts_with("Usage:"));
    let told: Vec<&str> = lines.filter(|line| !line.is_empty() && !line.starts_with("For more information")).collect();
    told.join(" ").trim_start_matches("error: ").to_owned()
}
