//! One pair of shapes after the other, nearly touching: how far apart they are, where they meet, and a hash of all of it.

use carom::{
    Capsule, Closest, Collide, Compound, Cuboid, HalfSpace, HeightField, Manifold, ManifoldSink, Part, Pose, Quat,
    Scalar, Sphere, StateHash, UnitVec3, Vec3,
};

/// Points of the field to each side.
const COLUMNS: u16 = 5;

/// What came of a pair.
pub struct Meeting<S: Scalar> {
    pub names: [&'static str; 2],
    /// Before the first was moved to the second.
    pub closest: Closest<S>,
    /// After that: the manifolds and their points.
    pub manifolds: u32,
    pub points: u32,
    /// The last manifold's.
    pub normal: UnitVec3<S>,
    pub separation: S,
}

/// Takes manifolds.
struct Sink<'a, S: Scalar> {
    place: Manifold<S>,
    hash: &'a mut StateHash,
    manifolds: u32,
    points: u32,
    separation: S,
}

impl<S: Scalar> ManifoldSink<S> for Sink<'_, S> {
    fn place(&mut self) -> &mut Manifold<S> {
        &mut self.place
    }

    fn take(&mut self, part: u32) {
        self.manifolds = self.manifolds.wrapping_add(1);
        add_integer::<S>(self.hash, (part >> 16) as u16);
        add_integer::<S>(self.hash, part as u16);
        add_unit(self.hash, self.place.normal);
        for point in self.place.points() {
            self.points = self.points.wrapping_add(1);
            self.separation = point.separation;
            self.hash.add_vec3(point.r_a);
            self.hash.add_vec3(point.r_b);
            self.hash.add(point.separation);
            add_integer::<S>(self.hash, point.feature.0);
        }
    }
}

fn add_unit<S: Scalar>(hash: &mut StateHash, d: UnitVec3<S>) {
    d.get().to_array().into_iter().for_each(|x| hash.add(x));
}

/// As a fraction that every format holds exactly.
fn add_integer<S: Scalar>(hash: &mut StateHash, n: u16) {
    if let Ok(fraction) = S::Unit::from_ratio(i32::from(n), 1 << 16) {
        hash.add(fraction);
    }
}

/// The first shape moves to the second, which stays where it is.
struct Scene<'a, S: Scalar, Each> {
    start: Pose<S>,
    /// As deep the shapes are brought into each other.
    depth: S,
    hash: StateHash,
    each: &'a mut Each,
}

impl<S: Scalar, Each: FnMut(&Meeting<S>)> Scene<'_, S, Each> {
    #[inline(never)]
    fn meet<A: Collide<S, B>, B>(&mut self, names: [&'static str; 2], a: &A, b: &B) -> Option<()> {
        let mut pose = self.start;
        let closest = a.closest(&pose, b, &Pose::IDENTITY)?;
        self.hash.add(closest.separation);
        add_unit(&mut self.hash, closest.normal);
        self.hash.add_vec3(closest.r_a);
        self.hash.add_vec3(closest.r_b);
        pose.position += closest.normal.times(closest.separation.plus(self.depth));
        let hash = &mut self.hash;
        let place = Manifold::empty(UnitVec3::Z);
        let mut sink = Sink { place, hash, manifolds: 0, points: 0, separation: S::ZERO };
        a.collide(&pose, b, &Pose::IDENTITY, self.depth, &mut sink);
        let Sink { manifolds, points, separation, place, .. } = sink;
        (self.each)(&Meeting { names, closest, manifolds, points, normal: place.normal, separation });
        Some(())
    }
}

/// Pairs of shapes, as many as the flash of a small part holds in three formats at once (making a hull would take a tenth of it),
/// and the hash. `None` where the format does not hold the scene.
pub fn meet_all<S: Scalar>(each: &mut impl FnMut(&Meeting<S>)) -> Option<u64> {
    let eighths = |n| S::from_ratio(n, 8).ok();
    let vector = |x, y, z| Some(Vec3::new(eighths(x)?, eighths(y)?, eighths(z)?));
    let unit = |n| S::Unit::from_ratio(n, 16).ok();
    let leaning = Quat::normalize(unit(15)?, unit(2)?, unit(-3)?, unit(1)?).ok()?;
    let start = Pose::new(vector(1, -1, 12)?, leaning);
    let mut scene = Scene { start, depth: S::from_ratio(1, 128).ok()?, hash: StateHash::new(), each };

    let sphere = Sphere::new(eighths(3)?).ok()?;
    let cuboid = Cuboid::new(vector(4, 3, 2)?).ok()?;
    let capsule = Capsule::new(eighths(2)?, eighths(3)?).ok()?;
    let ground = HalfSpace::new(UnitVec3::Z);
    scene.meet(["sphere", "sphere"], &sphere, &sphere)?;
    scene.meet(["sphere", "half-space"], &sphere, &ground)?;
    scene.meet(["sphere", "cuboid"], &sphere, &cuboid)?;
    scene.meet(["sphere", "capsule"], &sphere, &capsule)?;
    scene.meet(["cuboid", "half-space"], &cuboid, &ground)?;
    scene.meet(["cuboid", "cuboid"], &cuboid, &cuboid)?;
    scene.meet(["capsule", "half-space"], &capsule, &ground)?;
    scene.meet(["capsule", "cuboid"], &capsule, &cuboid)?;

    let end = |x| Some(Part { pose: Pose::at(vector(x, 0, 0)?), shape: sphere });
    let ends = [end(-4)?, end(4)?];
    let dumbbell = Compound::new(&ends).ok()?;
    scene.meet(["compound", "half-space"], &dumbbell, &ground)?;

    // Waves of a sixteenth.
    let mut heights = [S::ZERO; (COLUMNS * COLUMNS) as usize];
    for (k, height) in (0i32..).zip(&mut heights) {
        *height = S::from_ratio(k * k % 7 - 3, 48).ok()?;
    }
    let field = HeightField::new(&heights, COLUMNS, COLUMNS, eighths(4)?).ok()?;
    scene.meet(["sphere", "field"], &sphere, &field)?;
    Some(scene.hash.get())
}
