//! The kind of a file by its first bytes, whatever its name.

use super::error::MeshError;
use super::format::Format;
use super::text::BYTE_ORDER_MARK;

/// Number of first bytes that a file is recognised by.
pub(super) const START: usize = 1024;

/// A kind of content.
struct Content {
    name: &'static str,
    /// The format, if it is one that is read.
    format: Option<Format>,
    remedy: &'static str,
    is_it: fn(&[u8]) -> bool,
}

const DOWNLOAD: &str = "download the file itself, not the page that shows it";
const EXPORT: &str = "export the mesh as .obj, .ply, .off or .stl";
const UNPACK: &str = "unpack it first";

const CONTENTS: [Content; 15] = [
    Content {
        name: "a PLY file",
        format: Some(Format::Ply),
        remedy: "give it the ending .ply",
        is_it: |start| first_word(start) == b"ply" && start.starts_with(b"ply"),
    },
    Content {
        name: "an OFF file",
        format: Some(Format::Off),
        remedy: "give it the ending .off",
        is_it: |start| {
            let word = first_word_after_comments(start);
            word.ends_with(b"OFF") || word.eq_ignore_ascii_case(b"off")
        },
    },
    Content {
        name: "an STL file",
        format: Some(Format::Stl),
        remedy: "give it the ending .stl",
        is_it: is_text_stl,
    },
    Content {
        name: "a gzip file within a gzip file",
        format: None,
        remedy: "unpack it once",
        is_it: |start| start.starts_with(b"\x1f\x8b\x08"),
    },
    Content {
        name: "a zip archive",
        format: None,
        remedy: UNPACK,
        is_it: |start| start.starts_with(b"PK\x03\x04"),
    },
    Content {
        name: "a bzip2 file",
        format: None,
        remedy: UNPACK,
        is_it: |start| start.starts_with(b"BZh") && start.get(4..7) == Some(b"1AY"),
    },
    Content {
        name: "an xz file",
        format: None,
        remedy: UNPACK,
        is_it: |start| start.starts_with(b"\xfd7zXZ\0"),
    },
    Content {
        name: "a zstd file",
        format: None,
        remedy: UNPACK,
        is_it: |start| start.starts_with(b"\x28\xb5\x2f\xfd"),
    },
    Content {
        name: "a 7z archive",
        format: None,
        remedy: UNPACK,
        is_it: |start| start.starts_with(b"7z\xbc\xaf\x27\x1c"),
    },
    Content {
        name: "an HTML page",
        format: None,
        remedy: DOWNLOAD,
        is_it: |start| has_tag(start, "<!doctype html") || has_tag(start, "<html"),
    },
    Content {
        name: "an XML file",
        format: None,
        remedy: EXPORT,
        is_it: |start| has_tag(start, "<?xml"),
    },
    Content {
        name: "a git-lfs pointer, not the mesh",
        format: None,
        remedy: "fetch the mesh with 'git lfs pull'",
        is_it: |start| start.starts_with(b"version https://git-lfs.github.com/"),
    },
    Content {
        name: "a binary glTF file",
        format: None,
        remedy: EXPORT,
        is_it: |start| start.starts_with(b"glTF"),
    },
    Content {
        name: "a binary FBX file",
        format: None,
        remedy: EXPORT,
        is_it: |start| start.starts_with(b"Kaydara FBX Binary"),
    },
    Content {
        name: "an OBJ file",
        format: Some(Format::Obj),
        remedy: "give it the ending .obj",
        is_it: |start| {
            let word = first_word_after_comments(start);
            [&b"v"[..], b"vt", b"vn", b"mtllib", b"usemtl", b"o", b"g"].contains(&word)
        },
    },
];

/// Returns the error that the content is not of `format`, if the first bytes prove that.
pub(super) fn foreign_to(format: Format, start: &[u8]) -> Option<MeshError> {
    let content = recognise(start).filter(|content| content.format != Some(format))?;
    Some(MeshError::Foreign { content: content.name, remedy: content.remedy })
}

/// Returns the error that an OBJ file without faces is no text, if it is none.
pub(super) fn binary(start: &[u8]) -> Option<MeshError> {
    let content = "binary data, no text";
    start.contains(&0).then_some(MeshError::Foreign { content, remedy: EXPORT })
}

/// Returns the format of a file without a name: OBJ where nothing says otherwise.
pub(super) fn guess_format(start: &[u8]) -> Format {
    let start = without_mark(start);
    match recognise(start) {
        Some(content) => content.format.unwrap_or(Format::Obj),
        None if start.contains(&0) => Format::Stl,
        None if first_word_after_comments(start).first().is_some_and(u8::is_ascii_digit) => {
            Format::Off
        }
        None => Format::Obj,
    }
}

fn recognise(start: &[u8]) -> Option<&'static Content> {
    let start = without_mark(start);
    CONTENTS.iter().find(|content| (content.is_it)(start))
}

fn without_mark(start: &[u8]) -> &[u8] {
    start.strip_prefix(BYTE_ORDER_MARK).unwrap_or(start)
}

/// Returns the first word of the first line that is neither empty nor a comment.
fn first_word_after_comments(start: &[u8]) -> &[u8] {
    let lines = start.split(|byte| matches!(byte, b'\n' | b'\r'));
    lines.map(first_word).find(|word| !word.is_empty() && word[0] != b'#').unwrap_or_default()
}

fn first_word(text: &[u8]) -> &[u8] {
    let text = text.trim_ascii_start();
    &text[..text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len())]
}

/// Returns whether the text begins with `solid` and has a facet or the end of the solid.
pub(super) fn is_text_stl(start: &[u8]) -> bool {
    let has = |word: &str| memchr::memmem::find(start, word.as_bytes()).is_some();
    first_word(start).eq_ignore_ascii_case(b"solid")
        && ["facet", "FACET", "Facet", "end", "END"].into_iter().any(has)
}

/// Returns whether the text begins with `tag`, in letters of either case.
fn has_tag(start: &[u8], tag: &str) -> bool {
    let start = start.trim_ascii_start();
    start.get(..tag.len()).is_some_and(|first| first.eq_ignore_ascii_case(tag.as_bytes()))
}
