//! Files as other systems save them: UTF-8, UTF-16, and the encodings of one byte that XML names in its first line.

use std::borrow::Cow;

/// What windows-1252 has where ISO 8859-1 has control characters, from 0x80.
const WINDOWS: &str = "€\u{81}‚ƒ„…†‡ˆ‰Š‹Œ\u{8d}Ž\u{8f}\u{90}‘’“”•–—˜™š›œ\u{9d}žŸ";

/// The bytes in UTF-8, if they say that they are in another encoding: by a byte order mark, or in the first line of XML. Else they
/// are left as they are.
pub fn in_utf8(bytes: &[u8]) -> Cow<'_, [u8]> {
    let text = match bytes {
        [0xFF, 0xFE, rest @ ..] => utf16(rest, u16::from_le_bytes),
        [0xFE, 0xFF, rest @ ..] => utf16(rest, u16::from_be_bytes),
        _ if has_one_byte_each(bytes) => Some(bytes.iter().map(|byte| letter(*byte)).collect()),
        _ => None,
    };
    text.map_or(Cow::Borrowed(bytes), |text: String| Cow::Owned(text.into_bytes()))
}

/// None: it is cut off or broken.
fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Option<String> {
    let (units, []) = bytes.as_chunks::<2>() else {
        return None;
    };
    let units = units.iter().map(|pair| unit(*pair));
    char::decode_utf16(units).collect::<Result<_, _>>().ok()
}

fn has_one_byte_each(bytes: &[u8]) -> bool {
    let end = bytes.iter().take(200).position(|byte| *byte == b'>');
    let Some(head) = end.and_then(|end| bytes[..end].strip_prefix(b"<?xml")) else {
        return false;
    };
    let head = head.to_ascii_lowercase();
    ["iso-8859-1", "windows-1252"].iter().any(|name| {
        [b'"', b'\''].iter().any(|quote| {
            let quoted = [&[*quote], name.as_bytes(), &[*quote]].concat();
            head.windows(quoted.len()).any(|part| part == quoted)
        })
    })
}

fn letter(byte: u8) -> char {
    match byte {
        0x80..=0x9F => WINDOWS
            .chars()
            .nth(usize::from(byte - 0x80))
            .unwrap_or('\u{fffd}'),
        _ => char::from(byte),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(bytes: &[u8], text: &str) {
        assert_eq!(String::from_utf8_lossy(&in_utf8(bytes)), text);
    }

    #[test]
    fn what_says_its_encoding_is_read() {
        check(b"\xFF\xFE<\0\xFC\0", "<ü");
        check(b"\xFE\xFF\0<\xD8\x3D\xDE\x00", "<😀");
        let xml = b"<?xml version=\"1.0\" encoding=\"Windows-1252\"?><a>\x80\xFC\x9F</a>";
        check(xml, "<?xml version=\"1.0\" encoding=\"Windows-1252\"?><a>€üŸ</a>");
    }

    #[test]
    fn what_does_not_or_is_broken_stays() {
        for bytes in [
            &b"\xFF\xFE<"[..],
            b"\xFF\xFE\0\xD8",
            b"<?xml version='1.0'?><a>\xFC</a>",
            b"<?xml version='1.0' encoding='utf-8'?>\xFC",
            b"\xC3\xBC encoding='iso-8859-1'>",
        ] {
            assert!(matches!(in_utf8(bytes), Cow::Borrowed(same) if same == bytes));
        }
    }
}
