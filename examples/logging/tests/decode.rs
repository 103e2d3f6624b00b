//! Reads the firmware's log with defmt's own decoder, and holds every number against the same scene on this machine, bit for bit.
//!
//! `CAROM_LOG_ELF` names the firmware and `CAROM_LOG` the bytes that it sent; `cargo xtask test --only interop` makes both.

#[path = "../src/scene.rs"]
mod scene;

use carom::{Quat, Scalar, UnitVec3, Vec3};
use defmt_decoder::{DecodeError, Table};
use scene::Real;

type Scaled = <Real as Scalar>::Scaled;

/// A line without its numbers, and these.
#[derive(Debug, PartialEq)]
struct Line {
    text: String,
    numbers: Vec<f64>,
}

impl Line {
    fn new(text: &str, numbers: impl IntoIterator<Item = f64>) -> Self {
        Self { text: text.into(), numbers: numbers.into_iter().collect() }
    }

    /// Takes the numbers out of a line: what begins with a digit, or a sign and a digit, behind anything but a letter or digit.
    fn read(line: &str) -> Self {
        let (mut text, mut numbers, mut rest) = (String::new(), Vec::new(), line);
        while let Some(c) = rest.chars().next() {
            // A hash is text, whatever its digits look like.
            if text.ends_with("state ") {
                text.push_str(rest);
                break;
            }
            let digits = rest.strip_prefix('-').unwrap_or(rest);
            let begins =
                digits.starts_with(|c: char| c.is_ascii_digit()) && !text.ends_with(|c: char| c.is_alphanumeric());
            let length = if begins {
                let end = |(i, c): (usize, char)| (i > 0 && !(c.is_ascii_digit() || ".e-".contains(c))).then_some(i);
                rest.char_indices().find_map(end).unwrap_or(rest.len())
            } else {
                0
            };
            if length > 0 {
                numbers.push(number(&rest[..length]));
                text.push('#');
                rest = &rest[length..];
            } else {
                text.push(c);
                rest = &rest[c.len_utf8()..];
            }
        }
        Self { text, numbers }
    }
}

/// As the number type prints it: the shortest decimal that means the same bits.
fn number(text: &str) -> f64 {
    if cfg!(feature = "fixed") {
        text.parse().expect("a number")
    } else {
        f64::from(text.parse::<f32>().expect("a number"))
    }
}

#[cfg(feature = "fixed")]
fn exact(x: Scaled) -> f64 {
    f64::from(x.mantissa()) * f64::from(x.exponent() - 30).exp2()
}

#[cfg(not(feature = "fixed"))]
fn exact(x: Scaled) -> f64 {
    f64::from(x)
}

fn of(v: Vec3<Real>) -> [f64; 3] {
    v.to_array().map(|x| exact(x.to_scaled()))
}

fn of_direction(d: UnitVec3<Real>) -> [f64; 3] {
    d.get().to_array().map(|x| exact(x.to_scaled()))
}

fn of_rotation(q: Quat<Real>) -> [f64; 4] {
    q.to_array().map(|x| exact(x.to_scaled()))
}

/// What the log has to hold.
fn expected() -> Vec<Line> {
    let values = scene::values().expect("values");
    let mut lines = Vec::new();
    let body = carom::Body::dynamic(values.mass);
    let tensor = body.inv_inertia_local().map(exact);
    lines.push(Line::new(
        "MassProperties { inv_mass: #, inv_inertia: [xx #, xy #, xz #, yy #, yz #, zz #] }",
        [exact(body.inv_mass())].into_iter().chain(tensor),
    ));
    let (e, mu) = (values.material.restitution(), values.material.friction());
    lines.push(Line::new(
        "Material { restitution: #, friction: #, law: Newton }",
        [exact(e.to_scaled()), exact(mu.to_scaled())],
    ));
    let contact = values.contact;
    lines.push(Line::new(
        "Contact { normal: (#, #, #), r_a: (#, #, #), r_b: (#, #, #) }",
        of_direction(contact.normal).into_iter().chain(of(contact.r_a)).chain(of(contact.r_b)),
    ));
    let impact = values.impact;
    lines.push(Line::new(
        &format!(
            "Impact {{ outcome: {:?}, normal_impulse: #, friction_impulse: (#, #, #), saturated: false }}",
            impact.outcome
        ),
        [exact(impact.normal_impulse.to_scaled())].into_iter().chain(of(impact.friction_impulse)),
    ));
    lines.push(Line::new(
        "HalfSpace { normal: (#, #, #) } Cuboid { half_extents: (#, #, #) }",
        of_direction(values.ground.normal()).into_iter().chain(of(values.cuboid.half_extents())),
    ));
    lines.push(Line::read(&format!("{} / {}", carom::ShapeError::Radius, carom::SolidError::Radius)));
    lines.push(Line::read(&format!("{} / {}", carom::OrientationError::NotUnit, carom::HandleError::Stale)));
    let mut touched = 0;
    scene::throw(|moment| {
        let body = moment.body;
        lines.push(Line::new(
            "Body { position: (#, #, #), orientation: (#; #, #, #), linear_velocity: (#, #, #), \
             angular_velocity: (#, #, #), inv_mass: # }",
            of(body.position)
                .into_iter()
                .chain(of_rotation(body.orientation()))
                .chain(of(body.linear_velocity))
                .chain(of(body.angular_velocity))
                .chain([exact(body.inv_mass())]),
        ));
        if let Some(touching) = moment.touching {
            touched += 1;
            let handle = "BodyHandle { index: #, generation: # }";
            lines.push(Line::new(
                &format!(
                    "Touching {{ bodies: [{handle}, {handle}], part: #, phase: {:?}, sensor: false, normal_impulse: #, \
                     approach_speed: # }}",
                    touching.phase
                ),
                [0.0, 0.0, 1.0, 0.0, f64::from(touching.part)]
                    .into_iter()
                    .chain([exact(touching.normal_impulse), exact(touching.approach_speed.to_scaled())]),
            ));
        }
        let report = moment.report;
        lines.push(Line::read(&format!("{report:?} state {:016x}", moment.hash.get())));
    })
    .expect("a scene");
    assert!(touched > 3, "the box touches the ground in {touched} of the moments shown");
    lines
}

fn file(variable: &str) -> Option<Vec<u8>> {
    let path = std::env::var_os(variable)?;
    Some(std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display())))
}

#[test]
fn the_log_says_what_happened() {
    let (Some(elf), Some(bytes)) = (file("CAROM_LOG_ELF"), file("CAROM_LOG")) else {
        panic!("CAROM_LOG_ELF and CAROM_LOG are not set: `cargo xtask test --only interop` sets them");
    };
    let table = Table::parse(&elf).expect("an ELF file").expect("texts of defmt in it");
    let mut decoder = table.new_stream_decoder();
    decoder.received(&bytes);
    let mut found = Vec::new();
    loop {
        match decoder.decode() {
            Ok(frame) => found.push(Line::read(&frame.display_message().to_string())),
            Err(DecodeError::UnexpectedEof) => break,
            Err(DecodeError::Malformed) => panic!("a frame that cannot be read, after {found:?}"),
        }
    }
    let expected = expected();
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!(found, expected);
    }
    assert_eq!(found.len(), expected.len(), "lines");
    assert!(found.iter().map(|line| line.numbers.len()).sum::<usize>() > 150, "numbers");
}

/// Numbers of fixed-point firmware are put together from integers.
#[test]
#[cfg(feature = "fixed")]
fn no_float_routine_is_linked() {
    use object::{Object, ObjectSymbol};
    let elf = file("CAROM_LOG_ELF").expect("CAROM_LOG_ELF: `cargo xtask test --only interop` sets it");
    let elf = object::File::parse(&*elf).expect("an ELF file");
    let names: Vec<&str> = elf.symbols().filter_map(|symbol| symbol.name().ok()).collect();
    assert!(names.iter().any(|name| name.contains("carom")), "{} symbols, none of carom", names.len());
    let float = |name: &&&str| {
        ["__aeabi_f", "__aeabi_d", "__aeabi_i2", "__aeabi_ui2", "__aeabi_l2", "__aeabi_ul2"]
            .iter()
            .any(|s| name.starts_with(s))
            || ["sf3", "df3", "sf2", "df2", "sfsi", "dfsi"].iter().any(|s| name.ends_with(s))
    };
    assert_eq!(names.iter().find(float), None);
}
