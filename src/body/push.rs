//! Impulses, forces and torques from outside: thrusters, springs, motors, a finger.
//!
//! v += J/m and w += I^-1 (r x J). Each change is found in [`Scaled`] numbers, whatever the masses and sizes, and added to the
//! velocity together with what that carries beyond its format: so a push too weak for the format arrives over several.

use super::Body;
use crate::math::{Block, Vec3};
use crate::scalar::{Scalar, Scaled, StepArithmetic};

type Rest<S> = <<S as Scalar>::Step as StepArithmetic<S>>::Rest;

/// # Pushing
///
/// Vectors are in the world's frame, and `r` is the arm from the centre of mass to where the push acts, m, as
/// [`arm`](Self::arm) gives it for a point of the body. An immovable body stays as it is.
///
/// In fixed point a component of the velocity is rounded to 2^-16 of the format's last place, of which what is stored is
/// the nearest number; the [`solver`](crate::solver) uses the rest. Before that a change of the velocity is off by at most
/// 2^-27 of |J|/m, and one of the spin by 2^-27 of |I^-1| times the angular impulse or |r||J|. In floating point each operation
/// rounds, and what a large velocity cannot hold of a small change is lost.
///
/// **True** is returned where the velocities are not those of the formula: a component met the end of the format and stays there,
/// or, in floating point, something was not finite and the body is as it was, bit for bit. Nothing panics or wraps.
impl<S: Scalar> Body<S> {
    /// An impulse at the centre of mass, N s: v += J/m.
    ///
    /// Three products and three sums.
    pub fn apply_impulse(&mut self, impulse: Vec3<S>) -> bool {
        self.push(&scaled(impulse))
    }

    /// An impulse at the end of an arm, N s: v += J/m and w += I^-1 (r x J).
    ///
    /// As costly as [`apply_impulse`](Self::apply_impulse) and [`apply_angular_impulse`](Self::apply_angular_impulse), and
    /// six products more.
    pub fn apply_impulse_at(&mut self, impulse: Vec3<S>, r: Vec3<S>) -> bool {
        self.push_at(&scaled(impulse), r)
    }

    /// An angular impulse, N m s: w += I^-1 L.
    ///
    /// Nine products and three sums.
    pub fn apply_angular_impulse(&mut self, angular_impulse: Vec3<S>) -> bool {
        self.twist(&scaled(angular_impulse))
    }

    /// A force at the centre of mass, N, over some time: v += F t/m.
    ///
    /// `seconds` is [`Settings::seconds`](crate::solver::Settings::seconds) for a force that acts over the next step, as a spring
    /// does that is asked again before each. Three products more than [`apply_impulse`](Self::apply_impulse).
    ///
    /// ```
    /// # #[cfg(feature = "f32")] {
    /// use carom::solver::Settings;
    /// use carom::{Body, Material, Solid, Sphere, Vec3, World};
    ///
    /// let steps = Settings::new(Vec3::new(0.0, 0.0, 0.0), [1, 60], 4).unwrap();
    /// let mut world = World::<f32, Sphere<f32>, 1, 1, 1>::new();
    /// let rocket = Body::dynamic(Solid::sphere(0.5_f32)?.with_mass(2.0)?);
    /// let rocket = world.insert(rocket, Sphere::new(0.5)?, Material::DEAD)?;
    /// for _ in 0..60 {
    ///     world.body_mut(rocket)?.apply_force(Vec3::new(0.0, 0.0, 3.0), steps.seconds());
    ///     world.step(&steps);
    /// }
    /// assert!((world.body(rocket)?.linear_velocity.z - 1.5).abs() < 1e-5);    // 3 N over 1 s on 2 kg
    /// # }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn apply_force(&mut self, force: Vec3<S>, seconds: S::Scaled) -> bool {
        let Some(impulse) = over(force, seconds) else { return self.refuses() };
        self.push(&impulse)
    }

    /// A force at the end of an arm, N, over some time: v += F t/m and w += I^-1 (r x F) t.
    ///
    /// Three products more than [`apply_impulse_at`](Self::apply_impulse_at).
    pub fn apply_force_at(&mut self, force: Vec3<S>, r: Vec3<S>, seconds: S::Scaled) -> bool {
        let Some(impulse) = over(force, seconds) else { return self.refuses() };
        self.push_at(&impulse, r)
    }

    /// A torque, N m, over some time: w += I^-1 M t.
    ///
    /// Three products more than [`apply_angular_impulse`](Self::apply_angular_impulse).
    pub fn apply_torque(&mut self, torque: Vec3<S>, seconds: S::Scaled) -> bool {
        let Some(angular_impulse) = over(torque, seconds) else { return self.refuses() };
        self.twist(&angular_impulse)
    }

    fn push(&mut self, impulse: &[S::Scaled; 3]) -> bool {
        if self.is_immovable() {
            return false;
        }
        let Some(linear) = changed(self.linear_velocity, self.rests.linear, self.speed_of(impulse)) else {
            return true;
        };
        self.set_linear(linear)
    }

    fn twist(&mut self, angular_impulse: &[S::Scaled; 3]) -> bool {
        if self.is_immovable() {
            return false;
        }
        let spin = self.spin_of(Block::align(*angular_impulse));
        let Some(angular) = changed(self.angular_velocity, self.rests.angular, spin) else { return true };
        self.set_angular(angular)
    }

    fn push_at(&mut self, impulse: &[S::Scaled; 3], r: Vec3<S>) -> bool {
        if self.is_immovable() {
            return false;
        }
        let (r, j) = (Block::<S>::align(scaled(r)), Block::<S>::align(*impulse));
        let spin = self.spin_of(Block::align(cross(&r, &j)));
        let linear = changed(self.linear_velocity, self.rests.linear, self.speed_of(impulse));
        let angular = changed(self.angular_velocity, self.rests.angular, spin);
        let (Some(linear), Some(angular)) = (linear, angular) else { return true };
        self.set_linear(linear) | self.set_angular(angular)
    }

    /// What a push that is not finite does.
    fn refuses(&self) -> bool {
        !self.is_immovable()
    }

    /// J/m
    #[inline(always)]
    fn speed_of(&self, [x, y, z]: &[S::Scaled; 3]) -> [S::Scaled; 3] {
        [*x * self.inv_mass, *y * self.inv_mass, *z * self.inv_mass]
    }

    /// I^-1 L: exact sums, rounded once each.
    #[inline(always)]
    fn spin_of(&self, angular_impulse: Block<S>) -> [S::Scaled; 3] {
        let [x, y, z] = self.inv_inertia_world.columns();
        [
            angular_impulse.along(&x).raised(self.exponent),
            angular_impulse.along(&y).raised(self.exponent),
            angular_impulse.along(&z).raised(self.exponent),
        ]
    }

    #[inline(always)]
    fn set_linear(&mut self, changed: Changed<S>) -> bool {
        (self.linear_velocity, self.rests.linear) = (changed.velocity, changed.rests);
        changed.clipped
    }

    #[inline(always)]
    fn set_angular(&mut self, changed: Changed<S>) -> bool {
        (self.angular_velocity, self.rests.angular) = (changed.velocity, changed.rests);
        changed.clipped
    }
}

/// A velocity after a push.
struct Changed<S: Scalar> {
    velocity: Vec3<S>,
    rests: [Rest<S>; 3],
    clipped: bool,
}

/// The velocity and what it carries, with a change; `None` where that is not finite.
fn changed<S: Scalar>(v: Vec3<S>, [x, y, z]: [Rest<S>; 3], change: [S::Scaled; 3]) -> Option<Changed<S>> {
    let [change_x, change_y, change_z] = change;
    let (x, rest_x, clipped_x) = S::Step::changed(v.x, x, change_x);
    let (y, rest_y, clipped_y) = S::Step::changed(v.y, y, change_y);
    let (z, rest_z, clipped_z) = S::Step::changed(v.z, z, change_z);
    let velocity = Vec3::new(x, y, z);
    let finite = velocity.is_finite() && change_x.is_finite() && change_y.is_finite() && change_z.is_finite();
    let clipped = clipped_x | clipped_y | clipped_z;
    if finite { Some(Changed { velocity, rests: [rest_x, rest_y, rest_z], clipped }) } else { None }
}

#[inline(always)]
fn scaled<S: Scalar>(v: Vec3<S>) -> [S::Scaled; 3] {
    [v.x.to_scaled(), v.y.to_scaled(), v.z.to_scaled()]
}

/// What acts over a time; `None` where that is not finite.
#[inline(always)]
fn over<S: Scalar>(v: Vec3<S>, seconds: S::Scaled) -> Option<[S::Scaled; 3]> {
    let [x, y, z] = scaled(v);
    if seconds.is_finite() { Some([x * seconds, y * seconds, z * seconds]) } else { None }
}

/// r x J: exact differences, rounded once each.
#[inline(always)]
fn cross<S: Scalar>(r: &Block<S>, j: &Block<S>) -> [S::Scaled; 3] {
    let opposite = j.opposite();
    [
        minor(r, [r.mantissas.y, r.mantissas.z], [j.mantissas.z, opposite.mantissas.y], j.exponent),
        minor(r, [r.mantissas.z, r.mantissas.x], [j.mantissas.x, opposite.mantissas.z], j.exponent),
        minor(r, [r.mantissas.x, r.mantissas.y], [j.mantissas.y, opposite.mantissas.x], j.exponent),
    ]
}

/// a0 b0 + a1 b1 for mantissas of a block and of one with that exponent.
#[inline(always)]
fn minor<S: Scalar>(block: &Block<S>, a: [S::Unit; 2], b: [S::Unit; 2], exponent: S::Exponent) -> S::Scaled {
    let zero = S::Unit::ZERO;
    let a = Block::<S> { mantissas: Vec3::new(a[0], a[1], zero), exponent: block.exponent };
    a.along(&Vec3::new(b[0], b[1], zero)).raised(exponent)
}
