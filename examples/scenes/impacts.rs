//! Ten thousand impacts among sixteen bodies: every solid, every outcome, chosen by a generator of its own.

use carom::impulse::{Impact, Outcome, resolve_collision, resolve_collision_with_friction};
use carom::{Body, Contact, Material, RestitutionLaw, Scalar, Solid, StateHash, Vec3};

use super::random::Random;

/// Impacts in all.
pub const IMPACTS: u32 = 10_000;
const BODIES: usize = 16;

/// The bodies, and what happened to them so far.
pub struct Scene<S: Scalar> {
    bodies: [Body<S>; BODIES],
    random: Random,
    /// Impacts that stuck, slid, and did nothing.
    pub stuck: u32,
    pub slid: u32,
    pub apart: u32,
    /// Impacts in which something met the end of the format.
    pub saturated: u32,
    hash: StateHash,
}

/// The body's solid by its number; the last one is the ground.
fn body<S: Scalar>(index: usize, random: &mut Random) -> Option<Body<S>> {
    let mut size = || random.number::<S>(256, 1024);
    let solid = match index {
        15 => return Some(Body::immovable()),
        0..4 => Solid::sphere(size()),
        4..8 => Solid::cuboid(Vec3::new(size(), size(), size())),
        8 | 9 => Solid::capsule(size(), size()),
        10 => Solid::cylinder(size(), size()),
        11 => Solid::cone(size(), size()),
        12 => Solid::ellipsoid(Vec3::new(size(), size(), size())),
        13 => Solid::spherical_shell(size()),
        _ => Solid::tube(size(), size()),
    };
    let mass = random.number(256, 4096);
    Some(Body::dynamic(solid.ok()?.with_mass(mass).ok()?))
}

impl<S: Scalar> Scene<S> {
    /// The sixteen bodies, turned and set in motion. `None` would mean that a size or mass is not one.
    pub fn new() -> Option<Self> {
        let mut random = Random::new(0x2545_f491);
        let mut bodies = [Body::immovable(); BODIES];
        for (index, slot) in bodies.iter_mut().enumerate() {
            *slot = body(index, &mut random)?;
            if !slot.is_immovable() {
                slot.set_orientation(random.orientation());
                slot.linear_velocity = random.vector(-4096, 4096);
                slot.angular_velocity = random.vector(-4096, 4096);
            }
        }
        Some(Self { bodies, random, stuck: 0, slid: 0, apart: 0, saturated: 0, hash: StateHash::new() })
    }

    /// The next impact: two bodies, a contact and a material, all at random.
    pub fn step(&mut self) -> Option<()> {
        let random = &mut self.random;
        let first = random.below(BODIES as u32 - 1) as usize;
        let second = first.wrapping_add(1).wrapping_add(random.below((BODIES - 1 - first) as u32) as usize);
        let contact =
            Contact { normal: random.direction(), r_a: random.vector(-1024, 1024), r_b: random.vector(-1024, 1024) };
        let (e, mu) = (random.number(0, 1024), random.number(0, 1536));
        let kind = random.below(8);
        let law = if kind < 3 { RestitutionLaw::EnergySafe } else { RestitutionLaw::Newton };
        let material = Material::new(e, mu).ok()?.with_law(law);

        let (left, right) = self.bodies.split_at_mut_checked(second)?;
        let (a, b) = (left.get_mut(first)?, right.first_mut()?);
        let impact = kernel_impact(a, b, &contact, &material, kind == 7);
        match impact.outcome {
            Outcome::Stuck => self.stuck = self.stuck.wrapping_add(1),
            Outcome::Slid => self.slid = self.slid.wrapping_add(1),
            _ => self.apart = self.apart.wrapping_add(1),
        }
        self.saturated = self.saturated.wrapping_add(u32::from(impact.saturated));
        self.hash.add(impact.normal_impulse);
        self.hash.add_vec3(impact.friction_impulse);
        self.hash.add_body(a);
        self.hash.add_body(b);

        // Impacts take energy out: now and then a body is set in motion again, and turned.
        let other = self.random.below(BODIES as u32 - 1) as usize;
        if self.random.below(4) == 0 {
            let body = self.bodies.get_mut(other)?;
            body.set_orientation(self.random.orientation());
            body.linear_velocity = self.random.vector(-4096, 4096);
            body.angular_velocity = self.random.vector(-4096, 4096);
        }
        Some(())
    }

    /// The hash of everything so far.
    pub fn hash(&self) -> u64 {
        self.hash.get()
    }
}

/// The hash after all impacts.
pub fn hash<S: Scalar>() -> Option<u64> {
    let mut scene = Scene::<S>::new()?;
    for _ in 0..IMPACTS {
        scene.step()?;
    }
    Some(scene.hash())
}

#[inline(never)]
fn kernel_impact<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    contact: &Contact<S>,
    material: &Material<S>,
    frictionless: bool,
) -> Impact<S> {
    if frictionless {
        resolve_collision(a, b, contact, material.restitution())
    } else {
        resolve_collision_with_friction(a, b, contact, material)
    }
}
