//! The same impulses on every core: thirty thousand contacts of ordinary and of extreme numbers, and a hash of what comes of
//! them. Where an impulse is written in a core's own instructions, it has to be the hash that the portable form gives.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;

use board::Exit;

board::entry!(run);

#[cfg(not(feature = "fixed"))]
fn run() -> Exit {
    board::println!("no fixed point in this build");
    Exit::Success
}

#[cfg(feature = "fixed")]
fn run() -> Exit {
    use fixed::types::{I2F30, I8F24, I12F20, I16F16, I25F7};

    sweep::<I16F16>("I16F16");
    sweep::<I12F20>("I12F20");
    sweep::<I8F24>("I8F24");
    sweep::<I25F7>("I25F7");
    sweep::<I2F30>("I2F30");
    Exit::Success
}

/// Prints the hash of what comes of all contacts in a number type: every board has to print the host's.
#[cfg(feature = "fixed")]
fn sweep<S: carom::Scalar>(name: &str) {
    use carom::Material;
    use carom::StateHash;
    use carom::impulse::{
        Outcome, apply_impulse, collision_impulse, effective_mass, resolve_collision, resolve_collision_with_friction,
    };

    let mut words = Words(1);
    let mut hash = StateHash::new();
    let mut rubbed = StateHash::new();
    let [mut struck, mut saturated, mut immovable, mut stuck, mut slid, mut met] = [0u32; 6];
    for turn in 0..6_000 {
        let (mut a, mut b) = (words.body::<S>(turn), words.body::<S>(turn / 8));
        let contact = words.contact::<S>(turn);
        let (restitution, j) = (words.number::<S>(), words.number::<S>());
        if let Ok(material) = Material::new(words.fraction::<S>(), words.fraction::<S>()) {
            let (mut a, mut b) = (a, b);
            let impact = resolve_collision_with_friction(&mut a, &mut b, &contact, &material);
            rubbed.add(impact.normal_impulse);
            rubbed.add_vec3(impact.friction_impulse);
            rubbed.add_body(&a);
            rubbed.add_body(&b);
            met += u32::from(impact.saturated);
            stuck += u32::from(impact.outcome == Outcome::Stuck);
            slid += u32::from(impact.outcome == Outcome::Slid);
        }
        hash.add(effective_mass(&a, &b, &contact, contact.normal));
        hash.add(collision_impulse(&a, &b, &contact, restitution));
        let impact = resolve_collision(&mut a, &mut b, &contact, restitution);
        hash.add(impact.normal_impulse);
        hash.add_body(&a);
        hash.add_body(&b);
        saturated += u32::from(impact.saturated) + u32::from(apply_impulse(&mut a, &mut b, &contact, j));
        struck += u32::from(impact.outcome == Outcome::Slid);
        immovable += u32::from(impact.outcome == Outcome::Immovable);
        hash.add_body(&a);
        hash.add_body(&b);
    }
    let hash = hash.get();
    board::println!("{} {:#018x}: {} struck, {} saturated, {} immovable", name, hash, struck, saturated, immovable);
    board::println!("{} {:#018x} with friction: {} stuck, {} slid, {} saturated", name, rubbed.get(), stuck, slid, met);
}

/// Words of every length: xorshift (Marsaglia, 2003), each shifted by a random number of places.
#[cfg(feature = "fixed")]
struct Words(u32);

#[cfg(feature = "fixed")]
impl Words {
    fn next(&mut self) -> i32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        let places = self.0.wrapping_mul(0x9e37_79b9) >> 27;
        self.0 as i32 >> places
    }

    fn number<S: carom::Scalar>(&mut self) -> S {
        S::STEP.times_integer(self.next())
    }

    /// From 0 to 1.
    fn fraction<S: carom::Scalar>(&mut self) -> S {
        S::from_ratio(self.next() & 255, 255).unwrap_or(S::ONE)
    }

    /// In every sixteenth vector nothing but extremes, in the next words of full length, in others words of a third of it.
    fn vector<S: carom::Scalar>(&mut self, turn: u32) -> carom::Vec3<S> {
        const EXTREMES: [i32; 8] = [0, 0, 1, -1, -2, i32::MAX, i32::MIN, 1 << 30];
        let mut component = || {
            let word = self.next();
            let bits = match turn % 16 {
                0 => EXTREMES[(word & 7) as usize],
                1 => self.0 as i32,
                _ => word >> (turn % 3 * 10),
            };
            S::STEP.times_integer(bits)
        };
        carom::Vec3::new(component(), component(), component())
    }

    /// Every eighth is immovable; the others have masses and moments of all sizes, and are turned.
    fn body<S: carom::Scalar>(&mut self, turn: u32) -> carom::Body<S> {
        use carom::{Body, MassProperties, Quat, Scalar, Scaled};

        let size = self.next() % 16;
        let mut inverse = || S::Scaled::from_parts(self.next() >> 4 & i32::MAX | 1 << 26, size - 28);
        let moments = [inverse(), inverse(), inverse()];
        let mass = S::Scaled::from_parts(self.next() & ((1 << 27) - 1) | 1 << 27, -26 - size);
        let mut body = match MassProperties::from_inverses(mass, moments) {
            Ok(mass) if !turn.is_multiple_of(8) => Body::dynamic(mass),
            _ => Body::immovable(),
        };
        let tenths = [[6, 8, 0, 0], [1, 7, 5, 5], [2, 4, 8, 4], [5, 5, 5, 5]][(turn % 4) as usize];
        if let [Ok(w), Ok(x), Ok(y), Ok(z)] = tenths.map(|n| S::Unit::from_ratio(n, 10)) {
            body.set_orientation(Quat::new(w, x, y, z).unwrap_or(Quat::IDENTITY));
        }
        body.linear_velocity = self.vector(turn);
        body.angular_velocity = self.vector(turn / 3);
        body
    }

    /// Every fifth arm goes along the normal, where it is no lever.
    fn contact<S: carom::Scalar>(&mut self, turn: u32) -> carom::Contact<S> {
        use carom::{Contact, UnitVec3};

        let normal = UnitVec3::normalize(self.vector::<S>(1)).unwrap_or(UnitVec3::X);
        let mut arm =
            |turn: u32| if turn.is_multiple_of(5) { normal.times(self.number()) } else { self.vector(turn / 5) };
        Contact { normal, r_a: arm(turn), r_b: arm(turn + 1) }
    }
}
