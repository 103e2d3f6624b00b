//! What is drawn, against rays: a pixel is filled where the ray through its middle meets the shape. And what a display relies on:
//! nothing beside it, the same picture in bands, the same lines both ways.
#![cfg(all(feature = "embedded-graphics", any(feature = "f32", feature = "f64", feature = "fixed")))]

#[macro_use]
#[path = "support/each_number.rs"]
mod each_number;
#[path = "support/display.rs"]
mod display;
#[path = "support/random.rs"]
mod random;

use carom::interop::embedded_graphics::{Camera, Lens, Style, View, ViewError};
use carom::{
    Body, Capsule, Compound, ConvexHull, Cuboid, HalfSpace, HeightField, Material, OutlineSink, Part, Pose, Quat, Ray,
    Scalar, Shape, Sphere, UnitVec3, Vec3, World,
};
use display::{Display, INK};
use embedded_graphics_core::Drawable;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::{PointsIter, Rectangle};
use random::Random;

each_number!(
    fills_what_rays_meet,
    draws_straight_lines,
    bands_make_the_whole,
    stays_on_the_display,
    draws_the_farthest_first,
    sees_points_where_they_are,
);

carom::shapes! { enum Piece<S> { Sphere, Capsule, Cuboid, HalfSpace } }

const SIDE: u32 = 96;
const EYE: [f64; 3] = [1.5, -2.0, 1.25];
const TARGET: [f64; 3] = [0.0, 0.0, 0.2];
const HALF_WIDTH: f64 = 0.4;
/// Half the width of what is seen without perspective.
const WIDTH: f64 = 1.1;

fn number<S: Scalar>(x: f64) -> S {
    S::from_ratio((x * 1e6).round() as i32, 1_000_000).expect("within the format")
}

fn vector<S: Scalar>(v: [f64; 3]) -> Vec3<S> {
    Vec3::from_array(v.map(number))
}

fn camera<S: Scalar>(lens: Lens<S>) -> Camera<S> {
    Camera { eye: vector(EYE), target: vector(TARGET), up: UnitVec3::Z, lens }
}

fn lenses<S: Scalar>() -> [Lens<S>; 2] {
    [Lens::Perspective(number(HALF_WIDTH)), Lens::Orthographic(number(WIDTH))]
}

fn view<S: Scalar>(lens: Lens<S>) -> View<S> {
    View::new(Size::new(SIDE, SIDE), &camera(lens)).expect("a view")
}

fn pose<S: Scalar>(random: &mut Random, reach: f64) -> Pose<S> {
    let [w, x, y, z] = [(); 4].map(|()| S::Unit::from_ratio(random.below(2000) as i32 - 1000, 1000).expect("a part"));
    let orientation = Quat::normalize(w, x, y, z).unwrap_or(Quat::IDENTITY);
    Pose::new(vector([(); 3].map(|()| random.between(-reach, reach))), orientation)
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

/// To the right, down and ahead.
fn axes() -> [[f64; 3]; 3] {
    let ahead = unit([0, 1, 2].map(|k| TARGET[k] - EYE[k]));
    let right = unit(cross(ahead, [0.0, 0.0, 1.0]));
    [right, cross(ahead, right), ahead]
}

/// The ray through the middle of a pixel.
fn ray<S: Scalar>(perspective: bool, [column, row]: [u32; 2]) -> Ray<S> {
    let part = |pixel: u32| (f64::from(pixel) + 0.5) / (f64::from(SIDE) / 2.0) - 1.0;
    let [right, down, ahead] = axes();
    let aside = |half: f64| [0, 1, 2].map(|k| half * (part(column) * right[k] + part(row) * down[k]));
    let (from, way) = if perspective {
        let aside = aside(HALF_WIDTH);
        (EYE, [0, 1, 2].map(|k| ahead[k] + aside[k]))
    } else {
        let aside = aside(WIDTH);
        ([0, 1, 2].map(|k| EYE[k] + aside[k]), ahead)
    };
    let direction = UnitVec3::normalize(vector(way)).expect("a direction");
    Ray { origin: vector(from), direction, length: number(20.0) }
}

/// Pixels whose neighbours are of one mind about a shape are filled, or not, as the ray through them says.
fn compare<S: Scalar, Sh: Shape<S>>(name: &str, shape: &Sh, pose: &Pose<S>, lens: Lens<S>) -> usize {
    let mut display = Display::new(SIDE);
    view(lens).shape(shape, pose, Style::filled(INK)).draw(&mut display).expect("a display never fails");
    let perspective = matches!(lens, Lens::Perspective(_));
    let met = |at: [u32; 2]| shape.cast_ray(pose, &ray(perspective, at)).is_some();
    let met: Vec<Vec<bool>> = (0..SIDE).map(|row| (0..SIDE).map(|column| met([column, row])).collect()).collect();
    let mut compared = 0;
    for row in 1..SIDE as usize - 1 {
        for column in 1..SIDE as usize - 1 {
            let here = met[row][column];
            let around = (row - 1..=row + 1).flat_map(|row| &met[row][column - 1..=column + 1]);
            if around.into_iter().all(|there| *there == here) {
                assert_eq!(display.is_inked(column, row), here, "{name}: column {column}, row {row} of {pose:?}");
                compared += usize::from(here);
            }
        }
    }
    compared
}

fn fills_what_rays_meet<S: Scalar>(name: &str) {
    let mut random = Random::new(7);
    let ball = Sphere::new(number::<S>(0.4)).expect("a ball");
    let capsule = Capsule::new(number::<S>(0.2), number(0.4)).expect("a capsule");
    let cuboid = Cuboid::new(vector::<S>([0.4, 0.3, 0.2])).expect("a box");
    let corners = [[0.5, 0.0, 0.0], [-0.3, 0.4, 0.1], [-0.2, -0.5, 0.0], [0.0, 0.1, 0.6], [0.1, 0.0, -0.4]];
    let hull = ConvexHull::<S, 8>::new(&corners.map(vector)).expect("a hull");
    let parts = [
        Part { pose: Pose::at(vector([0.2, 0.0, 0.0])), shape: Piece::from(ball) },
        Part { pose: pose(&mut random, 0.3), shape: Piece::from(cuboid) },
    ];
    let compound = Compound::new(&parts).expect("a compound");
    let mut compared = 0;
    for _ in 0..4 {
        // Some of it beyond the border.
        let pose = pose(&mut random, 0.7);
        for lens in lenses() {
            compared += compare(name, &ball, &pose, lens);
            compared += compare(name, &capsule, &pose, lens);
            compared += compare(name, &cuboid, &pose, lens);
            compared += compare(name, &&hull, &pose, lens);
            compared += compare(name, &compound, &pose, lens);
        }
    }
    assert!(compared > 20_000, "{name}: {compared} filled pixels");
}

/// Each pixel of a line is in the column or row that it belongs to, half a pixel at most from where the line is.
fn draws_straight_lines<S: Scalar>(name: &str) {
    let mut random = Random::new(11);
    let side = f64::from(SIDE);
    // A unit of length is a pixel, and the middle of the display the origin.
    let camera = Camera {
        eye: vector::<S>([0.0, 0.0, 10.0]),
        target: Vec3::ZERO,
        up: UnitVec3::Y,
        lens: Lens::Orthographic(number(side / 2.0)),
    };
    let view = View::new(Size::new(SIDE, SIDE), &camera).expect("a view");
    let mut steep = 0;
    for _ in 0..200 {
        let ends = [(); 2].map(|()| [(); 2].map(|()| random.between(-45.0, 45.0)));
        let [a, b] = ends.map(|[x, y]| vector::<S>([x, y, 0.0]));
        let [mut there, mut back] = [Display::new(SIDE), Display::new(SIDE)];
        view.line([a, b], INK).draw(&mut there).expect("a display never fails");
        view.line([b, a], INK).draw(&mut back).expect("a display never fails");
        assert!(there.pixels == back.pixels, "{name}: {ends:?} is another line backwards");

        let [[ax, ay], [bx, by]] = ends.map(|[x, y]| [side / 2.0 + x, side / 2.0 - y]);
        let is_steep = (by - ay).abs() > (bx - ax).abs();
        let turn = |[x, y]: [f64; 2]| if is_steep { [y, x] } else { [x, y] };
        let [[a, c], [b, d]] = [turn([ax, ay]), turn([bx, by])];
        let pixels: Vec<[f64; 2]> = there.inked().map(|[x, y]| turn([x as f64 + 0.5, y as f64 + 0.5])).collect();
        for [along, across] in &pixels {
            let expected = c + (d - c) * (along - a) / (b - a);
            assert!((across - expected).abs() < 0.6, "{name}: {ends:?} at {along}: {across}, not {expected}");
        }
        let count = (a.floor() - b.floor()).abs() + 1.0;
        assert!((pixels.len() as f64 - count).abs() <= 1.0, "{name}: {ends:?}: {} of {count}", pixels.len());
        steep += u32::from(is_steep);
    }
    assert!((50..150).contains(&steep), "{steep} of 200 are steep");
}

/// A world with one of each, far and near, and lines that pass the eye.
fn draw_all<S: Scalar>(random: &mut Random, lens: Lens<S>, displays: &mut [Display]) {
    let mut world = World::<S, Piece<S>, 16, 1, 1>::new();
    let ground = Body::immovable().at(vector([0.0, 0.0, -0.5]));
    world.insert(ground, HalfSpace::new(UnitVec3::Z), Material::DEAD).expect("room");
    let shapes: [Piece<S>; 3] = [
        Sphere::new(number(0.5)).expect("a ball").into(),
        Capsule::new(number(0.2), number(0.6)).expect("a capsule").into(),
        Cuboid::new(vector([0.9, 0.1, 0.3])).expect("a box").into(),
    ];
    for number in 0..12 {
        // Around the eye, too.
        let mut body = Body::immovable().at(pose(random, 3.0).position);
        body.set_orientation(Quat::normalize(S::Unit::ONE, S::Unit::ZERO, S::Unit::ONE, S::Unit::ONE).expect("a turn"));
        world.insert(body, shapes[number % 3], Material::DEAD).expect("room");
    }
    let view = view(lens).with_grid(number(0.5), 12);
    let style = |handle: carom::BodyHandle, _: &Body<S>| match handle.index() % 3 {
        0 => Style::wireframe(INK),
        1 => Style::solid(INK, display::OTHER),
        _ => Style::filled(INK),
    };
    let ends: Vec<_> = (0..40).map(|_| [(); 2].map(|()| pose::<S>(random, 100.0).position)).collect();
    for display in displays {
        view.world(&world, style).draw(display).expect("a display never fails");
        for ends in &ends {
            view.line(*ends, INK).draw(display).expect("a display never fails");
        }
    }
}

fn bands_make_the_whole<S: Scalar>(name: &str) {
    for (seed, lens) in [(1, lenses()[0]), (2, lenses()[1])] {
        let row = |top: i32| Display::window(SIDE, Rectangle::new(Point::new(0, top), Size::new(SIDE, 5)));
        let column = |left: i32| Display::window(SIDE, Rectangle::new(Point::new(left, 0), Size::new(7, SIDE)));
        let rows = (0..SIDE as i32).step_by(5).map(row);
        let mut displays: Vec<Display> = rows.chain((0..SIDE as i32).step_by(7).map(column)).collect();
        displays.push(Display::new(SIDE));
        draw_all::<S>(&mut Random::new(seed), lens, &mut displays);
        let whole = displays.pop().expect("the last");
        assert!(whole.inked().count() > 500, "{name}: next to nothing is drawn");
        for band in &displays {
            for Point { x, y } in band.window.points().filter(|at| at.x < SIDE as i32 && at.y < SIDE as i32) {
                let at = y as usize * SIDE as usize + x as usize;
                assert_eq!(band.pixels[at], whole.pixels[at], "{name}: column {x}, row {y} of {:?}", band.window);
            }
        }
    }
}

/// [`Display`] panics where a pixel is beside it. What is far away costs no more than what is seen.
fn stays_on_the_display<S: Scalar>(name: &str) {
    for seed in 3..9 {
        let lens = lenses()[seed as usize % 2];
        let small = Display::window(SIDE, Rectangle::new(Point::new(40, 50), Size::new(3, 2)));
        // A target that reaches beyond the view, too.
        let large = Display::window(SIDE, Rectangle::new(Point::new(-50, -50), Size::new(400, 400)));
        let mut displays = [Display::new(SIDE), small, large];
        draw_all::<S>(&mut Random::new(seed), lens, &mut displays);
        assert!(displays[0].pixels == displays[2].pixels, "{name}: the view ends where its display does");
    }
    // Lines across all there is, and behind the eye.
    let far = number::<S>(if S::LARGEST.integer_below() > 1000 { 1000.0 } else { 100.0 });
    let [x, y] = [Vec3::new(far, S::ZERO, S::ZERO), Vec3::new(S::ZERO, far, S::ZERO)];
    let view = view(lenses()[0]);
    for ends in [[x, -x], [y, -y], [x, y], [-x, y], [x, -y], [vector(EYE), x], [vector(EYE); 2]] {
        view.line(ends, INK).draw(&mut Display::new(SIDE)).expect("a display never fails");
    }
    let behind = [[3.0, -4.0, 2.5], [3.5, -4.0, 2.5]].map(vector::<S>);
    let mut display = Display::new(SIDE);
    view.line(behind, INK).draw(&mut display).expect("a display never fails");
    assert_eq!((display.inked().count(), view.pixel(behind[0])), (0, None), "{name}: nothing behind the eye");
}

fn draws_the_farthest_first<S: Scalar>(name: &str) {
    let mut random = Random::new(23);
    let mut world = World::<S, Piece<S>, 24, 1, 1>::new();
    let ball = Sphere::new(number::<S>(0.1)).expect("a ball");
    let mut handles = Vec::new();
    for _ in 0..20 {
        let body = Body::immovable().at(pose(&mut random, 2.0).position);
        handles.push(world.insert(body, ball, Material::DEAD).expect("room"));
    }
    // Of two in one place the first comes first.
    let twin = Body::immovable().at(world.body(handles[5]).expect("there").position);
    handles.push(world.insert(twin, ball, Material::DEAD).expect("room"));
    let ground = world.insert(Body::immovable(), HalfSpace::new(UnitVec3::Z), Material::DEAD).expect("room");
    world.remove(handles.remove(2)).expect("there");
    assert_eq!(world.bodies_with_shapes().count(), 21);

    let distance = |handle| {
        let v: Vec3<S> = world.body(handle).expect("there").position - vector(EYE);
        v.dot(v)
    };
    handles.sort_by(|a, b| distance(*b).partial_cmp(&distance(*a)).expect("numbers"));
    let order: Vec<_> = view::<S>(lenses()[0]).back_to_front(&world).map(|(handle, ..)| handle).collect();
    assert_eq!(order[0], ground, "{name}");
    assert_eq!(order[1..], handles, "{name}");
}

/// Where a point is seen, by the definition.
fn sees_points_where_they_are<S: Scalar>(name: &str) {
    let mut random = Random::new(31);
    let (view, mut seen) = (view::<S>(lenses()[0]), 0);
    for _ in 0..500 {
        let point = [(); 3].map(|()| random.between(-1.5, 1.5));
        let [x, y, z] = axes().map(|axis| (0..3).map(|k| axis[k] * (point[k] - EYE[k])).sum::<f64>());
        let at = [x, y].map(|aside| (aside / z / HALF_WIDTH + 1.0) * f64::from(SIDE) / 2.0);
        let is_seen = z > 0.0 && at.iter().all(|at| (0.1..f64::from(SIDE) - 0.1).contains(at));
        let Some(pixel) = view.pixel(vector(point)) else {
            assert!(!is_seen, "{name}: {point:?} is not seen at {at:?}");
            continue;
        };
        for (at, pixel) in at.into_iter().zip([pixel.x, pixel.y]) {
            assert!((at - 0.5 - f64::from(pixel)).abs() < 0.6, "{name}: {point:?} at {pixel}, not {at}");
        }
        seen += 1;
    }
    assert!(seen > 100, "{seen} points are seen");
}

#[cfg(feature = "f32")]
#[test]
fn numbers_that_are_none_draw_nothing() {
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for lens in lenses::<f32>() {
            let (view, mut display) = (view(lens).with_grid(bad, 3), Display::new(SIDE));
            let pose = Pose::at(Vec3::new(0.0, bad, 0.0));
            let shapes: [Piece<f32>; 4] = [
                Sphere::new(0.5).expect("a ball").into(),
                Capsule::new(0.2, 0.6).expect("a capsule").into(),
                Cuboid::new(Vec3::new(0.9, 0.1, 0.3)).expect("a box").into(),
                HalfSpace::new(UnitVec3::Z).into(),
            ];
            for shape in &shapes {
                view.shape(shape, &pose, Style::solid(INK, INK)).draw(&mut display).expect("a display never fails");
            }
            assert_eq!(display.inked().count(), 0, "{bad} {lens:?}");
            assert_eq!(view.pixel(pose.position), None);
        }
    }
}

#[cfg(feature = "f32")]
#[test]
fn what_cannot_be_seen_is_refused() {
    let refused = |size, change: fn(&mut Camera<f32>)| {
        let mut camera = camera(lenses()[0]);
        change(&mut camera);
        View::new(size, &camera).err()
    };
    let size = Size::new(240, 320);
    assert_eq!(refused(size, |_| {}), None);
    assert_eq!(refused(Size::new(3840, 1), |_| {}), None);
    assert_eq!(refused(Size::new(0, 320), |_| {}), Some(ViewError::Size));
    assert_eq!(refused(Size::new(240, 3841), |_| {}), Some(ViewError::Size));
    assert_eq!(refused(size, |camera| camera.target = camera.eye), Some(ViewError::Direction));
    assert_eq!(refused(size, |camera| camera.eye.x = f32::NAN), Some(ViewError::Direction));
    assert_eq!(refused(size, |camera| camera.target = camera.eye - Vec3::new(0.0, 0.0, 1.0)), Some(ViewError::Up));
    assert_eq!(refused(size, |camera| camera.lens = Lens::Perspective(0.0)), Some(ViewError::HalfWidth));
    assert_eq!(refused(size, |camera| camera.lens = Lens::Orthographic(f32::INFINITY)), Some(ViewError::HalfWidth));
}

/// What shapes tell is counted.
#[derive(Default)]
struct Counts {
    faces: Vec<usize>,
    segments: usize,
    rods: usize,
    planes: usize,
}

impl<S: Scalar> OutlineSink<S> for Counts {
    fn face(&mut self, corners: &[Vec3<S>]) {
        self.faces.push(corners.len());
    }

    fn segment(&mut self, _: [Vec3<S>; 2]) {
        self.segments += 1;
    }

    fn rod(&mut self, _: [Vec3<S>; 2], _: S) {
        self.rods += 1;
    }

    fn plane(&mut self, _: Vec3<S>, _: UnitVec3<S>) {
        self.planes += 1;
    }
}

#[cfg(feature = "f32")]
#[test]
fn shapes_tell_their_outlines() {
    fn counts(shape: &impl Shape<f32>) -> Counts {
        let mut counts = Counts::default();
        shape.outline(&Pose::IDENTITY, &mut counts);
        counts
    }
    let pyramid = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
    let hull = ConvexHull::<f32, 5>::new(&[pyramid.as_slice(), &[Vec3::new(0.0, 0.0, 1.0)]].concat()).expect("a hull");
    let mut faces = counts(&&hull).faces;
    faces.sort_unstable();
    assert_eq!(faces, [3, 3, 3, 3, 4]);
    // Of 3 by 4 samples: 2 x 4 lines along the rows and 3 x 3 along the columns.
    assert_eq!(counts(&HeightField::new(&[0.0; 12], 3, 4, 0.5).expect("a field")).segments, 17);
    let parts = [
        Part { pose: Pose::IDENTITY, shape: Piece::from(Sphere::new(1.0).expect("a ball")) },
        Part { pose: Pose::IDENTITY, shape: Capsule::new(1.0, 1.0).expect("a capsule").into() },
        Part { pose: Pose::IDENTITY, shape: Cuboid::new(Vec3::new(1.0, 1.0, 1.0)).expect("a box").into() },
        Part { pose: Pose::IDENTITY, shape: HalfSpace::new(UnitVec3::Z).into() },
    ];
    let Counts { faces, segments, rods, planes } = counts(&Compound::new(&parts).expect("a compound"));
    assert_eq!((faces, segments, rods, planes), (vec![4; 6], 0, 2, 1));
}
