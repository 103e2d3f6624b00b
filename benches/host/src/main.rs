//! A step of 64 bodies in f32 on this machine: carom, rapier3d and he3d-physics, each on one thread and with its own iterations.
//!
//! Eight stacks of eight unit balls, or boxes, that have stood for a second; friction of a half, steps of 1/60 s, nobody sleeps. Prints
//! the ratios to carom (times of one machine say little by themselves), and how high the stacks stand: 7.5 m would be rigid.

mod with_carom;
mod with_he3d;
mod with_rapier;

use anyhow::{Context, Result};
use criterion::{Criterion, SamplingMode};
use std::path::Path;
use std::time::Duration;

/// Stacks, and pieces of each.
pub const STACKS: u8 = 8;
pub const HIGH: u8 = 8;

/// What the pieces are.
#[derive(Clone, Copy, Debug)]
pub enum Piece {
    Ball,
    Box,
}

/// Somebody's world.
pub trait Peer {
    const NAME: &'static str;

    fn new(piece: Piece) -> Self;
    fn step(&mut self);
    /// The height of the centre of each piece.
    fn heights(&self) -> Vec<f32>;
}

/// Where the piece begins: x, y, z, of which y is up.
pub fn start(stack: u8, piece: u8) -> [f32; 3] {
    let [row, column] = [stack / 4, stack % 4].map(f32::from);
    [4.0 * row, 0.5 + f32::from(piece), 4.0 * column]
}

/// Measures, and returns the height of the stacks in the end: the mean of the eight highest pieces.
fn measure<P: Peer>(criterion: &mut Criterion, piece: Piece) -> f32 {
    let mut world = P::new(piece);
    let mut group = criterion.benchmark_group(format!("{piece:?}"));
    group.sampling_mode(SamplingMode::Flat).sample_size(20).measurement_time(Duration::from_secs(3));
    for _ in 0..60 {
        world.step();
    }
    group.bench_function(P::NAME, |bencher| bencher.iter(|| world.step()));
    let mut heights = world.heights();
    heights.sort_by(|a, b| b.total_cmp(a));
    heights.iter().take(STACKS.into()).sum::<f32>() / f32::from(STACKS)
}

/// The median time of a step in nanoseconds, from what criterion wrote.
fn median(piece: Piece, name: &str) -> Result<f64> {
    let path = format!("{piece:?}/{name}/new/estimates.json");
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/criterion").join(path);
    let text = std::fs::read_to_string(&path).with_context(|| format!("reading {}", path.display()))?;
    let estimates: serde_json::Value = serde_json::from_str(&text)?;
    estimates["median"]["point_estimate"].as_f64().context("criterion wrote no median")
}

fn main() -> Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/criterion");
    let mut criterion = Criterion::default().output_directory(&folder).configure_from_args();
    let mut lines = Vec::new();
    for piece in [Piece::Ball, Piece::Box] {
        let tops = [
            (with_carom::WithCarom::NAME, measure::<with_carom::WithCarom>(&mut criterion, piece)),
            (with_he3d::WithHe3d::NAME, measure::<with_he3d::WithHe3d>(&mut criterion, piece)),
            (with_rapier::WithRapier::NAME, measure::<with_rapier::WithRapier>(&mut criterion, piece)),
        ];
        let carom = median(piece, tops[0].0)?;
        for (name, top) in tops {
            let time = median(piece, name)?;
            let (kind, micros, ratio) = (format!("{piece:?}"), time / 1e3, time / carom);
            lines.push(format!("| {kind:<5} | {name:<12} | {micros:>8.1} | {ratio:>9.2} | {top:>7.4} |"));
        }
    }
    println!(
        "64 bodies, one thread, f32\n| piece | engine       | us/step  | of carom's | top, m  |\n{}",
        lines.join("\n")
    );
    Ok(())
}
