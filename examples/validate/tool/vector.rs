//! Three components in f64: no more than the closed form needs, and none of it the kernel's.

pub type Vector = [f64; 3];
pub type Matrix = [Vector; 3];

pub const ZERO: Vector = [0.0; 3];

pub fn add(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn scale(k: f64, a: Vector) -> Vector {
    [k * a[0], k * a[1], k * a[2]]
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The largest magnitude among the components.
pub fn largest(a: Vector) -> f64 {
    a.iter().fold(0.0, |m, x| m.max(x.abs()))
}

pub fn unit(a: Vector) -> Vector {
    scale(1.0 / norm(a), a)
}

/// The matrix, by rows, times a vector.
pub fn apply(m: &Matrix, a: Vector) -> Vector {
    [dot(m[0], a), dot(m[1], a), dot(m[2], a)]
}

pub fn diagonal([x, y, z]: Vector) -> Matrix {
    [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]
}

/// The rotation of a quaternion w, x, y, z of unit length.
pub fn rotation([w, x, y, z]: [f64; 4]) -> Matrix {
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// R A R^T for a diagonal A.
pub fn rotated(r: &Matrix, a: Vector) -> Matrix {
    let entry = |i: usize, j: usize| (0..3).map(|k| r[i][k] * r[j][k] * a[k]).sum();
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

/// The solution of m x = b by Cramer's rule, for the columns of m.
pub fn solve(columns: [Vector; 3], b: Vector) -> Vector {
    let [x, y, z] = columns;
    let determinant = dot(x, cross(y, z));
    [dot(b, cross(y, z)) / determinant, dot(x, cross(b, z)) / determinant, dot(x, cross(y, b)) / determinant]
}

/// The least eigenvalue of a symmetric matrix, by the roots of its characteristic polynomial.
pub fn least_eigenvalue(m: &Matrix) -> f64 {
    let mean = (m[0][0] + m[1][1] + m[2][2]) / 3.0;
    let shifted = |i: usize, j: usize| m[i][j] - if i == j { mean } else { 0.0 };
    let b = [0, 1, 2].map(|i| [0, 1, 2].map(|j| shifted(i, j)));
    let spread = (b.iter().flatten().map(|x| x * x).sum::<f64>() / 6.0).sqrt();
    if spread == 0.0 {
        return mean;
    }
    let half = (dot(b[0], cross(b[1], b[2])) / (2.0 * spread.powi(3))).clamp(-1.0, 1.0);
    mean + 2.0 * spread * (half.acos() / 3.0 + std::f64::consts::TAU / 3.0).cos()
}
