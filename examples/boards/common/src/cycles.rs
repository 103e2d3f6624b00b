//! The cycles that something takes, by SysTick: of the counters that run with the core, the one that an M0+ has, too.

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// SysTick counts down from here: 24 bits, a tenth of a second at 168 MHz.
const TOP: u32 = 0x00ff_ffff;

/// The core's clock.
pub struct Cycles {
    /// What the core runs at, MHz.
    mhz: u32,
    /// Held, so that nobody else sets it.
    _timer: SYST,
}

impl Cycles {
    pub fn new(mut timer: SYST, mhz: u32) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(TOP);
        timer.clear_current();
        timer.enable_counter();
        Self { mhz, _timer: timer }
    }

    pub fn mhz(&self) -> u32 {
        self.mhz
    }

    /// What the work comes to, and the cycles it takes: below 2^24, interrupts among them included.
    pub fn of<T>(&mut self, work: impl FnOnce() -> T) -> (T, u32) {
        let before = SYST::get_current();
        let result = work();
        (result, before.wrapping_sub(SYST::get_current()) & TOP)
    }
}

/// The cycles of many steps.
pub struct Tally {
    fewest: u32,
    most: u32,
    sum: u64,
    count: u32,
}

impl Tally {
    pub const fn new() -> Self {
        Self { fewest: u32::MAX, most: 0, sum: 0, count: 0 }
    }

    pub fn add(&mut self, cycles: u32) {
        self.fewest = self.fewest.min(cycles);
        self.most = self.most.max(cycles);
        self.sum = self.sum.wrapping_add(u64::from(cycles));
        self.count = self.count.wrapping_add(1);
    }

    /// One line about them, at that many cycles a microsecond.
    pub fn print(&self, what: &str, mhz: u32) {
        let (count, mhz) = (self.count.max(1), mhz.max(1));
        let mean = (self.sum / u64::from(count)) as u32;
        let Self { fewest, most, .. } = self;
        rtt_target::rprintln!(
            "{}: {} steps, cycles each: fewest {}, mean {}, most {} ({} us)",
            what,
            self.count,
            fewest,
            mean,
            most,
            most / mhz
        );
    }
}

impl Default for Tally {
    fn default() -> Self {
        Self::new()
    }
}
