//! The text of a rung: `XIC(a)[XIO(b) ,XIC(c) ]OTE(d);` as Logix writes it, `SOR XIC a BST XIO b NXB XIC c BND OTE d EOR` as
//! RSLogix 500 does.

/// A part of a rung.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Part<'t> {
    /// An instruction.
    Instruction(Instruction<'t>),
    /// Legs from top to bottom; one without parts is a wire.
    Branch(Vec<Vec<Part<'t>>>),
}

/// An instruction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Instruction<'t> {
    /// Where it is in the text of the rung, in bytes.
    pub at: usize,
    /// What it is called.
    pub name: &'t str,
    /// What is between its parentheses.
    pub operands: Vec<&'t str>,
    /// All of it, as it is written.
    pub text: &'t str,
}

/// What is wrong, and where in the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wrong {
    /// Where, in bytes.
    pub at: usize,
    /// What.
    pub message: String,
}

/// Branches nest no deeper, and a rung has no more parts: a drawing must have a use.
const DEEPEST: usize = 24;
const MOST_PARTS: usize = 2_000;
const MOST_LEGS: usize = 200;

/// Reads the text of one rung, in either spelling. `operands` says how many operands an instruction has where no parentheses are
/// around them.
///
/// # Errors
///
/// If brackets do not pair, or something is there that is not an instruction.
pub fn parse<'t>(text: &'t str, operands: &dyn Fn(&str) -> Option<usize>) -> Result<Vec<Part<'t>>, Wrong> {
    let mut reader = Reader {
        text,
        operands,
        at: 0,
        parts: 0,
    };
    let parts = reader.series(0)?;
    if reader.at < text.len() {
        let message = match reader.word() {
            "NXB" | "BND" => format!("`{}` has no `BST` before it", reader.word()),
            _ => format!("`{}` is not expected here", reader.shown()),
        };
        return Err(reader.wrong(message));
    }
    Ok(parts)
}

/// All instructions of parts, from left to right and top to bottom.
pub fn instructions<'p, 't>(parts: &'p [Part<'t>], visit: &mut impl FnMut(&'p Instruction<'t>)) {
    for part in parts {
        match part {
            Part::Instruction(instruction) => visit(instruction),
            Part::Branch(legs) => legs.iter().for_each(|leg| instructions(leg, visit)),
        }
    }
}

struct Reader<'t, 'o> {
    text: &'t str,
    operands: &'o dyn Fn(&str) -> Option<usize>,
    at: usize,
    parts: usize,
}

impl<'t> Reader<'t, '_> {
    fn wrong(&self, message: impl Into<String>) -> Wrong {
        Wrong {
            at: self.at,
            message: message.into(),
        }
    }

    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn shown(&self) -> String {
        self.rest().chars().take(20).collect()
    }

    fn blanks(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    /// The name that begins here.
    fn word(&self) -> &'t str {
        let rest = self.rest();
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        &rest[..end.unwrap_or(rest.len())]
    }

    fn eat(&mut self, c: char) -> bool {
        let eaten = self.rest().starts_with(c);
        self.at += usize::from(eaten);
        eaten
    }

    /// Parts one after the other, up to what ends them.
    fn series(&mut self, depth: usize) -> Result<Vec<Part<'t>>, Wrong> {
        let mut parts = Vec::new();
        loop {
            self.blanks();
            match self.rest().chars().next() {
                None | Some(',' | ']') => return Ok(parts),
                Some(';') => self.at += 1,
                Some('[') => {
                    self.at += 1;
                    parts.push(self.branch(depth, |reader| match reader.rest().chars().next() {
                        Some(',') => Some((1, true)),
                        Some(']') => Some((1, false)),
                        _ => None,
                    })?);
                }
                Some(_) => match self.word() {
                    "" => return Err(self.wrong(format!("`{}` is not expected here", self.shown()))),
                    "NXB" | "BND" => return Ok(parts),
                    word @ ("SOR" | "EOR") => {
                        self.at += word.len();
                        self.blanks();
                        // A rung's number may follow.
                        if word == "SOR" {
                            let number = self.rest().find(|c: char| !c.is_ascii_digit());
                            self.at += number.unwrap_or(0);
                        }
                    }
                    "BST" => {
                        self.at += 3;
                        parts.push(self.branch(depth, |reader| match reader.word() {
                            "NXB" => Some((3, true)),
                            "BND" => Some((3, false)),
                            _ => None,
                        })?);
                    }
                    _ => parts.push(Part::Instruction(self.instruction()?)),
                },
            }
            self.parts += 1;
            if self.parts > MOST_PARTS {
                return Err(self.wrong(format!("the rung has more than {MOST_PARTS} parts")));
            }
        }
    }

    /// Legs up to the end of their branch. `next` says how long what ends a leg is, and whether there is another.
    fn branch(
        &mut self,
        depth: usize,
        next: impl Fn(&Self) -> Option<(usize, bool)>,
    ) -> Result<Part<'t>, Wrong> {
        if depth == DEEPEST {
            return Err(self.wrong(format!("branches are nested deeper than {DEEPEST}")));
        }
        let begin = self.at;
        let mut legs = Vec::new();
        loop {
            legs.push(self.series(depth + 1)?);
            let Some((length, more)) = next(self) else {
                self.at = begin;
                return Err(self.wrong("the branch that begins here has no end"));
            };
            self.at += length;
            if legs.len() > MOST_LEGS {
                return Err(self.wrong(format!("the branch has more than {MOST_LEGS} legs")));
            }
            if !more {
                return Ok(Part::Branch(legs));
            }
        }
    }

    fn instruction(&mut self) -> Result<Instruction<'t>, Wrong> {
        let at = self.at;
        let name = self.word();
        self.at += name.len();
        let after_name = self.at;
        self.blanks();
        let operands = if self.eat('(') {
            self.in_parentheses(at)?
        } else {
            self.at = after_name;
            self.after_blanks(name)
        };
        Ok(Instruction {
            at,
            name,
            operands,
            text: &self.text[at..self.at],
        })
    }

    /// Operands up to the closing parenthesis, parted by commas that no bracket and no string encloses.
    fn in_parentheses(&mut self, begin: usize) -> Result<Vec<&'t str>, Wrong> {
        let mut operands = Vec::new();
        let mut start = self.at;
        let mut open = 0usize;
        let mut in_string = false;
        let mut escaped = false;
        for (offset, c) in self.rest().char_indices() {
            let at = self.at + offset;
            match c {
                _ if escaped => escaped = false,
                '$' if in_string => escaped = true,
                '\'' => in_string = !in_string,
                _ if in_string => {}
                '(' | '[' => open += 1,
                ')' if open == 0 => {
                    let last = self.text[start..at].trim();
                    if !(last.is_empty() && operands.is_empty()) {
                        operands.push(last);
                    }
                    self.at = at + 1;
                    return Ok(operands);
                }
                ')' | ']' => open = open.saturating_sub(1),
                ',' if open == 0 => {
                    operands.push(self.text[start..at].trim());
                    start = at + 1;
                }
                _ => {}
            }
        }
        self.at = begin;
        Err(self.wrong("the parenthesis of this instruction is not closed"))
    }

    /// Operands parted by blanks, as RSLogix 500 writes them: as many as the instruction has.
    fn after_blanks(&mut self, name: &str) -> Vec<&'t str> {
        let Some(count) = (self.operands)(name) else {
            return Vec::new();
        };
        let mut operands = Vec::new();
        for _ in 0..count {
            self.blanks();
            let rest = self.rest();
            let end = rest.find(|c: char| c.is_whitespace() || c == ';' || c == ',');
            let operand = &rest[..end.unwrap_or(rest.len())];
            if operand.is_empty() || matches!(operand, "NXB" | "BND" | "EOR" | "BST") {
                break;
            }
            // The list may stand in another spelling: `XIC a]`.
            self.at += operand.len();
            operands.push(operand);
        }
        operands
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn shown(parts: &[Part<'_>]) -> String {
        let one = |part: &Part<'_>| match part {
            Part::Instruction(it) => format!("{}:{}<{}>", it.at, it.name, it.operands.join("|")),
            Part::Branch(legs) => {
                let legs: Vec<String> = legs.iter().map(|leg| shown(leg)).collect();
                format!("[{}]", legs.join(" / "))
            }
        };
        parts.iter().map(one).collect::<Vec<_>>().join(" ")
    }

    #[track_caller]
    fn check(text: &str, expected: Expect) {
        let operands = |name: &str| match name {
            "XIC" | "OTE" => Some(1),
            "TON" => Some(4),
            _ => None,
        };
        expected.assert_eq(&match parse(text, &operands) {
            Ok(parts) => shown(&parts),
            Err(wrong) => format!("{}: {}", wrong.at, wrong.message),
        });
    }

    #[test]
    fn neutral_text() {
        check("XIC(a)OTE(b);", expect!["0:XIC<a> 6:OTE<b>"]);
        check(
            "[XIC(a) OTE(b) ,OTE(c) ][,XIO(d)];",
            expect!["[1:XIC<a> 8:OTE<b> / 16:OTE<c>] [ / 26:XIO<d>]"],
        );
        check(
            "XIC(s[1,3].[t.m])CMP(ATAN(_T) > 1.0)MOVE('a,$'b)',x)TON(t,?,?)XIC()AFI;",
            expect![
                "0:XIC<s[1,3].[t.m]> 17:CMP<ATAN(_T) > 1.0> 36:MOVE<'a,$'b)'|x> 52:TON<t|?|?> 62:XIC<> 67:AFI<>"
            ],
        );
    }

    #[test]
    fn text_of_rslogix_500() {
        check(
            "SOR 3 BST XIC I:0/0 NXB XIC O:10/0 BND TON T4:0 1.0 5 0 OTE Motor EOR",
            expect!["[10:XIC<I:0/0> / 24:XIC<O:10/0>] 39:TON<T4:0|1.0|5|0> 56:OTE<Motor>"],
        );
    }

    #[test]
    fn broken_rungs_say_where() {
        check(
            "XIC(a",
            expect!["0: the parenthesis of this instruction is not closed"],
        );
        check(
            "XIC(a)[XIC(b),",
            expect!["7: the branch that begins here has no end"],
        );
        check("XIC(a)]OTE(b);", expect!["6: `]OTE(b);` is not expected here"]);
        check(
            "XIC I:0/0 BST XIC I:0/1 OTE O:0/0",
            expect!["13: the branch that begins here has no end"],
        );
        check("XIC a NXB OTE b", expect!["6: `NXB` has no `BST` before it"]);
        check(
            &"[".repeat(100),
            expect!["25: branches are nested deeper than 24"],
        );
    }
}
