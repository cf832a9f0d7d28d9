//! What the drawing does of itself while a person types.
//!
//! - When a block, a branch or a rung is completed its network is drawn again. One in which something is open
//!   (a parenthesis, a connector without its partner) stays as it is, to the letter.
//! - Enter within a network goes on with its rail, and below an open `\` with the cursor under it.
//! - Enter behind a rung that completes its network draws the network again.
//! - Enter in a section indents the next declaration.
//!
//! Only blanks, wires and rails change: what was typed stays.

use crate::body::line_text;
use ladder_analysis::context::Context;
use ladder_analysis::networks::NetworkAt;
use ladder_format::{Edit, Options, display_width, format_ranges};
use ladder_syntax::wiring::{PartKind, Rung};
use ladder_syntax::{LineKind, Mode, SyntaxKind, TextRange, TextSize};

/// The characters behind which the drawing may do something.
pub const TRIGGERS: [char; 5] = ['\n', ')', '/', '+', '>'];

/// How far declarations stand in (LANGUAGE §8 rule 8).
const INDENT: &str = "    ";

/// The edits after a character was typed; `offset` is right behind it. Sorted, none touching another.
pub fn on_type(context: &Context, offset: TextSize, typed: char, options: &Options) -> Vec<Edit> {
    match typed {
        '\n' => enter(context, offset, options),
        ')' | '/' | '+' | '>' => completed(context, offset, options).unwrap_or_default(),
        _ => Vec::new(),
    }
}

/// The network drawn again, if what ends at the offset completes a block, a branch or a rung.
fn completed(context: &Context, offset: TextSize, options: &Options) -> Option<Vec<Edit>> {
    let parse = &context.parse;
    let before = offset.checked_sub(TextSize::new(1))?;
    let line = parse.line_at(before)?;
    if parse.lines()[line].kind != LineKind::Rung {
        return None;
    }
    let syntax = parse.lines()[line].syntax();
    let within = offset - parse.line_start(line);
    let token = syntax.token_at_offset(within).left_biased()?;
    if token.text_range().end() != within {
        return None;
    }
    let of = token.parent()?.kind();
    let completes = match token.kind() {
        // The first part of a coil has its operand still to come.
        SyntaxKind::R_PAREN => of == SyntaxKind::OPERAND_LIST,
        SyntaxKind::R_ANGLE => of == SyntaxKind::BLOCK_HEAD,
        SyntaxKind::UP | SyntaxKind::RAIL_CONNECTOR => true,
        _ => false,
    };
    if !completes {
        return None;
    }
    drawn_again(context, line, options)
}

/// The edits that lay out the network of a line, if nothing in it is open.
fn drawn_again(context: &Context, line: usize, options: &Options) -> Option<Vec<Edit>> {
    let network = network_at(context, line)?;
    let open = network.broken || !network.wiring.unpaired.is_empty();
    if open || context.parse.unclosed_comment().is_some() {
        return None;
    }
    Some(format_ranges(&context.parse, options, &[network.range]))
}

fn network_at(context: &Context, line: usize) -> Option<NetworkAt<'_>> {
    let networks = &context.parse.structure().networks;
    let number = networks.partition_point(|network| network.lines.end <= line);
    let found = networks.get(number)?.lines.contains(&line);
    found.then(|| context.networks.at(number))
}

fn enter(context: &Context, offset: TextSize, options: &Options) -> Vec<Edit> {
    let parse = &context.parse;
    let Some((new_line, above)) = blank_line(context, offset) else {
        return Vec::new();
    };
    if parse.unclosed_comment().is_some_and(|open| open.start() < offset) {
        return Vec::new();
    }
    let line = &parse.lines()[above];
    if line.mode_after == Mode::Section
        && matches!(line.kind, LineKind::SectionHeader | LineKind::Declaration)
    {
        return replace(context, new_line, INDENT.to_owned());
    }
    if !matches!(line.kind, LineKind::Rung | LineKind::Rail) {
        return Vec::new();
    }
    match goes_on(context, above) {
        Some(prefix) => replace(context, new_line, prefix),
        None if line.kind == LineKind::Rung => drawn_again(context, above, options).unwrap_or_default(),
        None => Vec::new(),
    }
}

/// The blanks of the physical line that an offset is in, if it holds nothing else, and the logical line above it.
fn blank_line(context: &Context, offset: TextSize) -> Option<(TextRange, usize)> {
    let parse = &context.parse;
    let line = parse.line_at(offset)?;
    // At the end of the text there is no logical line behind the last line end.
    if parse.line_range(line).end() == offset && ends_line(context, line) {
        return Some((TextRange::empty(offset), line));
    }
    if parse.lines()[line].kind != LineKind::Blank {
        return None;
    }
    let above = line.checked_sub(1).filter(|&above| ends_line(context, above))?;
    let text = line_text(parse, line);
    let blanks = TextSize::of(text.trim_end_matches(['\r', '\n']));
    Some((TextRange::at(parse.line_start(line), blanks), above))
}

fn ends_line(context: &Context, line: usize) -> bool {
    let text = line_text(&context.parse, line);
    text.ends_with(['\n', '\r'])
}

/// What the line below one begins with, if the network goes on there: its rail, and blanks up to the first `\`
/// that waits for its partner.
fn goes_on(context: &Context, above: usize) -> Option<String> {
    let parse = &context.parse;
    let structure = &parse.structure().networks;
    // Rail lines behind the last rung do not belong to the network any more.
    let rung_above = (0..=above)
        .rev()
        .take_while(|&line| parse.lines()[line].kind.is_decoration() || line == above)
        .find(|&line| parse.lines()[line].kind == LineKind::Rung)
        .or_else(|| {
            let mut lines = (0..above).rev();
            lines
                .find(|&line| !parse.lines()[line].kind.is_decoration())
                .filter(|&line| parse.lines()[line].kind == LineKind::Rung)
        })?;
    let network = network_at(context, rung_above)?;
    let number = structure.partition_point(|network| network.lines.end <= rung_above);
    let rung = (0..network.wiring.rungs.len()).find(|&rung| network.line(rung) == rung_above)?;
    let open = network
        .wiring
        .unpaired
        .iter()
        .find(|(of, part)| *of == rung && network.wiring.rungs[rung].parts[*part].kind == PartKind::Down);
    let inside = structure[number].lines.end > above + 1;
    if open.is_none() && !inside {
        return None;
    }
    let railed = network.wiring.rungs.iter().any(Rung::has_left_rail);
    let mut prefix = if railed { "|  ".to_owned() } else { String::new() };
    if let Some(&(_, part)) = open {
        let range = network.part_range(parse, rung, part);
        let text = line_text(parse, rung_above);
        let before = &text[..usize::from(range.start() - parse.line_start(rung_above))];
        let column = display_width(before.rsplit(['\n', '\r']).next().unwrap_or(before));
        while display_width(&prefix) < column {
            prefix.push(' ');
        }
    }
    Some(prefix)
}

fn replace(context: &Context, range: TextRange, new: String) -> Vec<Edit> {
    let text = crate::outline::text_of(&context.parse, range);
    if text == new {
        return Vec::new();
    }
    vec![Edit { range, text: new }]
}

#[cfg(test)]
mod tests {
    use super::on_type;
    use crate::fixture::Fixture;
    use expect_test::{Expect, expect};
    use ladder_format::{Options, apply};

    /// The character before the cursor is the one that was typed; blanks there are those that an editor puts behind a
    /// line end.
    fn check(text: &str, expected: Expect) {
        let fixture = Fixture::new(text);
        let (context, offset, _) = fixture.ask();
        let before = fixture.text("main.clad");
        let typed = before[..usize::from(offset)]
            .trim_end_matches(' ')
            .chars()
            .next_back();
        let typed = typed.unwrap();
        let edits = on_type(context, offset, typed, &Options::default());
        let shown = if edits.is_empty() {
            "nothing".to_owned()
        } else {
            let after = apply(before, &edits);
            let solid = |text: &str| text.replace([' ', '-', '|', '\n', '\r'], "");
            assert_eq!(solid(before), solid(&after), "nothing is lost");
            after.replace('\r', "").replace(" \n", "·\n")
        };
        expected.assert_eq(&(shown + "\n"));
    }

    #[test]
    fn a_completed_block_draws_its_network() {
        check(
            "+--\\--[ ]( start )$0--\\--( )( run )--+\n|  /--[ ]( run )--/\n",
            expect![[r#"
                +--\--[ ]( start )--\------( )( run )--+
                |  /--[ ]( run )----/                  |

            "#]],
        );
        check(
            "+--[ ]( a )$0",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+--[ ]( a )--<RET>$0--+\n",
            expect![[r#"
            +--[ ]( a )---------------------<RET>--+

        "#]],
        );
        check(
            "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( bbbbbbb )--/$0\n",
            expect![[r#"
                +--\--[ ]( a )--------\------( )( y )--+
                |  /--[ ]( bbbbbbb )--/                |

            "#]],
        );
        check(
            "+--[ ]( a )--( )( y )--+$0\n\n+-[ ]( x )-( )( z )-+\n",
            expect![[r#"
                +--[ ]( a )------------------( )( y )--+

                +-[ ]( x )-( )( z )-+

            "#]],
        );
    }

    #[test]
    fn what_is_half_typed_stays() {
        check(
            "+--[ ]( a )--( )$0--+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+--[CALC]( y, (a + b)$0 --( )( x )--+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+--\\--[ ]( a )--\\--( )( y )$0--+\n|  /--[ ]( b )\n",
            expect![[r#"
                nothing
            "#]],
        );
        check(
            "+--[ ]( a )$0-------------[TON]( t\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "# a (b)$0 #\n+-[ ]( a )-( )( y )-+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+-[ ]( a )-( )( y )-+  # (c)$0 #\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+-[ ]( a )-[MOV]( y, 'x)$0' )-+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+-[/$0]( a )-( )( y )-+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "# open +-[ ]( a )$0-( )( y )-+\n",
            expect![[r#"
            nothing
        "#]],
        );
    }

    #[test]
    fn enter_goes_on_with_the_rail() {
        check(
            "+--\\--[ ]( a )--\\--( )( y )--+\n$0",
            expect![[r#"
            +--\--[ ]( a )--\--( )( y )--+
            |  
        "#]],
        );
        check(
            "+--[ ]( ä )--\\--[ ]( b )--\\--( )( y )--+\n  $0\n",
            expect![[r#"
                +--[ ]( ä )--\--[ ]( b )--\--( )( y )--+
                |           ·

            "#]],
        );
        check(
            "+--\\--[ ]( a )--\\--( )( y )--+\n$0\n|  /--[ ]( b )--/            |\n",
            expect![[r#"
                +--\--[ ]( a )--\--( )( y )--+
                | ·
                |  /--[ ]( b )--/            |

            "#]],
        );
        check(
            "+--\\--[ ]( a )--\\--( )( y )--+\r\n|  |  |\r\n$0\r\n",
            expect![[r#"
                +--\--[ ]( a )--\--( )( y )--+
                |  |  |
                | ·

            "#]],
        );
        check(
            "[ ]( b )--\\--[ ]( a )--\n$0\n",
            expect![[r#"
                [ ]( b )--\--[ ]( a )--
                         ·

            "#]],
        );
    }

    #[test]
    fn enter_elsewhere() {
        check(
            "+--[ ]( a )-( )( y )--+\n$0",
            expect![[r#"
            +--[ ]( a )------------------( )( y )--+

        "#]],
        );
        check(
            "+--[ ]( a )-( )( y )--+\n\n$0\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+--[ ]( a )\n$0--( )( y )--+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+--[ ]( a\n$0\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "VAR\n$0\nEND_VAR\n",
            expect![[r#"
            VAR
               ·
            END_VAR

        "#]],
        );
        check(
            "VAR\n    a : INT;\n  $0\nEND_VAR\n",
            expect![[r#"
                VAR
                    a : INT;
                   ·
                END_VAR

            "#]],
        );
        check(
            "VAR\n    a : INT;\nEND_VAR\n$0\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "# comment\n$0\n #\n+-[ ]( a )-+\n",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "+--[ ]( a )--+  # open\n$0",
            expect![[r#"
            nothing
        "#]],
        );
        check(
            "\n$0",
            expect![[r#"
            nothing
        "#]],
        );
    }
}
