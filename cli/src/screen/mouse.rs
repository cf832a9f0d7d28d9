//! What clicks and the wheel do.

use super::draw::hints;
use super::keys;
use super::plant::Plant;
use super::update::Command;
use super::view::{Mode, View};
use super::{columns, inputs};
use ratatui::crossterm::event::{KeyModifiers, MouseButton, MouseEvent, MouseEventKind};
use ratatui::layout::{Position, Rect};

/// This many lines or columns are scrolled by one notch of the wheel.
const NOTCH: isize = 3;

/// Takes in what the mouse did.
pub(super) fn update(view: &mut View, event: MouseEvent, plant: &Plant) -> Vec<Command> {
    let sideways = event.modifiers.contains(KeyModifiers::SHIFT);
    match event.kind {
        MouseEventKind::ScrollUp if sideways => view.scroll_sideways(-NOTCH, plant),
        MouseEventKind::ScrollDown if sideways => view.scroll_sideways(NOTCH, plant),
        MouseEventKind::ScrollUp => view.scroll(-NOTCH, plant),
        MouseEventKind::ScrollDown => view.scroll(NOTCH, plant),
        MouseEventKind::ScrollLeft => view.scroll_sideways(-NOTCH, plant),
        MouseEventKind::ScrollRight => view.scroll_sideways(NOTCH, plant),
        MouseEventKind::Down(MouseButton::Left) => {
            view.note = None;
            return click(view, Position::new(event.column, event.row), plant);
        }
        _ => {}
    }
    Vec::new()
}

fn click(view: &mut View, at: Position, plant: &Plant) -> Vec<Command> {
    if !matches!(view.mode, Mode::Diagram) {
        // A click next to what is open closes it.
        view.mode = Mode::Diagram;
        return Vec::new();
    }
    let panes = view.panes(plant);
    if panes.diagram.contains(at) {
        return click_diagram(view, panes.diagram, at, plant);
    }
    if panes.inputs.contains(at) {
        return click_input(view, panes.inputs, at, plant);
    }
    if panes.watch.contains(at) {
        let line = usize::from(at.y - panes.watch.y);
        let track = line.checked_sub(1).and_then(|line| plant.watched().get(line));
        if let Some(track) = track {
            view.go_to_tag(&track.point, plant);
        }
        return Vec::new();
    }
    if panes.hints.contains(at)
        && let Some(action) = hints::at(
            at.x - panes.hints.x,
            keys::hints(view.running, plant.watching().is_some()),
            panes.hints.width,
        )
    {
        return view.act(action, plant);
    }
    Vec::new()
}

/// A click on a block selects it; on the contact of an input it also switches it.
fn click_diagram(view: &mut View, pane: Rect, at: Position, plant: &Plant) -> Vec<Command> {
    let sheet = &plant.sheet;
    let line = view.top + usize::from(at.y - pane.y);
    if line >= sheet.height() {
        return Vec::new();
    }
    let window = sheet.window(line, sheet.folding(pane.width.into()), view.left);
    let column = window.drawn_at(usize::from(at.x - pane.x));
    let Some(offset) = column.and_then(|column| columns::offset(sheet.line(line), column)) else {
        return Vec::new();
    };
    let Some(index) = sheet.block_at(sheet.line_start(line) + offset) else {
        return Vec::new();
    };
    view.selected = index;
    let block = &sheet.blocks[index];
    if plant
        .operands(block)
        .iter()
        .any(|operand| Plant::is_input(&operand.point))
    {
        return view.switch_selected(plant);
    }
    Vec::new()
}

fn click_input(view: &mut View, pane: Rect, at: Position, plant: &Plant) -> Vec<Command> {
    let Some(line) = (at.y - pane.y).checked_sub(1) else {
        return Vec::new();
    };
    let column = at.x - pane.x;
    let flow = inputs::flow(plant, pane.width);
    let entry = flow
        .entries
        .iter()
        .find(|entry| entry.line == line && (entry.column..entry.column + entry.width).contains(&column));
    match entry {
        Some(entry) => view.switch(&inputs::numbered(plant)[entry.index].clone(), plant),
        None => Vec::new(),
    }
}
