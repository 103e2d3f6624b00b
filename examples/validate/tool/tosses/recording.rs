//! What was recorded.

use std::path::Path;

use super::super::error::Result;
use super::super::table::Table;

/// Where the cube is.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub position: [f64; 3],
    /// w, x, y, z
    pub orientation: [f64; 4],
}

/// A toss: where the cube was at each frame, and how it moved at the first.
#[derive(Clone, Debug)]
pub struct Toss {
    pub id: String,
    pub frames: Vec<Frame>,
    pub velocity: [f64; 3],
    /// In the body's frame.
    pub spin: [f64; 3],
}

/// All tosses of a file, whose rows stand together and in order.
pub fn read(file: &Path) -> Result<Vec<Toss>> {
    let mut table = Table::open(file)?;
    let [id] = table.columns(["toss"])?;
    let position = table.columns(["px", "py", "pz"])?;
    let orientation = table.columns(["qw", "qx", "qy", "qz"])?;
    let velocity = table.columns(["vx", "vy", "vz"])?;
    let spin = table.columns(["wbx", "wby", "wbz"])?;
    let mut tosses: Vec<Toss> = vec![];
    while let Some(row) = table.next_row()? {
        let frame = Frame { position: row.numbers(position)?, orientation: unit(row.numbers(orientation)?) };
        let id = row.text(id)?;
        match tosses.last_mut() {
            Some(toss) if toss.id == id => toss.frames.push(frame),
            _ => tosses.push(Toss {
                id: id.to_owned(),
                frames: vec![frame],
                velocity: row.numbers(velocity)?,
                spin: row.numbers(spin)?,
            }),
        }
    }
    Ok(tosses)
}

fn unit(q: [f64; 4]) -> [f64; 4] {
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    q.map(|x| x / length)
}
