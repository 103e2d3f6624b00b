//! The impacts to measure, one a line, as `xtask` writes them: numbers of any magnitude without a decimal point, which a
//! board reads without floating point and each number type rounds for itself.

use crate::board::LineReader;

/// `mantissa * 2^exponent`
#[derive(Clone, Copy, Default)]
pub struct Number {
    pub mantissa: i32,
    pub exponent: i32,
}

/// One of the two bodies.
#[derive(Clone, Copy, Default)]
pub struct Body {
    /// Zero where it is immovable.
    pub inv_mass: Number,
    pub inv_moments: [Number; 3],
    /// w, x, y, z
    pub orientation: [Number; 4],
    pub arm: [Number; 3],
    pub velocity: [Number; 3],
    pub spin: [Number; 3],
}

/// Two bodies that meet.
#[derive(Clone, Copy, Default)]
pub struct Impact {
    pub bodies: [Body; 2],
    pub normal: [Number; 3],
    pub restitution: Number,
    pub friction: Number,
}

/// The next impact; `None` at the end of the file, an error where a line is none.
pub fn next(file: &mut LineReader) -> Result<Option<Impact>, &'static str> {
    let Some(line) = file.next_line().map_err(|_| "the input cannot be read")? else { return Ok(None) };
    let mut numbers = line.split(' ').map(number);
    let mut impact = Impact::default();
    let Impact { bodies, normal, restitution, friction } = &mut impact;
    for body in bodies {
        let Body { inv_mass, inv_moments, orientation, arm, velocity, spin } = body;
        fill(core::slice::from_mut(inv_mass), &mut numbers)?;
        fill(inv_moments, &mut numbers)?;
        fill(orientation, &mut numbers)?;
        for vector in [arm, velocity, spin] {
            fill(vector, &mut numbers)?;
        }
    }
    fill(normal, &mut numbers)?;
    fill(core::slice::from_mut(restitution), &mut numbers)?;
    fill(core::slice::from_mut(friction), &mut numbers)?;
    if numbers.next().is_some() { Err("a line of the input is too long") } else { Ok(Some(impact)) }
}

fn fill(slots: &mut [Number], numbers: &mut impl Iterator<Item = Option<Number>>) -> Result<(), &'static str> {
    for slot in slots {
        *slot = numbers.next().flatten().ok_or("a line of the input is no impact")?;
    }
    Ok(())
}

/// Ten hexadecimal digits: eight of the mantissa, two of the exponent, both in two's complement.
fn number(text: &str) -> Option<Number> {
    let (mantissa, exponent) = text.split_at_checked(8)?;
    let mantissa = u32::from_str_radix(mantissa, 16).ok()?;
    let exponent = u8::from_str_radix(exponent, 16).ok()?;
    Some(Number { mantissa: mantissa as i32, exponent: (exponent as i8).into() })
}
