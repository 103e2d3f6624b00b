//! The one table of tolerances: which measure of error, in which number type, may be how large, and why.

use super::checker::Sample;
use super::errors::Quantity;
use super::number::Number;
use super::statistics::rank;

/// Which file a tolerance is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum File {
    Impulses,
    Planar,
    /// Pairs of shapes.
    Geometry,
    /// The same, boxes as hulls and planes as height fields.
    Disguised,
}

/// Which rows of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rows {
    All,
    /// All but the worst, for a share of all that there are.
    Most(f64),
    /// Where v_n is more than a hundredth of what it is the difference of: |J| > 0.01 s/K.
    Clear,
    /// Categories A to D with inputs drawn to suit Q16.16, without those of other drawings in which rounding the inputs
    /// costs, by itself, more than two thirds of the bound.
    Q16,
}

/// Where a bound comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// What is asked of the kernel.
    Required,
    /// What the kernel does, with little to spare: tests fail where it could be tighter.
    Found,
}

/// An entry of the table.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    pub files: &'static [File],
    pub numbers: &'static [Number],
    pub quantity: Quantity,
    pub rows: Rows,
    pub bound: f64,
    pub origin: Origin,
    pub reason: &'static str,
}

/// How a tolerance was met.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The largest error among the rows it is for, and where.
    pub worst: f64,
    pub row: String,
    pub met: bool,
}

impl Tolerance {
    /// The entries for a file and a number type.
    pub fn of(file: File, number: Number) -> impl Iterator<Item = &'static Self> {
        TABLE.iter().filter(move |entry| entry.files.contains(&file) && entry.numbers.contains(&number))
    }

    /// `None` where no row is of its kind.
    pub fn judge<'a>(&self, samples: impl IntoIterator<Item = &'a Sample>) -> Option<Verdict> {
        let mut errors: Vec<(f64, &str)> = samples
            .into_iter()
            .filter(|sample| self.is_for(sample))
            .map(|sample| (sample.errors.get(self.quantity), sample.id.as_str()))
            .filter(|(error, _)| !error.is_nan())
            .collect();
        errors.sort_by(|a, b| a.0.total_cmp(&b.0));
        let share = if let Rows::Most(share) = self.rows { share } else { 1.0 };
        let last = errors.len().checked_sub(1)?;
        let (worst, row) = errors[rank(last + 1, share)];
        Some(Verdict { worst, row: row.to_owned(), met: worst <= self.bound })
    }

    /// Whether it says something about that row.
    pub fn is_for(&self, sample: &Sample) -> bool {
        let rounding = match self.quantity {
            Quantity::Velocity => sample.errors.get(Quantity::RoundingVelocity),
            Quantity::Spin => sample.errors.get(Quantity::RoundingSpin),
            _ => 0.0,
        };
        match self.rows {
            Rows::All | Rows::Most(_) => true,
            Rows::Clear => {
                let [relative, honest] = [Quantity::ImpulseRelative, Quantity::Impulse].map(|q| sample.errors.get(q));
                relative == 0.0 || relative < 100.0 * honest
            }
            // Without a single solution for the rounded inputs, nothing excuses the row.
            Rows::Q16 => sample.suits_q16 && (rounding.is_nan() || 3.0 * rounding <= 2.0 * self.bound),
        }
    }
}

const IMPULSES: &[File] = &[File::Impulses];
const PLANAR: &[File] = &[File::Planar];
const BOTH: &[File] = &[File::Impulses, File::Planar];
const GEOMETRY: &[File] = &[File::Geometry];
const SHAPES: &[File] = &[File::Geometry, File::Disguised];
const ALL: &[Number] = &[Number::F32, Number::F64, Number::I16F16, Number::I12F20, Number::I8F24, Number::Micromath];
const FIXED: &[Number] = &[Number::I16F16, Number::I12F20, Number::I8F24];
const I16: &[Number] = &[Number::I16F16];
const I12: &[Number] = &[Number::I12F20];
const I8: &[Number] = &[Number::I8F24];
const F32: &[Number] = &[Number::F32];
const F64: &[Number] = &[Number::F64];
const MICROMATH: &[Number] = &[Number::Micromath];

const fn entry(
    files: &'static [File],
    numbers: &'static [Number],
    quantity: Quantity,
    rows: Rows,
    bound: f64,
    origin: Origin,
    reason: &'static str,
) -> Tolerance {
    Tolerance { files, numbers, quantity, rows, bound, origin, reason }
}

use Origin::{Found, Required};
use Quantity as Q;
use Rows::{All, Clear, Most, Q16};

const NAIVE: &str = "2.6 times what the formulas written down in f32 lose";
const IMAGE: &str = "the image of the bound on J";
const CANCELS: &str = "all but rows in which the approach speed nearly cancels";
const STORED: &str = "a few roundings to 30 bits of what is added up";

const UNITS: &str = "two units of the last place";

/// The table.
pub const TABLE: &[Tolerance] = &[
    entry(BOTH, ALL, Q::Law, All, 2.5e-14, Found, "some 100 roundings to 53 bits in the closed form"),
    entry(BOTH, FIXED, Q::StoredImpulse, All, 6.0, Found, STORED),
    entry(BOTH, FIXED, Q::StoredVelocity, All, 6.0, Found, STORED),
    entry(BOTH, FIXED, Q::StoredSpin, All, 8.0, Found, STORED),
    entry(
        IMPULSES,
        &[Number::I16F16],
        Q::Velocity,
        Q16,
        2e-3,
        Required,
        "holding all of it in Q16.16 costs up to 8.5e-4",
    ),
    entry(IMPULSES, &[Number::I16F16], Q::Spin, Q16, 6e-3, Required, "holding all of it in Q16.16 costs up to 2.8e-3"),
    entry(PLANAR, &[Number::I16F16], Q::Impulse, All, 1e-5, Found, "mostly e, rounded by up to 7.6e-6"),
    entry(PLANAR, &[Number::I12F20], Q::Impulse, All, 1e-6, Found, "mostly e and mu, rounded by up to 4.8e-7"),
    entry(
        PLANAR,
        &[Number::I8F24],
        Q::Impulse,
        All,
        5e-7,
        Found,
        "rounded inputs, and roundings to 30 bits in badly conditioned rows",
    ),
    entry(IMPULSES, F32, Q::Impulse, All, 5e-6, Required, NAIVE),
    entry(IMPULSES, F32, Q::ImpulseRelative, Most(0.995), 1e-5, Required, CANCELS),
    entry(IMPULSES, F32, Q::VelocityImage, All, 5e-6, Required, IMAGE),
    entry(IMPULSES, F32, Q::SpinImage, All, 5e-6, Required, IMAGE),
    entry(PLANAR, F32, Q::Impulse, All, 1e-5, Required, "the closed form in f64"),
    entry(PLANAR, F32, Q::VelocityImage, All, 1e-5, Required, IMAGE),
    entry(PLANAR, F32, Q::SpinImage, All, 1e-5, Required, IMAGE),
    entry(BOTH, F32, Q::StoredImpulse, All, 1.5, Found, "roundings to 24 bits of what is added up"),
    entry(BOTH, F32, Q::StoredVelocity, All, 0.9, Found, "roundings to 24 bits of what is added up"),
    entry(BOTH, F32, Q::StoredSpin, All, 0.9, Found, "roundings to 24 bits of what is added up"),
    entry(BOTH, F64, Q::ImpulseRelative, Clear, 1e-12, Required, CANCELS),
    entry(BOTH, F64, Q::Impulse, All, 1e-12, Required, "4500 roundings to 53 bits"),
    entry(BOTH, F64, Q::Impulse, All, 1.2e-14, Found, "roundings to 53 bits, and planar results to 15 digits"),
    entry(BOTH, MICROMATH, Q::Impulse, All, 1e-4, Required, "its root is within 1e-5"),
    entry(BOTH, MICROMATH, Q::ImpulseRelative, Clear, 1e-4, Required, CANCELS),
    entry(BOTH, MICROMATH, Q::VelocityImage, All, 1e-4, Required, IMAGE),
    entry(BOTH, MICROMATH, Q::SpinImage, All, 1e-4, Required, IMAGE),
    entry(BOTH, MICROMATH, Q::StoredImpulse, All, 3.0, Found, "its root, of which five bits are lost"),
    entry(BOTH, MICROMATH, Q::StoredVelocity, All, 3.0, Found, IMAGE),
    entry(IMPULSES, MICROMATH, Q::SpinImage, All, 1.5e-6, Found, IMAGE),
    entry(SHAPES, F32, Q::Distance, All, 2e-6, Required, "sizes and places of 1 to 3, each with 6e-8 of itself"),
    entry(GEOMETRY, F32, Q::Distance, All, 5e-7, Found, "a few roundings of numbers near 2"),
    entry(SHAPES, F64, Q::Distance, All, 1e-11, Required, "the file has twelve digits"),
    entry(SHAPES, I16, Q::Distance, All, 1e-3, Required, "64 units of the last place"),
    entry(GEOMETRY, I16, Q::Distance, All, 4e-5, Found, UNITS),
    entry(SHAPES, I12, Q::Distance, All, 6.3e-5, Required, "64 units of the last place"),
    entry(GEOMETRY, I12, Q::Distance, All, 2.5e-6, Found, UNITS),
    entry(SHAPES, I8, Q::Distance, All, 3.9e-6, Required, "64 units of the last place"),
    entry(GEOMETRY, I8, Q::Distance, All, 2e-7, Found, UNITS),
    entry(GEOMETRY, MICROMATH, Q::Distance, All, 5e-6, Found, "its root, of lengths up to 2"),
    entry(SHAPES, ALL, Q::Normal, All, 1e-3, Required, "rows with tied axes excepted"),
    entry(GEOMETRY, F32, Q::Normal, All, 5e-6, Found, "ways of 0.1, each with 6e-8 of what they are the difference of"),
    entry(GEOMETRY, F64, Q::Normal, All, 4e-12, Found, "the file has twelve digits"),
    entry(GEOMETRY, I16, Q::Normal, All, 5e-4, Found, "the same, with 1e-5"),
    entry(GEOMETRY, I12, Q::Normal, All, 6e-5, Found, "the same, with 7e-7"),
    entry(GEOMETRY, I8, Q::Normal, All, 4e-6, Found, "the same, with 4e-8"),
    entry(GEOMETRY, MICROMATH, Q::Normal, All, 5e-6, Found, "its root"),
    entry(GEOMETRY, F32, Q::Contact, All, 6e-7, Found, "a few roundings of numbers near 2"),
    entry(GEOMETRY, F64, Q::Contact, All, 1e-12, Found, "the file has twelve digits"),
    entry(GEOMETRY, I16, Q::Contact, All, 4e-5, Found, UNITS),
    entry(GEOMETRY, I12, Q::Contact, All, 2.5e-6, Found, UNITS),
    entry(GEOMETRY, I8, Q::Contact, All, 2e-7, Found, UNITS),
    entry(GEOMETRY, MICROMATH, Q::Contact, All, 5e-6, Found, "its root, of lengths up to 2"),
];

/// What the replayed tosses of a cube must reach.
pub struct TossTolerances {
    /// Mean distance, in % of the side: at most.
    pub position: f64,
    /// Mean angle, in degrees: at most.
    pub rotation: f64,
    /// The share that ends on the recorded face: at least.
    pub face: f64,
}

/// In every number type: a rigid cube, solved to convergence in steps that tend to zero, reaches 14.5, 18.5 and 0.82. Parameters
/// moved by a few per cent move the scores by 0.33, 0.54 and 0.016.
pub const TOSSES: TossTolerances = TossTolerances { position: 14.5, rotation: 18.5, face: 0.82 };
