//! Arbitrary bits as numbers, vectors and bodies.

use carom::{Body, MassProperties, Quat, Scaled, Vec3};

use super::format::Format;

/// Arbitrary bits, handed out word by word.
pub struct Words<'a>(pub std::slice::Iter<'a, u64>);

/// As many as one case takes.
pub const WORDS: usize = 64;

impl Words<'_> {
    pub fn next(&mut self) -> u64 {
        *self.0.next().expect("enough words")
    }

    /// Any number of a format. Fixed point: any bits, moved right by up to 31 places. Floats: any bits, or one of the
    /// numbers that bite, or a number of ordinary size.
    pub fn number<S: Format>(&mut self) -> S {
        let word = self.next();
        if S::saturates() {
            return S::from_raw(((word as u32 as i32) >> (word >> 32 & 31)) as u32 as u64);
        }
        match word >> 60 {
            0..=3 => S::from_raw(word),
            4 => S::nearest(
                [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 1e-310, 1e-40, 1.0][word as usize % 8],
            ),
            5 => S::nearest([S::largest(), -S::largest(), S::largest() / 2.0, 1e19][word as usize % 4]),
            _ => S::nearest((word as u32 as i32 as f64) * 2f64.powi((word >> 32 & 31) as i32 - 40)),
        }
    }

    pub fn vector<S: Format>(&mut self) -> Vec3<S> {
        Vec3::new(self.number(), self.number(), self.number())
    }

    pub fn unit<S: Format>(&mut self) -> S::Unit {
        S::unit_from_raw(self.number::<S>().raw())
    }

    /// Any intermediate number; `wild` exponents are those that no format leads to.
    pub fn scaled<S: Format>(&mut self, wild: bool) -> S::Scaled {
        let word = self.next();
        let exponent = if wild { (word >> 32) as i32 } else { (word >> 32) as i32 % 64 };
        let mantissa = word as u32 as i32;
        S::Scaled::from_parts(if word & 3 << 62 == 0 { mantissa } else { mantissa.saturating_abs() }, exponent)
    }

    pub fn body<S: Format>(&mut self, wild: bool) -> Body<S> {
        let inv_mass = self.scaled::<S>(wild);
        let moments = [self.scaled::<S>(wild), self.scaled::<S>(wild), self.scaled::<S>(wild)];
        let valid = inv_mass > S::Scaled::ZERO
            && inv_mass.is_finite()
            && moments.iter().all(|m| *m >= S::Scaled::ZERO && m.is_finite());
        let mut body = match MassProperties::<S>::from_inverses(inv_mass, moments) {
            Ok(mass) => {
                assert!(valid, "accepted {inv_mass:?} {moments:?}");
                Body::dynamic(mass)
            }
            Err(_) => Body::immovable(),
        };
        if let Ok(orientation) = Quat::normalize(self.unit::<S>(), self.unit::<S>(), self.unit::<S>(), self.unit::<S>())
        {
            body.set_orientation(orientation);
        }
        body.position = self.vector();
        body.linear_velocity = self.vector();
        body.angular_velocity = self.vector();
        body
    }
}
