//! The networks of a file, one below the other, with the comments between them.

use super::Options;
use super::columns::{Layout, layout};
use super::draw::Drawing;
use super::figure::{Figure, figure};
use super::paper::Paper;
use super::scene::{Anchor, BlockKind, Scene};
use super::style::{LINE, Look, MARGIN, UNIT};
use super::symbol::{Words, width};
use ladder_analysis::context::Context;
use ladder_syntax::{Item, LineKind};

/// Pixels between a network and what stands above it.
const APART: i32 = 14;
/// A network whose right rail would be further right than this column has one of its own.
const WIDEST: u32 = 100;
/// The right rail is never further left.
const LEAST: u32 = 40;

/// One thing on the page.
enum PageItem {
    Comment(Vec<String>),
    Heading(String),
    /// The index of a network, and what it looks like.
    Network(usize, Box<(Figure, Layout)>),
    /// The text of a network that cannot be drawn.
    Text(usize, Vec<String>),
    /// A section of declarations, and whether a comment stands right above it.
    Section(usize, bool),
}

/// Draws the page.
pub(super) fn draw(context: &Context, options: &Options<'_>) -> Scene {
    let text = context.parse.to_string();
    let words = Words {
        context,
        text: &text,
        value: options.value,
    };
    let mut parts = parts(context, &words);
    // As in the text: one right rail for all networks but those that are wider than a page.
    let least_rails = parts.iter().filter_map(|part| match part {
        PageItem::Network(_, drawn) => drawn.1.least_rail,
        _ => None,
    });
    let rail = least_rails.filter(|&rail| rail <= WIDEST).max();
    let rail = rail.unwrap_or(0).max(LEAST);
    let mut paper = Paper::default();
    let mut y = MARGIN;
    let mut close = true;
    for part in &mut parts {
        if !matches!(part, PageItem::Section(..)) {
            if !close || matches!(part, PageItem::Comment(_)) {
                y += APART;
            }
            close = matches!(part, PageItem::Comment(_) | PageItem::Heading(_));
        }
        let top = y;
        let kind = match part {
            PageItem::Comment(lines) => {
                y = texts(&mut paper, Look::Comment, lines, y);
                BlockKind::Comment(std::mem::take(lines))
            }
            PageItem::Heading(heading) => {
                y += LINE + 4;
                let at = (MARGIN, y - 4);
                paper.text(Look::Name, at, Anchor::Start, width(heading), heading);
                BlockKind::Heading
            }
            PageItem::Network(index, drawn) => {
                y += 4;
                let (figure, layout) = &mut **drawn;
                let rail = layout.least_rail.map(|least| least.max(rail));
                if let Some(rail) = rail {
                    layout.move_right(rail);
                }
                let drawing = Drawing {
                    parse: &context.parse,
                    index: *index,
                    network: context.networks.at(*index),
                    figure,
                    layout,
                    rail,
                    power: options.power.as_ref(),
                };
                y = drawing.draw(&mut paper, y);
                network(context, *index)
            }
            PageItem::Text(index, lines) => {
                y = texts(&mut paper, Look::Text, lines, y);
                network(context, *index)
            }
            PageItem::Section(section, noted) => {
                let (section, noted) = (*section, *noted);
                BlockKind::Declarations { section, noted }
            }
        };
        paper.end_block(kind, top, y);
    }
    paper.finish(y, MARGIN, 20 * UNIT)
}

fn network(context: &Context, index: usize) -> BlockKind {
    BlockKind::Network {
        index,
        line: context.line_number(context.networks.at(index).range.start()),
    }
}

fn texts(paper: &mut Paper, look: Look, lines: &[String], mut y: i32) -> i32 {
    for line in lines {
        y += LINE;
        paper.text(look, (MARGIN, y - 4), Anchor::Start, width(line), line);
    }
    y
}

fn parts(context: &Context, words: &Words<'_>) -> Vec<PageItem> {
    let parse = &context.parse;
    let mut parts: Vec<PageItem> = Vec::new();
    // Comments on lines that follow each other are one text.
    let mut goes_on = false;
    for item in &parse.structure().items {
        let follows = std::mem::replace(&mut goes_on, false);
        match *item {
            Item::Network(index) if context.networks.at(index).broken => {
                let range = context.networks.at(index).range;
                let lines = words.text_of(range).lines().map(str::to_owned);
                parts.push(PageItem::Text(index, lines.collect()));
            }
            Item::Network(index) => {
                let figure = figure(context.networks.at(index), words);
                let layout = layout(&figure);
                parts.push(PageItem::Network(index, Box::new((figure, layout))));
            }
            Item::BlockHeader(block) => {
                let name = context
                    .user_blocks
                    .get(block)
                    .map_or("", |block| block.name.as_str());
                parts.push(PageItem::Heading(format!("FUNCTION_BLOCK {name}")));
            }
            Item::BlockEnd(_) => parts.push(PageItem::Heading("END_FUNCTION_BLOCK".to_owned())),
            Item::Decoration(line) if parse.lines()[line].kind == LineKind::Comment => {
                let lines = words.comments_of(line);
                goes_on = true;
                match parts.last_mut() {
                    Some(PageItem::Comment(before)) if follows => before.extend(lines),
                    _ if lines.is_empty() => {}
                    _ => parts.push(PageItem::Comment(lines)),
                }
            }
            Item::Section(section) => {
                let noted = follows && matches!(parts.last(), Some(PageItem::Comment(_)));
                parts.push(PageItem::Section(section, noted));
            }
            Item::Decoration(_) | Item::Stray(_) => {}
        }
    }
    parts
}
