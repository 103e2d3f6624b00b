//! Dice on a Raspberry Pi Pico 2: thrown in time with its timer, the LED lights up where they strike.
#![no_std]
#![no_main]

use carom_boards::cycles::Cycles;
use carom_boards::{bits, costs, throws};
use hal::block::ImageDef;
use hal::clocks::init_clocks_and_plls;
use hal::gpio::Pins;
use hal::pac;
use hal::{Clock, Sio, Timer, Watchdog};
use panic_rtt_target as _;
use rp235x_hal as hal;

/// The board's crystal, Hz.
const CRYSTAL: u32 = 12_000_000;

// SAFETY: the section that the linker script keeps where the ROM looks for it.
#[unsafe(link_section = ".start_block")]
#[used]
static IMAGE: ImageDef = ImageDef::secure_exe();

#[hal::entry]
fn main() -> ! {
    rtt_target::rtt_init_print!();
    let (core, mut chip) = (cortex_m::Peripherals::take().unwrap(), pac::Peripherals::take().unwrap());
    let mut watchdog = Watchdog::new(chip.WATCHDOG);
    let clocks = init_clocks_and_plls(
        CRYSTAL,
        chip.XOSC,
        chip.CLOCKS,
        chip.PLL_SYS,
        chip.PLL_USB,
        &mut chip.RESETS,
        &mut watchdog,
    );
    let clocks = clocks.ok().unwrap();
    let timer = Timer::new_timer0(chip.TIMER0, &mut chip.RESETS, &clocks);
    let sio = Sio::new(chip.SIO);
    let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0, &mut chip.RESETS);
    let mut led = pins.gpio25.into_push_pull_output();

    let mut cycles = Cycles::new(core.SYST, clocks.system_clock.freq().to_MHz());
    bits::print();
    costs::print(&mut cycles);
    throws::run(&mut led, &mut cycles, || timer.get_counter().ticks())
}
