//! The definitions of the blocks as ladder text. They compute what the fork's own code does, in the same order.

use super::{Count, Kind, Made, MadeCounter, Segments};
use ladder_syntax::{NodeOrToken, SyntaxKind, parse};

/// Those of blocks that have one form.
const FIXED: &str = include_str!("made.clad");

impl Made {
    /// From `FUNCTION_BLOCK` to its end.
    pub(super) fn definition(self) -> String {
        let head = self.head();
        match self {
            Made::Segments(segments) => segments.definition(&head),
            Made::Counter(counter) => counter.definition(&head),
            _ => definition_in(FIXED, &head).unwrap_or_default().to_owned(),
        }
    }

    /// Whether a text that defines a block of this name is this definition.
    pub(crate) fn is_defined_by(self, text: &str) -> bool {
        essence(&self.definition()) == essence(text)
    }
}

/// A text without its layout and its comments.
fn essence(text: &str) -> Vec<String> {
    let tokens = parse(text).syntax().descendants_with_tokens();
    let tokens = tokens.filter_map(NodeOrToken::into_token);
    let is_layout =
        |kind: SyntaxKind| kind.is_trivia() || matches!(kind, SyntaxKind::WIRE | SyntaxKind::RAIL);
    tokens
        .filter(|token| !is_layout(token.kind()))
        .map(|token| token.text().to_uppercase())
        .collect()
}

/// The definition of the block with this head in a text.
pub(crate) fn definition_in<'t>(text: &'t str, head: &str) -> Option<&'t str> {
    const END: &str = "END_FUNCTION_BLOCK";
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let defines = line.trim().strip_prefix("FUNCTION_BLOCK").map(str::trim);
        if defines.is_some_and(|own| own.eq_ignore_ascii_case(head)) {
            let text = &text[at..];
            return Some(&text[..text.find(END)? + END.len()]);
        }
        at += line.len();
    }
    None
}

/// A definition: what it does, what it changes, its inputs and own tags, and what is on its rungs.
fn written(head: &str, says: &str, declared: [&str; 3], rungs: &[String]) -> String {
    let mut text = format!("FUNCTION_BLOCK {head}\n# {says} #\n");
    for (keyword, declared) in ["VAR_IN_OUT", "VAR_INPUT", "VAR"].into_iter().zip(declared) {
        if !declared.is_empty() {
            text.push_str(&format!("{keyword}\n{declared};\nEND_VAR\n"));
        }
    }
    for rung in rungs {
        text.push_str(&format!("+--{rung}--+\n"));
    }
    text + "END_FUNCTION_BLOCK"
}

impl Segments {
    /// Numbers that stand for no character are blank; 176, the degree sign, is the last one.
    fn definition(self, head: &str) -> String {
        let (character, declared) = if self.fixed {
            ("k", ["y : INT", "a : INT", "k : INT"])
        } else {
            ("a", ["y, a : INT", "", ""])
        };
        let last = CHARACTERS.len() - 1;
        let segments = CHARACTERS.map(|segments| segments.to_string()).join(", ");
        let mut rungs = vec![
            format!("[ ]( EN )--[EQ]( {character}, 176 )--[MOV]( {character}, {last} )"),
            format!("[ ]( EN )--[LT]( {character}, 0 )--[MOV]( {character}, 32 )"),
            format!("[ ]( EN )--[GT]( {character}, {last} )--[MOV]( {character}, 32 )"),
            format!("[ ]( EN )--[LUT]( y, {character}, {segments} )"),
        ];
        if self.fixed {
            rungs.insert(0, "[ ]( EN )--[MOV]( k, a )".to_owned());
        }
        if self.anode {
            rungs.push("[ ]( EN )--[NOT]( y, y )".to_owned());
        }
        let how = if self.anode { "low" } else { "high" };
        let says = format!(
            "The segments of a digit or an ASCII character, lit by {how} bits: a to g are bits 0 to 6, the point is 7."
        );
        written(head, &says, declared, &rungs)
    }
}

/// The segments that LDmicro lights for 0 to F, the same with a point, the characters from blank on, and the degree sign.
const CHARACTERS: [u8; 129] = [
    0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71, 0xBF,
    0x86, 0xDB, 0xCF, 0xE6, 0xED, 0xFD, 0x87, 0xFF, 0xEF, 0xF7, 0xFC, 0xB9, 0xDE, 0xF9, 0xF1, 0x00, 0xB0,
    0x22, 0x4E, 0x6D, 0xD2, 0xDA, 0x20, 0x39, 0x0F, 0x72, 0x70, 0x0C, 0x40, 0x80, 0x52, 0x3F, 0x06, 0x5B,
    0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F, 0x09, 0x0D, 0x61, 0x41, 0x43, 0xD3, 0x9F, 0x77, 0x7C, 0x39,
    0x5E, 0x79, 0x71, 0x3D, 0x74, 0x30, 0x1E, 0x75, 0x38, 0x55, 0x54, 0x5C, 0x73, 0x67, 0x33, 0x6D, 0x78,
    0x3E, 0x1C, 0x6A, 0x76, 0x6E, 0x5B, 0x39, 0x64, 0x0F, 0x23, 0x08, 0x20, 0x5F, 0x7C, 0x58, 0x5E, 0x7B,
    0x71, 0x6F, 0x74, 0x10, 0x0E, 0x75, 0x18, 0x55, 0x54, 0x5C, 0x73, 0x67, 0x50, 0x6D, 0x78, 0x3E, 0x1C,
    0x6A, 0x76, 0x6E, 0x5B, 0x39, 0x30, 0x0F, 0x01, 0x00, 0x63,
];

impl MadeCounter {
    fn definition(self, head: &str) -> String {
        let counts = self.kind.contacts();
        let (says, counting): (&str, &[&str]) = match self.count {
            Count::Up => (
                "Counts up to max; there is power from then on.",
                &["[LT]( c, max )--[ADD]( c, c, 1 )", "[GE]( c, max )--( )( ENO )"],
            ),
            Count::Down => (
                "Counts down to max; there is power until then.",
                &["[GT]( c, max )--[SUB]( c, c, 1 )", "[GT]( c, max )--( )( ENO )"],
            ),
            Count::Round => (
                "Counts up; beyond max it begins again at init, with power for one scan.",
                &["[ADD]( c, c, 1 )--[GT]( c, max )--( )( ENO )--[MOV]( c, init )"],
            ),
            Count::Reverse => (
                "Counts down; below max it begins again at init, with power for one scan.",
                &["[SUB]( c, c, 1 )--[LT]( c, max )--( )( ENO )--[MOV]( c, init )"],
            ),
        };
        let mut rungs: Vec<String> = counting.iter().map(|rung| (*rung).to_owned()).collect();
        rungs[0].insert_str(0, counts);
        let mut declared = ["c : INT", "max : INT", ""];
        if self.from_variable {
            let first = "[/]( begun )--[MOV]( c, init )--[MOV]( begun, TRUE )";
            rungs.insert(0, first.to_owned());
            declared[2] = "begun : BOOL";
        }
        if self.count.returns() || self.from_variable {
            declared[1] = "max, init : INT";
        }
        written(head, says, declared, &rungs)
    }
}

impl Kind {
    /// The contacts that pass power in the scans that count.
    const fn contacts(self) -> &'static str {
        match self {
            Kind::Rising => "[ ]( EN )--[OSR]--",
            Kind::Falling => "[ ]( EN )--[OSF]--",
            Kind::High => "[ ]( EN )--",
            Kind::Low => "[/]( EN )--",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_block_is_defined() {
        for made in Made::all() {
            let definition = made.definition();
            assert!(
                definition_in(&definition, &made.head()).is_some(),
                "{}",
                made.head()
            );
            assert!(parse(&definition).errors().is_empty(), "{definition}");
        }
    }
    #[test]
    fn layout_makes_no_other_definition_and_a_number_does() {
        let own = Made::Opposite.definition();
        let written = own.replace("--[", "----# it #---[").replace("(y AND", "( y  and");
        assert!(Made::Opposite.is_defined_by(&written));
        assert!(!Made::Opposite.is_defined_by(&own.replace("* 4", "* 8")));
    }
}
