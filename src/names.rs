//! Names of algorithms and the like: written, read back, and refused with the names there are.

/// A name that no item of its kind has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{name:?} is no {kind}; use one of: {}", known.join(", "))]
#[non_exhaustive]
pub struct UnknownNameError {
    /// The kind of item, in words.
    pub kind: &'static str,
    /// The name.
    pub name: String,
    /// The names that items of this kind have.
    pub known: Vec<&'static str>,
}

/// Returns the item of `all` that has this name.
///
/// # Errors
/// No item has it.
pub(crate) fn find<T: Copy>(
    kind: &'static str,
    all: &[T],
    id: fn(T) -> &'static str,
    name: &str,
) -> Result<T, UnknownNameError> {
    all.iter().copied().find(|&item| id(item) == name).ok_or_else(|| UnknownNameError {
        kind,
        name: name.to_owned(),
        known: all.iter().map(|&item| id(item)).collect(),
    })
}

/// Implements `Display`, `FromStr` and, with the feature `serde`, serialisation as a string for a
/// type whose items, `ALL` of them, have names.
macro_rules! named {
    ($name:ty, $kind:literal, $id:ident) => {
        impl std::str::FromStr for $name {
            type Err = $crate::UnknownNameError;

            fn from_str(name: &str) -> Result<Self, Self::Err> {
                $crate::names::find($kind, &Self::ALL, Self::$id, name)
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.$id())
            }
        }

        $crate::names::serde_as_string!($name);
    };
}

/// Implements serialisation by `Display` and `FromStr`, with the feature `serde`.
macro_rules! serde_as_string {
    ($name:ty) => {
        #[cfg(feature = "serde")]
        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_str(self)
            }
        }

        #[cfg(feature = "serde")]
        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                let name = <std::borrow::Cow<'de, str>>::deserialize(from)?;
                name.parse().map_err(serde::de::Error::custom)
            }
        }
    };
}

pub(crate) use {named, serde_as_string};

#[cfg(test)]
mod tests {
    use crate::triangulation::Law;
    use crate::{Algorithm, Augmentation, Expansion};

    #[test]
    fn names_fill_the_width_of_their_column() {
        assert_eq!(format!("{:>8}|", Algorithm::Velho), "   velho|");
        let variant = Algorithm::Lrs(Expansion::FewFlips);
        assert_eq!(format!("{variant:<15}|"), "lrs few-flips  |");
        assert_eq!(
            format!("{:>8}|{:<9}|", Augmentation::Local, Expansion::Printed),
            "   local|printed  |"
        );
        assert_eq!(format!("{:^14}|", Law::OneFan), " several-fans |");
    }
}
