//! The maze around the marble on five by five LEDs: two centimetres each, the marble in the middle.

use carom_boards::number::{Real, milli};
use carom_boards::scenes::maze::{GOAL, SIZE, WALLS};

/// From LED to LED in centimetres. Walls lie at multiples of twice that, so that none falls between two LEDs.
const PITCH: i32 = 2;

const MARBLE: u8 = 9;
const BLINK: u8 = 7;
const WALL: u8 = 3;

pub type Image = [[u8; 5]; 5];

pub const SMILE: Image = [[0, 0, 0, 0, 0], [0, 9, 0, 9, 0], [0, 0, 0, 0, 0], [9, 0, 0, 0, 9], [0, 9, 9, 9, 0]];

/// What is around the marble; whether the goal is lit now.
pub fn around(marble: [Real; 2], lit: bool) -> Image {
    // In centimetres from the lower left corner; the world has decimetres from the middle.
    let [x, y] = [0, 1].map(|axis: usize| (milli(marble[axis]) + 50 * SIZE[axis] + 50 * PITCH) / (100 * PITCH) * PITCH);
    let mut image = Image::default();
    for (row, dy) in image.iter_mut().zip([2, 1, 0, -1, -2]) {
        for (led, dx) in row.iter_mut().zip(-2..) {
            let place = [x + dx * PITCH, y + dy * PITCH];
            *led = match (dx, dy) {
                (0, 0) => MARBLE,
                _ if place == GOAL && lit => BLINK,
                _ if is_wall(place) => WALL,
                _ => 0,
            };
        }
    }
    image
}

fn is_wall([x, y]: [i32; 2]) -> bool {
    let outside = x <= 0 || y <= 0 || x >= SIZE[0] || y >= SIZE[1];
    outside || WALLS.iter().any(|&[from, to]| (from[0]..=to[0]).contains(&x) && (from[1]..=to[1]).contains(&y))
}
