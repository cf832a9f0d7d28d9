//! How bytes become texts, numbers and edits.
//!
//! Most inputs are texts that a person can read. Where more than one thing is asked for, a line `%%` is between
//! them.

/// What is between the parts of an input.
const SEPARATOR: &[u8] = b"\n%%\n";

/// The parts of an input; always one, which may be empty.
pub(crate) fn parts(data: &[u8]) -> Vec<&[u8]> {
    let mut parts = Vec::new();
    let mut rest = data;
    while let Some(at) = rest.windows(SEPARATOR.len()).position(|it| it == SEPARATOR) {
        parts.push(&rest[..at]);
        rest = &rest[at + SEPARATOR.len()..];
    }
    parts.push(rest);
    parts
}

/// Bytes as a text: what is not UTF-8 becomes U+FFFD.
pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Takes numbers from the front of bytes.
pub(crate) struct Numbers<'b>(pub(crate) &'b [u8]);

impl Numbers<'_> {
    /// A number of one byte; 0 after the end.
    pub(crate) fn small(&mut self) -> usize {
        let Some((&first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        usize::from(first)
    }

    /// A number of two bytes.
    pub(crate) fn large(&mut self) -> usize {
        self.small() | self.small() << 8
    }
}

/// The boundary of a character at an offset or before it.
pub(crate) fn floor(text: &str, offset: usize) -> usize {
    let mut offset = offset.min(text.len());
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}
