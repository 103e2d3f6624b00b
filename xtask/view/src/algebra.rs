//! The little algebra of pictures. (carom's own is for bodies; what is checked here is not computed with it.)

pub fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn scale(a: [f64; 3], s: f64) -> [f64; 3] {
    a.map(|part| part * s)
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// Of length one; up, where there is no direction.
pub fn direction(a: [f64; 3]) -> [f64; 3] {
    let length = length(a);
    if length > 0.0 { scale(a, 1.0 / length) } else { [0.0, 0.0, 1.0] }
}

/// From the body's frame to the world's.
pub fn rotate([w, x, y, z]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let axis = [x, y, z];
    let t = scale(cross(axis, v), 2.0);
    add(add(v, scale(t, w)), cross(axis, t))
}

/// From the world's frame to the body's.
pub fn rotate_back([w, x, y, z]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    rotate([w, -x, -y, -z], v)
}

/// The rotation that brings z to that direction.
pub fn turn_from_z(to: [f64; 3]) -> [f64; 4] {
    let to = direction(to);
    if to[2] < -0.999_999 {
        return [0.0, 1.0, 0.0, 0.0];
    }
    let q = [1.0 + to[2], -to[1], to[0], 0.0];
    let length = q.iter().map(|part| part * part).sum::<f64>().sqrt();
    q.map(|part| part / length)
}

/// The inverse of a symmetric tensor xx, xy, xz, yy, yz, zz; `None` of a singular one.
pub fn inverse([xx, xy, xz, yy, yz, zz]: [f64; 6]) -> Option<[f64; 6]> {
    let minors = [
        yy * zz - yz * yz,
        xz * yz - xy * zz,
        xy * yz - xz * yy,
        xx * zz - xz * xz,
        xy * xz - xx * yz,
        xx * yy - xy * xy,
    ];
    let determinant = xx * minors[0] + xy * minors[1] + xz * minors[2];
    (determinant != 0.0).then(|| minors.map(|minor| minor / determinant))
}
