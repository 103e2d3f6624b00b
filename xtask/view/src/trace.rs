//! A trace as it was written: `docs/view.md` has the format. Numbers are exact, in the scene's own units.

use crate::cursor::{Cursor, Format};
use anyhow::{Context, Result, bail};

const MAGIC: &[u8] = b"CAROM\0TR";
const VERSION: u8 = 1;

/// What happened in a world.
#[derive(Debug)]
pub struct Trace {
    /// The number type, as examples name it.
    pub scalar: String,
    pub format: Format,
    /// Steps in a second.
    pub rate: u16,
    /// Sub-steps in a step.
    pub sub_steps: u8,
    /// Metres to a unit of length.
    pub unit: f64,
    pub bodies: Vec<Subject>,
    /// The state at the start, and after each step.
    pub frames: Vec<Frame>,
}

/// A body, in what does not change.
#[derive(Debug)]
pub struct Subject {
    pub look: Look,
    pub shape: Shape,
    /// Zero: nothing moves it but its own velocity.
    pub inv_mass: f64,
    /// xx, xy, xz, yy, yz, zz in the body's frame.
    pub inv_inertia: [f64; 6],
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    Plain,
    Die,
    Sensor,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// What is solid lies against the normal.
    HalfSpace {
        normal: [f64; 3],
    },
    Sphere {
        radius: f64,
    },
    Cuboid {
        half: [f64; 3],
    },
    /// Along z.
    Capsule {
        radius: f64,
        half_length: f64,
    },
}

#[derive(Clone, Debug)]
pub struct Frame {
    pub gravity: [f64; 3],
    /// Of every body.
    pub motions: Vec<Motion>,
    pub touches: Vec<Touch>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    pub position: [f64; 3],
    /// w, x, y, z.
    pub orientation: [f64; 4],
    pub velocity: [f64; 3],
    pub spin: [f64; 3],
}

/// Two bodies that touched in the step.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    pub bodies: [usize; 2],
    pub sensor: bool,
    /// They did not touch in the step before.
    pub began: bool,
    /// Along the normal, over the whole step.
    pub impulse: f64,
    /// How fast they met; zero where they did not in this step.
    pub approach: f64,
}

impl Subject {
    pub fn is_fixed(&self) -> bool {
        self.inv_mass == 0.0
    }

    /// Half its least thickness.
    pub fn size(&self) -> f64 {
        match self.shape {
            Shape::HalfSpace { .. } => f64::INFINITY,
            Shape::Sphere { radius } | Shape::Capsule { radius, .. } => radius,
            Shape::Cuboid { half: [x, y, z] } => x.min(y).min(z),
        }
    }
}

impl Trace {
    /// Takes a file apart.
    pub fn read(bytes: &[u8]) -> Result<Self> {
        let mut cursor = Cursor::new(bytes);
        if !bytes.starts_with(MAGIC) {
            bail!("this is no trace: it does not begin as one does");
        }
        cursor.take(MAGIC.len())?;
        let version = cursor.u8()?;
        if version != VERSION {
            bail!(
                "a trace of version {version}, and only {VERSION} is known: build example and viewer from one source"
            );
        }
        let length = usize::from(cursor.u8()?);
        let scalar = String::from_utf8(cursor.take(length)?.to_vec()).context("the name of the number type")?;
        cursor.format = match (cursor.u8()?, cursor.u8()?) {
            (4, 255) => Format::F32,
            (8, 255) => Format::F64,
            (4, bits @ 0..=31) => Format::Fixed(u32::from(bits)),
            (bytes, bits) => bail!("numbers of {bytes} bytes with {bits} bits behind the point are not known"),
        };
        let (rate, sub_steps, micrometres) = (cursor.u16()?, cursor.u8()?, cursor.u32()?);
        if rate == 0 || sub_steps == 0 || micrometres == 0 {
            bail!("the trace has no step or no unit of length");
        }
        let count = usize::from(cursor.u8()?);
        let bodies = (0..count).map(|index| subject(&mut cursor, index)).collect::<Result<Vec<_>>>()?;
        let frames = frames(&mut cursor, count)?;
        let (format, unit) = (cursor.format, f64::from(micrometres) * 1e-6);
        Ok(Self { scalar, format, rate, sub_steps, unit, bodies, frames })
    }

    /// Which bodies ever change their place.
    pub fn moving(&self, body: usize) -> bool {
        let pose = |frame: &Frame| (frame.motions[body].position, frame.motions[body].orientation);
        self.frames.windows(2).any(|pair| pose(&pair[0]) != pose(&pair[1]))
    }
}

fn subject(cursor: &mut Cursor<'_>, index: usize) -> Result<Subject> {
    if usize::from(cursor.u8()?) != index {
        bail!("the places of the bodies have gaps: a trace has to begin before any is removed");
    }
    let look = match cursor.u8()? {
        0 => Look::Plain,
        1 => Look::Die,
        2 => Look::Sensor,
        other => bail!("body {index} looks like {other}, which is not known"),
    };
    let shape = match cursor.u8()? {
        b'H' => Shape::HalfSpace { normal: [cursor.unit()?, cursor.unit()?, cursor.unit()?] },
        b'S' => Shape::Sphere { radius: cursor.word()? },
        b'B' => Shape::Cuboid { half: cursor.vector()? },
        b'C' => Shape::Capsule { radius: cursor.word()?, half_length: cursor.word()? },
        other => bail!("body {index} has the shape {other}, which is not known"),
    };
    let inv_mass = cursor.scaled()?;
    let mut inv_inertia = [0.0; 6];
    for entry in &mut inv_inertia {
        *entry = cursor.scaled()?;
    }
    Ok(Subject { look, shape, inv_mass, inv_inertia })
}

fn frames(cursor: &mut Cursor<'_>, bodies: usize) -> Result<Vec<Frame>> {
    let mut frames: Vec<Frame> = Vec::new();
    loop {
        match cursor.u8()? {
            b'F' => {
                let former = frames.last().map(|frame| frame.motions.clone());
                let motions = former.unwrap_or_else(|| vec![Motion::default(); bodies]);
                frames.push(frame(cursor, motions)?);
            }
            b'E' => break,
            other => bail!("byte {} of the trace is {other}, where a frame begins", cursor.place() - 1),
        }
    }
    let told = cursor.u32()? as usize;
    if told != frames.len() || frames.is_empty() || !cursor.is_at_end() {
        bail!("the trace has {} frames, and says {told}", frames.len());
    }
    Ok(frames)
}

fn frame(cursor: &mut Cursor<'_>, mut motions: Vec<Motion>) -> Result<Frame> {
    let gravity = cursor.vector()?;
    loop {
        let index = usize::from(cursor.u8()?);
        if index == 0 {
            break;
        }
        let motion = motions.get_mut(index - 1).with_context(|| format!("there is no body {}", index - 1))?;
        motion.position = cursor.vector()?;
        motion.orientation = [cursor.unit()?, cursor.unit()?, cursor.unit()?, cursor.unit()?];
        motion.velocity = cursor.vector()?;
        motion.spin = cursor.vector()?;
    }
    let mut touches = Vec::new();
    loop {
        let first = usize::from(cursor.u8()?);
        if first == 0 {
            return Ok(Frame { gravity, motions, touches });
        }
        let (second, flags) = (usize::from(cursor.u8()?), cursor.u8()?);
        let bodies = [first - 1, second];
        if bodies.iter().any(|body| *body >= motions.len()) {
            bail!("bodies {bodies:?} touch, and there are {}", motions.len());
        }
        let (impulse, approach) = (cursor.word()?, cursor.word()?);
        touches.push(Touch { bodies, sensor: flags & 1 != 0, began: flags & 2 != 0, impulse, approach });
    }
}
