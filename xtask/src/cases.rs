//! Which example is run where by `cargo xtask test`.

use crate::boards::{Board, Scalar};
use anyhow::{Result, bail};

/// One example with the boards and number types it runs in, every combination of them.
pub struct Case {
    pub scalars: &'static [Scalar],
    pub boards: &'static [Board],
    /// Arguments behind `--scalar`; `{validation}` stands for the folder that `CAROM_VALIDATION` names.
    pub arguments: &'static [&'static str],
}

/// What `{validation}` stands for.
pub const VALIDATION: &str = "{validation}";

const EVERYWHERE: &[Case] = &[Case { scalars: Scalar::ALL, boards: Board::ALL, arguments: &[] }];

/// Two copies of the table in f64 outgrow the 16 KB of RAM that all firmware here is linked for.
const BUT_F64: &[Case] = &[Case { scalars: NOT_F64, boards: Board::ALL, arguments: &[] }];

/// Worlds: those that fill half of the 16 KB in the other types do not fit there in f64, and a link of one takes its time. All number
/// types run in `edge`.
const WORLDS: &[Case] = &[Case { scalars: WORLDLY, boards: Board::ALL, arguments: &[] }];

/// A third fixed format does not fit 256 KB of flash beside two others: I8F24 runs on this machine.
const WORLDLY: &[Scalar] = &[Scalar::F32, Scalar::I16F16, Scalar::I12F20];

/// Large, and in every number type but that.
const LARGE: &[Case] = &[Case { scalars: BUT_I8F24, boards: Board::ALL, arguments: &[] }];

const BUT_I8F24: &[Scalar] = &[Scalar::F32, Scalar::I16F16, Scalar::I12F20, Scalar::F64, Scalar::Micromath];

const NOT_F64: &[Scalar] = &[Scalar::F32, Scalar::I16F16, Scalar::I12F20, Scalar::I8F24, Scalar::Micromath];

/// Ten boxes need forty points: 15 KB of 16, which leaves no stack. This machine runs it. What is drawn has a
/// stage of its own.
const NOWHERE: &[Case] = &[];

/// Measured impacts: the numbers go over the debug channel, which is too slow to do it everywhere.
const IMPACTS: &[Case] = &[
    Case {
        scalars: &[Scalar::I16F16, Scalar::I12F20, Scalar::I8F24],
        boards: &[Board::M0, Board::M3],
        arguments: MEASURED,
    },
    Case { scalars: &[Scalar::F32, Scalar::I16F16], boards: &[Board::M4f], arguments: MEASURED },
];

const MEASURED: &[&str] = &["--input", "{validation}/planar_impacts/ellipse_impacts_dev1000.csv"];

/// The first of the measured tosses, on a board with an FPU and on one without.
const TOSSES: &[Case] = &[
    Case { scalars: &[Scalar::I16F16, Scalar::I12F20], boards: &[Board::M3], arguments: TOSSED },
    Case { scalars: &[Scalar::F32, Scalar::I16F16, Scalar::I12F20], boards: &[Board::M4f], arguments: TOSSED },
];

const TOSSED: &[&str] = &["--input", "{validation}/cube_tosses/cube_tosses_dev60.csv", "--tosses", "10"];

/// The core's own arithmetic, under every fixed-point format alike.
const PRODUCTS: &[Case] = &[Case { scalars: &[Scalar::I16F16], boards: Board::ALL, arguments: &[] }];

/// The arithmetic of the solver's rows, of the core and of the FPU.
const ROWS: &[Case] =
    &[Case { scalars: &[Scalar::F32, Scalar::I16F16, Scalar::I12F20], boards: Board::ALL, arguments: &[] }];

/// The FPU's own arithmetic.
const STRIKES: &[Case] = &[Case { scalars: &[Scalar::F32], boards: Board::ALL, arguments: &[] }];

/// The self-test holds several scenes: in f64 one of them outgrows the RAM, and a third fixed format the flash.
const SELFTEST: &[Case] = &[Case { scalars: SELFTESTED, boards: Board::ALL, arguments: &[] }];

const SELFTESTED: &[Scalar] = &[Scalar::F32, Scalar::I16F16, Scalar::I12F20, Scalar::Micromath];

/// Fails, and says what to do, for an example that the board has no room for.
pub fn check_room(name: &str, board: Board) -> Result<()> {
    if name == "stack" && board.target().starts_with("thumb") {
        bail!(
            "`stack` takes more than the 16 KB of RAM that firmware for {board} is linked for: run it here, or on `--board rv32`"
        );
    }
    Ok(())
}

/// The cases of an example.
pub fn cases(example: &str) -> &'static [Case] {
    match example {
        "billiard_break" => BUT_F64,
        "billiards" | "dice" | "marble_maze" | "newtons_cradle" | "pinball" => WORLDS,
        "edge" | "shapes" => LARGE,
        "impacts" => IMPACTS,
        "drawing" | "stack" => NOWHERE,
        "tosses" => TOSSES,
        "levers" | "products" => PRODUCTS,
        "rows" => ROWS,
        "strikes" => STRIKES,
        "selftest" => SELFTEST,
        _ => EVERYWHERE,
    }
}

/// The features of a build of these examples in that number type: what draws needs one more.
pub fn features(feature: &str, examples: &[String]) -> String {
    let draws = examples.iter().any(|example| example == "drawing");
    if draws { format!("{feature},embedded-graphics") } else { feature.to_owned() }
}

/// Whether a board runs the example in firmware of that feature.
pub fn is_for(example: &str, feature: &str) -> bool {
    cases(example).iter().flat_map(|case| case.scalars).any(|scalar| scalar.feature() == feature)
}

/// Whether firmware of that feature has no function of the library to begin with: what floats do in a row is inlined into whoever
/// asks, and is looked at in the worlds.
pub fn is_inlined(example: &str, feature: &str) -> bool {
    example == "rows" && feature != "fixed"
}

/// Whether the example's firmware is looked at with every check on, too: of those with a world, which share its code, two.
pub fn also_checked(example: &str) -> bool {
    !matches!(example, "billiards" | "edge" | "marble_maze" | "newtons_cradle" | "selftest" | "stack" | "tosses")
}

/// Whether this machine runs the example unoptimised too, and compares.
pub fn also_in_debug(example: &str) -> bool {
    example == "state_hash"
}

impl Case {
    /// Whether it needs data that is not in the repository.
    pub fn needs_validation(&self) -> bool {
        self.arguments.iter().any(|argument| argument.contains(VALIDATION))
    }
}
