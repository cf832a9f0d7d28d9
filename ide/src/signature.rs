//! Signature help: the operands of the block, or the arguments of the function, that is being written.

use crate::described::Described;
use crate::typing::{CursorContext, Open, Operand, Typing, typing};
use crate::wanted::{Called, called, function};
use ladder_analysis::context::Context;
use ladder_analysis::program::ParameterKind;
use ladder_analysis::written::user_block::UserBlockFacts;
use ladder_instructions::{Direction, Instruction, Presence, Profile};
use ladder_syntax::TextSize;
use std::ops::Range;

/// What can be given at a place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SignatureHelp {
    /// The block or function; NOT has two forms.
    pub signatures: Vec<Signature>,
    /// The one that is probably meant.
    pub active: usize,
}

/// A block or function with its operands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Signature {
    /// As a person writes it: `[TON]( t, PT, R := )`.
    pub label: String,
    /// What it does, in a sentence.
    pub doc: String,
    /// Its operands.
    pub parameters: Vec<Parameter>,
    /// The one that is being written; none where there are too many.
    pub active: Option<usize>,
}

/// An operand in a signature.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parameter {
    /// Where it is in the label, in bytes.
    pub range: Range<usize>,
    /// What it is for.
    pub doc: String,
}

/// What can be given at an offset: inside the operand list of a block, closed or not, or of an expression's function.
pub fn signature_help(context: &Context, offset: TextSize) -> Option<SignatureHelp> {
    let typing = typing(context, offset)?;
    let CursorContext::Operand(operand) = &typing.place else {
        return None;
    };
    let innermost = operand.open.iter().rev().find_map(|open| match open {
        Open::Call(name, commas) => Some((name, *commas)),
        _ => None,
    });
    if let Some((name, commas)) = innermost {
        return Some(SignatureHelp {
            signatures: vec![of_function(function(name)?, commas)],
            active: 0,
        });
    }
    let called = called(typing.context, operand.shape?, &operand.head);
    let signatures: Vec<Signature> = called
        .iter()
        .map(|called| match called {
            Called::Row(row) => of_row(row, operand, typing.context.profile),
            Called::User(block) => of_user(&typing, block, operand),
        })
        .collect();
    if signatures.is_empty() {
        return None;
    }
    let fits = called
        .iter()
        .position(|called| matches!(called, Called::Row(row) if row.takes(operand.count)))
        .or_else(|| {
            signatures
                .iter()
                .position(|signature| !signature.parameters.is_empty())
        });
    Some(SignatureHelp {
        active: fits.unwrap_or(0),
        signatures,
    })
}

/// A label that grows by one parameter after the other.
struct Label {
    text: String,
    parameters: Vec<Parameter>,
}

impl Label {
    fn new(text: String) -> Label {
        Label {
            text,
            parameters: Vec::new(),
        }
    }

    fn add(&mut self, text: &str, doc: String) {
        if !self.parameters.is_empty() {
            self.text.push_str(", ");
        }
        let start = self.text.len();
        self.text.push_str(text);
        self.parameters.push(Parameter {
            range: start..self.text.len(),
            doc,
        });
    }
}

fn of_row(row: &'static Instruction, operand: &Operand, profile: Profile) -> Signature {
    let mut label = Label::new(format!("{}( ", row.block()));
    let mut active = None;
    let meant = match &operand.name {
        Some(name) => row.named(name),
        None => row.positional(operand.before.len()),
    };
    let shown = row.operands.iter().filter(|o| o.profiles.contain(profile));
    for (index, formal) in shown.enumerate() {
        let text = match (formal.presence, formal.direction) {
            (Presence::Named, Direction::Out) => format!("{} =>", formal.name),
            (Presence::Named, _) => format!("{} :=", formal.name),
            _ => formal.name.to_owned(),
        };
        if meant.is_some_and(|meant| std::ptr::eq(meant, formal)) {
            active = Some(index);
        }
        let way = match formal.direction {
            Direction::In => "",
            Direction::Out => " It is written.",
            Direction::InOut => " It is read and written.",
        };
        label.add(&text, format!("{}{way}", formal.doc));
    }
    // After those by place comes the first of those by name that is not given yet.
    if active.is_none() && operand.name.is_none() {
        let free = |formal: &&ladder_instructions::Operand| {
            formal.presence == Presence::Named
                && formal.profiles.contain(profile)
                && !operand
                    .given
                    .iter()
                    .any(|given| given.eq_ignore_ascii_case(formal.name))
        };
        let next = row.operands.iter().find(free);
        active = next.and_then(|next| row.operands.iter().position(|formal| std::ptr::eq(formal, next)));
    }
    let more = if row.repeats() { ", ..." } else { "" };
    let text = if label.parameters.is_empty() {
        row.block()
    } else {
        format!("{}{more} )", label.text)
    };
    Signature {
        label: text,
        doc: format!("{}: {}", row.title, row.summary()),
        parameters: label.parameters,
        active,
    }
}

fn of_function(row: &'static Instruction, commas: usize) -> Signature {
    let mut label = Label::new(format!("{}(", row.mnemonic));
    // The first operand of the row is the result.
    let mut active = None;
    for (index, formal) in row.operands.iter().skip(1).enumerate() {
        if row
            .positional(commas + 1)
            .is_some_and(|meant| std::ptr::eq(meant, formal))
        {
            active = Some(index);
        }
        label.add(formal.name, formal.doc.to_owned());
    }
    let more = if row.repeats() { ", ..." } else { "" };
    Signature {
        label: format!("{}{more})", label.text),
        doc: format!("{}: {}", row.title, row.summary()),
        parameters: label.parameters,
        active,
    }
}

fn of_user(typing: &Typing<'_>, block: &UserBlockFacts, operand: &Operand) -> Signature {
    let described = Described::of(typing.context, block);
    let (open, close) = block.shape.brackets();
    let mut label = Label::new(format!("{open}{}{close}( ", block.name));
    label.add(
        "state",
        format!(
            "a tag of type {}, may be left out: then the state belongs to this place",
            block.name
        ),
    );
    for parameter in &block.parameters {
        let ty = parameter.ty.map(|ty| ty.to_string()).unwrap_or_default();
        let way = match parameter.kind {
            ParameterKind::Input => "input",
            ParameterKind::Output => "output",
            ParameterKind::InOut => "read and written",
        };
        let optional = if parameter.has_default {
            ", may be left out"
        } else {
            ""
        };
        let comment = described.as_ref().and_then(|block| block.parameter(parameter));
        let comment = comment.map_or(String::new(), |text| format!(": {text}"));
        label.add(&parameter.name, format!("{ty}, {way}{optional}{comment}"));
    }
    let is_first = operand.before.is_empty() && operand.state.is_none() && operand.name.is_none();
    let active = if is_first && typing.keeps_state(&typing.text[operand.start..typing.word.end], &block.name)
    {
        Some(0)
    } else {
        let meant = crate::wanted::parameter(block, operand);
        // After the state.
        meant
            .and_then(|meant| (block.parameters.iter().zip(1..)).find(|(p, _)| std::ptr::eq(*p, meant)))
            .map(|(_, index)| index)
    };
    Signature {
        label: format!("{} )", label.text),
        doc: match described.as_ref().and_then(Described::of_library) {
            Some(source) => source.summary(),
            None => "User-defined block".to_owned(),
        },
        parameters: label.parameters,
        active,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::Fixture;
    use expect_test::{Expect, expect};

    /// Each signature with the active parameter in braces, and what that is for.
    fn check(text: &str, expected: Expect) {
        let fixture = Fixture::new(text);
        let (context, offset, _) = fixture.ask();
        let mut shown = String::new();
        match signature_help(context, offset) {
            None => shown.push_str("nothing\n"),
            Some(help) => {
                for (index, signature) in help.signatures.iter().enumerate() {
                    let active = signature.active.map(|active| &signature.parameters[active]);
                    let mut label = signature.label.clone();
                    if let Some(active) = active {
                        label.insert(active.range.end, '}');
                        label.insert(active.range.start, '{');
                    }
                    let mark = if index == help.active { "" } else { "  or " };
                    let doc = active.map(|active| active.doc.as_str()).unwrap_or_default();
                    shown.push_str(&format!("{mark}{label}  {doc}\n"));
                }
            }
        }
        expected.assert_eq(&shown);
    }

    #[test]
    fn by_place() {
        check(
            "+--[TON]( $0 )--( )( y )--+\n",
            expect![[r#"
            [TON]( {t}, PT, R := )  The timer's tag, of type TON. It is read and written.
        "#]],
        );
        check(
            "+--[TON]( t, T#5$0s )--( )( y )--+\n",
            expect![[r#"
            [TON]( t, {PT}, R := )  The preset time; a plain integer is milliseconds.
        "#]],
        );
        check(
            "+--[TON]( t, $0\n",
            expect![[r#"
            [TON]( t, {PT}, R := )  The preset time; a plain integer is milliseconds.
        "#]],
        );
        check(
            "+--[TON]( t, 5s, $0 )--( )( y )--+\n",
            expect![[r#"
            [TON]( t, PT, {R :=} )  The reset, while it is high.
        "#]],
        );
        check(
            "+--[ADD]( y, a, b, $0c )--+\n",
            expect![[r#"
            [ADD]( y, a, {b}, ... )  What is added to it.
        "#]],
        );
        check(
            "+--[PWL]( y, x, 1, 2, 3$0, 4 )--+\n",
            expect![[r#"
            [PWL]( y, x, x0, y0, {x1}, y1, ... )  Where the next point is, right of the one before.
        "#]],
        );
        check(
            "+--[ ]( a, $0b )--+\n",
            expect![[r#"
            [ ]( tag )  
        "#]],
        );
        check(
            "+--[FMT]( 'a, $0b', c )--+\n",
            expect![[r#"
            [FMT]( {text}, a, ... )  The text; each `%d` stands for a value.
        "#]],
        );
    }

    #[test]
    fn by_name() {
        check(
            "+--[CTUD]( c, 5, LD := $0 )--+\n",
            expect![[r#"
            [CTUD]( c, PV, CD :=, R :=, {LD :=} )  Loads PV, while it is high.
        "#]],
        );
        check(
            "+--[CTUD]( c, 5, R := a, $0 )--+\n",
            expect![[r#"
            [CTUD]( c, PV, {CD :=}, R :=, LD := )  Counts down when it rises.
        "#]],
        );
        check(
            "+--[SEARCH]( y, EQ, a, t[1..4], FOUND => $0\n",
            expect![[r#"
            [SEARCH]( y, op, a, t, NEXT :=, {FOUND =>} )  High if an element was found. It is written.
        "#]],
        );
    }

    #[test]
    fn two_forms() {
        check(
            "+--[NOT]( $0 )--+\n",
            expect![[r#"
              or [NOT]  
            [NOT]( {y}, a )  The result. It is written.
        "#]],
        );
        check(
            "+--[NOT]( y, $0a )--+\n",
            expect![[r#"
              or [NOT]  
            [NOT]( y, {a} )  The value whose bits are inverted.
        "#]],
        );
    }

    #[test]
    fn functions_of_expressions() {
        check(
            "+--[CALC]( y, LIMIT(0, $0a, 10) + 1 )--+\n",
            expect![[r#"
            LIMIT(low, {a}, high)  The value.
        "#]],
        );
        check(
            "+--[CALC]( y, MAX(a, (b + $0c)) )--+\n",
            expect![[r#"
            MAX(a, {b}, ...)  A further value.
        "#]],
        );
        check(
            "+--[CALC]( y, SQRT($0\n",
            expect![[r#"
            SQRT({a})  The value, 0 or more.
        "#]],
        );
        check(
            "+--[CALC]( y, a + $0b )--+\n",
            expect![[r#"
            [CALC]( y, {expression} )  The formula, as in `(a + b) / 2`.
        "#]],
        );
    }

    #[test]
    fn parameters_say_what_their_comments_say() {
        check(
            "+--[$Blink]( 1s, $0 )--( )( y )--+\n",
            expect![[r#"
                [$Blink]( state, high, {low}, q )  TIME, input, may be left out: how long it is low
            "#]],
        );
        check(
            "FUNCTION_BLOCK [$B]\nVAR_INPUT\n a : BOOL; # is it *on*? #\nEND_VAR\nEND_FUNCTION_BLOCK\n+--[$B]( $0 )--+\n",
            expect![[r#"
                [$B]( state, {a} )  BOOL, input: is it \*on\*\?
            "#]],
        );
    }

    #[test]
    fn user_defined_blocks() {
        let library = "FUNCTION_BLOCK [$Hold]\nVAR_INPUT raw : BOOL; wait : TIME := T#1s; END_VAR\nVAR_OUTPUT clean : BOOL; END_VAR\n\
             +--[ ]( raw )--( )( clean )--+\nEND_FUNCTION_BLOCK\n";
        let own = |rung: &str| format!("%% main.clad\n{rung}\n%% library.clad\n{library}");
        check(
            &own("+--[$Hold]( a, $0 )--+"),
            expect![[r#"
                [$Hold]( state, raw, {wait}, clean )  TIME, input, may be left out
            "#]],
        );
        check(
            &own("+--[$Hold]( clean => $0"),
            expect![[r#"
                [$Hold]( state, raw, wait, {clean} )  BOOL, output
            "#]],
        );
    }

    #[test]
    fn the_state_of_a_block() {
        let plant = "FUNCTION_BLOCK [$Motor]\nVAR_INPUT start, stop : BOOL; END_VAR\nVAR_OUTPUT run : BOOL; END_VAR\n\
             +--[ ]( start )--( )( run )--+\nEND_FUNCTION_BLOCK\n\
             TYPE\n    Cell : STRUCT\n        drive : $Motor;\n        t     : TON;\n        c     : ARRAY[1..2, 1..3] OF CTU;\n    END_STRUCT;\nEND_TYPE\n\
             VAR m1 : $Motor; cell : ARRAY[1..4] OF Cell; a : BOOL; END_VAR\n";
        for (rung, expected) in [
            (
                "[$Motor]( $0 )",
                expect![[r#"
                [$Motor]( state, {start}, stop, run )  BOOL, input
            "#]],
            ),
            (
                "[$Motor]( m1$0, a )",
                expect![[r#"
                [$Motor]( {state}, start, stop, run )  a tag of type $Motor, may be left out: then the state belongs to this place
            "#]],
            ),
            (
                "[$Motor]( m1, $0",
                expect![[r#"
                [$Motor]( state, {start}, stop, run )  BOOL, input
            "#]],
            ),
            (
                "[$Motor]( cell[2].drive, a, $0a )",
                expect![[r#"
                [$Motor]( state, start, {stop}, run )  BOOL, input
            "#]],
            ),
            (
                "[$Motor]( m1, start := a, run => $0 )",
                expect![[r#"
                [$Motor]( state, start, stop, {run} )  BOOL, output
            "#]],
            ),
            (
                "[$Motor]( a, $0a )",
                expect![[r#"
                [$Motor]( state, start, {stop}, run )  BOOL, input
            "#]],
            ),
            (
                "[TON]( cell[1].t, 5$0000 )",
                expect![[r#"
                [TON]( t, {PT}, R := )  The preset time; a plain integer is milliseconds.
            "#]],
            ),
            (
                "[CTU]( cell[k + 1].c[1, 2], $0",
                expect![[r#"
                [CTU]( c, {PV}, R := )  The preset value.
            "#]],
            ),
        ] {
            check(&format!("{plant}+--{rung}--( )( y )--+\n"), expected);
        }
    }

    #[test]
    fn nothing_there() {
        check(
            "+--[ ]( a )--$0( )( y )--+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+--[T$0ON]( t, 5s )--+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+--[FOO]( $0a )--+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+--[ ]( a # $0 # )--+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "VAR\n    a : ARRAY[1..$0 8] OF INT;\nEND_VAR\n",
            expect![[r#"
            nothing
        "#]],
        );
    }
}
