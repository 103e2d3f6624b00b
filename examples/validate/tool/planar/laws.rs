//! Impacts under several laws of restitution; the kernel's is Newton's.

use super::{Entry, impact};
use crate::tool::checker::Case;
use crate::tool::error::Result;
use crate::tool::problem::{Body, Mode};
use crate::tool::table::{Row, Table, quoted};

/// Where everything is.
pub struct Laws {
    id: usize,
    shape: usize,
    mass: usize,
    moment: usize,
    arm: [usize; 2],
    friction: usize,
    restitution: usize,
    /// vx, vy, w
    before: [usize; 3],
    normal_impulse: usize,
    tangential_impulse: usize,
    mode: usize,
}

impl Laws {
    pub fn find(table: &Table) -> Result<Self> {
        let names =
            ["id", "shape", "m", "I", "rx", "ry", "mu", "e", "vx", "vy", "w", "newton_jn", "newton_jt", "newton_mode"];
        let c = table.columns(names)?;
        Ok(Self {
            id: c[0],
            shape: c[1],
            mass: c[2],
            moment: c[3],
            arm: [c[4], c[5]],
            friction: c[6],
            restitution: c[7],
            before: [c[8], c[9], c[10]],
            normal_impulse: c[11],
            tangential_impulse: c[12],
            mode: c[13],
        })
    }

    pub fn read(&self, row: Row<'_>) -> Result<Entry> {
        let mode = match row.text(self.mode)? {
            "stick" => Mode::Stick,
            "slip" => Mode::Slip,
            // The friction at which a paradox begins, and no impact.
            "threshold_mu" => return Ok(Entry::Skipped),
            other => {
                return Err(row.refuse(self.mode, format!("{} is none of stick, slip, threshold_mu", quoted(other))));
            }
        };
        let positive = |column| row.checked(column, |x| x > 0.0, "is not positive");
        let (mass, moment) = (positive(self.mass)?, positive(self.moment)?);
        let restitution = row.checked(self.restitution, |x| (0.0..=1.0).contains(&x), "is outside 0 to 1")?;
        let friction = row.checked(self.friction, |x| x >= 0.0, "is negative")?;
        let [vx, vy, w] = row.numbers(self.before)?;
        // Thin in the plane, so that the other two moments add up to this one; they do not act.
        let body = Body::new(1.0 / mass, [2.0 / moment, 2.0 / moment, 1.0 / moment], [1.0, 0.0, 0.0, 0.0]);
        let problem = impact(body, row.numbers(self.arm)?, [vx, vy], w, restitution, friction);
        let impulse = [row.number(self.tangential_impulse)?, row.number(self.normal_impulse)?, 0.0];
        let case = Case {
            id: row.text(self.id)?.to_owned(),
            category: row.text(self.shape)?.to_owned(),
            suits_q16: false,
            problem,
            expected: Some(problem.after(impulse)),
            mode: Some(mode),
        };
        Ok(Entry::Impact(Box::new(case), None))
    }
}
