//! Every peer on the first impact of the input, and the impact as plain f32.

use crate::board;
use crate::cheap::Cheap;
use crate::harness::{Call, counter, input, stack};
use crate::with_3dgfx::With3dgfx;
use crate::with_glam::WithGlam;
use crate::with_nalgebra::WithNalgebra;
use fixed::types::I16F16;

/// One of the two bodies, for anybody to convert.
pub struct Body {
    pub inv_mass: f32,
    pub inv_moments: [f32; 3],
    /// w, x, y, z
    pub orientation: [f32; 4],
    pub arm: [f32; 3],
    pub velocity: [f32; 3],
    pub spin: [f32; 3],
}

/// Two bodies that meet.
pub struct Impact {
    pub bodies: [Body; 2],
    pub normal: [f32; 3],
    pub restitution: f32,
    pub friction: f32,
}

/// Somebody's way to resolve an impact.
pub trait Peer {
    /// Carom's name for what is measured.
    const OPERATION: &'static str = "resolve";

    /// Operands and their place for results.
    fn new(impact: &Impact) -> Self;
    /// What is measured.
    fn call(&mut self) -> Call;
    /// The bits of v_a, w_a, v_b and w_b.
    fn velocities(&self) -> [u32; 12];
}

/// Prints `counter EMPTY TICKS`, and `peer NAME OPERATION INSTRUCTIONS STACK WORD...` for each peer in the number
/// type that `--scalar` names, the words being the bits of v_a, w_a, v_b and w_b after the impact.
pub fn run() -> Result<(), &'static str> {
    board::println!("counter {} {}", counter::empty(), counter::ticks_per_thousand());
    let path = board::option("--input").ok_or("--input FILE is missing")?;
    let mut file = board::open(path).map_err(|_| "the input cannot be opened")?;
    let impact = plain(&input::next(&mut file)?.ok_or("the input is empty")?);
    match board::option("--scalar") {
        Some("f32") => {
            measure::<WithGlam>("glam", &impact)?;
            measure::<WithNalgebra>("nalgebra", &impact)?;
            measure::<Cheap<f32>>("plain", &impact)?;
            measure::<With3dgfx>("embedded-3dgfx", &impact)
        }
        Some("i16f16") => measure::<Cheap<I16F16>>("fixed", &impact),
        _ => Err("--scalar f32 or i16f16 is missing"),
    }
}

fn measure<P: Peer>(name: &str, impact: &Impact) -> Result<(), &'static str> {
    let mut peer = P::new(impact);
    let instructions = counter::instructions(&peer.call()).ok_or("too long for the counter")?;
    board::print!("peer {name} {} {instructions} ", P::OPERATION);
    let velocities = peer.velocities();
    peer = P::new(impact);
    board::print!("{}", stack::bytes(&peer.call()).ok_or("more stack than is painted")?);
    velocities.iter().for_each(|word| board::print!(" {word}"));
    board::println!();
    Ok(())
}

fn plain(impact: &input::Impact) -> Impact {
    let number = |n: input::Number| n.mantissa as f32 * f32::from_bits(((n.exponent + 127) as u32) << 23);
    let body = |body: &input::Body| Body {
        inv_mass: number(body.inv_mass),
        inv_moments: body.inv_moments.map(number),
        orientation: body.orientation.map(number),
        arm: body.arm.map(number),
        velocity: body.velocity.map(number),
        spin: body.spin.map(number),
    };
    Impact {
        bodies: [body(&impact.bodies[0]), body(&impact.bodies[1])],
        normal: impact.normal.map(number),
        restitution: number(impact.restitution),
        friction: number(impact.friction),
    }
}

impl Body {
    /// R I^-1 R^T
    pub fn inv_inertia(&self) -> [[f32; 3]; 3] {
        let [w, x, y, z] = self.orientation;
        let r = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let [a, b, c] = self.inv_moments;
        r.map(|i| r.map(|j| i[0] * a * j[0] + i[1] * b * j[1] + i[2] * c * j[2]))
    }
}
