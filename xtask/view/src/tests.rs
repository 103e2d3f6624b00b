//! Traces made by hand, of which all is known: a ball of mass 2 falls from 10 dm onto a floor and stays there.

use crate::{Balance, Comparison, Format, Replay, Shape, Trace, Words, pushes};

const G: f64 = -98.0;
const RATE: u16 = 100;
const RADIUS: f64 = 0.5;
const FALL: usize = 40;

/// The bytes of that trace in i16f16, the ball to the side by `aside(frame)`, in dm.
fn bytes(aside: impl Fn(usize) -> f64) -> Vec<u8> {
    let word = |x: f64| ((x * 65536.0).round() as i32).to_le_bytes();
    let unit = |x: f64| ((x * 1_073_741_824.0).round() as i64).clamp(i64::from(i32::MIN), 1 << 30) as i32;
    let mut file = b"CAROM\0TR\x01\x06i16f16\x04\x10".to_vec();
    file.extend(RATE.to_le_bytes());
    file.push(4);
    file.extend(100_000u32.to_le_bytes());
    file.push(2);
    let scaled = |file: &mut Vec<u8>, mantissa: f64, exponent: i16| {
        file.extend(exponent.to_le_bytes());
        file.extend(unit(mantissa).to_le_bytes());
    };
    file.extend([0, 0, b'H']);
    [0.0, 0.0, 1.0].into_iter().for_each(|part| file.extend(unit(part).to_le_bytes()));
    (0..7).for_each(|_| scaled(&mut file, 0.0, -100));
    file.extend([1, 0, b'S']);
    file.extend(word(RADIUS));
    scaled(&mut file, 0.5, 0);
    // 1/I = 1/(2/5 2 0.25) = 5 on the diagonal: xx, yy and zz.
    [1, 0, 0, 1, 0, 1]
        .into_iter()
        .for_each(|one| scaled(&mut file, f64::from(one) * 5.0 / 8.0, if one == 1 { 3 } else { -100 }));
    for frame in 0..FALL + 10 {
        file.push(b'F');
        [0.0, 0.0, G].into_iter().for_each(|part| file.extend(word(part)));
        if frame == 0 {
            motion(&mut file, 1, [0.0; 3], [0.0; 3], [0.0; 3]);
        }
        if frame <= FALL {
            let (height, speed) = state(frame);
            motion(&mut file, 2, [aside(frame), 0.0, height], [0.0, 0.0, speed], [0.0, 3.0, 0.0]);
        }
        file.push(0);
        if frame >= FALL {
            file.extend([1, 1, if frame == FALL { 2 } else { 0 }]);
            file.extend(word(1.96));
            file.extend(word(if frame == FALL { 43.0 } else { 0.0 }));
        }
        file.push(0);
    }
    file.push(b'E');
    file.extend((FALL as u32 + 10).to_le_bytes());
    file
}

fn motion(file: &mut Vec<u8>, body: u8, position: [f64; 3], velocity: [f64; 3], spin: [f64; 3]) {
    let word = |x: f64| ((x * 65536.0).round() as i32).to_le_bytes();
    file.push(body);
    position.into_iter().for_each(|part| file.extend(word(part)));
    file.extend((1i32 << 30).to_le_bytes());
    file.extend([0; 12]);
    velocity.into_iter().chain(spin).for_each(|part| file.extend(word(part)));
}

/// Height and speed by the closed form; on the floor at the end.
fn state(frame: usize) -> (f64, f64) {
    let time = frame as f64 / f64::from(RATE);
    if frame < FALL { (10.0 + 0.5 * G * time * time, G * time) } else { (RADIUS, 0.0) }
}

fn read(aside: impl Fn(usize) -> f64) -> Trace {
    Trace::read(&bytes(aside)).expect("a trace")
}

#[test]
fn numbers_are_read_exactly() {
    let trace = read(|_| -3.0 / 65536.0);
    assert_eq!(
        (trace.scalar.as_str(), trace.format, trace.rate, trace.sub_steps),
        ("i16f16", Format::Fixed(16), RATE, 4)
    );
    assert_eq!(trace.bodies[0].shape, Shape::HalfSpace { normal: [0.0, 0.0, 1.0] });
    assert_eq!((trace.bodies[1].shape, trace.bodies[1].inv_mass), (Shape::Sphere { radius: RADIUS }, 0.5));
    assert_eq!(trace.bodies[1].inv_inertia, [5.0, 0.0, 0.0, 5.0, 0.0, 5.0]);
    assert!(trace.bodies[0].is_fixed() && !trace.bodies[1].is_fixed() && !trace.moving(0) && trace.moving(1));
    assert_eq!(trace.frames.len(), FALL + 10);
    for (index, frame) in trace.frames.iter().enumerate() {
        let (height, _) = state(index);
        let [x, _, z] = frame.motions[1].position;
        assert_eq!((x, z), (-3.0 / 65536.0, (height * 65536.0).round() / 65536.0), "frame {index}");
        assert_eq!(frame.touches.len(), usize::from(index >= FALL));
    }
}

/// Whatever is missing or added, reading says so.
#[test]
fn what_is_no_trace_is_refused() {
    let whole = bytes(|_| 0.0);
    for length in 0..whole.len() {
        assert!(
            Trace::read(&whole[..length]).is_err(),
            "the first {length} bytes of {} are taken for a trace",
            whole.len()
        );
    }
    assert!(Trace::read(&[whole.clone(), vec![0]].concat()).is_err());
    for (place, byte) in [(0, b'X'), (8, 9), (16, 7), (17, 40)] {
        let mut broken = whole.clone();
        broken[place] = byte;
        assert!(Trace::read(&broken).is_err(), "byte {place} can be {byte}");
    }
}

#[test]
fn energy_is_that_of_a_falling_ball() {
    let trace = read(|_| 0.0);
    // 2 kg fall from 1 m, under 9.8 m/s^2; I = 0.2 kg dm^2, at 3 rad/s.
    let (given, spin) = (2.0 * 9.8, 0.5 * 0.002 * 9.0);
    for (index, frame) in trace.frames.iter().enumerate().take(FALL) {
        let balance = Balance::of(&trace, frame);
        let time = index as f64 / f64::from(RATE);
        assert!((balance.total() - given - spin).abs() < 1e-3, "frame {index}: {balance:?}");
        assert!((balance.motion - 0.5 * 2.0 * (9.8 * time).powi(2)).abs() < 1e-3, "frame {index}: {balance:?}");
        assert!((balance.spin - spin).abs() < 1e-12, "frame {index}: {balance:?}");
        assert!((balance.momentum[2] + 2.0 * 9.8 * time).abs() < 1e-4, "frame {index}: {balance:?}");
    }
}

#[test]
fn runs_part_when_they_are_a_tenth_of_a_ball_apart() {
    let (trace, other) = (read(|_| 0.0), read(|frame| frame as f64 / 64.0));
    let comparison = Comparison::new(&trace, &other).expect("one scene");
    // A tenth of 1 dm is passed after seven 64ths.
    assert_eq!((comparison.bound, comparison.parted), (0.01, Some(7)));
    assert!((comparison.distance[FALL] - 0.0625).abs() < 1e-9);
    let itself = Comparison::new(&trace, &trace).expect("one scene");
    assert!(itself.parted.is_none() && itself.distance.iter().all(|distance| *distance == 0.0));
}

#[test]
fn a_ball_is_pushed_where_it_lies() {
    let trace = read(|_| 1.0);
    assert!((0..FALL).all(|frame| pushes(&trace, frame).is_empty()));
    for frame in FALL + 1..FALL + 10 {
        let pushes = pushes(&trace, frame);
        assert_eq!(pushes.len(), 1);
        let [x, y, z] = pushes[0].points[0];
        assert!((x - 1.0).abs() < 1e-9 && y.abs() < 1e-9 && z.abs() < 1e-9, "at {:?}", pushes[0].points);
        assert!((pushes[0].direction[2] - 1.0).abs() < 1e-9, "up: {:?}", pushes[0].direction);
    }
}

/// An ivory ball on the picture is where the camera has it: in the middle across, and lower at the end than at the start.
#[test]
fn pictures_show_the_ball() {
    let (trace, other) = (read(|_| 0.0), read(|_| 2.0));
    let words =
        Words { example: "ball".into(), place: "here".into(), ghost_place: "here".into(), command: String::new() };
    let replay = Replay::new(&trace, Some(&other), words).expect("a replay");
    let size = crate::image::Size { width: 320, height: 180, closer: 1.0 };
    let seen = |frame: usize| {
        let picture = crate::image::picture(&replay, frame, size);
        let middle = |wanted: fn(&[u8; 3]) -> bool| {
            let places: Vec<_> = picture
                .iter()
                .enumerate()
                .filter(|(_, pixel)| wanted(pixel))
                .map(|(at, _)| [at % 320, at / 320])
                .collect();
            let mean =
                |axis: usize| places.iter().map(|place| place[axis]).sum::<usize>() as f64 / places.len().max(1) as f64;
            (places.len(), mean(0), mean(1))
        };
        let own = middle(|[red, _, blue]| *red > blue.saturating_add(4));
        let ghost = middle(|[red, _, blue]| *blue > red.saturating_add(60));
        (own, ghost)
    };
    let ((start, x0, y0), (ghosts, ..)) = seen(0);
    let ((end, x1, y1), _) = seen(FALL - 1);
    assert!(start > 20 && end > 20 && ghosts > 20, "{start}, {end} and {ghosts} pixels");
    assert!((x0 - 160.0).abs() < 6.0 && (x1 - 160.0).abs() < 6.0, "across at {x0}, then {x1}");
    assert!(y1 > y0 + 80.0, "down at {y0}, then {y1}");
    let page = crate::page(&replay).expect("a page");
    assert!(!page.contains("{{") && page.contains("\"parted\":0.0"), "the page has gaps");
}
