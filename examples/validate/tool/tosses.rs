//! `validate tosses`: measured tosses of a cube onto a table, replayed from their first frame.

mod recording;
mod replay;
// Its nominal parameters are for boards; here they come from the tool's table.
#[allow(dead_code)]
#[path = "../../scenes/toss.rs"]
mod scene;
mod score;

use std::fmt::Write;
use std::path::Path;

use self::recording::read;
use self::replay::{BETTER_KNOWN, Cube, replay};
use self::score::Score;
use super::error::{Error, Result};
use super::number::{Job, Number};
use super::output::Output;
use super::report::Report;
use super::tolerances::TOSSES;
use crate::host::HostScalar;

/// Friction coefficients to choose from; the cube's is in the middle.
const FRICTIONS: [f64; 5] = [0.10, 0.14, 0.18, 0.22, 0.30];
/// How far a parameter is moved, for the spread; those that are better known, a third of that.
const JITTER: f64 = 0.03;

/// A run over a file in one number type.
pub struct Tosses<'a> {
    pub file: &'a Path,
    pub number: Number,
    pub out: Option<&'a Path>,
}

impl Job for Tosses<'_> {
    type Output = Result<Report>;

    fn run<S: HostScalar>(self) -> Result<Report> {
        let tosses = read(self.file)?;
        let header = ["toss", "k", "px", "py", "pz", "qw", "qx", "qy", "qz"];
        let mut output = self.out.map(|path| Output::create(path, self.file, &header)).transpose()?;
        let run = |cube: &Cube| -> Result<Score> {
            let mut score = Score::default();
            for toss in &tosses {
                score.add(toss, &self.found(replay::<S>(cube, toss), &toss.id)?);
            }
            Ok(score)
        };
        if let Some(output) = &mut output {
            for toss in &tosses {
                let frames = self.found(replay::<S>(&Cube::NOMINAL, toss), &toss.id)?;
                for (k, frame) in frames.iter().enumerate() {
                    let numbers = [k as f64].into_iter().chain(frame.position).chain(frame.orientation);
                    output.row(&toss.id, numbers)?;
                }
            }
        }
        output.map_or(Ok(()), Output::finish)?;

        let nominal = run(&Cube::NOMINAL)?;
        let frames: usize = tosses.iter().map(|toss| toss.frames.len()).sum();
        let mut text = format!(
            "{}: {} tosses, {frames} frames, in {}\n\
             position: mean distance from the recorded cube in % of its side; rotation: mean angle to it in degrees;\n\
             face: tosses that end within 45 degrees of the recorded end\n\n",
            self.file.display(),
            tosses.len(),
            self.number
        );
        let _ = writeln!(text, "parameters as given           {nominal}");
        let mut spread = vec![nominal];
        for cube in Cube::NOMINAL.jittered(JITTER) {
            spread.push(run(&cube)?);
        }
        let _ = writeln!(
            text,
            "each parameter moved by {:.0} %, the side and gravity by {:.0} %:",
            100.0 * JITTER,
            100.0 * JITTER / BETTER_KNOWN
        );
        let _ = writeln!(text, "                   the least  {}", Score::least(&spread));
        let _ = writeln!(text, "                   the most   {}", Score::most(&spread));
        let mut best = (f64::INFINITY, 0.0);
        for friction in FRICTIONS {
            let score =
                if friction == Cube::NOMINAL.friction { nominal } else { run(&Cube::NOMINAL.rubbed(friction))? };
            let _ = writeln!(text, "friction {friction:.2}                 {score}");
            if score.position() < best.0 {
                best = (score.position(), friction);
            }
        }
        let exceeded = verdicts(&mut text, &nominal, best.1);
        let problem = (exceeded > 0).then(|| format!("{exceeded} of the tolerances exceeded"));
        Ok(Report { text, problem })
    }
}

impl Tosses<'_> {
    fn found<T>(&self, replayed: Option<T>, toss: &str) -> Result<T> {
        let problem = format!("toss {toss}: does not fit {}", self.number);
        replayed.ok_or_else(|| Error::of_file(self.file, problem))
    }
}

fn verdicts(text: &mut String, score: &Score, best: f64) -> usize {
    let _ = writeln!(text, "\ntolerances");
    let mut exceeded = 0;
    let mut line = |met: bool, words: String| {
        exceeded += usize::from(!met);
        let _ = writeln!(text, "  {:8} {words}", if met { "met" } else { "EXCEEDED" });
    };
    let [position, rotation, face] = [score.position(), score.rotation(), score.face()];
    line(position <= TOSSES.position, format!("position {position:.2} <= {} %", TOSSES.position));
    line(rotation <= TOSSES.rotation, format!("rotation {rotation:.2} <= {} degrees", TOSSES.rotation));
    line(face >= TOSSES.face, format!("face {face:.3} >= {}", TOSSES.face));
    line(best == Cube::NOMINAL.friction, format!("best friction {best:.2} = {:.2}", Cube::NOMINAL.friction));
    exceeded
}
