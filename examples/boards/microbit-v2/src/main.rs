//! A marble in a maze, on a BBC micro:bit v2: tilt the board. The LEDs show what is around the marble; the goal blinks.
#![no_std]
#![no_main]

mod view;

use carom_boards::cycles::{Cycles, Tally};
use carom_boards::number::Real;
use carom_boards::scenes::maze::{Maze, RATE, Room};
use carom_boards::{bits, costs};
use core::cell::RefCell;
use cortex_m_rt::entry;
use critical_section::Mutex;
use lsm303agr::{AccelMode, AccelOutputDataRate, Lsm303agr};
use microbit::Board;
use microbit::display::nonblocking::{Display, GreyscaleImage};
use microbit::hal::{Timer, twim};
use microbit::pac::{self, TIMER1, interrupt, twim0::frequency::FREQUENCY_A};
use panic_rtt_target as _;
use rtt_target::rprintln;

/// What the core runs at, MHz.
const CORE: u32 = 64;
/// Microseconds from step to step.
const STEP: u32 = 1_000_000 / RATE as u32;
/// Steps between two pictures.
const PICTURE: u32 = 4;

static DISPLAY: Mutex<RefCell<Option<Display<TIMER1>>>> = Mutex::new(RefCell::new(None));

#[entry]
fn main() -> ! {
    rtt_target::rtt_init_print!();
    let board = Board::take().unwrap();
    // Flash is slower than the core.
    board.NVMC.icachecnf.write(|w| w.cacheen().enabled());
    let mut cycles = Cycles::new(board.SYST, CORE);
    bits::print();
    costs::print(&mut cycles);

    let mut delay = Timer::new(board.TIMER0);
    let wires = twim::Twim::new(board.TWIM0, board.i2c_internal.into(), FREQUENCY_A::K400);
    let mut sensor = Lsm303agr::new_with_i2c(wires);
    sensor.init().unwrap();
    sensor.set_accel_mode_and_odr(&mut delay, AccelMode::HighResolution, AccelOutputDataRate::Hz100).unwrap();
    let mut timer = delay.into_periodic();
    // It runs for ever, and round.
    timer.start(u32::MAX);
    let mut due = timer.read();
    let mut wait = || {
        due = due.wrapping_add(STEP);
        while (timer.read().wrapping_sub(due) as i32) < 0 {}
    };

    let display = Display::new(board.TIMER1, board.display_pins);
    critical_section::with(|cs| DISPLAY.replace(cs, Some(display)));
    // SAFETY: from here on the handler may run; what it needs is in place, and nobody is in a critical section.
    unsafe { pac::NVIC::unmask(pac::Interrupt::TIMER1) };

    let mut world = Room::<Real>::new();
    loop {
        let mut maze = Maze::new(&mut world).unwrap();
        let (mut steps, mut tally) = (0u32, Tally::new());
        while maze.reached.is_none() {
            // A reading that fails leaves gravity as it was.
            if let Ok(seen) = sensor.acceleration() {
                // The chip is on the back, its x to the left as one looks at the LEDs, its z away.
                let upwards = [-seen.x_mg(), seen.y_mg(), -seen.z_mg()];
                maze.tilt(upwards.map(|part| part as i16));
            }
            tally.add(cycles.of(|| maze.advance()).1);
            steps = steps.wrapping_add(1);
            if let (0, Some(marble)) = (steps % PICTURE, maze.marble()) {
                show(&view::around([marble.x, marble.y], steps & 32 == 0));
            }
            wait();
        }
        rprintln!("the goal after {} ms, state {:016x}", steps * 1000 / u32::from(RATE), maze.hash());
        tally.print("this game", cycles.mhz());
        show(&view::SMILE);
        for _ in 0..2 * RATE {
            wait();
        }
    }
}

fn show(image: &[[u8; 5]; 5]) {
    critical_section::with(|cs| {
        if let Some(display) = DISPLAY.borrow_ref_mut(cs).as_mut() {
            display.show(&GreyscaleImage::new(image));
        }
    });
}

#[interrupt]
fn TIMER1() {
    critical_section::with(|cs| {
        if let Some(display) = DISPLAY.borrow_ref_mut(cs).as_mut() {
            display.handle_display_event();
        }
    });
}
