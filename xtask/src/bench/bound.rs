//! A bound of the instructions of a step, for what there is to do in it.

use anyhow::{Context, Result, bail};
use serde::{Deserialize, Serialize};

/// What there is to do in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Work {
    pub sub_steps: u32,
    /// That move.
    pub bodies: u32,
    /// Of boxes that overlap.
    pub pairs: u32,
    pub points: u32,
}

/// A step that was counted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sample {
    pub kind: String,
    pub scene: String,
    pub work: Work,
    pub instructions: u32,
}

/// At most `step + bodies (body + sub_steps body_sub_step) + pairs pair + points sub_steps point_sub_step` instructions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bound {
    pub step: u32,
    pub body: u32,
    pub body_sub_step: u32,
    pub pair: u32,
    pub point_sub_step: u32,
    /// The most that the scene of the trial took of it, in per cent.
    pub reached: u32,
}

/// The scene that the bound is not made from.
const TRIAL: &str = "jam";

/// Above what was measured.
const MARGIN: f64 = 1.15;

impl Bound {
    pub fn of(self, work: Work) -> u32 {
        let Work { sub_steps, bodies, pairs, points } = work;
        let bodies = bodies * (self.body + sub_steps * self.body_sub_step);
        self.step + bodies + pairs * self.pair + points * sub_steps * self.point_sub_step
    }

    /// The bound of that kind of world; an error where the trial exceeds it.
    pub fn find(kind: &str, samples: &[Sample]) -> Result<Self> {
        let of =
            |scene: &'static str| samples.iter().filter(move |sample| sample.kind == kind && sample.scene == scene);
        let step = of("empty").map(|sample| sample.instructions).max().context("no empty step was counted")?;

        // Free bodies, the most of each number of sub-steps.
        let free = |scene, sub_steps| {
            let here = of(scene).filter(|sample| sample.work.sub_steps == sub_steps);
            let costs = here.map(|sample| f64::from(sample.instructions - step) / f64::from(sample.work.bodies));
            costs.fold(0.0, f64::max)
        };
        let body_sub_step = ((free("free", 8) - free("free", 2)) / 6.0).max(0.0);
        let body = [2, 4, 8].map(|n| free("free", n) - body_sub_step * f64::from(n)).into_iter().fold(0.0, f64::max);

        // What points add to bodies that hardly turn, by the point; then what is left, by the pair.
        let rest = |sample: &Sample| {
            let Work { sub_steps, bodies, .. } = sample.work;
            f64::from(sample.instructions - step) - f64::from(bodies) * free("calm", sub_steps)
        };
        let scenes = ["stack", "slide", "bounce"];
        let by_point = |scene, sub_steps| {
            let here = of(scene).filter(|sample| sample.work.sub_steps == sub_steps && sample.work.points > 0);
            here.map(|sample| rest(sample) / f64::from(sample.work.points)).fold(0.0, f64::max)
        };
        let slopes = scenes.map(|scene| (by_point(scene, 8) - by_point(scene, 2)) / 6.0);
        let point_sub_step = slopes.into_iter().fold(0.0, f64::max);
        let by_pair = |sample: &Sample| {
            let Work { sub_steps, pairs, points, .. } = sample.work;
            (rest(sample) - f64::from(points * sub_steps) * point_sub_step) / f64::from(pairs.max(1))
        };
        let pair = scenes.into_iter().flat_map(of).map(by_pair).fold(0.0, f64::max);

        let up = |x: f64| (x * MARGIN).ceil() as u32;
        let mut bound = Self {
            step: up(step.into()),
            body: up(body),
            body_sub_step: up(body_sub_step),
            pair: up(pair),
            point_sub_step: up(point_sub_step),
            reached: 0,
        };
        let reached = of(TRIAL).map(|sample| f64::from(sample.instructions) / f64::from(bound.of(sample.work)));
        let reached = reached.fold(0.0, f64::max);
        bound.reached = (100.0 * reached).round() as u32;
        if reached == 0.0 || reached > 1.0 {
            bail!("a {TRIAL} of {kind} takes {:.1} % of the bound {bound:?}", 100.0 * reached);
        }
        Ok(bound)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Steps that cost just so much, and a jam that costs that share of it.
    fn samples(jam: f64) -> Vec<Sample> {
        let truth = Bound { step: 100, body: 50, body_sub_step: 10, pair: 70, point_sub_step: 20, reached: 0 };
        let mut samples = Vec::new();
        for sub_steps in [2, 4, 8] {
            let mut add = |scene: &str, share: f64, bodies, pairs, points| {
                let work = Work { sub_steps, bodies, pairs, points };
                let instructions = (f64::from(truth.of(work)) * share) as u32;
                samples.push(Sample { kind: "boxes".to_owned(), scene: scene.to_owned(), work, instructions });
            };
            add("empty", 1.0, 0, 0, 0);
            add("calm", 1.0, 8, 0, 0);
            add("free", 1.0, 8, 0, 0);
            for scene in ["stack", "slide", "bounce"] {
                add(scene, 1.0, 8, 8, 32);
            }
            add(TRIAL, jam, 4, 10, 12);
        }
        samples
    }

    #[test]
    fn what_it_is_made_of_is_found() {
        let Bound { step, body, body_sub_step, pair, point_sub_step, reached } =
            Bound::find("boxes", &samples(1.0)).expect("a bound");
        // The margin, and what belongs to points however many sub-steps there are goes to the pairs.
        let near = |found: u32, truth: u32| (truth..truth * 6 / 5 + 2).contains(&found);
        assert!(near(step, 100) && near(body, 50) && near(body_sub_step, 10), "{step} {body} {body_sub_step}");
        assert!(point_sub_step >= 15 && pair >= 70, "{point_sub_step} {pair}");
        assert!((60..=100).contains(&reached), "{reached}");
    }

    #[test]
    fn a_trial_above_it_is_an_error() {
        assert!(Bound::find("boxes", &samples(1.6)).is_err());
        assert!(Bound::find("spheres", &samples(1.0)).is_err());
    }
}
