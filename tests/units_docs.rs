//! Every number of docs/units.md.
#![cfg(any(feature = "f32", feature = "fixed", feature = "micromath"))]

#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;
#[path = "support/host.rs"]
mod host;

#[cfg(feature = "fixed")]
use carom::units::Units;
use carom::units::{Format, NumberFormat, Property, Quantity, Scene};
use host::HostScalar;

each_format!(ranges, examples);

const PAGE: &str = include_str!("../docs/units.md");

const STEPS: Scene = Scene {
    smallest_size: Quantity::ONE,
    largest_distance: Quantity::ONE,
    lightest: Quantity::ONE,
    heaviest: Quantity::ONE,
    fastest: Quantity::ONE,
    gravity: Quantity::centi(981),
    step: Quantity::ratio(1, 60),
    sub_steps: 4,
    duration: Quantity::whole(3600),
};

const MARBLES: Scene = Scene {
    smallest_size: Quantity::milli(5),
    largest_distance: Quantity::milli(80),
    lightest: Quantity::micro(1300),
    heaviest: Quantity::micro(1300),
    fastest: Quantity::whole(2),
    ..STEPS
};

const DICE: Scene = Scene {
    smallest_size: Quantity::milli(8),
    largest_distance: Quantity::milli(600),
    lightest: Quantity::milli(4),
    heaviest: Quantity::milli(4),
    fastest: Quantity::whole(4),
    ..STEPS
};

const ROBOT: Scene = Scene {
    smallest_size: Quantity::milli(50),
    largest_distance: Quantity::whole(20),
    lightest: Quantity::milli(200),
    heaviest: Quantity::whole(40),
    fastest: Quantity::whole(3),
    ..STEPS
};

const PINBALL: Scene = Scene {
    smallest_size: Quantity::micro(13_500),
    largest_distance: Quantity::new(12, -1),
    lightest: Quantity::milli(80),
    heaviest: Quantity::milli(150),
    fastest: Quantity::whole(8),
    gravity: Quantity::centi(111),
    step: Quantity::ratio(1, 240),
    sub_steps: 4,
    ..STEPS
};

fn assert_row(row: &str) {
    assert!(PAGE.lines().any(|line| line == row), "docs/units.md should have the row\n{row}");
}

/// The number type's row in the table of ranges.
fn ranges<S: HostScalar + NumberFormat>(name: &str) {
    let noise = 2.0 * S::spacing(1.0) * 60.0;
    let row = match S::FORMAT {
        Format::Fixed { .. } => {
            let unit = S::spacing(1.0);
            let range = S::LARGEST.to_f64() + unit;
            format!("| `{name}` | ±{range} | {unit:.1e} | {:.1e} | {noise:.1e} |", 512.0 * unit)
        }
        Format::Float { .. } => {
            format!(
                "| `{name}` | ±2e12 | {:.1e} of it | 1/16384 of the distance | {noise:.1e} at 1 m |",
                S::spacing(1.0)
            )
        }
    };
    assert_row(&row);
    let ratio =
        |denominator| Scene { smallest_size: Quantity::ratio(1, denominator), fastest: Quantity::micro(1), ..STEPS };
    let tight = |scene: Scene| matches!(scene.check::<S>(), Err(error) if error.property == Property::Size);
    match S::FORMAT {
        Format::Fixed { fraction_bits } => {
            let smallest = 1 << (fraction_bits - 9);
            assert!(!tight(ratio(smallest)) && tight(ratio(smallest + smallest / 100)));
        }
        Format::Float { .. } => assert!(!tight(ratio(16384)) && tight(ratio(16500))),
    }
}

/// The number type's rows in the tables of examples.
fn examples<S: HostScalar + NumberFormat>(name: &str) {
    for (what, scene) in [("marbles", MARBLES), ("dice", DICE), ("robot", ROBOT), ("pinball", PINBALL)] {
        let in_si = match scene.check::<S>() {
            Ok(_) => "fits".to_owned(),
            Err(error) => {
                error.to_string().split(';').next().unwrap_or_default().replace(" (units: 1 m, 1 kg, 1 s)", "")
            }
        };
        let row = match scene.propose::<S>() {
            Ok(units) => {
                let fit = scene.check_in::<S>(&units).expect("what was proposed");
                format!(
                    "| {what} | `{name}` | {in_si} | {units} | 2^{} ({:?}) | {} m/s |",
                    fit.room, fit.tightest, fit.resting_noise
                )
            }
            Err(error) => format!("| {what} | `{name}` | {in_si} | {error} | | |"),
        };
        assert_row(&row);
    }
}

/// The scenes of the page, and one that nothing fits, all at compile time.
#[cfg(feature = "fixed")]
#[test]
fn at_compile_time() {
    use fixed::types::{I8F24, I16F16};
    const FITS: bool = MARBLES.propose::<I8F24>().is_ok() && PINBALL.propose::<I16F16>().is_ok();
    const NOTHING: Scene = Scene { largest_distance: Quantity::kilo(1000), ..MARBLES };
    const REFUSED: Result<Units, carom::units::UnitsError> = NOTHING.propose::<I8F24>();
    assert!(FITS && REFUSED.is_err());
}
