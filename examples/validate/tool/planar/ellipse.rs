//! Measured impacts of a dropped ellipse, and the law that is to predict them.

use super::newton;
use super::{Entry, impact};
use crate::tool::checker::Case;
use crate::tool::error::Result;
use crate::tool::problem::Body;
use crate::tool::table::{Row, Table};

const MASS: f64 = 0.0364;
const SEMI_AXES: [f64; 2] = [0.035, 0.025];
/// A published fit to these measurements.
const FRICTION: f64 = 0.12;
const RESTITUTION: f64 = 0.537;

/// Where everything is, and the coefficients.
pub struct Ellipse {
    id: usize,
    /// vx0, vy0, w0
    before: [usize; 3],
    /// vx1, vy1
    after: [usize; 2],
    /// Jn_x, Jn_y, Jt_x, Jt_y with what they must be.
    fixed: [(usize, f64); 4],
    /// Jn_w, Jt_w
    arm: [usize; 2],
    friction: f64,
    restitution: f64,
}

impl Ellipse {
    pub fn find(table: &Table, friction: Option<f64>, restitution: Option<f64>) -> Result<Self> {
        let names = ["i", "vx0", "vy0", "w0", "vx1", "vy1", "Jn_x", "Jn_y", "Jn_w", "Jt_x", "Jt_y", "Jt_w"];
        let c = table.columns(names)?;
        Ok(Self {
            id: c[0],
            before: [c[1], c[2], c[3]],
            after: [c[4], c[5]],
            fixed: [(c[6], 0.0), (c[7], 1.0), (c[9], 1.0), (c[10], 0.0)],
            arm: [c[8], c[11]],
            friction: friction.unwrap_or(FRICTION),
            restitution: restitution.unwrap_or(RESTITUTION),
        })
    }

    pub fn read(&self, row: Row<'_>) -> Result<Entry> {
        for (column, value) in self.fixed {
            row.checked(column, |x| x == value, &format!("is not {value}: the plane is horizontal"))?;
        }
        // v_n = vy + rx w and v_t = vx - ry w
        let [jn_w, jt_w] = row.numbers(self.arm)?;
        let [vx, vy, w] = row.numbers(self.before)?;
        let problem = impact(lamina(), [jn_w, -jt_w], [vx, vy], w, self.restitution, self.friction);
        let Some(solution) = newton::resolve(&problem) else { return Ok(Entry::Unsolved) };
        let case = Case {
            id: row.text(self.id)?.to_owned(),
            category: "ellipse".to_owned(),
            suits_q16: false,
            problem,
            expected: Some(solution.state),
            mode: Some(solution.mode),
        };
        Ok(Entry::Impact(Box::new(case), Some(row.numbers(self.after)?)))
    }
}

/// An elliptical disc in the plane z = 0.
fn lamina() -> Body {
    let [a, b] = SEMI_AXES;
    let moments = [MASS * b * b / 4.0, MASS * a * a / 4.0, MASS * (a * a + b * b) / 4.0];
    Body::new(1.0 / MASS, moments.map(|x| 1.0 / x), [1.0, 0.0, 0.0, 0.0])
}
