//! What the examples' scenes claim, on the host: fair dice, a cradle that hands on its speed, boxes that fall in time.
#![cfg(any(feature = "f32", feature = "f64", feature = "fixed"))]

#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;
#[path = "../examples/scenes/mod.rs"]
mod scenes;

use carom::{Scalar, Scaled};
use scenes::{billiards, cradle, dice, edge, maze, pinball, stack};

each_number!(fair_dice, boxes_fall, cradle_swings, balls_roll, marble_arrives, boxes_stand, pinball_is_played);

fn ratio<S: Scalar>(numerator: i32, denominator: i32) -> S {
    S::from_ratio(numerator, denominator).expect("a number within the format")
}

/// Three thousand throws of two dice: chi-square over the six faces stays below what fair dice exceed once in a thousand
/// times, and a die that shows a face twice as often as another would be far above.
fn fair_dice<S: Scalar>(_: &str) {
    let mut world = dice::Room::<S>::new();
    let (mut counts, mut leaning, mut restless) = ([0u32; 6], 0, 0);
    for seed in 1..=3000 {
        let mut throw = dice::Throw::new(&mut world, seed).expect("a throw");
        let lie = (0..dice::STEPS).any(|_| !throw.step());
        restless += u32::from(!lie);
        assert_eq!(throw.dropped, 0, "seed {seed}");
        for face in throw.faces() {
            match face {
                Some(face) => counts[usize::from(face) - 1] += 1,
                None => leaning += 1,
            }
        }
    }
    let sum: u32 = counts.iter().sum();
    let expected = f64::from(sum) / 6.0;
    let chi_square: f64 = counts.iter().map(|n| (f64::from(*n) - expected).powi(2) / expected).sum();
    assert!(restless <= 2 && leaning <= 30, "{restless} throws do not end, {leaning} dice lean");
    assert!(chi_square < 20.5, "chi-square {chi_square}: {counts:?}");
}

/// The times of f64 are those in the scene; others are within a tenth, half at a hundredth of a degree.
fn boxes_fall<S: Scalar>(_: &str) {
    let mut world = edge::Room::<S>::new();
    for start in &edge::STARTS {
        let (time, _) = edge::fall(&mut world, start).expect("a box");
        let time = f64::from(time.expect("it falls"));
        let in_f64 = f64::from(start.in_f64);
        let bound = if size_of::<S>() == 8 {
            1.0
        } else if start.past == 1 {
            1.5
        } else {
            1.1
        };
        let ratio = time / in_f64;
        assert!(ratio <= bound && ratio >= 1.0 / bound, "{} hundredths: {time} ms, {in_f64} in f64", start.past);
    }
}

/// The last ball leaves with the speed of the first one within a thousandth, and the energy stays within two.
fn cradle_swings<S: Scalar>(_: &str) {
    let mut world = cradle::Room::<S>::new();
    let mut cradle = cradle::Cradle::new(&mut world).expect("a cradle");
    for _ in 0..cradle::STEPS {
        cradle.step();
        let off = cradle.energy().minus(S::ONE);
        assert!(off < ratio(2, 1000) && off > ratio(-2, 1000), "energy {off:?}");
    }
    let [first, last] = cradle.fastest;
    let lost = first.minus(last);
    assert!(lost < first.times(ratio(1, 1000)) && lost > first.times(ratio(-1, 1000)), "{first:?} {last:?}");
    assert!(first > ratio(62, 10) && first < ratio(63, 10), "as high as 20 cm on a thread of a metre: {first:?}");
    assert_eq!(cradle.impacts, 16, "four blows each time");
}

/// Energy only goes down, and balls come to roll.
fn balls_roll<S: Scalar>(_: &str) {
    let mut world = billiards::Room::<S>::new();
    let mut table = billiards::Billiards::new(&mut world).expect("a table");
    let mut before = table.energy();
    for _ in 0..billiards::STEPS {
        table.step();
        let energy = table.energy();
        assert!(energy <= before.plus(ratio(1, 500)), "from {before:?} to {energy:?}");
        before = energy;
    }
    assert_eq!((table.dropped, table.saturated), (0, false));
    assert!(table.ball_impacts >= 8 && table.cushion_impacts >= 4, "little happened");
    assert!(table.rolling() >= billiards::BALLS - 1, "{} balls roll", table.rolling());
    let [x, y] = billiards::HALF.map(|half| ratio::<S>(half, 1000));
    for body in table.balls() {
        let at = body.position;
        assert!(at.x < x && at.x > x.negated() && at.y < y && at.y > y.negated(), "off the table: {at:?}");
    }
}

fn marble_arrives<S: Scalar>(_: &str) {
    let mut world = maze::Room::<S>::new();
    let mut maze = maze::Maze::new(&mut world).expect("a maze");
    for _ in 0..maze::STEPS {
        maze.step();
        let height = maze.marble().expect("the marble").z;
        assert!(height < ratio(2, 10) && height > ratio(1, 10), "it stays between floor and walls: {height:?}");
    }
    assert!(maze.reached.is_some_and(|step| step > 500), "{:?}", maze.reached);
    assert_eq!(maze.dropped, 0);
}

fn boxes_stand<S: Scalar>(_: &str) {
    let mut world = stack::Room::<S>::new();
    let mut stack = stack::Stack::new(&mut world).expect("a stack");
    for _ in 0..stack::STEPS {
        stack.step();
    }
    assert_eq!((stack.dropped, stack.moved().count()), (0, stack::BOXES));
    let tenth = ratio::<S>(1, 10);
    for moved in stack.moved() {
        assert!(moved.iter().all(|part| *part < tenth && *part > tenth.negated()), "{moved:?}");
    }
}

fn pinball_is_played<S: Scalar>(_: &str) {
    let mut world = pinball::Room::<S>::new();
    let mut pinball = pinball::Pinball::new(&mut world).expect("a table");
    let steps = (0..pinball::STEPS).take_while(|_| pinball.step()).count();
    assert!(pinball.hits >= 3 && pinball.flips >= 3 && steps > 480, "{} hits, {} flips", pinball.hits, pinball.flips);
    assert_eq!((pinball.dropped, pinball.saturated, pinball.score), (0, false, 100 * pinball.hits));
    let height = pinball.ball().expect("the ball").z;
    assert!(S::Scaled::ratio(3, 10) > height.to_scaled(), "the ball stays on the board: {height:?}");
}
