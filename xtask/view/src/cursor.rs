//! Numbers out of the bytes of a trace.

use anyhow::{Context, Result, bail};

/// How the numbers of a trace are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 32 bits, of which so many are behind the point.
    Fixed(u32),
    F32,
    F64,
}

/// Reads from the front.
pub struct Cursor<'a> {
    bytes: &'a [u8],
    length: usize,
    pub format: Format,
}

impl<'a> Cursor<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, length: bytes.len(), format: Format::F64 }
    }

    /// How far it has come.
    pub fn place(&self) -> usize {
        self.length - self.bytes.len()
    }

    pub fn is_at_end(&self) -> bool {
        self.bytes.is_empty()
    }

    pub fn take(&mut self, count: usize) -> Result<&'a [u8]> {
        let place = self.place();
        let (taken, rest) = self
            .bytes
            .split_at_checked(count)
            .with_context(|| format!("the trace is cut off at byte {place}: was the run stopped?"))?;
        self.bytes = rest;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N]> {
        Ok(self.take(N)?.try_into()?)
    }

    pub fn u8(&mut self) -> Result<u8> {
        Ok(u8::from_le_bytes(self.array()?))
    }

    pub fn u16(&mut self) -> Result<u16> {
        Ok(u16::from_le_bytes(self.array()?))
    }

    pub fn i16(&mut self) -> Result<i16> {
        Ok(i16::from_le_bytes(self.array()?))
    }

    pub fn u32(&mut self) -> Result<u32> {
        Ok(u32::from_le_bytes(self.array()?))
    }

    fn number(&mut self, format: Format) -> Result<f64> {
        let x = match format {
            Format::Fixed(bits) => f64::from(i32::from_le_bytes(self.array()?)) * 0.5f64.powi(bits as i32),
            Format::F32 => f64::from(f32::from_le_bytes(self.array()?)),
            Format::F64 => f64::from_le_bytes(self.array()?),
        };
        if !x.is_finite() {
            bail!("a number at byte {} is not finite", self.place());
        }
        Ok(x)
    }

    /// A number of the format: exact, since every one of them is a double.
    pub fn word(&mut self) -> Result<f64> {
        self.number(self.format)
    }

    /// A component of a direction or rotation: 30 bits behind the point in fixed point.
    pub fn unit(&mut self) -> Result<f64> {
        self.number(if let Format::Fixed(_) = self.format { Format::Fixed(30) } else { self.format })
    }

    pub fn vector(&mut self) -> Result<[f64; 3]> {
        Ok([self.word()?, self.word()?, self.word()?])
    }

    /// A number with an exponent of its own.
    pub fn scaled(&mut self) -> Result<f64> {
        let exponent = self.i16()?;
        Ok(self.unit()? * 2f64.powi(i32::from(exponent)))
    }
}
