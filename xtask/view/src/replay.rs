//! What is shown: a trace, and perhaps another one beside it, in metres and seconds, ready to be drawn.

use crate::compare::Comparison;
use crate::contact::pushes;
use crate::energy::Balance;
use crate::mesh::{Mesh, tidy};
use crate::stage::Stage;
use crate::trace::{Look, Shape, Subject, Trace};
use anyhow::Result;
use serde::Serialize;

/// More frames than that are thinned out: the page stays small.
const FRAMES: usize = 1300;

/// What the page says about a run.
#[derive(Clone, Debug, Serialize)]
pub struct Words {
    /// The example.
    pub example: String,
    /// Where it ran.
    pub place: String,
    /// What the other one ran on, where there is one.
    pub ghost_place: String,
    /// The command that makes this.
    pub command: String,
}

#[derive(Debug, Serialize)]
pub struct Replay {
    pub words: Words,
    pub scalar: String,
    pub rate: u16,
    pub sub_steps: u8,
    /// Seconds, of each frame.
    pub times: Vec<f32>,
    pub stage: Stage,
    pub meshes: Vec<Mesh>,
    pub actors: Vec<Actor>,
    /// An arrow along z.
    pub arrow: Mesh,
    /// A ball of radius one.
    pub dot: Mesh,
    /// In the steps that led to each frame.
    pub pushes: Vec<Vec<Mark>>,
    pub energy: Vec<Balance>,
    pub ghost: Option<Ghost>,
}

/// A body with an end.
#[derive(Debug, Serialize)]
pub struct Actor {
    pub mesh: usize,
    /// Red, green, blue, 0 to 1, as a screen has them.
    pub colour: [f32; 3],
    pub sensor: bool,
    /// A mass moves it, and it is drawn as a ghost too.
    pub free: bool,
    /// Position and orientation (w, x, y, z) in each frame; once where it never moves.
    pub poses: Vec<f32>,
    /// The same of the other run; empty where it never moves.
    pub ghost: Vec<f32>,
}

/// Where and how hard two bodies pushed.
#[derive(Debug, Serialize)]
pub struct Mark {
    pub points: Vec<[f32; 3]>,
    pub direction: [f32; 3],
    /// N s, of bodies whose masses are in the scene's unit.
    pub impulse: f32,
    pub struck: bool,
}

#[derive(Debug, Serialize)]
pub struct Ghost {
    pub scalar: String,
    /// The largest distance of a body to its ghost, m.
    pub distance: Vec<f32>,
    pub bound: f32,
    /// When they have parted, s.
    pub parted: Option<f32>,
}

const IVORY: [f32; 3] = [0.96, 0.93, 0.86];
const STONE: [f32; 3] = [0.56, 0.60, 0.66];
const COLOURS: [[f32; 3]; 8] = [
    [0.93, 0.91, 0.87],
    [0.93, 0.69, 0.13],
    [0.16, 0.42, 0.79],
    [0.84, 0.25, 0.21],
    [0.45, 0.29, 0.66],
    [0.93, 0.47, 0.17],
    [0.13, 0.55, 0.40],
    [0.62, 0.20, 0.28],
];

impl Replay {
    pub fn new(trace: &Trace, other: Option<&Trace>, words: Words) -> Result<Self> {
        let stride = trace.frames.len().div_ceil(FRAMES);
        let kept: Vec<usize> = (0..trace.frames.len()).step_by(stride).collect();
        let mut meshes: Vec<Mesh> = Vec::new();
        let mut known: Vec<(Shape, Look)> = Vec::new();
        let mut actors = Vec::new();
        for (index, subject) in trace.bodies.iter().enumerate() {
            let kind = (subject.shape, subject.look);
            let mesh = match known.iter().position(|one| *one == kind) {
                Some(mesh) => mesh,
                None => {
                    let Some(mesh) = Mesh::of(&subject.shape, subject.look, trace.unit) else { continue };
                    meshes.push(mesh);
                    known.push(kind);
                    known.len() - 1
                }
            };
            actors.push(Actor {
                mesh,
                colour: colour(subject, actors.len()),
                sensor: subject.look == Look::Sensor,
                free: !subject.is_fixed(),
                poses: poses(trace, index, &kept),
                ghost: other
                    .filter(|other| other.moving(index))
                    .map_or_else(Vec::new, |other| poses(other, index, &kept)),
            });
        }
        let ghost = other
            .map(|other| -> Result<Ghost> {
                let comparison = Comparison::new(trace, other)?;
                Ok(Ghost {
                    scalar: other.scalar.clone(),
                    distance: kept.iter().map(|index| comparison.distance[*index] as f32).collect(),
                    bound: tidy(comparison.bound),
                    parted: comparison.parted.map(|index| tidy(index as f64 / f64::from(trace.rate))),
                })
            })
            .transpose()?;
        Ok(Self {
            words,
            scalar: trace.scalar.clone(),
            rate: trace.rate,
            sub_steps: trace.sub_steps,
            times: kept.iter().map(|index| tidy(*index as f64 / f64::from(trace.rate))).collect(),
            stage: Stage::of(trace),
            meshes,
            actors,
            arrow: Mesh::arrow(0.05),
            dot: Mesh::of(&Shape::Sphere { radius: 1.0 }, Look::Sensor, 1.0).unwrap_or_default(),
            pushes: kept.iter().map(|index| marks(trace, *index, stride)).collect(),
            energy: kept.iter().map(|index| Balance::of(trace, &trace.frames[*index])).collect(),
            ghost,
        })
    }

    /// The frames shown.
    pub fn len(&self) -> usize {
        self.times.len()
    }

    pub fn is_empty(&self) -> bool {
        self.times.is_empty()
    }
}

fn colour(subject: &Subject, number: usize) -> [f32; 3] {
    match subject.look {
        Look::Die => IVORY,
        _ if subject.is_fixed() => STONE,
        _ => COLOURS[number % COLOURS.len()],
    }
}

fn poses(trace: &Trace, body: usize, kept: &[usize]) -> Vec<f32> {
    let kept = if trace.moving(body) { kept } else { &kept[..1] };
    let last = trace.frames.len() - 1;
    let motions = kept.iter().map(|index| trace.frames[(*index).min(last)].motions[body]);
    motions
        .flat_map(|motion| {
            let [x, y, z] = motion.position.map(|part| tidy(part * trace.unit));
            let [w, i, j, k] = motion.orientation.map(tidy);
            [x, y, z, w, i, j, k]
        })
        .collect()
}

/// Pushes of the steps since the frame shown before: of steps in between only blows.
fn marks(trace: &Trace, index: usize, stride: usize) -> Vec<Mark> {
    let first = (index + 1).saturating_sub(stride);
    let all = (first..=index).flat_map(|step| {
        let pushes = pushes(trace, step).into_iter();
        pushes.filter(move |push| step == index || push.struck)
    });
    all.map(|push| Mark {
        points: push.points.iter().map(|point| point.map(|part| tidy(part * trace.unit))).collect(),
        direction: push.direction.map(tidy),
        impulse: tidy(push.impulse * trace.unit),
        struck: push.struck,
    })
    .collect()
}
