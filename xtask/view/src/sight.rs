//! From where a scene is seen at first.

use crate::algebra::{add, cross, dot, scale, sub};

pub struct Sight {
    pub target: [f64; 3],
    /// Round the vertical, and above the floor.
    pub azimuth: f64,
    pub elevation: f64,
    pub distance: f64,
}

/// The tangent of half the angle of view, upwards; how much wider a picture is than high; and how much of it is filled.
const VIEW: f64 = 0.3425;
const ASPECT: f64 = 16.0 / 9.0;
const FILLED: f64 = 0.88;
/// How often what is seen is brought to the middle: each time moves it less.
const ROUNDS: usize = 6;

impl Sight {
    /// So that all points are in the picture, and fill it.
    pub fn of(extent: [f64; 3], middle: [f64; 3], points: &[[f64; 3]]) -> Self {
        let wide = extent[0].max(extent[1]);
        // What is flat is seen from above.
        let flat = extent[2] < 0.25 * wide && extent[0].min(extent[1]) > 0.4 * wide;
        let (turned, elevation) = if flat { (-0.12, 0.95) } else { (0.45, 0.38) };
        // What is longer than wide lies across the picture.
        let along = if extent[1] > 1.2 * extent[0] && !flat { 0.0 } else { -std::f64::consts::FRAC_PI_2 };
        let azimuth: f64 = along + turned;
        let out = [f64::cos(elevation) * azimuth.cos(), f64::cos(elevation) * azimuth.sin(), f64::sin(elevation)];
        let across = [-azimuth.sin(), azimuth.cos(), 0.0];
        let up = cross(out, across);
        let (mut target, mut distance) = (middle, 0.0);
        for _ in 0..ROUNDS {
            let seen = || {
                points.iter().map(|point| sub(*point, target)).map(|at| (dot(at, across), dot(at, up), dot(at, out)))
            };
            let needed = |(x, y, z): (f64, f64, f64)| z + (x.abs() / ASPECT).max(y.abs()) / (VIEW * FILLED);
            distance = seen().map(needed).fold(0.0, f64::max);
            // The middle of what is seen, at the distance of the target.
            let centre = |part: fn((f64, f64, f64)) -> f64| {
                let places = seen().map(|at| part(at) * distance / (distance - at.2));
                let (low, high) =
                    places.fold((f64::MAX, f64::MIN), |(low, high), place| (low.min(place), high.max(place)));
                0.5 * (low + high)
            };
            let (right, higher) = (centre(|at| at.0), centre(|at| at.1));
            target = add(target, add(scale(across, right), scale(up, higher)));
        }
        Self { target, azimuth, elevation, distance }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a cloud of points that lies far to one side: all of it is in the picture, and it touches opposite sides alike.
    #[test]
    fn everything_is_seen_and_fills_the_picture() {
        let points: Vec<[f64; 3]> = (0..200)
            .map(|number| f64::from(number) * 0.7)
            .map(|t: f64| [3.0 + t.sin() + 0.01 * t, -7.0 + (1.7 * t).cos(), 0.3 + 0.3 * (0.9 * t).sin()])
            .collect();
        let sight = Sight::of([3.4, 2.0, 0.6], [3.5, -7.0, 0.3], &points);
        let (sin, cos) = (sight.azimuth.sin(), sight.azimuth.cos());
        let (mut low, mut high) = ([f64::MAX; 2], [f64::MIN; 2]);
        for point in points {
            let [x, y, z] = sub(point, sight.target);
            let (near, right) = (x * cos + y * sin, y * cos - x * sin);
            let depth = sight.distance - near * sight.elevation.cos() - z * sight.elevation.sin();
            let up = z * sight.elevation.cos() - near * sight.elevation.sin();
            let seen = [right / depth / VIEW / ASPECT, up / depth / VIEW];
            low = [low[0].min(seen[0]), low[1].min(seen[1])];
            high = [high[0].max(seen[0]), high[1].max(seen[1])];
        }
        let most = high[0].max(high[1]).max(-low[0]).max(-low[1]);
        assert!(most < 0.95 && most > 0.8, "from {low:?} to {high:?}");
        assert!((low[0] + high[0]).abs() < 0.05 && (low[1] + high[1]).abs() < 0.05, "from {low:?} to {high:?}");
    }
}
