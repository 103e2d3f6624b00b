//! How far the replayed cubes are from the recorded ones.

use std::fmt;

use super::recording::{Frame, Toss};
use super::replay::Cube;

/// Sums over tosses.
#[derive(Clone, Copy, Debug, Default)]
pub struct Score {
    tosses: f64,
    position: f64,
    rotation: f64,
    face: f64,
}

impl Score {
    /// A toss as it was replayed.
    pub fn add(&mut self, toss: &Toss, replayed: &[Frame]) {
        let side = 2.0 * Cube::NOMINAL.half_side;
        let frames = toss.frames.len() as f64;
        let (mut position, mut rotation, mut last) = (0.0, 0.0, 0.0);
        for (recorded, found) in toss.frames.iter().zip(replayed) {
            position += 100.0 * distance(recorded.position, found.position) / side;
            last = angle(recorded.orientation, found.orientation);
            rotation += last;
        }
        self.tosses += 1.0;
        self.position += position / frames;
        self.rotation += rotation / frames;
        self.face += f64::from(last < 45.0);
    }

    /// % of the side
    pub fn position(&self) -> f64 {
        self.position / self.tosses
    }

    /// degrees
    pub fn rotation(&self) -> f64 {
        self.rotation / self.tosses
    }

    /// a share
    pub fn face(&self) -> f64 {
        self.face / self.tosses
    }

    fn each(scores: &[Self], choose: fn(f64, f64) -> f64) -> Self {
        let of = |value: fn(&Self) -> f64| scores.iter().map(value).reduce(choose).unwrap_or(f64::NAN);
        Self { tosses: 1.0, position: of(Self::position), rotation: of(Self::rotation), face: of(Self::face) }
    }

    /// The least of each.
    pub fn least(scores: &[Self]) -> Self {
        Self::each(scores, f64::min)
    }

    /// The most of each.
    pub fn most(scores: &[Self]) -> Self {
        Self::each(scores, f64::max)
    }
}

impl fmt::Display for Score {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [position, rotation, face] = [self.position(), self.rotation(), self.face()];
        write!(f, "position {position:6.2} %   rotation {rotation:5.2} degrees   face {face:.2}")
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// Between two orientations, in degrees.
fn angle(a: [f64; 4], b: [f64; 4]) -> f64 {
    let length = b.iter().map(|x| x * x).sum::<f64>().sqrt();
    let cosine = a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>().abs() / length;
    2.0 * cosine.min(1.0).acos().to_degrees()
}
