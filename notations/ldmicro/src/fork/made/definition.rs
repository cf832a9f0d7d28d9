//! The definitions of the blocks as ladder text. They compute what the fork's own code does, in the same order.

use super::{Count, Kind, Made, MadeCounter, Segments};
use ladder_format::program::{
    Block, Declaration, Drawing, Element, Expression, Invalid, Item, Network, Operand, Path, ProgramSketch,
    Section, SectionKind,
};
use ladder_format::{Circuit, Options};
use ladder_instructions::Op;
use ladder_syntax::{NodeOrToken, SyntaxKind, parse};

/// Those of blocks that have one form.
const FIXED: &str = include_str!("made.clad");

impl Made {
    /// From `FUNCTION_BLOCK` to its end.
    pub(super) fn definition(self) -> String {
        let head = self.head();
        let items = match self {
            Made::Segments(segments) => segments.items(),
            Made::Counter(counter) => counter.items(),
            _ => return definition_in(FIXED, &head).unwrap_or_default().to_owned(),
        };
        let items = vec![Item::Block {
            header: head,
            origin: None,
            items: items.unwrap_or_default(),
        }];
        ProgramSketch { items }.write(&Options::default()).text
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

/// A tag, by its name.
fn tag(name: &str) -> Expression {
    Path::tag(name).into()
}

/// What is in a definition: what it does, what it changes, its inputs and own tags, and what is on its rungs.
fn items(says: &str, declared: [(&[&str], &str); 3], rungs: Vec<Vec<Block>>) -> Vec<Item> {
    let mut items = vec![Item::Comment(says.to_owned())];
    let kinds = [SectionKind::VarInOut, SectionKind::VarInput, SectionKind::Var];
    for (kind, (names, ty)) in kinds.into_iter().zip(declared) {
        let mut section = Section::new(kind);
        if !names.is_empty() {
            section.declarations.push(Declaration {
                names: names.iter().map(|name| (*name).to_owned()).collect(),
                ..Declaration::new("", ty)
            });
        }
        items.push(Item::Section(section));
    }
    for blocks in rungs {
        let elements = blocks
            .into_iter()
            .map(|block| Circuit::Element(Element::of(block, None)));
        items.push(Item::Network(Network {
            comments: Vec::new(),
            drawing: Drawing::Circuit(Circuit::Series(elements.collect())),
        }));
    }
    items
}

impl Segments {
    /// Numbers that stand for no character are blank; 176, the degree sign, is the last one.
    fn items(self) -> Result<Vec<Item>, Invalid> {
        let (name, declared): (_, [(&[&str], &str); 3]) = if self.fixed {
            ("k", [(&["y"], "INT"), (&["a"], "INT"), (&["k"], "INT")])
        } else {
            ("a", [(&["y", "a"], "INT"), (&[], ""), (&[], "")])
        };
        let character = || tag(name);
        let powered = || Block::contact(tag("EN"));
        let last = CHARACTERS.len() as i64 - 1;
        let becomes = |op, than: i64, value: i64| {
            let compare = Block::of(op, [character(), than.into()])?;
            Ok(vec![
                powered(),
                compare,
                Block::of(Op::Mov, [character(), value.into()])?,
            ])
        };
        let segments = CHARACTERS.map(|segments| Expression::from(i64::from(segments)));
        let table = [tag("y"), character()].into_iter().chain(segments);
        let mut rungs = vec![
            becomes(Op::Eq, 176, last)?,
            becomes(Op::Lt, 0, 32)?,
            becomes(Op::Gt, last, 32)?,
            vec![powered(), Block::of(Op::Lut, table)?],
        ];
        if self.fixed {
            rungs.insert(0, vec![powered(), Block::of(Op::Mov, [tag("k"), tag("a")])?]);
        }
        if self.anode {
            rungs.push(vec![powered(), Block::of(Op::Not, [tag("y"), tag("y")])?]);
        }
        let how = if self.anode { "low" } else { "high" };
        let says = format!(
            "The segments of a digit or an ASCII character, lit by {how} bits: a to g are bits 0 to 6, the point is 7."
        );
        Ok(items(&says, declared, rungs))
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
    fn items(self) -> Result<Vec<Item>, Invalid> {
        let says = match self.count {
            Count::Up => "Counts up to max; there is power from then on.",
            Count::Down => "Counts down to max; there is power until then.",
            Count::Round => "Counts up; beyond max it begins again at init, with power for one scan.",
            Count::Reverse => "Counts down; below max it begins again at init, with power for one scan.",
        };
        let count = |op| Block::of(op, [tag("c"), tag("c"), 1.into()]);
        let compare = |op| Block::of(op, [tag("c"), tag("max")]);
        let begin = || Block::of(Op::Mov, [tag("c"), tag("init")]);
        let ends = || Block::coil(tag("ENO"));
        let mut rungs = vec![self.kind.contacts()?];
        match self.count {
            Count::Up => {
                rungs[0].extend([compare(Op::Lt)?, count(Op::Add)?]);
                rungs.push(vec![compare(Op::Ge)?, ends()]);
            }
            Count::Down => {
                rungs[0].extend([compare(Op::Gt)?, count(Op::Sub)?]);
                rungs.push(vec![compare(Op::Gt)?, ends()]);
            }
            Count::Round => rungs[0].extend([count(Op::Add)?, compare(Op::Gt)?, ends(), begin()?]),
            Count::Reverse => rungs[0].extend([count(Op::Sub)?, compare(Op::Lt)?, ends(), begin()?]),
        }
        let mut declared: [(&[&str], &str); 3] = [(&["c"], "INT"), (&["max"], "INT"), (&[], "BOOL")];
        if self.from_variable {
            let begun = Block::of(Op::Mov, [tag("begun"), Expression::literal("TRUE")?])?;
            rungs.insert(0, vec![Block::negated_contact(tag("begun")), begin()?, begun]);
            declared[2].0 = &["begun"];
        }
        if self.count.returns() || self.from_variable {
            declared[1].0 = &["max", "init"];
        }
        Ok(items(says, declared, rungs))
    }
}

impl Kind {
    /// The contacts that pass power in the scans that count.
    fn contacts(self) -> Result<Vec<Block>, Invalid> {
        let power = Path::tag("EN");
        Ok(match self {
            Kind::Rising => vec![Block::contact(power), Block::one_shot()],
            Kind::Falling => {
                let fell = Block::of(Op::OneShotFalling, Operand::NONE)?;
                vec![Block::contact(power), fell]
            }
            Kind::High => vec![Block::contact(power)],
            Kind::Low => vec![Block::negated_contact(power)],
        })
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
