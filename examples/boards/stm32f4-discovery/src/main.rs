//! Newton's cradle on an STM32F4 Discovery: each LED is the gap between two balls, and lights up when they meet.
#![no_std]
#![no_main]

use carom_boards::cycles::{Cycles, Tally};
use carom_boards::number::Real;
use carom_boards::scenes::cradle::{BALLS, Cradle, RATE, Room, STEPS};
use carom_boards::{bits, costs};
use cortex_m_rt::entry;
use hal::gpio::PinState;
use hal::pac;
use hal::prelude::*;
use hal::rcc::Config;
use panic_rtt_target as _;
use rtt_target::rprintln;
use stm32f4xx_hal as hal;

/// What the board's crystal and the core run at, MHz.
const CRYSTAL: u32 = 8;
const CORE: u32 = 168;
/// How long a blow lights an LED: a tenth of a second.
const FLASH: u32 = RATE as u32 / 10;

#[entry]
fn main() -> ! {
    rtt_target::rtt_init_print!();
    // Before anything but the core is touched, with the clock that the chip begins with.
    bits::print();

    let (core, chip) = (cortex_m::Peripherals::take().unwrap(), pac::Peripherals::take().unwrap());
    let mut rcc = chip.RCC.freeze(Config::hse(CRYSTAL.MHz()).sysclk(CORE.MHz()));
    let pins = chip.GPIOD.split(&mut rcc);
    // Clockwise from the left: green, orange, red, blue.
    let mut leds = [
        pins.pd12.into_push_pull_output().erase(),
        pins.pd13.into_push_pull_output().erase(),
        pins.pd14.into_push_pull_output().erase(),
        pins.pd15.into_push_pull_output().erase(),
    ];
    let mut timer = chip.TIM2.counter_hz(&mut rcc);
    timer.start(u32::from(RATE).Hz()).unwrap();
    let mut cycles = Cycles::new(core.SYST, rcc.clocks.sysclk().to_MHz());
    costs::print(&mut cycles);

    let mut world = Room::<Real>::new();
    let mut lit = [0; BALLS - 1];
    loop {
        let mut cradle = Cradle::new(&mut world).unwrap();
        let mut tally = Tally::new();
        for _ in 0..STEPS {
            tally.add(cycles.of(|| cradle.step()).1);
            for impact in cradle.world().impacts() {
                // Balls were put in from left to right.
                let [a, b] = impact.bodies.map(|ball| ball.index());
                if let Some(left) = lit.get_mut(a.min(b)) {
                    *left = FLASH;
                }
            }
            for (led, left) in leds.iter_mut().zip(&mut lit) {
                led.set_state(if *left > 0 { PinState::High } else { PinState::Low });
                *left = left.saturating_sub(1);
            }
            while timer.wait().is_err() {}
        }
        rprintln!("{} blows, state {:016x}", cradle.impacts, cradle.hash());
        tally.print("four seconds", cycles.mhz());
    }
}
