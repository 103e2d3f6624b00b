//! The search for units.

use super::check::{Demand, Measures};
use super::format::Format;
use super::quantity::Quantity;
use super::scene::tightest;
use super::system::Units;

/// Powers of two of a second that are tried.
const SHORTEST: i32 = -12;
const LONGEST: i32 = 24;

/// Units, and the tightest demand in them.
type Candidate = (Demand, Units);

/// The first that fits: SI, then by the unit of time. Else what comes closest.
pub(super) const fn propose(measures: &Measures, format: Format) -> Result<Units, Candidate> {
    let mut best = (tightest(measures, format, &Units::SI), Units::SI);
    if best.0.room >= 0 {
        return Ok(Units::SI);
    }
    let mut tens = true;
    loop {
        // 1 s, then shorter ones, then longer ones.
        let mut power = 0;
        loop {
            let time = if power == 0 { Quantity::ONE } else { power_of_two(power) };
            best = better(best, with_time(measures, format, time, tens));
            if best.0.room >= 0 {
                return Ok(best.1);
            }
            power = if power <= 0 && power > SHORTEST {
                power.wrapping_sub(1)
            } else {
                if power < 0 { 1 } else { power.wrapping_add(1) }
            };
            if power > LONGEST {
                break;
            }
        }
        if !tens {
            return Err(best);
        }
        tens = false;
    }
}

const fn better(a: Candidate, b: Candidate) -> Candidate {
    if b.0.room > a.0.room { b } else { a }
}

/// The length and the mass that leave about the most room beside a unit of time.
const fn with_time(measures: &Measures, format: Format, time: Quantity, tens: bool) -> Candidate {
    let units = Units { time, ..Units::SI };
    let of_time = measures.time(format, &units);
    if of_time.room < 0 {
        return (of_time, units);
    }
    let mut best = with_length(measures, format, of_time, units, tens);
    let first = first(measures.middle_of_lengths(format, &units), tens);
    let mut power = first;
    while power <= first.wrapping_add(2) {
        let units = Units { length: unit(power, tens), ..units };
        best = better(best, with_length(measures, format, of_time, units, tens));
        power = power.wrapping_add(1);
    }
    best
}

/// The mass that leaves about the most room beside units of length and time: a kilogram, if that fits.
const fn with_length(measures: &Measures, format: Format, of_time: Demand, units: Units, tens: bool) -> Candidate {
    let others = of_time.tighter(measures.motion(format, &units));
    let mut best = (measures.mass(format, &units), units);
    if others.room < 0 || best.0.room >= 0 {
        return (others.tighter(best.0), units);
    }
    let first = first(measures.middle_of_masses(format, &units), tens);
    let mut power = first;
    while power <= first.wrapping_add(2) {
        let units = Units { mass: unit(power, tens), ..units };
        best = better(best, (measures.mass(format, &units), units));
        power = power.wrapping_add(1);
    }
    (others.tighter(best.0), best.1)
}

/// The first of three powers, of ten or of two, around 2^middle.
const fn first(middle: i32, tens: bool) -> i32 {
    // lg 2 = 77/256.
    let power = if tens { middle.wrapping_mul(77) >> 8 } else { middle };
    power.wrapping_sub(if tens { 0 } else { 1 })
}

const fn unit(power: i32, tens: bool) -> Quantity {
    let tens_power = if power > 30 {
        30
    } else if power < -30 {
        -30
    } else {
        power
    };
    if tens { Quantity::new(1, tens_power as i8) } else { power_of_two(power) }
}

const fn power_of_two(power: i32) -> Quantity {
    let power = if power > 30 {
        30
    } else if power < -30 {
        -30
    } else {
        power
    };
    if power < 0 {
        Quantity::ratio(1, 1u32.wrapping_shl(power.unsigned_abs()))
    } else {
        Quantity::whole(1i32.wrapping_shl(power as u32))
    }
}
