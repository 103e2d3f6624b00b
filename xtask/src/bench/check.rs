//! Figures against the snapshot: none may rise, and one that fell is to be saved, or it could rise again unseen.

use super::figures::{Figure, Key, STAGES, Stages};

/// What a figure may differ by: a new version of a dependency may move an instruction here or there.
const TOLERANCE: f64 = 0.02;

/// Everything that is wrong, a line each.
pub fn compare(saved: &[Figure], measured: &[Figure]) -> Vec<String> {
    let mut found = Vec::new();
    for old in saved {
        match measured.iter().find(|new| new.key == old.key) {
            Some(new) => found.extend(changes(old, new).map(|change| format!("{}: {change}", name(&old.key)))),
            None => found.push(format!("{}: in the snapshot, but not measured any more", name(&old.key))),
        }
    }
    let is_new = |figure: &&Figure| saved.iter().all(|old| old.key != figure.key);
    found.extend(measured.iter().filter(is_new).map(|new| format!("{}: not in the snapshot", name(&new.key))));
    found
}

fn name(Key { board, by, operation, scalar, opt }: &Key) -> String {
    format!("{board} {by} {operation} {scalar} opt-level {opt}")
}

fn changes(old: &Figure, new: &Figure) -> impl Iterator<Item = String> {
    let max = |figure: &Figure| figure.spread.as_ref().map_or(figure.instructions, |spread| spread.max);
    let stages = |figure: &Figure| figure.scene.and_then(|scene| scene.stages).map_or([0; 6], Stages::all);
    let image = |figure: &Figure| figure.scene.and_then(|scene| scene.image).unwrap_or_default();
    let numbers = [
        ("instructions", old.instructions, new.instructions),
        ("most instructions", max(old), max(new)),
        ("bytes of flash", old.flash, new.flash),
        ("bytes of stack", old.stack, new.stack),
        ("bytes of RAM", old.ram, new.ram),
        ("bytes of the image", image(old), image(new)),
    ];
    let stages = STAGES.into_iter().zip(stages(old)).zip(stages(new)).map(|((what, old), new)| (what, old, new));
    let changes = numbers.into_iter().chain(stages).filter_map(|(what, old, new)| {
        let share = (f64::from(new) - f64::from(old)) / f64::from(old);
        // Nothing from nothing is no change.
        let share = if old == new { 0.0 } else { share };
        let word = if share > TOLERANCE {
            "rose"
        } else if share < -TOLERANCE {
            "fell and is not saved"
        } else {
            return None;
        };
        Some(format!("{what} {word}: {old} -> {new} ({:+.1} %)", 100.0 * share))
    });
    let error = (old.error != new.error).then(|| format!("the error changed: {:?} -> {:?}", old.error, new.error));
    let outcome = |figure: &Figure| figure.scene.map(|scene| scene.outcome);
    let outcome = (outcome(old) != outcome(new))
        .then(|| format!("the outcome changed: {:?} -> {:?}", outcome(old), outcome(new)));
    changes.chain(error).chain(outcome)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::figures::{Scene, Spread};
    use crate::bench::image::Opt;
    use crate::boards::{Board, Scalar};

    fn figure(instructions: u32) -> Figure {
        let key = Key {
            board: Board::M0,
            by: "carom".to_owned(),
            operation: "dot".to_owned(),
            scalar: Scalar::F32,
            opt: Opt::Speed,
        };
        Figure { key, instructions, spread: None, flash: 100, stack: 8, ram: 0, error: None, scene: None, bound: None }
    }

    #[track_caller]
    fn finds(saved: &[Figure], measured: &[Figure], expected: &[&str]) {
        let found = compare(saved, measured);
        assert_eq!(found.len(), expected.len(), "{found:?}");
        assert!(found.iter().zip(expected).all(|(line, part)| line.contains(part)), "{found:?}");
    }

    #[test]
    fn two_percent_are_nothing() {
        finds(&[figure(100)], &[figure(100)], &[]);
        finds(&[figure(100)], &[figure(102)], &[]);
        finds(&[figure(100)], &[figure(98)], &[]);
    }

    #[test]
    fn more_is_told() {
        finds(
            &[figure(100)],
            &[figure(103)],
            &["m0 carom dot f32 opt-level 3: instructions rose: 100 -> 103 (+3.0 %)", "most"],
        );
        finds(&[figure(100)], &[Figure { flash: 104, ..figure(100) }], &["bytes of flash rose"]);
        finds(&[figure(100)], &[Figure { ram: 4, ..figure(100) }], &["bytes of RAM rose: 0 -> 4"]);
        let scene = |solve, image| {
            let stages = Stages { broad: 1, narrow: 1, prepare: 1, solve, integrate: 1, keep: 1 };
            Some(Scene { outcome: 0.5, image: Some(image), stages: Some(stages) })
        };
        let old = Figure { scene: scene(100, 100), ..figure(100) };
        finds(std::slice::from_ref(&old), &[Figure { scene: scene(103, 100), ..figure(100) }], &["solve rose"]);
        finds(
            std::slice::from_ref(&old),
            &[Figure { scene: scene(100, 103), ..figure(100) }],
            &["bytes of the image rose"],
        );
        let moved = Scene { outcome: 0.4, ..old.scene.expect("it has one") };
        finds(std::slice::from_ref(&old), &[Figure { scene: Some(moved), ..figure(100) }], &["the outcome changed"]);
        let spread = |max| Some(Spread { min: 1, max, worst: "7".to_owned(), rows: 2, skipped: 0 });
        let [old, new] = [100, 110].map(|max| Figure { spread: spread(max), ..figure(50) });
        finds(&[old], &[new], &["most instructions rose"]);
    }

    #[test]
    fn a_stale_snapshot_is_told() {
        finds(&[figure(100)], &[figure(97)], &["instructions fell and is not saved", "most"]);
        finds(&[figure(100)], &[], &["not measured any more"]);
        finds(&[], &[figure(100)], &["not in the snapshot"]);
        finds(&[figure(100)], &[Figure { error: Some(1e-6), ..figure(100) }], &["the error changed"]);
    }
}
