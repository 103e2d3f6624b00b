//! Dice, thrown again and again: an LED lights up where they strike.

use crate::cycles::{Cycles, Tally};
use crate::number::Real;
use crate::scenes::dice::{RATE, Room, SEED, STEPS, Throw};
use embedded_hal::digital::OutputPin;
use rtt_target::rprintln;

/// From step to step, how long a blow lights the LED, and how long dice lie, in microseconds.
const STEP: u64 = 1_000_000 / RATE as u64;
const FLASH: u64 = 20_000;
const PAUSE: u64 = 2_000_000;

/// Throws for ever, in time with a clock of microseconds. The first throw is the one whose state is pinned.
pub fn run(led: &mut impl OutputPin, cycles: &mut Cycles, now: impl Fn() -> u64) -> ! {
    let mut world = Room::<Real>::new();
    let mut seed = SEED;
    while let Some(mut throw) = Throw::new(&mut world, seed) {
        let mut tally = Tally::new();
        let (mut due, mut dark) = (now(), 0);
        for _ in 0..STEPS {
            let before = throw.impacts;
            let (rolling, taken) = cycles.of(|| throw.step());
            tally.add(taken);
            if throw.impacts != before {
                dark = now() + FLASH;
            }
            // A pin of the chip itself takes every state.
            let _ = led.set_state((now() < dark).into());
            due += STEP;
            while now() < due {}
            if !rolling {
                break;
            }
        }
        let _ = led.set_low();
        for face in throw.faces() {
            rprintln!("a die shows {}", face.unwrap_or_default());
        }
        rprintln!("seed {}: {} impacts, state {:016x}", seed, throw.impacts, throw.hash());
        tally.print("this throw", cycles.mhz());
        due += PAUSE;
        while now() < due {}
        // When the dice come to rest depends on how they fell, to the microsecond on nothing that anybody knows.
        seed = now() as u32;
    }
    rprintln!("the dice cannot be set up");
    loop {
        cortex_m::asm::wfi();
    }
}
