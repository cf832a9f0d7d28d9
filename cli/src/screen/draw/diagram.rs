//! The program with its power: live wires are double and bold, what is high has a dot, what is forced an `F`.

use super::{Scene, put};
use crate::screen::columns::{self, Cell};
use crate::screen::fold::{ColumnPlace, Folding};
use crate::screen::sheet::{Block, Mark, Shown};
use crate::screen::theme::{heading as heading_style, quiet};
use crate::screen::values;
use ladder_analysis::program::ElementKind;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::Breakpoint;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};

pub(super) fn draw(buffer: &mut Buffer, gutter: Rect, pane: Rect, scene: Scene) {
    let Scene { view, plant, theme } = scene;
    let sheet = &plant.sheet;
    let selected_line = sheet.blocks.get(view.selected).map(|block| block.line);
    let fault_line = plant
        .last_fault()
        .and_then(|(fault, _)| Some(sheet.place(fault.location)?.0));
    let next = plant.simulation().next_block();
    let next_line = next.and_then(|location| Some(sheet.place(location)?.0));
    let breakpoints = breakpoint_lines(scene);
    let numbers = gutter.width > 3;
    let folding = sheet.folding(pane.width.into());
    for row in 0..pane.height {
        let line = view.top + row as usize;
        if line >= sheet.height() {
            return;
        }
        if numbers {
            let width = gutter.width as usize - 3;
            put(buffer, gutter, 0, row, &format!("{:>width$}", line + 1), quiet());
        }
        let warning = if fault_line == Some(line) {
            Some(("!", theme.alarm()))
        } else if breakpoints.contains(&line) {
            Some((theme.breakpoint(), theme.note()))
        } else {
            None
        };
        if let Some((mark, style)) = warning {
            put(buffer, gutter, gutter.width.saturating_sub(3), row, mark, style);
        }
        let place = if next_line == Some(line) {
            Some(theme.next())
        } else if selected_line == Some(line) {
            Some(">")
        } else {
            None
        };
        if let Some(mark) = place {
            put(
                buffer,
                gutter,
                gutter.width.saturating_sub(2),
                row,
                mark,
                heading_style(),
            );
        }
        draw_line(buffer, pane, row, line, folding, scene);
    }
}

/// The lines of the rungs that a run stops at.
fn breakpoint_lines(scene: Scene) -> Vec<usize> {
    let program = scene.plant.simulation().program();
    let networks = scene
        .plant
        .breakpoints()
        .iter()
        .filter_map(|breakpoint| match breakpoint {
            Breakpoint::Network(network) => program.networks.get(*network),
            Breakpoint::Block(_) | Breakpoint::Change(_) => None,
        });
    networks
        .filter_map(|network| Some(scene.plant.sheet.place(network.location)?.0))
        .collect()
}

/// How one character is drawn.
#[derive(Debug, Clone, Copy)]
struct Look {
    style: Style,
    /// Another character in its place.
    instead: Option<char>,
}

/// What of a line is not seen between its left part and its right-hand blocks.
#[derive(Debug, Clone, Copy)]
enum Hidden {
    Nothing,
    /// Only wire, which looks so.
    Wire(Look),
    More,
}

impl Hidden {
    fn add(&mut self, cell: Cell, in_block: bool, look: Look) {
        *self = match (cell.shown, *self) {
            (_, Hidden::More) => Hidden::More,
            ("-", _) if !in_block => Hidden::Wire(look),
            (" ", hidden) if !in_block => hidden,
            _ => Hidden::More,
        };
    }
}

fn draw_line(buffer: &mut Buffer, pane: Rect, row: u16, line: usize, folding: Folding, scene: Scene) {
    let Scene { view, plant, theme } = scene;
    let sheet = &plant.sheet;
    let window = sheet.window(line, folding, view.left);
    let text = sheet.line(line);
    let start = sheet.line_start(line);
    let first = sheet.blocks_of(line).start;
    let blocks: Vec<(&Block, bool)> = sheet.blocks[sheet.blocks_of(line)]
        .iter()
        .enumerate()
        .map(|(index, block)| (block, first + index == view.selected))
        .collect();
    let marks = sheet.marks(line);
    let mut mark = 0;
    // Where the next character would be, and where the rail ends.
    let (mut end, mut rail) = (0, 0);
    let mut between = Hidden::Nothing;
    let mut hides_a_block = false;
    for cell in columns::cells(text) {
        let place = window.place(cell.column);
        let offset = start + cell.offset;
        while mark < marks.len() && marks[mark].end <= offset {
            mark += 1;
        }
        let under = marks.get(mark).filter(|mark| mark.start <= offset);
        let column = match place {
            ColumnPlace::Seen(column) if column + cell.width <= pane.width as usize => column as u16,
            ColumnPlace::Seen(_) | ColumnPlace::After => {
                hides_a_block = blocks.last().is_some_and(|(last, _)| last.end > offset);
                break;
            }
            ColumnPlace::Between => {
                let in_block = sheet.block_at(offset).is_some();
                between.add(
                    cell,
                    in_block,
                    look(offset, &text[cell.offset..], under, &blocks, scene),
                );
                continue;
            }
            ColumnPlace::Before | ColumnPlace::Folded => continue,
        };
        let look = look(offset, &text[cell.offset..], under, &blocks, scene);
        let mut letter = [0; 4];
        let shown = match look.instead {
            Some(instead) => instead.encode_utf8(&mut letter),
            None => cell.shown,
        };
        // A tab is more than one blank.
        for blank in 1..cell.width {
            put(buffer, pane, column + blank as u16, row, " ", look.style);
        }
        put(buffer, pane, column, row, shown, look.style);
        end = column + cell.width as u16;
        if !sheet.is_comment(offset) && cell.shown != " " {
            rail = end;
        }
    }
    if let Some(split) = window.split() {
        draw_gap(buffer, pane, row, split.at as u16, between, scene);
    }
    if hides_a_block {
        put(
            buffer,
            pane,
            pane.width.saturating_sub(1),
            row,
            theme.more(),
            theme.note(),
        );
    } else {
        let needed = values_width(line, scene);
        let column = if end + 2 + needed <= pane.width { end } else { rail };
        draw_values(buffer, pane, row, column + 2, line, scene);
    }
}

/// The column between the left part of a wide line and its right-hand blocks.
fn draw_gap(buffer: &mut Buffer, pane: Rect, row: u16, column: u16, hidden: Hidden, scene: Scene) {
    match hidden {
        Hidden::Nothing => {}
        Hidden::Wire(look) => {
            let shown = look.instead.unwrap_or('-').to_string();
            put(buffer, pane, column, row, &shown, look.style);
        }
        Hidden::More => {
            put(buffer, pane, column, row, scene.theme.more(), scene.theme.note());
        }
    }
}

fn look(offset: usize, rest: &str, mark: Option<&Mark>, blocks: &[(&Block, bool)], scene: Scene) -> Look {
    let Scene { plant, theme, .. } = scene;
    let live = mark.is_some_and(|mark| plant.simulation().is_live(mark.element));
    let power = if live { theme.live() } else { Style::new() };
    let block = blocks
        .iter()
        .find(|(block, _)| (block.start..block.end).contains(&offset));
    let Some(&(block, selected)) = block else {
        let is_wire = mark.is_some_and(|mark| mark.kind == ElementKind::Wire);
        return match mark {
            Some(_) if is_wire && rest.starts_with('-') => Look {
                style: power,
                instead: Some(theme.wire(live)),
            },
            // A comment that joins two wires keeps its text.
            Some(_) if is_wire && !live => plain(quiet()),
            Some(_) => plain(power),
            None if plant.sheet.is_comment(offset) => plain(quiet()),
            None => plain(Style::new()),
        };
    };
    let mut look = look_of_block(offset, rest, block, power, scene);
    if selected {
        look.style = look.style.add_modifier(Modifier::REVERSED);
    }
    look
}

/// A block's brackets show the power that leaves it, its tags what they hold.
fn look_of_block(offset: usize, rest: &str, block: &Block, power: Style, scene: Scene) -> Look {
    let Scene { plant, theme, .. } = scene;
    let blank = rest.starts_with(' ');
    for operand in plant.operands(block).iter() {
        let point = &operand.point;
        let inside = (operand.start..operand.end).contains(&offset);
        let before = blank && offset + 1 == operand.start;
        let after = blank && offset == operand.end;
        if !inside && !before && !after {
            continue;
        }
        let high = plant.is_high(point);
        let forced = plant.is_forced(point);
        let state = match (forced, high) {
            (true, _) => theme.forced(),
            (false, true) => theme.live(),
            (false, false) => Style::new(),
        };
        if inside {
            return plain(state);
        }
        if before && high {
            return Look {
                style: state,
                instead: Some(theme.dot(true)),
            };
        }
        if after && forced {
            return Look {
                style: state,
                instead: Some('F'),
            };
        }
        if before && forced {
            return plain(state);
        }
    }
    plain(power)
}

fn plain(style: Style) -> Look {
    Look { style, instead: None }
}

/// How many columns the values of a line take now.
fn values_width(line: usize, scene: Scene) -> u16 {
    let texts = scene
        .plant
        .sheet
        .shown(line)
        .map(|shown| value_text(shown, scene))
        .filter(|text| !text.is_empty());
    let widths = texts.map(|text| ladder_format::display_width(&text) as u16);
    widths
        .reduce(|all, next| all.saturating_add(2).saturating_add(next))
        .unwrap_or(0)
}

/// The values after the end of a line. What is there is a comment, and gives way.
fn draw_values(buffer: &mut Buffer, pane: Rect, row: u16, column: u16, line: usize, scene: Scene) {
    let Scene { plant, theme, .. } = scene;
    let mut column = column;
    for shown in plant.sheet.shown(line) {
        for blank in column.saturating_sub(2)..pane.width {
            put(buffer, pane, blank, row, " ", Style::new());
        }
        let forced = match shown {
            Shown::Progress { reached, .. } => plant.is_forced(reached),
            Shown::Value(point) => plant.is_forced(point),
            Shown::Indexed(indexed) => {
                let point = plant.simulation().indexed_point(&indexed.place);
                point.is_some_and(|point| plant.is_forced(&point))
            }
        };
        let style = if forced { theme.forced() } else { theme.value() };
        let mut text = value_text(shown, scene);
        if text.is_empty() {
            continue;
        }
        if forced {
            text.push_str(" F");
        }
        let width = ladder_format::display_width(&text) as u16;
        if column + width > pane.width {
            // Half a number is another number. The rail is not written over.
            let edge = pane.width.saturating_sub(1);
            if edge + 2 >= column {
                put(buffer, pane, edge, row, theme.more(), theme.note());
            }
            return;
        }
        column = put(buffer, pane, column, row, &text, style) + 2;
    }
}

/// `warmup 1.2s/5s`, `level=42`, `trip[2]=1`; nothing of an index that leads to no element.
pub(super) fn value_text(shown: &Shown, scene: Scene) -> String {
    let plant = scene.plant;
    match shown {
        Shown::Progress {
            name, reached, goal, ..
        } => format!(
            "{name} {}/{}",
            values::short(&plant.value(reached), reached.ty),
            values::goal(&plant.value(goal), goal.ty),
        ),
        Shown::Value(point) => format!("{}={}", point.name, values::short(&plant.value(point), point.ty)),
        Shown::Indexed(indexed) => match plant.simulation().indexed_point(&indexed.place) {
            Some(point) if point.ty == Scalar::Bool => {
                format!("{}={}", point.name, u8::from(plant.is_high(&point)))
            }
            Some(point) => format!("{}={}", point.name, values::short(&plant.value(&point), point.ty)),
            None => String::new(),
        },
    }
}
