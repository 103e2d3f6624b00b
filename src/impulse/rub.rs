//! An impact with friction: from the bodies to the contact's problem, and from its solution back.

use super::apply::apply_block;
use super::energy::limit_energy;
use super::friction::{ContactBlock, Impulse};
use super::lever::without_impulse;
use super::{Impact, Outcome};
use crate::body::Body;
use crate::contact::{Material, RestitutionLaw};
use crate::math::{Block, BlockImpulse, SymBlock, Vec3};
use crate::scalar::{Scalar, Scaled};

/// An impact with friction. `apart`: the solution by scaled numbers is rarely needed, and is kept out of the way.
pub(super) fn rub<S: Scalar>(
    a: &mut Body<S>,
    b: &mut Body<S>,
    normal: Vec3<S::Unit>,
    [r_a, r_b]: [&Vec3<S>; 2],
    material: &Material<S>,
    apart: bool,
) -> Impact<S> {
    let velocity = S::contact_velocity(
        [&a.linear_velocity, &b.linear_velocity],
        [&a.angular_velocity, &b.angular_velocity],
        [r_a, r_b],
    );
    if !S::Unit::is_against(velocity.mantissas.to_array(), normal.to_array()) {
        return Impact::nothing(unmoved(a, b, velocity, normal, [r_a, r_b]));
    }
    // Not an array, into which the second would be copied.
    let arm_a = S::arm(r_a, &a.inv_inertia_world, a.exponent);
    let arm_b = S::arm(r_b, &b.inv_inertia_world, b.exponent);
    let inv_masses = [a.inv_mass, b.inv_mass];
    let inverse_mass = S::contact_inverse_mass(inv_masses, [&arm_a, &arm_b]);
    let surface = [material.restitution(), material.friction()];
    let (j, outcome) = match S::contact_impulse(&inverse_mass, &velocity, &normal, surface) {
        Some((j, stuck)) => (j, if stuck { Outcome::Stuck } else { Outcome::Slid }),
        None => match solve_scaled(&inverse_mass, &velocity, &normal, inv_masses, material, apart) {
            Ok(solved) => solved,
            Err(outcome) => return Impact::nothing(outcome),
        },
    };
    let j = match material.law {
        RestitutionLaw::Newton => j,
        RestitutionLaw::EnergySafe => {
            let block = ContactBlock::new(&inverse_mass, &velocity, &normal, inv_masses);
            match limit_energy(&block, material.friction().to_scaled(), Impulse::from_block(&j)) {
                None => j,
                Some(less) if less.is_finite() => less.to_block(),
                Some(_) => return Impact::nothing(Outcome::NotFinite),
            }
        }
    };
    let clipped = apply_block(a, b, [r_a, r_b], [&arm_a, &arm_b], &Block { mantissas: j.whole, exponent: j.exponent });
    let (normal_impulse, large) = S::from_block(j.normal, j.normal_exponent);
    let (x, large_x) = S::from_block(j.across.x, j.exponent);
    let (y, large_y) = S::from_block(j.across.y, j.exponent);
    let (z, large_z) = S::from_block(j.across.z, j.exponent);
    let saturated = clipped | large | large_x | large_y | large_z;
    Impact { outcome, normal_impulse, friction_impulse: Vec3::new(x, y, z), saturated }
}

/// The outcome where the points do not approach.
#[cold]
#[inline(never)]
pub(super) fn unmoved<S: Scalar>(
    a: &Body<S>,
    b: &Body<S>,
    velocity: Block<S>,
    normal: Vec3<S::Unit>,
    r: [&Vec3<S>; 2],
) -> Outcome {
    let arms = [S::arm(r[0], &a.inv_inertia_world, a.exponent), S::arm(r[1], &b.inv_inertia_world, b.exponent)];
    let inverse_mass = S::contact_inverse_mass([a.inv_mass, b.inv_mass], [&arms[0], &arms[1]]);
    let [xx, _, _, yy, _, zz] = inverse_mass.to_scaled();
    let speed = S::Unit::scaled_dot3(velocity.mantissas.to_array(), normal.to_array());
    without_impulse(speed, xx + yy + zz)
}

/// The impulse by [`Scaled`] numbers; the outcome where there is none.
#[inline(always)]
fn solve_scaled<S: Scalar>(
    inverse_mass: &SymBlock<S>,
    velocity: &Block<S>,
    normal: &Vec3<S::Unit>,
    inv_masses: [S::Scaled; 2],
    material: &Material<S>,
    apart: bool,
) -> Result<(BlockImpulse<S>, Outcome), Outcome> {
    let block = ContactBlock::new(inverse_mass, velocity, normal, inv_masses);
    let refuse = || Err(without_impulse(block.speed, block.trace()));
    let movable = block.trace() > S::Scaled::ZERO;
    if !movable {
        return refuse();
    }
    let (restitution, friction) = (material.restitution().to_scaled(), material.friction().to_scaled());
    let (j, outcome) =
        if apart { block.solve_apart(restitution, friction) } else { block.solve(restitution, friction) };
    if !j.is_finite() {
        return refuse();
    }
    Ok((j.to_block(), outcome))
}
