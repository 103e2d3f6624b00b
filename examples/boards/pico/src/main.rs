//! Dice on a Raspberry Pi Pico: thrown in time with its timer, the LED lights up where they strike.
#![no_std]
#![no_main]

use carom_boards::cycles::Cycles;
use carom_boards::{bits, costs, throws};
use hal::clocks::init_clocks_and_plls;
use hal::gpio::Pins;
use hal::pac;
use hal::{Clock, Sio, Timer, Watchdog};
use panic_rtt_target as _;
use rp2040_hal as hal;

/// The board's crystal, Hz.
const CRYSTAL: u32 = 12_000_000;

// SAFETY: the section's 256 bytes, which the ROM takes for the program that sets up the flash chip of this board.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

#[hal::entry]
fn main() -> ! {
    rtt_target::rtt_init_print!();
    let (core, mut chip) = (pac::CorePeripherals::take().unwrap(), pac::Peripherals::take().unwrap());
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
    let timer = Timer::new(chip.TIMER, &mut chip.RESETS, &clocks);
    let sio = Sio::new(chip.SIO);
    let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0, &mut chip.RESETS);
    let mut led = pins.gpio25.into_push_pull_output();

    let mut cycles = Cycles::new(core.SYST, clocks.system_clock.freq().to_MHz());
    bits::print();
    costs::print(&mut cycles);
    throws::run(&mut led, &mut cycles, || timer.get_counter().ticks())
}
