//! Serialisation of values: what goes out is plain data, and what comes in passes the constructors' checks.
//!
//! Types without invariants have their derives where they are defined.

mod bodies;
#[cfg(feature = "fixed")]
mod fixed;
mod geometry;
mod mass;

/// A type goes out as its `data`, and comes in through `TryFrom` of that; the bounds are on the numbers in it.
macro_rules! as_data {
    ($type:ident as $data:ty: $($number:ty),+) => {
        impl<S: $crate::scalar::Scalar> ::serde::Serialize for $type<S>
        where
            $($number: ::serde::Serialize),+
        {
            fn serialize<Out: ::serde::Serializer>(&self, serializer: Out) -> Result<Out::Ok, Out::Error> {
                ::serde::Serialize::serialize(&<$data>::from(*self), serializer)
            }
        }

        impl<'de, S: $crate::scalar::Scalar> ::serde::Deserialize<'de> for $type<S>
        where
            $($number: ::serde::Deserialize<'de>),+
        {
            fn deserialize<In: ::serde::Deserializer<'de>>(deserializer: In) -> Result<Self, In::Error> {
                let data = <$data as ::serde::Deserialize>::deserialize(deserializer)?;
                $type::try_from(data).map_err(::serde::de::Error::custom)
            }
        }
    };
}

use as_data;
