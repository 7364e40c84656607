//! Numbers as text for storage: base 64 and variable-length integers.

/// Alphabet of RFC 4648, section 4.
const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Bytes in base 64, with padding.
pub(super) fn to_text(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let three = [0, 1, 2].map(|i| u32::from(chunk.get(i).copied().unwrap_or(0)));
        let bits = three[0] << 16 | three[1] << 8 | three[2];
        for i in 0..4 {
            let is_there = i <= chunk.len();
            let symbol = ALPHABET[(bits >> (18 - 6 * i) & 63) as usize];
            text.push(if is_there { char::from(symbol) } else { '=' });
        }
    }
    text
}

/// The bytes that [`to_text`] encoded; `None` for invalid text.
pub(super) fn from_text(text: &str) -> Option<Vec<u8>> {
    let symbols = text.as_bytes();
    if !symbols.len().is_multiple_of(4) {
        return None;
    }
    let mut bytes = Vec::with_capacity(symbols.len() / 4 * 3);
    let last = symbols.len() / 4;
    for (index, four) in symbols.chunks(4).enumerate() {
        let padding = if index + 1 == last { four.iter().rev().take_while(|s| **s == b'=').count() } else { 0 };
        if padding > 2 {
            return None;
        }
        let mut bits = 0_u32;
        for &symbol in &four[..4 - padding] {
            bits = bits << 6 | ALPHABET.iter().position(|known| *known == symbol)? as u32;
        }
        bits <<= 6 * padding;
        bytes.extend(&bits.to_be_bytes()[1..4 - padding]);
    }
    Some(bytes)
}

/// Appends a whole number: seven bits a byte, the lowest first, the sign lowest of all (zigzag).
pub(super) fn push(bytes: &mut Vec<u8>, value: i64) {
    let mut rest = (value << 1 ^ value >> 63) as u64;
    while rest >= 0x80 {
        bytes.push(rest as u8 | 0x80);
        rest >>= 7;
    }
    bytes.push(rest as u8);
}

/// Removes a number that [`push`] wrote from the front; `None` if there is none.
pub(super) fn take(bytes: &mut &[u8]) -> Option<i64> {
    let mut value = 0_u64;
    for shift in (0..64).step_by(7) {
        let (&byte, rest) = bytes.split_first()?;
        *bytes = rest;
        value |= u64::from(byte & 0x7f) << shift;
        if byte < 0x80 {
            return Some((value >> 1) as i64 ^ -((value & 1) as i64));
        }
    }
    None
}

/// A hash (FNV-1a) to detect damaged texts.
pub(super) fn digest(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_come_back() {
        for length in 0..20 {
            let bytes: Vec<u8> = (0..length).map(|i| (i * 37 + 201) as u8).collect();
            assert_eq!(from_text(&to_text(&bytes)).as_deref(), Some(&bytes[..]));
        }
        assert_eq!(to_text(b"foobar"), "Zm9vYmFy");
        assert_eq!(to_text(b"foob"), "Zm9vYg==");
        for wrong in ["Zm9", "Zm9v!m9v", "Zm=vZm9v", "====", "Z===", "äöü"] {
            assert_eq!(from_text(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn whole_numbers_come_back() {
        let values = [0, 1, -1, 63, -64, 64, 500, -500, 1 << 40, i64::MAX, i64::MIN];
        let mut bytes = Vec::new();
        for value in values {
            push(&mut bytes, value);
        }
        let mut rest = &bytes[..];
        assert_eq!(values.map(|_| take(&mut rest)), values.map(Some));
        assert_eq!(take(&mut rest), None);
        assert_eq!(take(&mut &[0xff; 12][..]), None, "a number without end");
    }
}
