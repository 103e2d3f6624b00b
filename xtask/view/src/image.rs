//! PNG and GIF files of the replay.

use crate::raster;
use crate::replay::Replay;
use anyhow::{Context, Result};
use std::collections::HashMap;

/// Frames of a GIF in a second: its clock counts hundredths.
const RATE: f32 = 25.0;
/// Shorter than that, in seconds, no GIF is.
const SHORTEST: f32 = 3.0;
/// How long the last one stays, in hundredths of a second.
const REST: u16 = 160;
/// Colours of a GIF; one place is for what stays as it was.
const COLOURS: usize = 255;
const SAME: u8 = COLOURS as u8;

/// What kind of picture.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    pub width: usize,
    pub height: usize,
    /// More than one shows less, larger.
    pub closer: f32,
}

/// A picture of a frame, with red, green and blue for each pixel.
pub fn picture(replay: &Replay, index: usize, size: Size) -> Vec<[u8; 3]> {
    raster::frame(replay, index, [size.width, size.height], 3, size.closer)
}

/// A PNG file of a frame.
pub fn png(replay: &Replay, index: usize, size: Size) -> Result<Vec<u8>> {
    let pixels = picture(replay, index, size).concat();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, size.width as u32, size.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.write_header()?.write_image_data(&pixels)?;
    Ok(file)
}

/// A GIF file of the whole; calls `progress` with how much is done and how much there is.
pub fn gif(replay: &Replay, size: Size, mut progress: impl FnMut(usize, usize)) -> Result<Vec<u8>> {
    let end = replay.times.last().copied().context("the replay is empty")?;
    // What is over soon is shown slowly.
    let speed = (end / SHORTEST).min(1.0);
    let count = (end / speed * RATE) as usize + 1;
    let at = |time: f32| replay.times.partition_point(|other| *other < time - 1e-4).min(replay.len() - 1);
    let pictures: Vec<Vec<[u8; 3]>> = (0..=count)
        .map(|number| {
            progress(number, count);
            picture(replay, if number == count { replay.len() - 1 } else { at(number as f32 / RATE * speed) }, size)
        })
        .collect();
    let palette = Palette::of(&pictures);
    let (width, height) = (size.width as u16, size.height as u16);
    let mut file = Vec::new();
    let mut encoder = gif::Encoder::new(&mut file, width, height, &palette.colours.concat())?;
    encoder.set_repeat(gif::Repeat::Infinite)?;
    let mut before: Vec<u8> = Vec::new();
    for (number, picture) in pictures.iter().enumerate() {
        let now: Vec<u8> = picture.iter().map(|colour| palette.index(*colour)).collect();
        let changed: Vec<u8> = if before.is_empty() {
            now.clone()
        } else {
            now.iter().zip(&before).map(|(new, old)| if new == old { SAME } else { *new }).collect()
        };
        let delay = if number == count { REST } else { (100.0 / RATE) as u16 };
        let transparent = Some(SAME);
        encoder.write_frame(&gif::Frame {
            width,
            height,
            delay,
            transparent,
            buffer: changed.into(),
            ..Default::default()
        })?;
        before = now;
    }
    drop(encoder);
    Ok(file)
}

/// The colours that all pictures share.
struct Palette {
    colours: Vec<[u8; 3]>,
    /// By the upper six bits of each part.
    nearest: Vec<u8>,
}

const BITS: u32 = 6;

fn cell(colour: [u8; 3]) -> usize {
    colour.iter().fold(0, |cell, part| cell << BITS | usize::from(part >> (8 - BITS)))
}

impl Palette {
    /// Median cut: the box of colours with the most in it is cut in half, until there are enough.
    fn of(pictures: &[Vec<[u8; 3]>]) -> Self {
        let mut counts: HashMap<usize, (u64, [u64; 3])> = HashMap::new();
        for colour in pictures.iter().flatten() {
            let (count, sum) = counts.entry(cell(*colour)).or_default();
            *count += 1;
            sum.iter_mut().zip(colour).for_each(|(sum, part)| *sum += u64::from(*part));
        }
        let mut entries: Vec<Entry> = counts
            .into_values()
            .map(|(count, sum)| Entry {
                colour: sum.map(|part| part as f32 / count as f32),
                weight: (count as f32).sqrt(),
            })
            .collect();
        // Hash maps have an order of their own each time.
        entries.sort_by(|a, b| a.colour.partial_cmp(&b.colour).unwrap_or(std::cmp::Ordering::Equal));
        let mut boxes = vec![entries];
        while boxes.len() < COLOURS {
            let widest = (0..boxes.len()).filter(|one| boxes[*one].len() > 1);
            let Some(place) = widest.max_by(|a, b| error(&boxes[*a]).total_cmp(&error(&boxes[*b]))) else { break };
            let (low, high) = halves(std::mem::take(&mut boxes[place]));
            boxes[place] = low;
            boxes.push(high);
        }
        let mut colours: Vec<[u8; 3]> = boxes.iter().map(|one| mean(one).map(|part| (part + 0.5) as u8)).collect();
        colours.resize(COLOURS + 1, [0; 3]);
        let used = boxes.len();
        let nearest = (0..1usize << (3 * BITS))
            .map(|cell| {
                let part = |shift: u32| ((cell >> shift & 63) << 2 | 2) as i32;
                let wanted = [part(2 * BITS), part(BITS), part(0)];
                let far =
                    |colour: &[u8; 3]| (0..3).map(|axis| (i32::from(colour[axis]) - wanted[axis]).pow(2)).sum::<i32>();
                (0..used).min_by_key(|index| far(&colours[*index])).unwrap_or(0) as u8
            })
            .collect();
        Self { colours, nearest }
    }

    fn index(&self, colour: [u8; 3]) -> u8 {
        self.nearest[cell(colour)]
    }
}

struct Entry {
    colour: [f32; 3],
    weight: f32,
}

fn mean(entries: &[Entry]) -> [f32; 3] {
    let weight: f32 = entries.iter().map(|entry| entry.weight).sum();
    std::array::from_fn(|axis| entries.iter().map(|entry| entry.colour[axis] * entry.weight).sum::<f32>() / weight)
}

/// How far the colours of a box are from their mean along each axis, weighed.
fn spread(entries: &[Entry]) -> [f32; 3] {
    let mean = mean(entries);
    std::array::from_fn(|axis| {
        entries.iter().map(|entry| (entry.colour[axis] - mean[axis]).powi(2) * entry.weight).sum()
    })
}

fn error(entries: &[Entry]) -> f32 {
    spread(entries).iter().sum()
}

/// Cut at the mean of the axis along which they are spread most.
fn halves(entries: Vec<Entry>) -> (Vec<Entry>, Vec<Entry>) {
    let (spread, mean) = (spread(&entries), mean(&entries));
    let axis = (0..3).max_by(|a, b| spread[*a].total_cmp(&spread[*b])).unwrap_or(0);
    entries.into_iter().partition(|entry| entry.colour[axis] < mean[axis])
}
