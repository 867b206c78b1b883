//! Encodings of text, by their byte-order marks.

/// The mark that begins some UTF-8 texts.
pub(super) const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Returns the order of bytes in a UTF-16 text by its first bytes; none if it is no such text.
///
/// Without a mark, the first two characters must be ASCII.
pub(super) fn utf16_order(start: &[u8]) -> Option<Order> {
    match start {
        [0xff, 0xfe, ..] | [b'\t'..=b'~', 0, b'\t'..=b'~', 0, ..] => Some(Order::Little),
        [0xfe, 0xff, ..] | [0, b'\t'..=b'~', 0, b'\t'..=b'~', ..] => Some(Order::Big),
        _ => None,
    }
}

/// The order of the two bytes of a UTF-16 code unit.
#[derive(Clone, Copy)]
pub(super) enum Order {
    Little,
    Big,
}

/// Returns a UTF-16 text as UTF-8, without its mark. What is no character becomes U+FFFD.
pub(super) fn from_utf16(bytes: &[u8], order: Order) -> Vec<u8> {
    let unit = match order {
        Order::Little => u16::from_le_bytes,
        Order::Big => u16::from_be_bytes,
    };
    let units = bytes.as_chunks::<2>().0.iter().map(|&pair| unit(pair));
    let units = units.skip_while(|&unit| unit == 0xfeff);
    let characters = char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER));
    characters.collect::<String>().into_bytes()
}

/// Returns whether `bytes` hold nothing: what fills the end of a file, but no content.
pub(super) fn is_padding(bytes: &[u8]) -> bool {
    bytes.iter().copied().all(is_padding_byte)
}

/// Returns whether `byte` is white space, zero, the end mark of CP/M (26) or erased (255).
pub(super) fn is_padding_byte(byte: u8) -> bool {
    byte.is_ascii_whitespace() || matches!(byte, 0 | 0x1a | 0xff)
}
