//! The same rows of the solver on every core: the speeds that 10,000 rows ask for and what their impulses do, of ordinary numbers
//! and of such as meet the ends of the format, as hashes. What is written in a core's own instructions has to give those of the
//! portable form, which the host prints.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;
mod numbers;

use board::Exit;
use carom::{Column, Scalar, Scaled, StateHash, StepArithmetic, Vec3, Velocity};
use numbers::{Job, Number};

board::entry!(run);

fn run() -> Exit {
    numbers::dispatch(&Rows)
}

struct Rows;

impl Job for Rows {
    fn run<S: Number>(&self) -> Exit {
        let mut words = Words(1);
        let mut tallies = [const { Tally::new() }; 6];
        for turn in 0..10_000u32 {
            // Of velocities every fourth may be as fast as the format can tell.
            let fastest = if turn.is_multiple_of(4) { 18 } else { 4 };
            let (a, b): (Velocity<S>, Velocity<S>) = (words.velocity(fastest), words.velocity(fastest));
            let d = words.vector(-2);
            let columns = [words.column(), words.column()];
            let impulse = words.number(fastest);
            let [lone, pair, central, push, both, thrust] = &mut tallies;
            lone.add(S::Step::lone_speed(&d, &b, &columns[1]));
            pair.add(S::Step::pair_speed(&d, [&a, &b], &columns));
            central.add(S::Step::central_speed(&d, [&a.v, &b.v]));
            let (mut e, mut f) = (a, b);
            S::Step::push(&mut f, &d, &columns[1], impulse);
            push.add_velocity(&f);
            f = b;
            S::Step::push_pair([&mut e, &mut f], &d, &columns, impulse);
            both.add_velocity(&e);
            both.add_velocity(&f);
            S::Step::thrust(&mut e.v, &d, columns[0].share, impulse);
            thrust.add_velocity(&e);
        }
        for (name, Tally { hash, ends }) in
            ["one body's speed", "a pair's", "its centres'", "a push", "of both", "a thrust"].iter().zip(&tallies)
        {
            board::println!("{}, {}: {:016x}, {} numbers at an end of the format", S::NAME, name, hash.get(), ends);
        }
        Exit::Success
    }
}

/// What came of rows.
struct Tally {
    hash: StateHash,
    ends: u32,
}

impl Tally {
    const fn new() -> Self {
        Self { hash: StateHash::new(), ends: 0 }
    }

    fn add<S: Scalar>(&mut self, x: S) {
        self.hash.add(x);
        if x == S::LARGEST || x.negated() == S::LARGEST {
            self.ends = self.ends.wrapping_add(1);
        }
    }

    fn add_velocity<S: Scalar>(&mut self, Velocity { v, w }: &Velocity<S>) {
        for x in v.to_array().into_iter().chain(w.to_array()) {
            self.add(x);
        }
    }
}

/// Numbers of every length: xorshift (Marsaglia, 2003).
struct Words(u32);

impl Words {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    /// Of a magnitude below 2^most, and one time in sixteen zero.
    fn number<S: Scalar>(&mut self, most: i32) -> S {
        let mantissa = if self.next().is_multiple_of(16) { 0 } else { self.next() as i32 >> 1 };
        let down = (self.next() >> 28) as i32;
        S::from_scaled(S::Scaled::from_parts(mantissa, most.wrapping_sub(30).wrapping_sub(down))).0
    }

    fn vector<S: Scalar>(&mut self, most: i32) -> Vec3<S> {
        Vec3::new(self.number(most), self.number(most), self.number(most))
    }

    fn velocity<S: Scalar>(&mut self, most: i32) -> Velocity<S> {
        Velocity { v: self.vector(most), w: self.vector(most) }
    }

    /// As long as columns may be: in fixed point a direction and a share are below one, an arm below two, a turn below sixteen,
    /// of which each has its own number of places.
    fn column<S: Scalar>(&mut self) -> Column<S> {
        let share: S::Unit = self.number(0);
        let share = if share < S::Unit::ZERO { share.negated() } else { share };
        Column { arm: self.vector(-1), turn: self.vector(0), share }
    }
}
