//! The least firmware with a world of balls and planes: it stacks eight, makes 180 steps and leaves the height in a register.
//! Nobody runs it: `cargo xtask bench` weighs it.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod balls;
#[cfg(target_os = "none")]
mod room;

#[cfg(target_os = "none")]
mod firmware {
    use crate::balls::Ball;
    use crate::room::{MOST, Room, Scene, fill, settings};
    use core::hint::black_box;

    #[cfg(feature = "float")]
    type S = f32;
    #[cfg(not(feature = "float"))]
    type S = fixed::types::I16F16;

    const SCENE: Scene = Scene { pieces: MOST, speed: 0 };

    #[cortex_m_rt::entry]
    fn main() -> ! {
        static mut ROOM: Room<S, Ball<S>, MOST> = Room::new();
        if let (Some(settings), Some(top)) = (settings(4), fill(ROOM, black_box(&SCENE))) {
            for _ in 0..180 {
                ROOM.step(&settings);
            }
            black_box(ROOM.body(top).ok().map(|body| body.position.z));
        }
        loop {
            cortex_m::asm::wfi();
        }
    }

    #[panic_handler]
    fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
        cortex_m::asm::udf()
    }
}

/// It is weighed for boards.
#[cfg(not(target_os = "none"))]
fn main() {}
