//! Halves of surrogate pairs in JSON.

use memchr::{memchr, memmem};

/// Makes every escaped half of a surrogate pair that has no other half a U+FFFD. Texts of some editors hold such
/// halves, and positions in them count the same: both are one unit of UTF-16.
pub(crate) fn replace_lone_surrogates(json: &mut [u8]) {
    if memmem::find(json, br"\uD").is_none() && memmem::find(json, br"\ud").is_none() {
        return;
    }
    let mut at = 0;
    while let Some(next) = memchr(b'\\', &json[at..]) {
        at += next;
        let Some(unit) = escaped_unit(&json[at..]) else {
            // Another escape, of two characters.
            at = (at + 2).min(json.len());
            continue;
        };
        let is_pair = (0xD800..0xDC00).contains(&unit)
            && escaped_unit(&json[at + 6..]).is_some_and(|unit| (0xDC00..0xE000).contains(&unit));
        if is_pair {
            at += 12;
            continue;
        }
        if (0xD800..0xE000).contains(&unit) {
            json[at..at + 6].copy_from_slice(br"\ufffd");
        }
        at += 6;
    }
}

/// The unit of UTF-16 that `\u1234` is, if the bytes begin with one.
fn escaped_unit(json: &[u8]) -> Option<u16> {
    let digits = json.strip_prefix(br"\u")?.get(..4)?;
    let digits = std::str::from_utf8(digits).ok()?;
    u16::from_str_radix(digits, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_halves_without_their_other_half_are_replaced() {
        for (json, expected) in [
            (r#""\ud800""#, r#""\ufffd""#),
            (r#""\uDFFF a""#, r#""\ufffd a""#),
            (r#""\udc00\ud800""#, r#""\ufffd\ufffd""#),
            (r#""\ud800\ud83d\ude00\ude00""#, r#""\ufffd\ud83d\ude00\ufffd""#),
            (r#""\ud83d\ude00""#, r#""\ud83d\ude00""#),
            (r#""\\ud800\\\ud800""#, r#""\\ud800\\\ufffd""#),
            (r#""\ud7ff\ue000\ud8""#, r#""\ud7ff\ue000\ud8""#),
            (r#"\ud800\"#, r#"\ufffd\"#),
        ] {
            let mut bytes = json.as_bytes().to_vec();
            replace_lone_surrogates(&mut bytes);
            assert_eq!(std::str::from_utf8(&bytes).unwrap(), expected, "{json}");
        }
    }
}
