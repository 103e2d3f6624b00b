//! `--trace FILE`: what happens in a world, step by step, as `cargo xtask view` shows it.
//!
//! Numbers go into the file as they are stored, so that fixed point is read back exactly; of a body only what has changed
//! since the step before. `docs/view.md` has the format. Without the option nothing is written, and nothing else changes.

// Each example uses the part that it needs.
#![allow(dead_code)]

pub mod look;

use carom::solver::Settings;
use carom::world::Phase;
use carom::{Body, Collide, Scalar, Scaled, StateHash, Vec3, World};

use crate::board::{self, BinaryWriter};
use crate::numbers::Number;
use look::{Look, Traced};

const MAGIC: &[u8; 8] = b"CAROM\0TR";
const VERSION: u8 = 1;
const FRAME: u8 = b'F';
const END: u8 = b'E';
/// Micrometres to the unit of length of all scenes, the decimetre.
const UNIT: u32 = 100_000;
/// In place of the bits behind the point.
const FLOAT: u8 = 255;

/// How time passes.
#[derive(Clone, Copy)]
pub struct Clock {
    /// Steps in a second.
    pub rate: u16,
    /// Sub-steps in a step.
    pub sub_steps: u8,
}

/// A trace being written, or nothing where none was asked for.
pub struct Trace<const BODIES: usize> {
    file: Option<BinaryWriter>,
    /// The state of each body when it was last written.
    written: [u64; BODIES],
    frames: u32,
}

impl<const BODIES: usize> Trace<BODIES> {
    /// Creates the file that `--trace` names and writes the scene and its first frame. `None`: it cannot be created, which
    /// has been said.
    pub fn start<S: Number, Sh, const MANIFOLDS: usize, const POINTS: usize>(
        world: &World<S, Sh, BODIES, MANIFOLDS, POINTS>,
        clock: Clock,
        settings: &Settings<S>,
        look: impl Fn(usize) -> Look,
    ) -> Option<Self>
    where
        Sh: Collide<S, Sh> + Traced<S>,
    {
        let mut trace = Self { file: None, written: [0; BODIES], frames: 0 };
        let Some(path) = board::option("--trace") else { return Some(trace) };
        match board::create_binary(path) {
            Ok(mut file) => {
                header(&mut file, world, clock, look);
                trace.file = Some(file);
            }
            Err(error) => {
                board::println!("{path}: {error}; --trace wants a place that can be written");
                return None;
            }
        }
        trace.frame(world, settings);
        Some(trace)
    }

    /// Writes the world as it is after a step.
    pub fn frame<S: Scalar, Sh, const MANIFOLDS: usize, const POINTS: usize>(
        &mut self,
        world: &World<S, Sh, BODIES, MANIFOLDS, POINTS>,
        settings: &Settings<S>,
    ) {
        let Some(file) = &mut self.file else { return };
        file.bytes(&[FRAME]);
        vector(file, settings.gravity);
        for (handle, body) in world.bodies() {
            let Some(written) = self.written.get_mut(handle.index()) else { continue };
            let mut hash = StateHash::new();
            hash.add_body(body);
            if *written != hash.get() {
                *written = hash.get();
                // Zero ends the list.
                file.bytes(&[(handle.index() as u8).wrapping_add(1)]);
                motion(file, body);
            }
        }
        file.bytes(&[0]);
        for contact in world.contacts().filter(|contact| contact.phase != Phase::Ended) {
            let [a, b] = contact.bodies.map(|handle| handle.index() as u8);
            let flags = u8::from(contact.sensor) | u8::from(contact.phase == Phase::Began) << 1;
            file.bytes(&[a.wrapping_add(1), b, flags]);
            word(file, S::from_scaled(contact.normal_impulse).0);
            word(file, contact.approach_speed);
        }
        file.bytes(&[0]);
        self.frames = self.frames.wrapping_add(1);
    }

    /// Ends the file. False: it could not be written, which has been said.
    pub fn finish(self) -> bool {
        let Some(mut file) = self.file else { return true };
        file.bytes(&[END]);
        file.bytes(&self.frames.to_le_bytes());
        match file.finish() {
            Ok(()) => true,
            Err(error) => {
                board::println!("the trace: {error}; is the disk full?");
                false
            }
        }
    }
}

fn header<S: Number, Sh, const BODIES: usize, const MANIFOLDS: usize, const POINTS: usize>(
    file: &mut BinaryWriter,
    world: &World<S, Sh, BODIES, MANIFOLDS, POINTS>,
    clock: Clock,
    look: impl Fn(usize) -> Look,
) where
    Sh: Collide<S, Sh> + Traced<S>,
{
    file.bytes(MAGIC);
    file.bytes(&[VERSION, S::NAME.len() as u8]);
    file.bytes(S::NAME.as_bytes());
    file.bytes(&[size_of::<S>() as u8, S::FRACTION.unwrap_or(FLOAT)]);
    file.bytes(&clock.rate.to_le_bytes());
    file.bytes(&[clock.sub_steps]);
    file.bytes(&UNIT.to_le_bytes());
    file.bytes(&[world.bodies().count() as u8]);
    for (handle, body) in world.bodies() {
        file.bytes(&[handle.index() as u8, look(handle.index()) as u8]);
        if let Ok(shape) = world.shape(handle) {
            shape.write(file);
        }
        scaled::<S>(file, body.inv_mass());
        body.inv_inertia_local().into_iter().for_each(|entry| scaled::<S>(file, entry));
    }
}

fn motion<S: Scalar>(file: &mut BinaryWriter, body: &Body<S>) {
    vector(file, body.position);
    body.orientation().to_array().into_iter().for_each(|part| word(file, part));
    vector(file, body.linear_velocity);
    vector(file, body.angular_velocity);
}

fn vector<S: Scalar>(file: &mut BinaryWriter, v: Vec3<S>) {
    v.to_array().into_iter().for_each(|part| word(file, part));
}

/// A number's bits.
pub fn word<S: Scalar>(file: &mut BinaryWriter, x: S) {
    let bits = x.bits().to_le_bytes();
    file.bytes(bits.get(..size_of::<S>()).unwrap_or_default());
}

/// A number of any magnitude from zero up or down: a power of two, and a `Unit` to multiply it with. (The terms of an inertia
/// tensor beside its diagonal may be negative.)
fn scaled<S: Scalar>(file: &mut BinaryWriter, x: S::Scaled) {
    let magnitude = if x < S::Scaled::ZERO { -x } else { x };
    // The least power of two above it, where there is one.
    let exponent = (-100..100).find(|exponent| magnitude < S::Scaled::from_parts(1, *exponent)).unwrap_or(0);
    let (mantissa, _) = S::Unit::from_scaled(x * S::Scaled::from_parts(1, exponent.wrapping_neg()));
    file.bytes(&(exponent as i16).to_le_bytes());
    word(file, mantissa);
}
