//! Semantic tokens in as many bytes as their numbers need: those that a client has are kept as long as the document is
//! open, and a program of ten thousand rungs has a hundred and sixty thousand.

use tower_lsp::ls_types::SemanticToken;

/// Tokens in their order. Each is five numbers, each number some groups of seven bits, the lowest first; the highest bit of
/// a byte says that another one belongs to the number.
#[derive(Debug, Default)]
pub(crate) struct Packed {
    bytes: Vec<u8>,
    count: usize,
}

const GOES_ON: u8 = 0x80;

impl Packed {
    /// Adds a token behind the others.
    pub(crate) fn push(&mut self, token: &SemanticToken) {
        let numbers = [
            token.delta_line,
            token.delta_start,
            token.length,
            token.token_type,
            token.token_modifiers_bitset,
        ];
        for mut number in numbers {
            while number >= u32::from(GOES_ON) {
                self.bytes.push(number as u8 | GOES_ON);
                number >>= 7;
            }
            self.bytes.push(number as u8);
        }
        self.count += 1;
    }

    /// How many tokens there are.
    pub(crate) fn len(&self) -> usize {
        self.count
    }

    /// The numbers of all tokens, five for each.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = u32> {
        let mut bytes = self.bytes.iter();
        std::iter::from_fn(move || {
            let mut number = 0;
            for group in 0.. {
                let byte = *bytes.next()?;
                number |= u32::from(byte & !GOES_ON) << (7 * group);
                if byte & GOES_ON == 0 {
                    break;
                }
            }
            Some(number)
        })
    }

    /// The tokens.
    pub(crate) fn iter(&self) -> impl Iterator<Item = SemanticToken> {
        let mut numbers = self.numbers();
        std::iter::from_fn(move || {
            Some(SemanticToken {
                delta_line: numbers.next()?,
                delta_start: numbers.next()?,
                length: numbers.next()?,
                token_type: numbers.next()?,
                token_modifiers_bitset: numbers.next()?,
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_comes_out_again() {
        let tokens = [0, 1, 127, 128, 16_383, 16_384, u32::MAX].map(|number| SemanticToken {
            delta_line: number,
            delta_start: number / 2,
            length: number / 3,
            token_type: 7,
            token_modifiers_bitset: number,
        });
        let mut packed = Packed::default();
        for token in &tokens {
            packed.push(token);
        }
        assert_eq!(packed.len(), tokens.len());
        assert!(packed.iter().eq(tokens));
    }
}
