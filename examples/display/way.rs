//! The way of thrown dice, to be drawn behind them.

use carom::{Pose, Quat, Scalar, Vec3};

use crate::scenes::dice::{DICE, Room, STEPS, Throw};

/// The throw: the dice come to rest side by side.
const SEED: u32 = 3;
/// The first step that is kept, and from there on each of so many.
const FIRST: u32 = 12;
const STRIDE: u32 = 4;
/// How many are kept.
pub const POSES: usize = 18;

/// Where the dice were on their way: as position and orientation, which take half the memory of a pose.
pub struct Way<S: Scalar>([[(Vec3<S>, Quat<S>); DICE]; POSES]);

impl<S: Scalar> Way<S> {
    pub const fn new() -> Self {
        Self([[(Vec3::ZERO, Quat::IDENTITY); DICE]; POSES])
    }

    /// Throws the dice until they lie. `None`: they do not, or a number does not fit the format. Never inlined: the picture has the
    /// memory after it.
    #[inline(never)]
    pub fn throw(&mut self, world: &mut Room<S>) -> Option<()> {
        let mut throw = Throw::new(world, SEED)?;
        for step in 1..=STEPS {
            if !throw.step() {
                return Some(());
            }
            if step >= FIRST && step % STRIDE == FIRST % STRIDE {
                self.keep((step.wrapping_sub(FIRST) / STRIDE) as usize, &throw);
            }
        }
        None
    }

    fn keep(&mut self, number: usize, throw: &Throw<S>) {
        // Before the dice comes the table.
        let dice = throw.world().bodies().skip(1);
        for ((_, die), place) in dice.zip(self.0.get_mut(number).into_iter().flatten()) {
            *place = (die.position, die.orientation());
        }
    }

    /// The poses of all dice, the oldest first.
    pub fn poses(&self) -> impl Iterator<Item = [Pose<S>; DICE]> {
        self.0.iter().map(|dice| dice.map(|(position, orientation)| Pose::new(position, orientation)))
    }
}
