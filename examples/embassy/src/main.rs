//! A hundred steps a second in a task of Embassy, at the beat of SysTick; another task prints what it sends.
#![no_std]
#![no_main]

#[path = "../../tasks/scene.rs"]
mod scene;

use core::sync::atomic::{AtomicU32, Ordering};
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_semihosting::{debug, hprintln};
use embassy_executor::Spawner;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::channel::Channel;
use embassy_sync::signal::Signal;
use scene::{Drop, Frame, RATE, Room, STEPS, chained, straight};
use static_cell::ConstStaticCell;

/// The clock of SysTick on the board, Hz.
const CLOCK: u32 = 25_000_000;

static WORLD: ConstStaticCell<Room> = ConstStaticCell::new(Room::new());
static REFERENCE: ConstStaticCell<Room> = ConstStaticCell::new(Room::new());
/// It is time for a step.
static BEAT: Signal<CriticalSectionRawMutex, ()> = Signal::new();
static BEATS: AtomicU32 = AtomicU32::new(0);
/// `None` is the end.
static FRAMES: Channel<CriticalSectionRawMutex, Option<Frame>, 4> = Channel::new();

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

#[cortex_m_rt::exception]
fn SysTick() {
    BEATS.store(BEATS.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
    BEAT.signal(());
}

#[embassy_executor::main]
async fn main(spawner: Spawner) {
    let (Some(mut core), Some(drop)) = (cortex_m::Peripherals::take(), Drop::new(WORLD.take())) else {
        return end(false);
    };
    let (Ok(physics), Ok(telemetry)) = (physics(drop), telemetry(REFERENCE.take())) else { return end(false) };
    core.SYST.set_clock_source(SystClkSource::Core);
    core.SYST.set_reload(CLOCK / u32::from(RATE) - 1);
    core.SYST.clear_current();
    core.SYST.enable_counter();
    core.SYST.enable_interrupt();
    spawner.spawn(physics);
    spawner.spawn(telemetry);
}

#[embassy_executor::task]
async fn physics(mut drop: Drop) {
    for _ in 0..STEPS {
        BEAT.wait().await;
        if let Some(frame) = drop.step() {
            // A full queue leaves a frame out; steps wait for nobody.
            let _ = FRAMES.try_send(Some(frame));
        }
    }
    FRAMES.send(None).await;
}

#[embassy_executor::task]
async fn telemetry(reference: &'static mut Room) {
    let mut run = 0;
    while let Some(frame) = FRAMES.receive().await {
        hprintln!("step {} height {} mm state {:016x}", frame.step, frame.height_mm, frame.hash);
        run = chained(run, &frame);
    }
    let beats = BEATS.load(Ordering::Relaxed);
    let same = straight(reference) == Some(run);
    // None was missed.
    let in_time = beats.abs_diff(STEPS) < 2;
    hprintln!("{} steps, none of them late: {}, the same bits as without Embassy: {}", STEPS, in_time, same);
    end(same && in_time);
}
