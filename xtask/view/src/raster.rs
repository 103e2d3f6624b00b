//! Pictures without a browser: a small rasteriser of triangles.

mod camera;
mod canvas;
mod paint;
mod shading;
mod vector;

pub use paint::frame;
