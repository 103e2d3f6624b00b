//! `cargo xtask draw`: the frame that the example `drawing` writes for a display, as a picture.

use crate::boards::{Board, Scalar};
use crate::view::{self, Progress};
use crate::workspace;
use anyhow::{Context, Result, bail};
use std::fs::File;
use std::io::BufReader;
use std::path::{Path, PathBuf};

pub const EXAMPLE: &str = "drawing";
/// Pixels of the display, across and down.
const SIDE: u32 = 240;

/// The picture of the documentation, and the number type in which it is drawn.
pub const PICTURE: &str = "docs/drawing.png";
pub const SHOWN: Scalar = Scalar::I12F20;

/// What to draw, and where.
#[derive(clap::Args)]
pub struct Options {
    /// Draw on this board in QEMU; without it, on this machine
    #[arg(long, value_parser = Board::cortex_m())]
    board: Option<Board>,
    /// The number type
    #[arg(long, default_value_t = SHOWN)]
    scalar: Scalar,
    /// Where the picture goes [default: target/view/drawing.png]
    #[arg(long, value_name = "FILE")]
    png: Option<PathBuf>,
    /// Install what is missing without asking
    #[arg(long)]
    yes: bool,
}

/// Draws, and writes the picture.
pub fn run(options: &Options) -> Result<()> {
    let usual = || workspace::target_dir().join("view").join("drawing.png");
    let path = std::path::absolute(options.png.clone().unwrap_or_else(usual))?;
    std::env::set_current_dir(workspace::root())?;
    let frame = frame(options.board, options.scalar, options.yes)?;
    view::save(&path, &png(&frame)?)?;
    println!("{}", path.display());
    Ok(())
}

/// What the example writes, on a board or on this machine. To be called in the root of the repository.
pub fn frame(place: Option<Board>, scalar: Scalar, yes: bool) -> Result<Vec<u8>> {
    let options = view::Options::new(EXAMPLE, place, scalar, yes);
    let frame = view::record(&options, "--frame", place, scalar, &Progress::new(3))?;
    if frame.len() != (SIDE * SIDE * 2) as usize {
        bail!("the frame has {} bytes", frame.len());
    }
    Ok(frame)
}

/// Row and column of the pixel that a byte of a frame belongs to.
pub const fn place(byte: usize) -> [usize; 2] {
    let pixel = byte / 2;
    [pixel / SIDE as usize, pixel % SIDE as usize]
}

/// Red, green and blue of each pixel, eight bits each, from RGB565.
pub fn colours(frame: &[u8]) -> Vec<u8> {
    let pixels = frame.chunks_exact(2).map(|bytes| u16::from_be_bytes([bytes[0], bytes[1]]));
    let widened = |part: u16, bits: u32| (part << (8 - bits) | part >> (2 * bits - 8)) as u8;
    pixels.flat_map(|p| [widened(p >> 11, 5), widened(p >> 5 & 63, 6), widened(p & 31, 5)]).collect()
}

fn png(frame: &[u8]) -> Result<Vec<u8>> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, SIDE, SIDE);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.write_header()?.write_image_data(&colours(frame))?;
    Ok(file)
}

/// Red, green and blue of each pixel of a picture.
pub fn read_png(path: &Path) -> Result<Vec<u8>> {
    let file = File::open(path).with_context(|| format!("opening {}", path.display()))?;
    let mut reader = png::Decoder::new(BufReader::new(file)).read_info()?;
    let mut pixels = vec![0; reader.output_buffer_size().context("too large a picture")?];
    let info = reader.next_frame(&mut pixels)?;
    if (info.color_type, info.bit_depth) != (png::ColorType::Rgb, png::BitDepth::Eight) {
        bail!("{} has no eight bits of red, green and blue", path.display());
    }
    Ok(pixels)
}

#[cfg(test)]
mod tests {
    use super::colours;

    #[test]
    fn colours_reach_from_end_to_end() {
        let bytes = [0xffff, 0, 31 << 11, 63 << 5, 31, 16 << 11 | 32 << 5 | 16u16].map(u16::to_be_bytes).concat();
        let expected = [[255; 3], [0; 3], [255, 0, 0], [0, 255, 0], [0, 0, 255], [132, 130, 132]];
        assert_eq!(colours(&bytes), expected.concat());
    }
}
