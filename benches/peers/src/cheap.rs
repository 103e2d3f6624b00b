//! The cheap form without a library for vectors: K = 1/m_a + 1/m_b + c . I^-1 c with c = r x n, and tensors of six
//! numbers; in f32, and in the operators of `fixed` in Q16.16 throughout, which cut off and wrap.

use crate::harness::{Call, call};
use crate::measure::{self, Impact, Peer};
use core::ops::{Add, Div, Mul, Neg, Sub};
use fixed::types::I16F16;

/// What the formula needs of a number.
pub trait Number:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    const ZERO: Self;
    const ONE: Self;
    fn from_f32(x: f32) -> Self;
    fn to_word(self) -> u32;
    /// The function that is measured.
    const RESOLVE: extern "C" fn(&mut Self, &mut Body<Self>, &mut Body<Self>, &Contact<Self>);
}

type Vector<S> = [S; 3];

pub struct Body<S> {
    velocity: Vector<S>,
    spin: Vector<S>,
    inv_mass: S,
    /// xx, xy, xz, yy, yz, zz
    inv_inertia: [S; 6],
}

pub struct Contact<S> {
    normal: Vector<S>,
    r_a: Vector<S>,
    r_b: Vector<S>,
    restitution: S,
}

pub struct Cheap<S> {
    impulse: S,
    a: Body<S>,
    b: Body<S>,
    contact: Contact<S>,
}

#[inline(always)]
fn dot<S: Number>(a: Vector<S>, b: Vector<S>) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<S: Number>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
fn times<S: Number>([xx, xy, xz, yy, yz, zz]: [S; 6], v: Vector<S>) -> Vector<S> {
    [dot([xx, xy, xz], v), dot([xy, yy, yz], v), dot([xz, yz, zz], v)]
}

#[inline(always)]
fn add<S: Number>(x: &mut Vector<S>, k: S, d: Vector<S>) {
    x.iter_mut().zip(d).for_each(|(x, d)| *x = *x + k * d);
}

#[inline(always)]
fn resolve<S: Number>(impulse: &mut S, a: &mut Body<S>, b: &mut Body<S>, contact: &Contact<S>) {
    let Contact { normal: n, r_a, r_b, restitution: e } = *contact;
    let (c_a, c_b) = (cross(r_a, n), cross(r_b, n));
    // (w x r) . n = w . (r x n)
    let approach = dot(b.velocity, n) - dot(a.velocity, n) + dot(b.spin, c_b) - dot(a.spin, c_a);
    *impulse = S::ZERO;
    if approach >= S::ZERO {
        return;
    }
    let (u_a, u_b) = (times(a.inv_inertia, c_a), times(b.inv_inertia, c_b));
    let k = a.inv_mass + b.inv_mass + dot(c_a, u_a) + dot(c_b, u_b);
    let j = -(S::ONE + e) * approach / k;
    add(&mut a.velocity, -(j * a.inv_mass), n);
    add(&mut b.velocity, j * b.inv_mass, n);
    add(&mut a.spin, -j, u_a);
    add(&mut b.spin, j, u_b);
    *impulse = j;
}

#[unsafe(export_name = "kernel_resolve_plain")]
extern "C" fn resolve_plain(impulse: &mut f32, a: &mut Body<f32>, b: &mut Body<f32>, contact: &Contact<f32>) {
    resolve(impulse, a, b, contact);
}

#[unsafe(export_name = "kernel_resolve_fixed")]
extern "C" fn resolve_fixed(
    impulse: &mut I16F16,
    a: &mut Body<I16F16>,
    b: &mut Body<I16F16>,
    contact: &Contact<I16F16>,
) {
    resolve(impulse, a, b, contact);
}

impl Number for f32 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;
    const RESOLVE: extern "C" fn(&mut Self, &mut Body<Self>, &mut Body<Self>, &Contact<Self>) = resolve_plain;

    fn from_f32(x: f32) -> Self {
        x
    }

    fn to_word(self) -> u32 {
        self.to_bits()
    }
}

impl Number for I16F16 {
    const ZERO: Self = Self::ZERO;
    const ONE: Self = Self::ONE;
    const RESOLVE: extern "C" fn(&mut Self, &mut Body<Self>, &mut Body<Self>, &Contact<Self>) = resolve_fixed;

    fn from_f32(x: f32) -> Self {
        Self::from_num(x)
    }

    fn to_word(self) -> u32 {
        self.to_bits().cast_unsigned()
    }
}

impl<S: Number> Peer for Cheap<S> {
    fn new(impact: &Impact) -> Self {
        let vector = |v: [f32; 3]| v.map(S::from_f32);
        let body = |body: &measure::Body| {
            let [x, y, z] = body.inv_inertia();
            Body {
                velocity: vector(body.velocity),
                spin: vector(body.spin),
                inv_mass: S::from_f32(body.inv_mass),
                inv_inertia: [x[0], x[1], x[2], y[1], y[2], z[2]].map(S::from_f32),
            }
        };
        let [a, b] = &impact.bodies;
        let contact = Contact {
            normal: vector(impact.normal),
            r_a: vector(a.arm),
            r_b: vector(b.arm),
            restitution: S::from_f32(impact.restitution),
        };
        Self { impulse: S::ZERO, a: body(a), b: body(b), contact }
    }

    fn call(&mut self) -> Call {
        let resolve = S::RESOLVE;
        call!(resolve, self.impulse, self.a, self.b, self.contact)
    }

    fn velocities(&self) -> [u32; 12] {
        let vectors = [self.a.velocity, self.a.spin, self.b.velocity, self.b.spin];
        core::array::from_fn(|i| vectors[i / 3][i % 3].to_word())
    }
}
