//! carom's values in a log: defmt's format, over semihosting.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod scene;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("this is a firmware: `cargo xtask test --only interop` runs it and decodes its log");
}

#[cfg(target_os = "none")]
#[cortex_m_rt::entry]
fn main() -> ! {
    // The log's channel, and the critical section that it works in.
    use {cortex_m as _, defmt_semihosting as _};
    let logged = log();
    semihosting::process::exit(if logged.is_some() { 0 } else { 1 })
}

#[cfg(target_os = "none")]
fn log() -> Option<()> {
    let scene::Values { mass, material, contact, impact, ground, cuboid } = scene::values()?;
    defmt::info!("{}", mass);
    defmt::info!("{}", material);
    defmt::info!("{}", contact);
    defmt::info!("{}", impact);
    defmt::info!("{} {}", ground, cuboid);
    defmt::error!("{} / {}", carom::ShapeError::Radius, carom::SolidError::Radius);
    defmt::error!("{} / {}", carom::OrientationError::NotUnit, carom::HandleError::Stale);
    scene::throw(|moment| {
        defmt::info!("{}", moment.body);
        if let Some(touching) = moment.touching {
            defmt::info!("{}", touching);
        }
        defmt::debug!("{} state {}", moment.report, moment.hash);
    })
}

#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    semihosting::process::exit(2)
}
