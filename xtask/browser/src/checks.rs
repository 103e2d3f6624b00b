//! What a reader does with the page, and what must come of it.

use crate::chromium::Chromium;
use crate::picture::Picture;
use crate::tab::Tab;
use anyhow::{Context, Result, bail, ensure};
use std::path::Path;
use std::time::Duration;

const MIDDLE: [f64; 2] = [0.5, 0.5];
const LIMIT: Duration = Duration::from_secs(30);
/// How far the middle of what is drawn may be from where the trace says, in pixels, of which a die has some sixty: faces that look
/// away from the light are not warm, and do not count.
const OFF: f64 = 12.0;

/// Everything, in the order in which a reader would.
pub fn all(browser: &mut Chromium, page: &Path, folder: &Path) -> Result<()> {
    let mut tab = Tab::open(browser, [1180, 1040])?;
    let url = format!("file://{}", page.display());
    tab.call("Page.navigate", serde_json::json!({ "url": url }))?;
    tab.wait("document.documentElement?.dataset.ready === 'true'", LIMIT).context("the page does not open")?;
    plays(&mut tab)?;
    scrubs(&mut tab)?;
    shows_the_trace(&mut tab, folder)?;
    orbits(&mut tab)?;
    takes_fingers(&mut tab)?;
    goes_dark(&mut tab, folder)?;
    ensure!(tab.complaints.is_empty(), "the page complains: {:#?}", tab.complaints);
    println!("  the page opens, plays, scrubs, orbits, goes dark; nothing in the console, nothing over the network");
    Ok(())
}

/// It begins by itself, stops at the button, and goes on.
fn plays(tab: &mut Tab<'_>) -> Result<()> {
    tab.wait("carom.player.playing && carom.player.at > 0", LIMIT).context("it does not begin to play")?;
    tab.click("play", MIDDLE)?;
    let stopped = tab.number("carom.player.at")?;
    std::thread::sleep(Duration::from_millis(300));
    let later = tab.number("carom.player.at")?;
    ensure!(stopped == later, "the button does not stop it: frame {stopped}, then {later}");
    tab.click("play", MIDDLE)?;
    tab.wait(&format!("carom.player.at !== {stopped}"), LIMIT).context("the button does not start it again")?;
    tab.click("play", MIDDLE)
}

/// The slider goes to the moment under the pointer, the buttons a frame back and forth, and the page says the time.
fn scrubs(tab: &mut Tab<'_>) -> Result<()> {
    let end = tab.number("carom.player.end")?;
    for part in [0.25, 0.75] {
        tab.click("scrub", [part, 0.5])?;
        let at = tab.number("carom.player.at")? / end;
        ensure!((at - part).abs() < 0.03, "a click at {part} of the slider goes to {at} of the replay");
    }
    let before = tab.number("carom.player.at")?;
    tab.click("forth", MIDDLE)?;
    let after = tab.number("carom.player.at")?;
    ensure!(after == before + 1.0, "a step forth goes from {before} to {after}");
    tab.click("back", MIDDLE)?;
    ensure!(tab.number("carom.player.at")? == before, "a step back does not take it back");
    let told = tab.number("(carom.draw(), parseFloat(document.getElementById('time').textContent))")?;
    let time = tab.number("carom.player.time")?;
    ensure!((told - time).abs() < 1e-3, "it is {time} s, and the page says {told}");
    Ok(())
}

/// The dice, and nothing else, are of a warm colour: the middle of the warm pixels is the middle of the dice.
fn shows_the_trace(tab: &mut Tab<'_>, folder: &Path) -> Result<()> {
    let end = tab.number("carom.player.end")?;
    tab.ask("carom.player.seek(0)")?;
    let first = tab.picture()?;
    ensure!(first.colours() > 200, "the picture is blank: {} colours", first.colours());
    tab.ask("document.querySelectorAll('#legend input:checked').forEach(input => input.click())")?;
    tab.ask("document.querySelectorAll('.legend, .verdict').forEach(box => box.style.visibility = 'hidden')")?;
    for part in [0.12, 0.3, 0.6, 1.0] {
        let frame = (part * end).round();
        tab.ask(&format!("carom.player.seek({frame})"))?;
        let picture = tab.picture()?;
        let [left, top] = tab.place("scene", [0.0, 0.0])?;
        let [right, bottom] = tab.place("scene", [1.0, 1.0])?;
        let warm = |[red, _, blue]: [u8; 3]| red > blue.saturating_add(5);
        let (count, seen) = picture.find([left, top, right, bottom], warm);
        let [x, y] = expected(tab, frame)?;
        let wanted = [left + x * (right - left), top + y * (bottom - top)];
        let off = f64::hypot(seen[0] - wanted[0], seen[1] - wanted[1]);
        ensure!(count > 200, "frame {frame}: the dice are not to be seen ({count} pixels)");
        ensure!(off < OFF, "frame {frame}: the dice are at {seen:?}, the trace has them at {wanted:?}");
        println!("  frame {frame}: {count} pixels of dice, {off:.1} pixels from where the trace has them");
    }
    tab.ask("document.querySelectorAll('.legend, .verdict').forEach(box => box.style.visibility = '')")?;
    tab.ask("document.querySelectorAll('#legend input').forEach(input => input.click())")?;
    tab.ask(&format!("carom.player.seek({})", (0.45 * end).round()))?;
    let light = tab.picture()?;
    light.save(&folder.join("light.png"))?;
    same_place(&first, &light)
}

/// Where the middle of the dice is in the picture, worked out from the poses with none of the page's matrices.
fn expected(tab: &mut Tab<'_>, frame: f64) -> Result<[f64; 2]> {
    let numbers = |tab: &mut Tab<'_>, expression: &str| -> Result<Vec<f64>> {
        let value = tab.ask(expression)?;
        let list = value.as_array().with_context(|| format!("`{expression}` is {value}"))?;
        Ok(list.iter().filter_map(serde_json::Value::as_f64).collect())
    };
    let view =
        numbers(tab, "[carom.camera.azimuth, carom.camera.elevation, carom.camera.distance, ...carom.camera.target]")?;
    let shape = tab.number("carom.scene.canvas.clientWidth / carom.scene.canvas.clientHeight")?;
    let places = numbers(
        tab,
        &format!("carom.replay.actors.filter(a => a.free).flatMap(a => a.poses.slice(7 * {frame}, 7 * {frame} + 3))"),
    )?;
    let &[azimuth, elevation, distance, tx, ty, tz] = &view[..] else { bail!("the camera is {view:?}") };
    let count = (places.len() / 3) as f64;
    let mut sum = [0.0; 2];
    for place in places.chunks(3) {
        let [x, y, z] = [place[0] - tx, place[1] - ty, place[2] - tz];
        // Turned so that the camera looks along, then tilted.
        let (along, across) = (x * azimuth.cos() + y * azimuth.sin(), y * azimuth.cos() - x * azimuth.sin());
        let depth = distance - along * elevation.cos() - z * elevation.sin();
        let up = z * elevation.cos() - along * elevation.sin();
        let tangent = f64::tan(0.33) * (1.7 / shape).max(1.0);
        sum[0] += (0.5 + across / (depth * tangent * shape) / 2.0) / count;
        sum[1] += (0.5 - up / (depth * tangent) / 2.0) / count;
    }
    Ok(sum)
}

fn same_place(first: &Picture, later: &Picture) -> Result<()> {
    let moved = first.difference(later);
    ensure!(moved > 0.001, "two moments look the same");
    Ok(())
}

/// Dragging goes round, the wheel comes nearer, a double click returns.
fn orbits(tab: &mut Tab<'_>) -> Result<()> {
    let before = tab.picture()?;
    let (azimuth, distance) = (tab.number("carom.camera.azimuth")?, tab.number("carom.camera.distance")?);
    let [x, y] = tab.place("scene", [0.5, 0.6])?;
    tab.mouse("mousePressed", [x, y])?;
    tab.mouse("mouseMoved", [x + 90.0, y - 20.0])?;
    tab.mouse("mouseReleased", [x + 90.0, y - 20.0])?;
    ensure!((tab.number("carom.camera.azimuth")? - azimuth).abs() > 0.1, "dragging does not turn the camera");
    let wheel = serde_json::json!({ "type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": -200 });
    tab.call("Input.dispatchMouseEvent", wheel)?;
    tab.wait(&format!("carom.camera.distance < {distance}"), LIMIT).context("the wheel does not come nearer")?;
    let turned = before.difference(&tab.picture()?);
    ensure!(turned > 0.02, "the camera has turned, and {turned} of the picture has changed");
    tab.ask("carom.camera.reset(), carom.draw()")?;
    let back = before.difference(&tab.picture()?);
    ensure!(back < 0.002, "from the same place {back} of the picture looks otherwise");
    Ok(())
}

/// One finger goes round, two come nearer.
fn takes_fingers(tab: &mut Tab<'_>) -> Result<()> {
    tab.call("Emulation.setTouchEmulationEnabled", serde_json::json!({ "enabled": true, "maxTouchPoints": 2 }))?;
    let (azimuth, distance) = (tab.number("carom.camera.azimuth")?, tab.number("carom.camera.distance")?);
    let [x, y] = tab.place("scene", MIDDLE)?;
    tab.touch("touchStart", &[[x, y]])?;
    tab.touch("touchMove", &[[x + 60.0, y]])?;
    tab.touch("touchEnd", &[])?;
    ensure!((tab.number("carom.camera.azimuth")? - azimuth).abs() > 0.1, "a finger does not turn the camera");
    tab.touch("touchStart", &[[x - 40.0, y], [x + 40.0, y]])?;
    tab.touch("touchMove", &[[x - 80.0, y], [x + 80.0, y]])?;
    tab.touch("touchEnd", &[])?;
    let nearer = tab.number("carom.camera.distance")? / distance;
    ensure!(nearer < 0.7, "two fingers that part by twice come nearer by {nearer}");
    tab.call("Emulation.setTouchEmulationEnabled", serde_json::json!({ "enabled": false }))?;
    tab.ask("carom.camera.reset(), carom.draw()").map(|_| ())
}

fn goes_dark(tab: &mut Tab<'_>, folder: &Path) -> Result<()> {
    let corner = tab.place("scene", [0.5, 0.03])?;
    let sum = |picture: &Picture| picture.at(corner).map(u32::from).iter().sum::<u32>();
    let light = sum(&tab.picture()?);
    tab.click("theme", MIDDLE)?;
    let picture = tab.picture()?;
    picture.save(&folder.join("dark.png"))?;
    let dark = sum(&picture);
    ensure!(light > 3 * dark && dark > 0, "the sky is {light} in the light and {dark} in the dark");
    Ok(())
}
