//! How far the kernel's result is from the right one, in each of the measures that are reported.

use super::closed_form::Solution;
use super::kernel::Found;
use super::number::Number;
use super::problem::{Body, Problem, State};
use super::vector::{Vector, apply, cross, largest, norm, sub};

/// A measure of error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// |dJ| / |J|.
    ImpulseRelative,
    /// |dJ| / max(|J|, s/K): what rounding of the inputs and of the approach speed leaves, also where v_n nearly cancels.
    Impulse,
    /// The largest error of a component of v.
    Velocity,
    /// |dv| / |v|, with the larger of v before and after.
    VelocityRelative,
    /// The largest error of a component in units of the last place of the vector's largest one.
    VelocityUlp,
    /// |dv| / (max(|J|, s/K)/m + |v|): the image in v of an error of [`Impulse`](Self::Impulse).
    VelocityImage,
    /// As for v.
    Spin,
    SpinRelative,
    SpinUlp,
    /// |dw| / (|I^-1 r x| max(|J|, s/K) + |w|).
    SpinImage,
    /// What rounding the inputs to the format costs by itself: the largest change of a component of the exact v.
    RoundingVelocity,
    RoundingSpin,
    /// The kernel alone, against the exact result for the inputs as stored: what rounding of the result leaves of |dJ|, in
    /// units of u (L |J| + (1 + e) s) / k. That is the rounding error u of the kernel's numbers, on what they add up.
    StoredImpulse,
    /// The image of that in v, and in w.
    StoredVelocity,
    StoredSpin,
    /// The file against the closed form, in the worst of J, v and w, each measured as [`Impulse`](Self::Impulse) and its
    /// images are.
    Law,
    /// Of two shapes: of the signed distance, in metres; of shapes a thousand times smaller, in millimetres.
    Distance,
    /// The length of the difference of the unit normals.
    Normal,
    /// The least separation of the points of contact against the signed distance, as for it.
    Contact,
}

/// All of them.
pub const QUANTITIES: [Quantity; 19] = [
    Quantity::ImpulseRelative,
    Quantity::Impulse,
    Quantity::Velocity,
    Quantity::VelocityRelative,
    Quantity::VelocityUlp,
    Quantity::VelocityImage,
    Quantity::Spin,
    Quantity::SpinRelative,
    Quantity::SpinUlp,
    Quantity::SpinImage,
    Quantity::RoundingVelocity,
    Quantity::RoundingSpin,
    Quantity::StoredImpulse,
    Quantity::StoredVelocity,
    Quantity::StoredSpin,
    Quantity::Law,
    Quantity::Distance,
    Quantity::Normal,
    Quantity::Contact,
];

impl Quantity {
    pub fn label(self) -> &'static str {
        match self {
            Self::ImpulseRelative => "J: |dJ| / |J|",
            Self::Impulse => "J: |dJ| / max(|J|, s/K)",
            Self::Velocity => "v: largest component of dv",
            Self::VelocityRelative => "v: |dv| / |v|",
            Self::VelocityUlp => "v: units of the last place",
            Self::VelocityImage => "v: |dv| / (max(|J|, s/K)/m + |v|)",
            Self::Spin => "w: largest component of dw",
            Self::SpinRelative => "w: |dw| / |w|",
            Self::SpinUlp => "w: units of the last place",
            Self::SpinImage => "w: |dw| / (|I^-1 r x| max(|J|, s/K) + |w|)",
            Self::RoundingVelocity => "v: largest component of what rounding the inputs costs",
            Self::RoundingSpin => "w: largest component of what rounding the inputs costs",
            Self::StoredImpulse => "J for the inputs as rounded: |dJ| / (u (L |J| + (1 + e) s) / k)",
            Self::StoredVelocity => "v for the inputs as rounded: the same",
            Self::StoredSpin => "w for the inputs as rounded: the same",
            Self::Law => "the file against the closed form in f64: J, v or w",
            Self::Distance => "signed distance",
            Self::Normal => "normal: |dn|",
            Self::Contact => "least separation of the points of contact",
        }
    }
}

/// One error for each of [`QUANTITIES`]; NaN where it was not measured.
#[derive(Clone, Copy, Debug)]
pub struct Errors([f64; QUANTITIES.len()]);

impl Errors {
    pub fn none() -> Self {
        Self([f64::NAN; QUANTITIES.len()])
    }

    pub fn get(&self, quantity: Quantity) -> f64 {
        self.0[quantity as usize]
    }

    pub fn set(&mut self, quantity: Quantity, error: f64) {
        self.0[quantity as usize] = error;
    }

    /// Against the result that was expected.
    pub fn measure(&mut self, problem: &Problem, expected: &State, found: &Found, spacing: impl Fn(f64) -> f64) {
        let scales = Scales::new(problem, expected);
        let dj = norm(sub(found.state.impulse, expected.impulse));
        self.set(Quantity::ImpulseRelative, share(dj, norm(expected.impulse)));
        self.set(Quantity::Impulse, share(dj, scales.impulse));
        let v = scales.vectors(found.state.velocity, expected.velocity, problem.bodies.map(|b| b.velocity));
        self.set(Quantity::Velocity, v.worst(|e| largest(e.error)));
        self.set(Quantity::VelocityRelative, v.worst(|e| share(norm(e.error), e.length)));
        self.set(Quantity::VelocityUlp, v.worst(|e| share(largest(e.error), spacing(e.component))));
        self.set(Quantity::VelocityImage, v.image(scales.linear, scales.impulse));
        let w = scales.vectors(found.state.spin, expected.spin, problem.bodies.map(|b| b.spin));
        self.set(Quantity::Spin, w.worst(|e| largest(e.error)));
        self.set(Quantity::SpinRelative, w.worst(|e| share(norm(e.error), e.length)));
        self.set(Quantity::SpinUlp, w.worst(|e| share(largest(e.error), spacing(e.component))));
        self.set(Quantity::SpinImage, w.image(scales.angular, scales.impulse));
    }

    /// Against the exact result for the inputs as stored.
    pub fn measure_stored(
        &mut self,
        number: Number,
        stored: &Problem,
        solution: &Solution,
        found: &Found,
        spacing: impl Fn(f64) -> f64,
    ) {
        let exact = &solution.state;
        let scales = Scales::new(stored, exact);
        let unit = number.precision() * solution.condition(stored);
        let beyond = |error: f64, rounding: f64, lever: f64| share((error - rounding).max(0.0), lever * unit);
        // The normal part is rounded once, and each component of the tangential one.
        let reported = 1.5 * spacing(largest(exact.impulse));
        self.set(Quantity::StoredImpulse, beyond(norm(sub(found.state.impulse, exact.impulse)), reported, 1.0));
        let v = scales.vectors(found.state.velocity, exact.velocity, stored.bodies.map(|b| b.velocity));
        let w = scales.vectors(found.state.spin, exact.spin, stored.bodies.map(|b| b.spin));
        let measure = |e: &VectorError, lever: f64| beyond(largest(e.error), 0.51 * spacing(e.component), lever);
        self.set(Quantity::StoredVelocity, v.worst_with(scales.linear, measure));
        self.set(Quantity::StoredSpin, w.worst_with(scales.angular, measure));
    }

    /// Of the exact result, by storing the inputs.
    pub fn measure_rounding(&mut self, given: &State, stored: &State) {
        let worst = |a: [Vector; 2], b: [Vector; 2]| largest(sub(a[0], b[0])).max(largest(sub(a[1], b[1])));
        self.set(Quantity::RoundingVelocity, worst(given.velocity, stored.velocity));
        self.set(Quantity::RoundingSpin, worst(given.spin, stored.spin));
    }

    /// Of what the file says, against the closed form.
    pub fn measure_law(&mut self, problem: &Problem, expected: &State, exact: &State) {
        let scales = Scales::new(problem, exact);
        let v = scales.vectors(expected.velocity, exact.velocity, problem.bodies.map(|b| b.velocity));
        let w = scales.vectors(expected.spin, exact.spin, problem.bodies.map(|b| b.spin));
        let images = v.image(scales.linear, scales.impulse).max(w.image(scales.angular, scales.impulse));
        self.set(Quantity::Law, images.max(share(norm(sub(expected.impulse, exact.impulse)), scales.impulse)));
    }
}

/// What errors of an impact are measured by.
struct Scales {
    /// max(|J|, s/K)
    impulse: f64,
    /// Velocity per impulse, for A and B.
    linear: [f64; 2],
    /// Angular velocity per impulse.
    angular: [f64; 2],
}

/// The error of one vector, and the larger of its value before the impact and after.
struct VectorError {
    error: Vector,
    length: f64,
    component: f64,
}

struct Pair([VectorError; 2]);

impl Scales {
    fn new(problem: &Problem, expected: &State) -> Self {
        let k = problem.inverse_mass();
        let floor = if k > 0.0 { problem.speed() / k } else { 0.0 };
        let lever = |body: &Body| {
            // The Frobenius norm of I^-1 (r x .).
            let column = |axis: Vector| norm(apply(&body.inv_inertia, cross(body.arm, axis)));
            column([1.0, 0.0, 0.0]).hypot(column([0.0, 1.0, 0.0])).hypot(column([0.0, 0.0, 1.0]))
        };
        let [a, b] = &problem.bodies;
        Self {
            impulse: norm(expected.impulse).max(floor),
            linear: [a.inv_mass, b.inv_mass],
            angular: [lever(a), lever(b)],
        }
    }

    fn vectors(&self, found: [Vector; 2], expected: [Vector; 2], before: [Vector; 2]) -> Pair {
        Pair([0, 1].map(|k| VectorError {
            error: sub(found[k], expected[k]),
            length: norm(expected[k]).max(norm(before[k])),
            component: largest(expected[k]).max(largest(before[k])),
        }))
    }
}

impl Pair {
    fn worst(&self, measure: impl Fn(&VectorError) -> f64) -> f64 {
        measure(&self.0[0]).max(measure(&self.0[1]))
    }

    fn worst_with(&self, levers: [f64; 2], measure: impl Fn(&VectorError, f64) -> f64) -> f64 {
        measure(&self.0[0], levers[0]).max(measure(&self.0[1], levers[1]))
    }

    fn image(&self, levers: [f64; 2], impulse: f64) -> f64 {
        self.worst_with(levers, |e, lever| share(norm(e.error), lever * impulse + e.length))
    }
}

/// `part / whole`, where nothing of nothing is nothing.
fn share(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}
