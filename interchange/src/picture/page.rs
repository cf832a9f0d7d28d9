//! The networks of a file, one below the other, with the comments between them.

use super::Options;
use super::draw::Drawing;
use super::paper::{Anchor, Paper};
use super::place::{Figure, figure};
use super::style::{LINE, MARGIN, UNIT, sheet};
use super::symbol::{Words, width};
use ladder_analysis::context::Context;
use ladder_format::Layout;
use ladder_syntax::{Item, LineKind};

/// Pixels between a network and what stands above it.
const APART: i32 = 14;

/// One thing on the page.
enum Part {
    Comment(Vec<String>),
    Heading(String),
    /// The index of a network, and what it looks like.
    Network(usize, Box<Figure>),
    /// The text of a network that cannot be drawn.
    Text(Vec<String>),
}

/// Draws the page.
pub(super) fn draw(context: &Context, options: &Options<'_>) -> String {
    let text = context.parse.to_string();
    let words = Words {
        context,
        text: &text,
        value: options.value,
    };
    let parts = parts(context, &words);
    let layout_options = ladder_format::Options::default();
    let place = |figure: &Figure, rail| figure.sketch.clone().lay_out(&layout_options, rail);
    // As in the text: one right rail for all networks but those that are wider than a page.
    let rail = parts
        .iter()
        .filter_map(|part| match part {
            Part::Network(_, figure) => place(figure, None).right_rail(),
            _ => None,
        })
        .filter(|&rail| rail <= layout_options.width)
        .max();
    let mut paper = Paper::default();
    let mut y = MARGIN;
    let mut close = true;
    for part in &parts {
        if !close || matches!(part, Part::Comment(_)) {
            y += APART;
        }
        close = matches!(part, Part::Comment(_) | Part::Heading(_));
        match part {
            Part::Comment(lines) => y = comment(&mut paper, lines, y),
            Part::Heading(heading) => {
                y += LINE + 4;
                let at = (MARGIN, y - 4);
                paper.text("name", at, Anchor::Start, width(heading), heading);
            }
            Part::Network(index, figure) => {
                y += 4;
                let layout: Layout = place(figure, rail);
                let drawing = Drawing {
                    parse: &context.parse,
                    network: &context.networks[*index],
                    figure,
                    layout: &layout,
                    power: options.power.as_ref(),
                };
                let line = context.line_number(context.networks[*index].range.start());
                paper.begin_group(&format!("Line {line}"));
                y = drawing.draw(&mut paper, y);
                paper.end_group();
            }
            Part::Text(lines) => {
                for line in lines {
                    y += LINE;
                    paper.text("", (MARGIN, y - 4), Anchor::Start, width(line), line);
                }
            }
        }
    }
    let right = paper.width + MARGIN;
    paper.document(right.max(20 * UNIT), y + MARGIN, &sheet(options.theme))
}

fn comment(paper: &mut Paper, lines: &[String], mut y: i32) -> i32 {
    for line in lines {
        y += LINE;
        paper.text("comment", (MARGIN, y - 4), Anchor::Start, width(line), line);
    }
    y
}

fn parts(context: &Context, words: &Words<'_>) -> Vec<Part> {
    let parse = &context.parse;
    let mut parts: Vec<Part> = Vec::new();
    // Comments on lines that follow each other are one text.
    let mut goes_on = false;
    for item in &parse.structure().items {
        let follows = std::mem::replace(&mut goes_on, false);
        match *item {
            Item::Network(index) if context.networks[index].broken => {
                let range = context.networks[index].range;
                let lines = words.text_of(range).lines().map(str::to_owned);
                parts.push(Part::Text(lines.collect()));
            }
            Item::Network(index) => {
                let figure = figure(&context.networks[index], words);
                parts.push(Part::Network(index, Box::new(figure)));
            }
            Item::BlockHeader(block) => {
                let name = context
                    .user_blocks
                    .get(block)
                    .map_or("", |block| block.name.as_str());
                parts.push(Part::Heading(format!("FUNCTION_BLOCK {name}")));
            }
            Item::BlockEnd(_) => parts.push(Part::Heading("END_FUNCTION_BLOCK".to_owned())),
            Item::Decoration(line) if parse.lines()[line].kind == LineKind::Comment => {
                let lines = words.comments_of(line);
                goes_on = true;
                match parts.last_mut() {
                    Some(Part::Comment(before)) if follows => before.extend(lines),
                    _ if lines.is_empty() => {}
                    _ => parts.push(Part::Comment(lines)),
                }
            }
            Item::Decoration(_) | Item::Section(_) | Item::Stray(_) => {}
        }
    }
    parts
}
