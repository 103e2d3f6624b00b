//! `docs/cost.svg`: instructions for an impulse by board and number format, ours and others', on a logarithmic scale.

use super::figures::OWN;
use super::image::Opt;
use super::markdown::grouped;
use super::snapshot::Snapshot;
use crate::boards::{Board, Scalar};

/// A line of a panel: what it is called, who, which operation, in which number type.
type Line = (&'static str, &'static str, &'static str, Scalar);

const IMPULSE: &[Line] = &[
    ("carom f32", OWN, "resolve", Scalar::F32),
    ("carom I16F16", OWN, "resolve", Scalar::I16F16),
    ("glam f32", "glam", "resolve", Scalar::F32),
    ("nalgebra f32", "nalgebra", "resolve", Scalar::F32),
    ("by hand f32", "plain", "resolve", Scalar::F32),
    ("by hand I16F16", "fixed", "resolve", Scalar::I16F16),
];

const FRICTION: &[Line] = &[
    ("carom f32, sticks", OWN, "friction_stick", Scalar::F32),
    ("carom f32, slides", OWN, "friction_slip", Scalar::F32),
    ("carom I16F16, sticks", OWN, "friction_stick", Scalar::I16F16),
    ("carom I16F16, slides", OWN, "friction_slip", Scalar::I16F16),
    ("embedded-3dgfx f32", "embedded-3dgfx", "friction", Scalar::F32),
];

const COLUMNS: [(&str, &[Line]); 2] = [("One impulse", IMPULSE), ("One impulse with friction", FRICTION)];

/// An M7 runs the same code as an M4F.
const BOARDS: [(Board, &str); 4] = [
    (Board::M0, "Cortex-M0: no FPU, no divide"),
    (Board::M3, "Cortex-M3: no FPU"),
    (Board::M4f, "Cortex-M4F, Cortex-M7"),
    (Board::M33, "Cortex-M33"),
];

const WIDTH: f64 = 880.0;
const COLUMN: f64 = WIDTH / 2.0;
/// Room for names, and for the number behind the longest line.
const LEFT: f64 = 150.0;
const RIGHT: f64 = 60.0;
const TOP: f64 = 84.0;
const ROW: f64 = 18.0;
const PANEL: f64 = ROW * IMPULSE.len() as f64 + 56.0;
const HEIGHT: f64 = TOP + PANEL * BOARDS.len() as f64;

/// Colours for light pages, and for dark ones.
const STYLE: &str = "\
text { font: 12px system-ui, -apple-system, 'Segoe UI', Helvetica, Arial, sans-serif; fill: #1f2328 }
.title { font-size: 15px; font-weight: 600 } .board { font-weight: 600 } .tick, .note { fill: #656d76; font-size: 11px }
.grid { stroke: #d1d9e0; stroke-width: 1 } .line { stroke: #8c959f; stroke-width: 2 } .dot { fill: #8c959f }
.own.line { stroke: #0969da } .own.dot { fill: #0969da } .own.name { font-weight: 600 }
@media (prefers-color-scheme: dark) {
text { fill: #e6edf3 } .tick, .note { fill: #9198a1 } .grid { stroke: #3d444d } .line { stroke: #7d8590 }
.dot { fill: #7d8590 } .own.line { stroke: #58a6ff } .own.dot { fill: #58a6ff }
}
";

/// The drawing.
pub fn svg(snapshot: &Snapshot) -> String {
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{HEIGHT}\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" \
         role=\"img\">\n<title>Instructions for one impulse, by board and number format</title>\n<style>\n{STYLE}</style>\n"
    );
    svg += &text(10.0, 20.0, "title", "start", "Instructions for one impulse between two bodies");
    let note =
        "Counted by QEMU, not cycles; opt-level 3; logarithmic scale. With friction: medians of a few hundred impacts.";
    svg += &text(10.0, 38.0, "note", "start", note);
    for (place, (_, name)) in BOARDS.into_iter().enumerate() {
        let y = TOP + place as f64 * PANEL;
        svg += &format!(
            "<line class=\"grid\" x1=\"10\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\"/>\n",
            y - 14.0,
            WIDTH - 10.0,
            y - 14.0
        );
        svg += &text(10.0, y + 3.0, "board", "start", name);
    }
    for (index, (title, lines)) in COLUMNS.into_iter().enumerate() {
        let scale = Scale::new(snapshot, lines, index as f64 * COLUMN);
        svg += &text(scale.left, 62.0, "board", "start", title);
        for (place, (board, _)) in BOARDS.into_iter().enumerate() {
            svg += &panel(snapshot, lines, board, &scale, TOP + place as f64 * PANEL);
        }
    }
    svg + "</svg>\n"
}

/// From instructions to places, the same for all panels of a column.
struct Scale {
    left: f64,
    /// Powers of ten.
    from: i32,
    to: i32,
}

impl Scale {
    fn new(snapshot: &Snapshot, lines: &[Line], x: f64) -> Self {
        let numbers: Vec<f64> =
            BOARDS.iter().flat_map(|(board, _)| lines.iter().filter_map(|line| find(snapshot, *board, line))).collect();
        let power = |x: f64| x.log10();
        let from = numbers.iter().copied().map(power).fold(f64::INFINITY, f64::min).floor();
        let to = numbers.iter().copied().map(power).fold(0.0, f64::max).ceil();
        Self { left: x + LEFT, from: if from.is_finite() { from as i32 } else { 0 }, to: to as i32 }
    }

    fn place(&self, instructions: f64) -> f64 {
        let share = (instructions.log10() - f64::from(self.from)) / f64::from(self.to - self.from);
        self.left + share * (COLUMN - LEFT - RIGHT)
    }
}

fn panel(snapshot: &Snapshot, lines: &[Line], board: Board, scale: &Scale, top: f64) -> String {
    let bottom = top + ROW * IMPULSE.len() as f64 + 16.0;
    let mut svg = String::new();
    for power in scale.from..=scale.to {
        let x = scale.place(10_f64.powi(power));
        svg += &format!(
            "<line class=\"grid\" x1=\"{x:.1}\" y1=\"{:.1}\" x2=\"{x:.1}\" y2=\"{bottom:.1}\"/>\n",
            top + 12.0
        );
        svg += &text(x, bottom + 12.0, "tick", "middle", &grouped(10_u32.pow(power.unsigned_abs())));
    }
    for (place, line) in lines.iter().enumerate() {
        let y = top + 24.0 + ROW * place as f64;
        let Some(instructions) = find(snapshot, board, line) else { continue };
        let (name, by, ..) = line;
        let own = if *by == OWN { "own " } else { "" };
        let x = scale.place(instructions);
        svg += &text(scale.left - 8.0, y + 4.0, &format!("{own}name"), "end", name);
        let from = scale.left;
        svg += &format!("<line class=\"{own}line\" x1=\"{from:.1}\" y1=\"{y:.1}\" x2=\"{x:.1}\" y2=\"{y:.1}\"/>\n");
        svg += &format!("<circle class=\"{own}dot\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>\n");
        svg += &text(x + 8.0, y + 4.0, "", "start", &grouped(instructions as u32));
    }
    svg
}

fn find(snapshot: &Snapshot, board: Board, (_, by, operation, scalar): &Line) -> Option<f64> {
    snapshot.find(board, by, operation, *scalar, Opt::Speed).map(|figure| figure.instructions.into())
}

fn text(x: f64, y: f64, class: &str, anchor: &str, words: &str) -> String {
    format!("<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{words}</text>\n")
}
