//! What has to fit: each demand of a scene on a number format, once.

use super::format::Format;
use super::magnitude::Magnitude;
use super::quantity::Dimension;
use super::scene::Scene;
use super::system::Units;

/// Units of the last place that a given number needs, so that rounding it changes it by less than a thousandth. A pile of boxes
/// of half that size does not stand.
pub(super) const PRECISE: u32 = 512;
/// The part of a unit of the last place of positions that gravity moves a body by in a sub-step, at least: with less, its weight is
/// lost beside what the rounding of its position does, and friction stops it too late.
const DROP: Magnitude = Magnitude::power_of_two(-9);
/// Fraction bits of a sub-step in fixed point.
const SUB_STEP_BITS: i32 = 31;
/// Bits beyond the format that are carried of a velocity from step to step.
const REST_BITS: i32 = 16;
/// The solver's place to spare above the fastest spin, and the four of its measure of a body's size, which is up to 16 radii.
const HEAD_OF_SPINS: i32 = 1 + 4;
/// The solver's places to spare above what gravity adds in a sub-step.
const HEAD_OF_GRAVITY: i32 = 10;
/// What overlaps are undone at, in units of length and time: `Settings::new`.
const PUSH_OUT_SPEED: Magnitude = Magnitude::new(4, 0);

/// A property of a scene that a number format has to hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Property {
    /// The largest distance.
    Distance,
    /// The smallest radius or half edge.
    Size,
    /// The mass of the lightest body.
    LightestMass,
    /// The mass of the heaviest body.
    HeaviestMass,
    /// The speed of the fastest body.
    Speed,
    /// The spin of the smallest body when it rolls at the highest speed.
    Spin,
    /// The impulse that reflects the heaviest body at the highest speed.
    Impulse,
    /// The acceleration of free fall.
    Gravity,
    /// The speed that gravity adds in a sub-step, in places that the fastest body leaves.
    Fall,
    /// What that speed moves a body by in a sub-step, against the unit of the last place of positions.
    Drop,
    /// The length of a sub-step.
    SubStep,
    /// What rounding the sub-step adds up to over the duration, against one step.
    Clock,
    /// The speed at which overlaps are undone, four units of length in one of time, which
    /// [`Settings::new`](crate::solver::Settings::new) stores: beyond formats of two integer bits, sign included.
    PushOutSpeed,
}

/// Which side of its limit a property is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Misfit {
    /// Beyond the range.
    TooLarge,
    /// Below what the format resolves.
    TooSmall,
}

/// A property beside its limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Demand {
    pub property: Property,
    pub misfit: Misfit,
    pub value: Magnitude,
    pub limit: Magnitude,
    /// The powers of two between them; negative where the demand is not met.
    pub room: i32,
}

impl Demand {
    const fn at_most(property: Property, value: Magnitude, limit: Magnitude) -> Self {
        let room = if limit.is_below(value) {
            value.over(limit).binary_order().wrapping_neg().wrapping_sub(1)
        } else {
            room(limit, value)
        };
        Self { property, misfit: Misfit::TooLarge, value, limit, room }
    }

    const fn at_least(property: Property, value: Magnitude, limit: Magnitude) -> Self {
        let room = if value.is_below(limit) {
            limit.over(value).binary_order().wrapping_neg().wrapping_sub(1)
        } else {
            room(value, limit)
        };
        Self { property, misfit: Misfit::TooSmall, value, limit, room }
    }

    /// The one with less room.
    pub const fn tighter(self, other: Self) -> Self {
        if other.room < self.room { other } else { self }
    }
}

const fn room(larger: Magnitude, smaller: Magnitude) -> i32 {
    larger.over(smaller).binary_order()
}

/// A scene's quantities in SI units.
#[derive(Clone, Copy)]
pub(super) struct Measures {
    size: Magnitude,
    distance: Magnitude,
    lightest: Magnitude,
    heaviest: Magnitude,
    speed: Magnitude,
    spin: Magnitude,
    gravity: Magnitude,
    sub_step: Magnitude,
    /// Binary places of the number of sub-steps.
    sum: i32,
    step: Magnitude,
    duration: Magnitude,
}

impl Measures {
    pub const fn of(scene: &Scene) -> Self {
        let (size, speed, step) = (scene.smallest_size.magnitude(), scene.fastest.magnitude(), scene.step.magnitude());
        let (light, heavy) = (scene.lightest.magnitude(), scene.heaviest.magnitude());
        let sub_steps = scene.sub_steps as u32;
        Self {
            size,
            distance: scene.largest_distance.magnitude().max(size),
            lightest: light.min(heavy),
            heaviest: heavy.max(light),
            speed,
            spin: speed.over(size),
            gravity: scene.gravity.magnitude(),
            sub_step: step.over(Magnitude::new(sub_steps, 0)),
            sum: sub_steps.next_power_of_two().trailing_zeros() as i32,
            step,
            duration: scene.duration.magnitude(),
        }
    }

    /// The tightest demand on the unit of time alone.
    pub const fn time(&self, format: Format, units: &Units) -> Demand {
        let h = units.measured(self.sub_step, Dimension::TIME);
        let steps = self.duration.over(self.sub_step);
        let drift = steps.times(format.clock_rounding(h));
        // 1 - 2^-22: a float next to one is one.
        let most = Magnitude::new((1 << 22) - 1, -22);
        let least = match format {
            Format::Fixed { .. } => Magnitude::new(PRECISE, -SUB_STEP_BITS),
            Format::Float { .. } => format.finest(PRECISE),
        };
        Demand::at_most(Property::SubStep, h, most)
            .tighter(Demand::at_least(Property::SubStep, h, least))
            .tighter(Demand::at_most(Property::Clock, drift, units.measured(self.step, Dimension::TIME)))
            .tighter(Demand::at_most(Property::PushOutSpeed, PUSH_OUT_SPEED, format.largest()))
            .tighter(Demand::at_most(Property::Spin, units.measured(self.spin, Dimension::SPIN), format.largest()))
    }

    /// The tightest demand on the units of length and time.
    pub const fn motion(&self, format: Format, units: &Units) -> Demand {
        self.largest(format, units).tighter(self.smallest(format, units))
    }

    /// The tightest of those for which a unit of length can be too small.
    const fn largest(&self, format: Format, units: &Units) -> Demand {
        let distance = units.measured(self.distance, Dimension::LENGTH);
        let speed = units.measured(self.speed, Dimension::SPEED);
        let gravity = units.measured(self.gravity, Dimension::ACCELERATION);
        let largest = format.largest();
        Demand::at_most(Property::Distance, distance, largest)
            .tighter(Demand::at_most(Property::Speed, speed, largest))
            .tighter(Demand::at_most(Property::Gravity, gravity, largest))
    }

    /// The tightest of those for which it can be too large.
    const fn smallest(&self, format: Format, units: &Units) -> Demand {
        let distance = units.measured(self.distance, Dimension::LENGTH);
        let size = units.measured(self.size, Dimension::LENGTH);
        let precise = Magnitude::new(PRECISE, 0);
        let tightest = Demand::at_least(Property::Size, size, precise.times(format.spacing(distance)))
            .tighter(Demand::at_least(Property::Size, size, format.finest(PRECISE)));
        if self.gravity.is_zero() {
            return tightest;
        }
        let speed = units.measured(self.speed, Dimension::SPEED);
        let gravity = units.measured(self.gravity, Dimension::ACCELERATION);
        let h = units.measured(self.sub_step, Dimension::TIME);
        let fall = gravity.times(h);
        let resolved = precise.times(self.spacing_of_speeds(format, speed, fall));
        tightest
            .tighter(Demand::at_least(Property::Gravity, gravity, format.finest(PRECISE)))
            .tighter(Demand::at_least(Property::Fall, fall, resolved))
            .tighter(Demand::at_least(Property::Drop, fall.times(h), DROP.times(format.spacing(distance))))
    }

    /// The power of two of a unit of length, in that of `units`, in the middle between those demands.
    pub const fn middle_of_lengths(&self, format: Format, units: &Units) -> i32 {
        self.smallest(format, units).room.wrapping_sub(self.largest(format, units).room) >> 1
    }

    /// The tightest demand on the unit of mass, given the others.
    pub const fn mass(&self, format: Format, units: &Units) -> Demand {
        let lightest = units.measured(self.lightest, Dimension::MASS);
        let heaviest = units.measured(self.heaviest, Dimension::MASS);
        let change = units.measured(self.speed, Dimension::SPEED).times(Magnitude::new(2, 0));
        let (largest, finest) = (format.largest(), format.finest(PRECISE));
        Demand::at_least(Property::LightestMass, lightest, finest)
            .tighter(Demand::at_most(Property::HeaviestMass, heaviest, largest))
            .tighter(Demand::at_most(Property::Impulse, heaviest.times(change), largest))
    }

    /// The power of two of a unit of mass, in kilograms, in the middle between the demands on it.
    pub const fn middle_of_masses(&self, format: Format, units: &Units) -> i32 {
        let change = units.measured(self.speed, Dimension::SPEED).times(Magnitude::new(2, 0));
        let least = self.heaviest.times(change.max(Magnitude::ONE)).over(format.largest()).binary_order();
        let most = self.lightest.over(format.finest(PRECISE)).binary_order();
        least.wrapping_add(most).wrapping_add(1) >> 1
    }

    /// The spacing of speeds within a step: in fixed point the solver moves them left as far as the fastest body, its spin,
    /// and gravity let it.
    const fn spacing_of_speeds(&self, format: Format, speed: Magnitude, fall: Magnitude) -> Magnitude {
        let spacing = format.spacing(speed.max(fall));
        match format {
            Format::Float { .. } => spacing,
            Format::Fixed { .. } => {
                // The spin asks for more than the speed.
                let of_spin = places_above(speed.over(spacing)).wrapping_sub(self.sum).wrapping_sub(HEAD_OF_SPINS);
                let of_fall = places_above(fall.over(spacing)).wrapping_sub(HEAD_OF_GRAVITY);
                let places = least(least(of_spin, of_fall), REST_BITS);
                spacing.times(Magnitude::power_of_two(places.wrapping_neg()))
            }
        }
    }

    /// What positions rounded to the format make of a body at rest: two units of the last place in a step.
    pub const fn resting_noise(&self, format: Format, units: &Units) -> Magnitude {
        let distance = units.measured(self.distance, Dimension::LENGTH);
        let speed = format.spacing(distance).times(Magnitude::new(2, 0)).times(units.length.magnitude());
        speed.over(self.step)
    }
}

/// By how many places a number of units of the last place can move left within 32 bits.
const fn places_above(units: Magnitude) -> i32 {
    30i32.wrapping_sub(units.binary_order())
}

const fn least(a: i32, b: i32) -> i32 {
    if a < b { a } else { b }
}
