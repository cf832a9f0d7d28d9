//! The networks of a file, one below the other, with the comments between them.

use super::Options;
use super::columns::{Layout, layout};
use super::draw::Drawing;
use super::figure::{Figure, figure};
use super::paper::Paper;
use super::shapes::{Anchor, BlockKind, Picture};
use super::style::{LINE, Look, MARGIN, UNIT};
use super::symbol::{Words, width};
use ladder_analysis::context::Context;
use ladder_syntax::{Item, LineKind};

/// Pixels between a network and what is above it.
const APART: i32 = 14;
/// A network whose right rail would be further right than this column has one of its own.
const WIDEST: u32 = 100;
/// The right rail is never further left.
const LEAST: u32 = 40;

/// One thing on the page.
pub(super) enum PageItem {
    Comment(Vec<String>),
    Heading(String),
    /// The index of a network, and what it looks like.
    Network(usize, Box<(Figure, Layout)>),
    /// The text of a network that cannot be drawn.
    Text(usize, Vec<String>),
    /// A section of declarations, and whether a comment is right above it.
    Section(usize, bool),
}

/// Draws the page.
pub(super) fn draw(context: &Context, options: &Options<'_>) -> Picture {
    let words = Words::of(context, options);
    let mut items = items(&context.parse.structure().items, &words);
    // As in the text: one right rail for all networks but those that are wider than a page.
    let least_rails = items.iter().filter_map(|item| match item {
        PageItem::Network(_, drawn) => drawn.1.least_rail,
        _ => None,
    });
    let rail = least_rails.filter(|&rail| rail <= WIDEST).max();
    let rail = rail.unwrap_or(0).max(options.rail.unwrap_or(LEAST));
    let mut paper = Paper::new(options.live);
    let mut y = MARGIN;
    let mut close = true;
    for item in &mut items {
        if !matches!(item, PageItem::Section(..)) {
            if !close || matches!(item, PageItem::Comment(_)) {
                y += APART;
            }
            close = matches!(item, PageItem::Comment(_) | PageItem::Heading(_));
        }
        y = item.draw(&mut paper, y, rail, context, options);
    }
    paper.finish(y, MARGIN, 20 * UNIT)
}

impl PageItem {
    /// Draws it below `top`, a network up to the right rail in this column if it is no wider. Returns its lower end.
    pub(super) fn draw(
        &mut self,
        paper: &mut Paper,
        top: i32,
        rail: u32,
        context: &Context,
        options: &Options<'_>,
    ) -> i32 {
        let mut y = top;
        let kind = match self {
            PageItem::Comment(lines) => {
                y = texts(paper, Look::Comment, lines, y);
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
                    live: options.live,
                };
                y = drawing.draw(paper, y);
                network(context, *index)
            }
            PageItem::Text(index, lines) => {
                y = texts(paper, Look::Text, lines, y);
                network(context, *index)
            }
            PageItem::Section(section, noted) => BlockKind::Declarations {
                section: *section,
                noted: *noted,
            },
        };
        paper.end_block(kind, top, y);
        y
    }
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

/// What is shown of the items of a file.
pub(super) fn items(items: &[Item], words: &Words<'_>) -> Vec<PageItem> {
    let mut found: Vec<PageItem> = Vec::new();
    // Comments on lines that follow each other are one text.
    let mut goes_on = false;
    for &item in items {
        let follows = std::mem::replace(&mut goes_on, is_comment(words.context, item));
        match PageItem::of(item, words) {
            Some(PageItem::Comment(lines)) if follows => match found.last_mut() {
                Some(PageItem::Comment(before)) => before.extend(lines),
                _ => found.push(PageItem::Comment(lines)),
            },
            Some(PageItem::Section(section, _)) => {
                let noted = follows && matches!(found.last(), Some(PageItem::Comment(_)));
                found.push(PageItem::Section(section, noted));
            }
            item => found.extend(item),
        }
    }
    found
}

/// Whether it is a line with nothing but comments.
pub(super) fn is_comment(context: &Context, item: Item) -> bool {
    matches!(item, Item::Decoration(line) if context.parse.lines()[line].kind == LineKind::Comment)
}

impl PageItem {
    /// What is shown of an item of a file, if anything is.
    fn of(item: Item, words: &Words<'_>) -> Option<PageItem> {
        let context = words.context;
        Some(match item {
            Item::Network(index) if context.networks.at(index).broken => {
                let range = context.networks.at(index).range;
                let text = words.text_of(range);
                let lines = text.lines().map(str::to_owned);
                PageItem::Text(index, lines.collect())
            }
            Item::Network(index) => {
                let figure = figure(context.networks.at(index), words);
                let layout = layout(&figure);
                PageItem::Network(index, Box::new((figure, layout)))
            }
            Item::BlockHeader(block) => {
                let name = context
                    .user_blocks
                    .get(block)
                    .map_or("", |block| block.name.as_str());
                PageItem::Heading(format!("FUNCTION_BLOCK {name}"))
            }
            Item::BlockEnd(_) => PageItem::Heading("END_FUNCTION_BLOCK".to_owned()),
            Item::Decoration(line) if is_comment(context, item) => {
                let lines = words.comments_of(line);
                if lines.is_empty() {
                    return None;
                }
                PageItem::Comment(lines)
            }
            Item::Section(section) => PageItem::Section(section, false),
            Item::Decoration(_) | Item::Stray(_) => return None,
        })
    }
}
