//! The little linear algebra that rigid bodies need, written out by hand for three dimensions.

mod block;
mod mat3;
mod order;
mod pose;
mod quat;
mod sym3;
mod unit_vec3;
mod vec3;

pub use self::block::{Block, BlockImpulse, SymBlock};
pub use self::mat3::Mat3;
pub(crate) use self::order::{abs, clamp, max, min};
pub use self::pose::Pose;
pub use self::quat::Quat;
pub use self::sym3::SymMat3;
pub use self::unit_vec3::UnitVec3;
pub use self::vec3::Vec3;
