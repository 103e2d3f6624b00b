//! The intermediate numbers of fixed point.

use ::serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::scalar::{Scaled, Scaled32};

/// The parts of a [`Scaled32`].
#[derive(Serialize, Deserialize)]
#[serde(rename = "Scaled32")]
struct Parts {
    mantissa: i32,
    exponent: i32,
}

impl Serialize for Scaled32 {
    fn serialize<Out: Serializer>(&self, serializer: Out) -> Result<Out::Ok, Out::Error> {
        Parts { mantissa: self.mantissa(), exponent: self.exponent() }.serialize(serializer)
    }
}

/// Any parts make a number; those that are not as the arithmetic leaves them are brought into its form.
impl<'de> Deserialize<'de> for Scaled32 {
    fn deserialize<In: Deserializer<'de>>(deserializer: In) -> Result<Self, In::Error> {
        let Parts { mantissa, exponent } = Parts::deserialize(deserializer)?;
        Ok(Scaled::from_parts(mantissa, exponent.saturating_sub(30)))
    }
}
