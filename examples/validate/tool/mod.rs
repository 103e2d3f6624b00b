//! The tool. The crate around it, the program or a test, says in `crate::host` and `crate::scalars` which number types
//! it holds.

pub mod checker;
pub mod closed_form;
pub mod commands;
pub mod error;
pub mod errors;
pub mod geometry;
pub mod impulses;
pub mod kernel;
pub mod number;
pub mod output;
pub mod planar;
pub mod problem;
pub mod progress;
pub mod report;
pub mod statistics;
pub mod table;
pub mod tolerances;
pub mod units;
pub mod vector;
