//! The same impulses in f32 on every core: 32,000 contacts of ordinary and of extreme numbers, and hashes of what comes
//! of them. Where an impulse is written in the instructions of an FPU, they have to be those that the portable form gives.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;

use board::Exit;

board::entry!(run);

#[cfg(not(feature = "f32"))]
fn run() -> Exit {
    board::println!("no f32 in this build");
    Exit::Success
}

/// Prints the hashes of what comes of all contacts: every board has to print the host's.
#[cfg(feature = "f32")]
fn run() -> Exit {
    use carom::impulse::{resolve_collision, resolve_collision_with_friction};
    use carom::{Material, RestitutionLaw};

    let mut words = Words(1);
    let (mut smooth, mut rough) = (Tally::new(), Tally::new());
    for turn in 0..32_000 {
        let kind = Kind::of(turn);
        let (a, b) = (words.body(turn, kind), words.body(turn / 8, kind));
        let contact = words.contact(turn, kind);
        let restitution = if turn.is_multiple_of(64) { words.number(kind) } else { words.fraction() };

        let (mut c, mut d) = (a, b);
        let impact = resolve_collision(&mut c, &mut d, &contact, restitution);
        smooth.add(&impact, [&c, &d]);

        let Ok(material) = Material::new(words.fraction(), words.fraction() * 2.0) else { return Exit::Failure };
        let law = if turn.is_multiple_of(4) { RestitutionLaw::EnergySafe } else { RestitutionLaw::Newton };
        let (mut c, mut d) = (a, b);
        let impact = resolve_collision_with_friction(&mut c, &mut d, &contact, &material.with_law(law));
        rough.add(&impact, [&c, &d]);
    }
    smooth.print("without friction");
    rough.print("with friction");
    Exit::Success
}

/// What became of contacts.
#[cfg(feature = "f32")]
struct Tally {
    hash: carom::StateHash,
    /// Separating, stuck, slid, immovable, not finite.
    outcomes: [u32; 5],
}

#[cfg(feature = "f32")]
impl Tally {
    fn new() -> Self {
        Self { hash: carom::StateHash::new(), outcomes: [0; 5] }
    }

    fn add(&mut self, impact: &carom::impulse::Impact<f32>, bodies: [&carom::Body<f32>; 2]) {
        use carom::impulse::Outcome;

        let outcome = match impact.outcome {
            Outcome::Separating => 0,
            Outcome::Stuck => 1,
            Outcome::Slid => 2,
            Outcome::Immovable => 3,
            Outcome::NotFinite => 4,
        };
        if let Some(count) = self.outcomes.get_mut(outcome) {
            *count += 1;
        }
        self.number(outcome as f32);
        self.number(f32::from(u8::from(impact.saturated)));
        self.number(impact.normal_impulse);
        self.vector(impact.friction_impulse);
        for body in bodies {
            self.vector(body.linear_velocity);
            self.vector(body.angular_velocity);
        }
    }

    fn vector(&mut self, v: carom::Vec3<f32>) {
        for x in v.to_array() {
            self.number(x);
        }
    }

    /// Which NaN it is differs from machine to machine.
    fn number(&mut self, x: f32) {
        self.hash.add(if x.is_nan() { f32::NAN } else { x });
    }

    fn print(&self, name: &str) {
        let [separating, stuck, slid, immovable, not_finite] = self.outcomes;
        board::println!("f32 {} {:#018x}:", name, self.hash.get());
        board::println!("  {} separating, {} stuck, {} slid", separating, stuck, slid);
        board::println!("  {} immovable, {} not finite", immovable, not_finite);
    }
}

/// Which numbers a contact is made of.
#[cfg(feature = "f32")]
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// Of sizes from 2^-8 to 2^7.
    Ordinary,
    /// Small integers, with zeros of both signs among them: sums that cancel, products of nothing.
    Whole,
    /// Of sizes from 2^-64 to 2^63.
    Far,
    /// Any bits, and infinities, NaN, zeros, the smallest and the largest numbers, among ordinary ones.
    Extreme,
}

#[cfg(feature = "f32")]
impl Kind {
    fn of(turn: u32) -> Self {
        match turn % 9 {
            0..=3 => Self::Ordinary,
            4 | 5 => Self::Whole,
            6 => Self::Far,
            _ => Self::Extreme,
        }
    }
}

/// Random words: xorshift (Marsaglia, 2003).
#[cfg(feature = "f32")]
struct Words(u32);

#[cfg(feature = "f32")]
impl Words {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0.wrapping_mul(0x9e37_79b9)
    }

    fn number(&mut self, kind: Kind) -> f32 {
        const EXTREMES: [f32; 16] = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            f32::INFINITY,
            f32::NEG_INFINITY,
            f32::NAN,
            f32::MAX,
            f32::MIN,
            f32::MIN_POSITIVE,
            -f32::MIN_POSITIVE,
            1e-45,
            -1e-45,
            1e-39,
            1e19,
            -1e-19,
        ];
        let word = self.next();
        let selected = self.next() >> 16;
        let sized = |bits: u32, bias: u32| f32::from_bits(word & 0x807f_ffff | (bias + (selected & bits)) << 23);
        match kind {
            Kind::Ordinary => sized(15, 127 - 8),
            Kind::Whole if selected & 7 == 0 => -0.0,
            Kind::Whole => ((word >> 29) as i32 - 4) as f32,
            Kind::Far => sized(127, 127 - 64),
            Kind::Extreme => match selected & 63 {
                0..16 => EXTREMES[(selected & 15) as usize],
                16..20 => f32::from_bits(word),
                _ => sized(15, 127 - 8),
            },
        }
    }

    /// From 0 to 1, both ends among them.
    fn fraction(&mut self) -> f32 {
        (self.next() >> 24) as f32 / 255.0
    }

    fn vector(&mut self, kind: Kind) -> carom::Vec3<f32> {
        carom::Vec3::new(self.number(kind), self.number(kind), self.number(kind))
    }

    /// Every eighth is immovable; the others have masses and moments of all sizes, and are turned.
    fn body(&mut self, turn: u32, kind: Kind) -> carom::Body<f32> {
        use carom::{Body, MassProperties, Quat};

        let mut inverse = || match self.number(kind) {
            x if x.is_finite() => x.abs(),
            _ => f32::MAX,
        };
        let (mass, moments) = (inverse(), [inverse(), inverse(), inverse()]);
        let mut body = match MassProperties::from_inverses(mass, moments) {
            Ok(mass) if !turn.is_multiple_of(8) => Body::dynamic(mass),
            _ => Body::immovable(),
        };
        let [w, x, y, z] = [[1.0, 0.0, 0.0, 0.0], [0.6, 0.8, 0.0, 0.0], [0.1, 0.7, 0.5, 0.5], [0.2, 0.4, 0.8, 0.4]]
            [(turn % 4) as usize];
        body.set_orientation(Quat::new(w, x, y, z).unwrap_or(Quat::IDENTITY));
        body.linear_velocity = self.vector(kind);
        body.angular_velocity = self.vector(kind);
        body
    }

    /// Every fifth arm goes along the normal, where it is no lever.
    fn contact(&mut self, turn: u32, kind: Kind) -> carom::Contact<f32> {
        use carom::{Contact, UnitVec3};

        let normal = UnitVec3::normalize(self.vector(kind)).unwrap_or(UnitVec3::X);
        let mut arm =
            |turn: u32| if turn.is_multiple_of(5) { normal.times(self.number(kind)) } else { self.vector(kind) };
        Contact { normal, r_a: arm(turn), r_b: arm(turn + 1) }
    }
}
