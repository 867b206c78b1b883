//! The header of a PLY file: the encoding, and which records follow.

use std::collections::HashSet;

use crate::mesh::error::MeshError;
use crate::mesh::tokens::{self, Tokens};

#[derive(Clone, Copy)]
pub(super) enum Encoding {
    Ascii,
    Little,
    Big,
}

impl Encoding {
    fn named(word: &[u8]) -> Option<Self> {
        match word {
            b"ascii" => Some(Self::Ascii),
            b"binary_little_endian" => Some(Self::Little),
            b"binary_big_endian" => Some(Self::Big),
            _ => None,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn named(word: &[u8]) -> Option<Self> {
        match word {
            b"char" | b"int8" => Some(Self::I8),
            b"uchar" | b"uint8" => Some(Self::U8),
            b"short" | b"int16" => Some(Self::I16),
            b"ushort" | b"uint16" => Some(Self::U16),
            b"int" | b"int32" => Some(Self::I32),
            b"uint" | b"uint32" => Some(Self::U32),
            b"float" | b"float32" => Some(Self::F32),
            b"double" | b"float64" => Some(Self::F64),
            _ => None,
        }
    }

    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

#[derive(Clone, Copy)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
}

impl Property {
    /// Reads a header line behind the word `property`.
    pub(super) fn read(tokens: &mut Tokens) -> Result<Self, MeshError> {
        let scalar = |tokens: &mut Tokens| tokens.read_in_line("a type", Scalar::named);
        let first = tokens.read_in_line("a type", |word| match word {
            b"list" => Some(None),
            _ => Scalar::named(word).map(Some),
        })?;
        let kind = match first {
            Some(kind) => Kind::Scalar(kind),
            None => Kind::List { count: scalar(tokens)?, item: scalar(tokens)? },
        };
        Ok(Self { name: tokens.read_in_line("a property name", text)?, kind })
    }
}

pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) properties: Vec<Property>,
}

impl Element {
    /// Reads a header line behind the word `element`.
    pub(super) fn read(tokens: &mut Tokens) -> Result<Self, MeshError> {
        let name = tokens.read_in_line("an element name", text)?;
        let count = tokens.read_in_line("a number of elements", tokens::count)?;
        Ok(Self { name, count, properties: Vec::new() })
    }

    /// Returns the coordinate that a property of `vertex` is.
    pub(super) fn axis(&self, property: &Property) -> Option<usize> {
        let is_scalar = matches!(property.kind, Kind::Scalar(_));
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == property.name);
        axis.filter(|_| is_scalar && self.name == "vertex")
    }

    /// Returns whether a property of `face` or `tristrips` is the list of corners.
    pub(super) fn is_corners(&self, property: &Property) -> bool {
        ["face", "tristrips"].contains(&self.name.as_str())
            && matches!(property.kind, Kind::List { .. })
            && ["vertex_indices", "vertex_index"].contains(&property.name.as_str())
    }

    /// Returns for each property whether it is the list of corners, and its kind.
    pub(super) fn plan(&self) -> Vec<(bool, Kind)> {
        self.properties.iter().map(|property| (self.is_corners(property), property.kind)).collect()
    }

    /// Returns the common type of the coordinates of a `vertex` and their places in a record.
    ///
    /// Returns none unless there is such a type and all records have the same size.
    pub(super) fn layout(&self) -> Option<(Scalar, Layout)> {
        let (mut size, mut coordinates) = (0, [None; 3]);
        for property in &self.properties {
            let Kind::Scalar(kind) = property.kind else { return None };
            if let Some(axis) = self.axis(property) {
                coordinates[axis] = Some((kind, size));
            }
            size += kind.size();
        }
        let [(x, at_x), (y, at_y), (z, at_z)] = [coordinates[0]?, coordinates[1]?, coordinates[2]?];
        let layout = Layout { size, coordinates: [at_x, at_y, at_z] };
        (x == y && y == z).then_some((x, layout))
    }

    /// Checks that a `vertex` or `face` has what makes it one, once.
    fn check(&self) -> Result<(), String> {
        let amount = |name: &str, matches: &dyn Fn(&Property) -> bool| match self
            .properties
            .iter()
            .filter(|property| matches(property))
            .count()
        {
            0 => Err(format!("element {} has no {name}", self.name)),
            1 => Ok(()),
            _ => Err(format!("element {} has more than one {name}", self.name)),
        };
        match self.name.as_str() {
            "vertex" => ["x", "y", "z"].iter().enumerate().try_for_each(|(axis, name)| {
                amount(&format!("number {name}"), &|property| self.axis(property) == Some(axis))
            }),
            "face" | "tristrips" => {
                amount("list vertex_indices", &|property| self.is_corners(property))
            }
            _ => Ok(()),
        }
    }

    /// Returns the names of what is skipped.
    pub(super) fn left_out(&self) -> Vec<String> {
        if self.count == 0 {
            return Vec::new();
        }
        if !["vertex", "face", "tristrips"].contains(&self.name.as_str()) {
            return vec![format!("element {}", self.name)];
        }
        let is_kept = |property| self.axis(property).is_some() || self.is_corners(property);
        let skipped = self.properties.iter().filter(|property| !is_kept(property));
        skipped.map(|property| format!("{} property {}", self.name, property.name)).collect()
    }
}

/// Records of equal size.
pub(super) struct Layout {
    /// Bytes of a record.
    pub(super) size: usize,
    /// Byte of a record at which each coordinate begins.
    pub(super) coordinates: [usize; 3],
}

pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
}

impl Header {
    /// Reads up to the first byte of data.
    pub(super) fn read(tokens: &mut Tokens) -> Result<Self, MeshError> {
        let first = tokens.read("'ply'", |word| (word == b"ply").then_some(()));
        first.map_err(|error| tokens.cut_off_within("ply").unwrap_or(error))?;
        let returns_alone = tokens.ends_with_return();
        let (encoding, elements) = Self::read_lines(tokens).map_err(|error| match error {
            // Half a word is wrong only because the file was cut off.
            MeshError::Malformed { .. } if tokens.rest().is_empty() => {
                tokens::truncated("end_header")
            }
            error => error,
        })?;
        let encoding = encoding.ok_or_else(|| tokens.malformed("no format line before"))?;
        if !elements.iter().any(|element| element.name == "vertex") {
            return Err(tokens.malformed("no element vertex before"));
        }
        tokens.skip_last_line(returns_alone);
        Ok(Self { encoding, elements })
    }

    /// Reads the lines up to the word `end_header`.
    fn read_lines(tokens: &mut Tokens) -> Result<(Option<Encoding>, Vec<Element>), MeshError> {
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        let mut names = HashSet::new();
        loop {
            tokens.skip_line();
            match tokens.next_word() {
                Some(b"comment" | b"obj_info") => {}
                Some(b"format") => {
                    encoding = Some(tokens.read_in_line("a PLY format", Encoding::named)?);
                }
                Some(b"element") => {
                    close_element(tokens, &elements, &mut names)?;
                    elements.push(Element::read(tokens)?);
                }
                Some(b"property") => match elements.last_mut() {
                    Some(element) => element.properties.push(Property::read(tokens)?),
                    None => return Err(tokens.malformed("a property before any element")),
                },
                Some(b"end_header") => break,
                Some(_) => return Err(tokens.unexpected("a word of a PLY header")),
                None => return Err(tokens::truncated("end_header")),
            }
        }
        close_element(tokens, &elements, &mut names)?;
        Ok((encoding, elements))
    }
}

/// Checks the last of `elements` when all its properties are known; `names` has those before it.
fn close_element(
    tokens: &Tokens,
    elements: &[Element],
    names: &mut HashSet<String>,
) -> Result<(), MeshError> {
    let Some(last) = elements.last() else { return Ok(()) };
    if !names.insert(last.name.clone()) {
        return Err(tokens.malformed(format!("a second element {} before", last.name)));
    }
    last.check().map_err(|problem| tokens.malformed(format!("{problem}; it ends here")))
}

fn text(word: &[u8]) -> Option<String> {
    Some(String::from_utf8_lossy(word).into_owned())
}
