//! A screenshot, and what is to be seen in it.

use anyhow::{Result, bail};
use std::io::Cursor;
use std::path::Path;

pub struct Picture {
    file: Vec<u8>,
    pub width: usize,
    pub height: usize,
    pixels: Vec<[u8; 3]>,
}

impl Picture {
    pub fn decode(file: Vec<u8>) -> Result<Self> {
        let mut reader = png::Decoder::new(Cursor::new(&file)).read_info()?;
        let (width, height) = (reader.info().width as usize, reader.info().height as usize);
        let channels = reader.info().color_type.samples();
        if channels < 3 {
            bail!("a screenshot without colours");
        }
        let mut bytes = vec![0; reader.output_buffer_size().unwrap_or(0)];
        reader.next_frame(&mut bytes)?;
        let pixels = bytes.chunks_exact(channels).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        Ok(Self { file, width, height, pixels })
    }

    pub fn save(&self, path: &Path) -> Result<()> {
        Ok(std::fs::write(path, &self.file)?)
    }

    pub fn at(&self, [x, y]: [f64; 2]) -> [u8; 3] {
        let column = (x.max(0.0) as usize).min(self.width - 1);
        self.pixels[(y.max(0.0) as usize).min(self.height - 1) * self.width + column]
    }

    /// How many pixels of a box satisfy `wanted`, and the middle of them.
    pub fn find(&self, [left, top, right, bottom]: [f64; 4], wanted: impl Fn([u8; 3]) -> bool) -> (usize, [f64; 2]) {
        let (mut count, mut sum) = (0, [0.0; 2]);
        for row in top as usize..(bottom as usize).min(self.height) {
            for column in left as usize..(right as usize).min(self.width) {
                if wanted(self.pixels[row * self.width + column]) {
                    count += 1;
                    sum = [sum[0] + column as f64 + 0.5, sum[1] + row as f64 + 0.5];
                }
            }
        }
        (count, sum.map(|sum| sum / count.max(1) as f64))
    }

    /// How many colours there are.
    pub fn colours(&self) -> usize {
        let mut colours = self.pixels.clone();
        colours.sort_unstable();
        colours.dedup();
        colours.len()
    }

    /// The part of pixels in which two pictures differ visibly.
    pub fn difference(&self, other: &Self) -> f64 {
        let differs = |(a, b): &(&[u8; 3], &[u8; 3])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 8);
        self.pixels.iter().zip(&other.pixels).filter(differs).count() as f64 / self.pixels.len().max(1) as f64
    }
}
