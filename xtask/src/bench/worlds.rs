//! The figures of whole steps, as the documentation and the terminal show them.

use super::bound::Bound;
use super::figures::{Figure, KINDS, Key, OWN, SCENES, STAGES, Stages};
use super::grid::Grid;
use super::image::Opt;
use super::markdown::{grouped, with_most};
use super::snapshot::Snapshot;
use crate::boards::{Board, Scalar};

/// Number types on boards, from the cheapest.
const PLACES: [(Scalar, Board); 6] = [
    (Scalar::F32, Board::M4f),
    (Scalar::F32, Board::M7),
    (Scalar::F32, Board::M33),
    (Scalar::I16F16, Board::M4f),
    (Scalar::I16F16, Board::M3),
    (Scalar::I16F16, Board::M0),
];

fn scalar_name(scalar: Scalar) -> &'static str {
    if scalar == Scalar::F32 { "`f32`" } else { "`I16F16`" }
}

/// Every scene: instructions of a step, and what came of it.
pub fn steps(snapshot: &Snapshot) -> String {
    let names = PLACES.map(|(scalar, board)| format!("{} {}", scalar_name(scalar), board.name()));
    let names = ["".to_owned()].into_iter().chain(names);
    let mut table = Grid::new(names.chain(["outcome", "`f32`", "`I16F16`"].map(str::to_owned)));
    for (name, _, words) in SCENES {
        let find = |(scalar, board)| snapshot.find(board, OWN, name, scalar, Opt::Speed);
        let cells = PLACES.map(|place| find(place).map_or_else(String::new, with_most));
        let outcomes =
            [Scalar::F32, Scalar::I16F16].map(|scalar| find((scalar, Board::M4f)).map_or_else(String::new, outcome));
        let kind = if name == "slide" { "rolls, m/s" } else { "top, m" };
        table.row([words.to_owned()].into_iter().chain(cells).chain([kind.to_owned()]).chain(outcomes));
    }
    table.render()
}

/// What a step is made of.
pub fn stages(snapshot: &Snapshot) -> String {
    let names = ["", "", "board", "step"].into_iter().chain(STAGES);
    let mut table = Grid::new(names.chain(["the world's own"]));
    for (name, _, words) in SCENES {
        for (scalar, board) in [(Scalar::F32, Board::M4f), (Scalar::I16F16, Board::M3), (Scalar::I16F16, Board::M0)] {
            let Some(figure) = snapshot.find(board, OWN, name, scalar, Opt::Speed) else { continue };
            let names = [words, scalar_name(scalar), board.name()].map(str::to_owned);
            table.row(names.into_iter().chain([grouped(figure.instructions)]).chain(parts(figure)));
        }
    }
    table.render()
}

/// The stages, and what is left of the step.
fn parts(figure: &Figure) -> [String; 7] {
    let Some(parts) = figure.scene.and_then(|scene| scene.stages).map(Stages::all) else {
        return [const { String::new() }; 7];
    };
    let rest = figure.instructions.saturating_sub(parts.iter().sum());
    let [a, b, c, d, e, f] = parts.map(grouped);
    [a, b, c, d, e, f, grouped(rest)]
}

/// Instructions, flash and stack at each opt-level, and what a world takes.
pub fn sizes(snapshot: &Snapshot) -> String {
    let names = ["", "", "board", "step 3", "s", "z", "flash 3", "s", "z", "stack 3", "s", "z", "world"];
    let mut table = Grid::new(names);
    for name in ["spheres_8", "boxes_4"] {
        let words = SCENES.iter().find(|(scene, ..)| *scene == name).map_or("", |(.., words)| words);
        for (scalar, board) in PLACES {
            let figures = Opt::ALL.map(|opt| snapshot.find(board, OWN, name, scalar, opt));
            let each = |value: fn(&Figure) -> u32| {
                figures.map(|figure| figure.map_or_else(String::new, |figure| grouped(value(figure))))
            };
            let cells = [words, scalar_name(scalar), board.name()].map(str::to_owned).into_iter();
            let cells = cells.chain(each(|figure| figure.instructions)).chain(each(flash));
            let cells = cells.chain(each(|figure| figure.stack));
            table.row(cells.chain([figures[0].map_or_else(String::new, |figure| grouped(figure.ram))]));
        }
    }
    table.render()
}

/// Of balls all that is flashed, of boxes a step.
fn flash(figure: &Figure) -> u32 {
    figure.scene.and_then(|scene| scene.image).unwrap_or(figure.flash)
}

/// Other libraries beside carom.
pub fn peers(snapshot: &Snapshot) -> String {
    let names = ["", "", "board", "step", "s", "z", "of carom's", "flash", "stack", "RAM", "outcome"];
    let mut table = Grid::new(names);
    for (name, _, words) in SCENES {
        for board in [Board::M4f, Board::M3] {
            let here = |figure: &&Figure| {
                figure.key.operation == name && figure.key.board == board && figure.key.opt == Opt::Speed
            };
            let all: Vec<&Figure> = snapshot.figures.iter().filter(here).collect();
            if all.iter().all(|figure| figure.key.by == OWN) {
                continue;
            }
            for figure in &all {
                let Key { by, scalar, .. } = &figure.key;
                let at = |opt| {
                    let figure = snapshot.find(board, by, name, *scalar, opt);
                    figure.map_or_else(String::new, |figure| grouped(figure.instructions))
                };
                table.row([
                    words.to_owned(),
                    format!("{by} {}", scalar_name(*scalar)),
                    board.name().to_owned(),
                    at(Opt::Speed),
                    at(Opt::S),
                    at(Opt::Z),
                    ratio(figure, &all).map_or_else(String::new, |ratio| format!("{ratio:.2}")),
                    grouped(flash(figure)),
                    grouped(figure.stack),
                    grouped(figure.ram),
                    outcome(figure),
                ]);
            }
        }
    }
    table.render()
}

/// Another library's instructions by carom's in the same number type, or else in the one that suits the board.
fn ratio(figure: &Figure, all: &[&Figure]) -> Option<f64> {
    let own = |scalar| {
        let key = Key { by: OWN.to_owned(), scalar, ..figure.key.clone() };
        all.iter().find(|one| one.key == key)
    };
    let own = own(figure.key.scalar).or_else(|| own(Scalar::I16F16)).filter(|_| figure.key.by != OWN)?;
    Some(f64::from(figure.instructions) / f64::from(own.instructions))
}

/// The constants of the bound.
pub fn bounds(snapshot: &Snapshot) -> String {
    let names =
        ["", "", "board", "step", "body", "body and sub-step", "pair", "point and sub-step", "highest stack", "trial"];
    let mut table = Grid::new(names);
    for (operation, _, words, _) in KINDS {
        for (scalar, board) in PLACES {
            let Some(figure) = snapshot.find(board, OWN, operation, scalar, Opt::Speed) else { continue };
            let names = [words, scalar_name(scalar), board.name()].map(str::to_owned);
            table.row(names.into_iter().chain(constants(figure)));
        }
    }
    table.render()
}

fn constants(figure: &Figure) -> Vec<String> {
    let Some(Bound { step, body, body_sub_step, pair, point_sub_step, reached }) = figure.bound else {
        return Vec::new();
    };
    let numbers = [step, body, body_sub_step, pair, point_sub_step, figure.instructions].map(grouped);
    numbers.into_iter().chain([format!("{reached} %")]).collect()
}

/// For the terminal: the bounds of a board.
pub fn bound_table(figures: &[&Figure]) -> String {
    let names =
        ["bound", "scalar", "opt", "step", "body", "body, sub-step", "pair", "point, sub-step", "stack", "trial"];
    let mut table = Grid::new(names);
    for figure in figures {
        let Key { operation, scalar, opt, .. } = &figure.key;
        table.row([operation.clone(), scalar.to_string(), opt.to_string()].into_iter().chain(constants(figure)));
    }
    table.render()
}

/// For the README: a step of the highest stacks, and the others' beside it.
pub fn short(snapshot: &Snapshot) -> String {
    let boards = [Board::M0, Board::M3, Board::M4f, Board::M33];
    let names = ["instructions for a step"].into_iter().chain(boards.map(Board::name));
    let mut table = Grid::new(names.chain(["outcome"]));
    let rows = [
        ("spheres_1", OWN, Scalar::F32),
        ("spheres_1", OWN, Scalar::I16F16),
        ("spheres_8", OWN, Scalar::F32),
        ("spheres_8", OWN, Scalar::I16F16),
        ("boxes_4", OWN, Scalar::F32),
        ("boxes_4", OWN, Scalar::I16F16),
        ("spheres_8", "embedded-3dgfx", Scalar::F32),
        ("spheres_8", "he3d-physics", Scalar::F32),
    ];
    for (name, by, scalar) in rows {
        let words = SCENES.iter().find(|(scene, ..)| *scene == name).map_or("", |(.., words)| words);
        let figures = boards.map(|board| snapshot.find(board, by, name, scalar, Opt::Speed));
        let whose = if by == OWN { format!("{words}, {}", scalar_name(scalar)) } else { format!("*{words}, {by}*") };
        let cells = figures.map(|figure| figure.map_or_else(String::new, |figure| grouped(figure.instructions)));
        let outcome = figures.iter().flatten().next().map_or_else(String::new, |figure| outcome(figure));
        table.row([whose].into_iter().chain(cells).chain([outcome]));
    }
    table.render()
}

/// For the terminal: all that is known of a board.
pub fn table(figures: &[&Figure]) -> String {
    let names = ["scene", "by", "scalar", "opt", "step", "most", "in step"].into_iter().chain(STAGES);
    let mut table = Grid::new(names.chain(["own", "flash", "image", "stack", "RAM", "outcome", "of carom's"]));
    for figure in figures {
        let Key { by, operation, scalar, opt, .. } = &figure.key;
        let here: Vec<&Figure> = figures.iter().copied().filter(|one| one.key.opt == *opt).collect();
        let spread = figure.spread.as_ref();
        let mut cells = vec![operation.clone(), by.clone(), scalar.to_string(), opt.to_string()];
        cells.push(grouped(figure.instructions));
        cells.push(spread.map_or_else(String::new, |spread| grouped(spread.max)));
        cells.push(spread.map_or_else(String::new, |spread| spread.worst.clone()));
        cells.extend(parts(figure));
        cells.push(grouped(figure.flash));
        cells.push(figure.scene.and_then(|scene| scene.image).map_or_else(String::new, grouped));
        cells.push(grouped(figure.stack));
        cells.push(grouped(figure.ram));
        cells.push(outcome(figure));
        cells.push(ratio(figure, &here).map_or_else(String::new, |ratio| format!("{ratio:.2}")));
        table.row(cells);
    }
    table.render()
}

fn outcome(figure: &Figure) -> String {
    figure.scene.map_or_else(String::new, |scene| format!("{:.4}", scene.outcome))
}
