//! A hundred steps a second in a task of RTIC; another of lower priority prints what it sends.
#![no_std]
#![no_main]

#[path = "../../tasks/scene.rs"]
mod scene;

use cortex_m_semihosting::{debug, hprintln};

/// Ends QEMU with that outcome.
fn end(good: bool) {
    debug::exit(if good { debug::EXIT_SUCCESS } else { debug::EXIT_FAILURE });
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        end(false);
    }
}

#[rtic::app(device = lm3s6965, dispatchers = [SSI0, QEI0])]
mod app {
    use super::scene::{Drop, Frame, RATE, Room, STEPS, chained, straight};
    use super::{end, hprintln};
    use rtic_monotonics::systick::prelude::*;
    use rtic_sync::channel::{Receiver, Sender};
    use rtic_sync::make_channel;

    /// The clock of SysTick on the board, Hz.
    const CLOCK: u32 = 25_000_000;
    const FRAMES: usize = 4;

    systick_monotonic!(Mono, 1000);

    #[shared]
    struct Shared {}

    #[local]
    struct Local {}

    #[init(local = [world: Room = Room::new(), reference: Room = Room::new()])]
    fn init(cx: init::Context) -> (Shared, Local) {
        Mono::start(cx.core.SYST, CLOCK);
        let (sender, receiver) = make_channel!(Frame, FRAMES);
        let started = Drop::new(cx.local.world).is_some_and(|drop| {
            physics::spawn(drop, sender).is_ok() && telemetry::spawn(cx.local.reference, receiver).is_ok()
        });
        if !started {
            end(false);
        }
        (Shared {}, Local {})
    }

    /// Every ten milliseconds, whatever else runs.
    #[task(priority = 2)]
    async fn physics(_: physics::Context, mut drop: Drop, mut frames: Sender<'static, Frame, FRAMES>) {
        let mut next = Mono::now();
        for _ in 0..STEPS {
            if let Some(frame) = drop.step() {
                // A full queue leaves a frame out; steps wait for nobody.
                let _ = frames.try_send(frame);
            }
            next += (1000 / u32::from(RATE)).millis();
            Mono::delay_until(next).await;
        }
    }

    #[task(priority = 1)]
    async fn telemetry(
        _: telemetry::Context,
        reference: &'static mut Room,
        mut frames: Receiver<'static, Frame, FRAMES>,
    ) {
        let begun = Mono::now();
        let mut run = 0;
        while let Ok(frame) = frames.recv().await {
            hprintln!("step {} height {} mm state {:016x}", frame.step, frame.height_mm, frame.hash);
            run = chained(run, &frame);
        }
        let ms = (Mono::now() - begun).as_millis();
        let same = straight(reference) == Some(run);
        let in_time = ms.abs_diff(STEPS * 1000 / u32::from(RATE)) < 100;
        hprintln!("{} steps, none of them late: {}, the same bits as without RTIC: {}", STEPS, in_time, same);
        end(same && in_time);
    }
}
