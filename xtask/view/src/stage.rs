//! What the bodies move on: the floor, and walls without an end, cut off where nothing happens any more. In metres.

use crate::algebra::{add, length, scale, sub};
use crate::extent::Extent;
use crate::mesh::tidy;
use crate::sight::Sight;
use crate::trace::{Look, Shape, Trace};
use serde::Serialize;

#[derive(Clone, Debug, Serialize)]
pub struct Stage {
    /// The height of the floor.
    pub floor: f32,
    /// Whether bodies lie on it: otherwise it only shows where they are.
    pub solid: bool,
    /// Its outline, anticlockwise, x and y.
    pub outline: Vec<[f32; 2]>,
    /// How high the walls are, and which sides of the outline are one.
    pub wall: f32,
    pub walled: Vec<bool>,
    /// Between lines of the grid.
    pub grid: f32,
    /// What the camera looks at, and how far everything reaches.
    pub middle: [f32; 3],
    pub reach: f32,
    /// Half the thickness of what moves: contacts are drawn in proportion to it.
    pub size: f32,
    /// From where it is seen at first: angles round the vertical and above the floor, and a distance.
    pub azimuth: f32,
    pub elevation: f32,
    pub distance: f32,
}

type Side = ([f64; 2], bool);

impl Stage {
    pub fn of(trace: &Trace) -> Self {
        let Extent { low, high, largest, smallest, points } = Extent::of(trace);
        let middle = scale(add(low, high), 0.5);
        let extent = sub(high, low);
        let reach = 0.5 * length(extent);
        let sight = Sight::of(extent, middle, &points);
        let planes: Vec<([f64; 3], [f64; 3])> = planes(trace).collect();
        let ground = planes.iter().find(|(normal, _)| normal[2] > 0.7);
        let floor = ground.map_or(low[2] - 0.15 * reach, |(_, at)| at[2]);
        let far = 6.0 * reach;
        let corner = |x: f64, y: f64| ([middle[0] + x * far, middle[1] + y * far], false);
        let mut outline: Vec<Side> = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        for (normal, at) in planes.iter().filter(|(normal, _)| normal[2].abs() < 0.5) {
            outline = cut(&outline, [normal[0], normal[1]], [at[0], at[1]]);
        }
        Self {
            floor: tidy(floor),
            solid: ground.is_some(),
            outline: outline.iter().map(|(corner, _)| corner.map(tidy)).collect(),
            wall: tidy((1.2 * largest).min(0.2 * reach)),
            walled: outline.iter().map(|(_, walled)| *walled).collect(),
            grid: tidy(spacing(reach)),
            middle: sight.target.map(tidy),
            reach: tidy(reach),
            size: tidy(smallest.min(0.2 * reach)),
            azimuth: tidy(sight.azimuth),
            elevation: tidy(sight.elevation),
            distance: tidy(sight.distance),
        }
    }
}

/// What is solid without an end: the normal, and a point of the surface.
fn planes(trace: &Trace) -> impl Iterator<Item = ([f64; 3], [f64; 3])> + '_ {
    let first = trace.frames[0].motions.iter();
    trace.bodies.iter().zip(first).filter_map(|(subject, motion)| match subject.shape {
        Shape::HalfSpace { normal } if subject.look != Look::Sensor => {
            Some((crate::algebra::rotate(motion.orientation, normal), scale(motion.position, trace.unit)))
        }
        _ => None,
    })
}

/// What of an outline lies on the side of the line to which the normal points. The new side is walled.
fn cut(outline: &[Side], normal: [f64; 2], at: [f64; 2]) -> Vec<Side> {
    let above = |[x, y]: [f64; 2]| normal[0] * (x - at[0]) + normal[1] * (y - at[1]);
    let mut kept = Vec::new();
    for (index, (corner, walled)) in outline.iter().enumerate() {
        let (next, _) = outline[(index + 1) % outline.len()];
        let (here, there) = (above(*corner), above(next));
        if here >= 0.0 {
            kept.push((*corner, *walled));
        }
        if (here >= 0.0) != (there >= 0.0) {
            let part = here / (here - there);
            let met = [0, 1].map(|axis| corner[axis] + part * (next[axis] - corner[axis]));
            // Where the outline leaves, the wall begins; where it comes back, the old side goes on.
            kept.push((met, if here >= 0.0 { true } else { *walled }));
        }
    }
    kept
}

/// A round number: some ten lines across.
fn spacing(reach: f64) -> f64 {
    let wanted = reach / 5.0;
    let decade = 10f64.powf(wanted.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * decade);
    steps.into_iter().find(|step| *step >= wanted).unwrap_or(steps[3])
}

/// Walls as quadrilaterals: four corners each, seen from inside.
pub fn walls(stage: &Stage) -> Vec<[[f64; 3]; 4]> {
    let corner = |index: usize, height: f64| {
        let [x, y] = stage.outline[index % stage.outline.len()].map(f64::from);
        [x, y, height]
    };
    let (floor, top) = (f64::from(stage.floor), f64::from(stage.floor + stage.wall));
    let walled = (0..stage.outline.len()).filter(|index| stage.walled[*index]);
    walled
        .map(|side| [corner(side + 1, floor), corner(side, floor), corner(side, top), corner(side + 1, top)])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_outline_is_cut_where_the_line_runs() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|corner| (corner, false));
        let kept = cut(&square, [-1.0, 0.0], [1.5, 0.0]);
        let area: f64 = (0..kept.len())
            .map(|index| {
                let ([x0, y0], [x1, y1]) = (kept[index].0, kept[(index + 1) % kept.len()].0);
                0.5 * (x0 * y1 - x1 * y0)
            })
            .sum();
        assert!((area - 3.0).abs() < 1e-12, "{kept:?}");
        let walled: Vec<_> = kept.iter().filter(|(_, walled)| *walled).collect();
        assert_eq!(walled.len(), 1);
        assert!((walled[0].0[0] - 1.5).abs() < 1e-12 && walled[0].0[1] == 0.0, "{walled:?}");
    }

    #[test]
    fn grids_are_round() {
        assert!([0.5, 0.031, 7.0].map(spacing).iter().zip([0.1, 0.01, 2.0]).all(|(a, b)| (a / b - 1.0).abs() < 1e-9));
    }
}
