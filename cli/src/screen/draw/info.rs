//! The line above the keys: what is selected, the last message, what is being typed.

use super::{Scene, put};
use crate::screen::picker;
use crate::screen::plant::Plant;
use crate::screen::prompt;
use crate::screen::sheet::Shown;
use crate::screen::theme::quiet;
use crate::screen::values;
use crate::screen::view::{Mode, NoteKind};
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::{Point, value_text};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::{Modifier, Style};

/// Draws the line. Returns where something is being typed.
pub(super) fn draw(buffer: &mut Buffer, pane: Rect, scene: Scene) -> Option<Position> {
    let Scene { view, theme, .. } = scene;
    if pane.height == 0 {
        return None;
    }
    match &view.mode {
        Mode::Prompt(prompt) => {
            let what = match prompt.purpose {
                prompt::Purpose::Set => "set",
                prompt::Purpose::Force => "FORCE",
            };
            let question = format!(" {what} {} ({}) to: ", prompt.point.name, prompt.point.ty);
            let typed_at = put(buffer, pane, 0, 0, &question, theme.note());
            let end = put(
                buffer,
                pane,
                typed_at,
                0,
                &prompt.text,
                Style::new().add_modifier(Modifier::BOLD),
            );
            let hint = format!("{}; Enter, Esc", prompt.example());
            put(buffer, pane, end + 3, 0, &hint, quiet());
            if let Some(problem) = &prompt.problem {
                draw_above(buffer, pane, problem, scene);
            }
            return Some(Position::new(
                (pane.x + end).min(pane.right().saturating_sub(1)),
                pane.y,
            ));
        }
        Mode::Force(point) => {
            let mut column = put(
                buffer,
                pane,
                0,
                0,
                &format!(" FORCE {}: ", point.name),
                theme.note(),
            );
            for (key, does) in [("1", "on"), ("0", "off"), ("u", "let go"), ("Esc", "leave it")] {
                column = put(buffer, pane, column, 0, key, theme.key());
                column = put(buffer, pane, column, 0, &format!(" {does}   "), Style::new());
            }
            return None;
        }
        Mode::Pick(picker) => {
            let question = match picker.purpose {
                picker::Purpose::Watch => " watch: ",
                picker::Purpose::Find => " find: ",
            };
            let typed_at = put(buffer, pane, 0, 0, question, theme.note());
            let end = put(
                buffer,
                pane,
                typed_at,
                0,
                &picker.text,
                Style::new().add_modifier(Modifier::BOLD),
            );
            put(
                buffer,
                pane,
                end + 3,
                0,
                "type some of its name; up, down, Enter, Esc",
                quiet(),
            );
            return Some(Position::new(
                (pane.x + end).min(pane.right().saturating_sub(1)),
                pane.y,
            ));
        }
        Mode::Outputs(_) => {
            let mut column = put(buffer, pane, 0, 0, " record: ", theme.note());
            for (key, does) in [
                ("space", "on or off"),
                ("a", "all"),
                ("Enter", "write"),
                ("Esc", "leave it"),
            ] {
                column = put(buffer, pane, column, 0, key, theme.key());
                column = put(buffer, pane, column, 0, &format!(" {does}   "), Style::new());
            }
            return None;
        }
        Mode::Diagram | Mode::Help | Mode::Why(_) => {}
    }
    if let Some(note) = &view.note {
        let style = match note.kind {
            NoteKind::Hint => theme.note(),
            NoteKind::Refused => theme.alarm(),
        };
        put(buffer, pane, 0, 0, &format!(" {} ", note.text), style);
        return None;
    }
    if view.changed_on_disk {
        let text = format!(
            " {} has changed on disk: r loads it again ",
            scene.plant.sheet.file
        );
        put(buffer, pane, 0, 0, &text, theme.note());
        return None;
    }
    put(buffer, pane, 0, 0, &selection(scene), Style::new());
    None
}

/// What is wrong with what was typed, over whatever is there.
fn draw_above(buffer: &mut Buffer, pane: Rect, problem: &str, scene: Scene) {
    if pane.y > scene.view.area.y {
        let above = Rect {
            y: pane.y - 1,
            ..pane
        };
        let text = format!(" {problem:<width$}", width = pane.width as usize);
        put(buffer, above, 0, 0, &text, scene.theme.alarm());
    }
}

/// What the selected block is, and what its tags hold.
fn selection(scene: Scene) -> String {
    let Scene { view, plant, .. } = scene;
    let Some(block) = plant.sheet.blocks.get(view.selected) else {
        return " the program has no blocks".to_owned();
    };
    let mut text = match block.instruction {
        Some(row) => format!(" {}", row.title),
        None => format!(" {}", plant.sheet.block_text(block)),
    };
    let mut named: Vec<&Point> = Vec::new();
    let operands = plant.operands(block);
    for operand in operands.iter() {
        if named.iter().all(|other| other.name != operand.point.name) {
            named.push(&operand.point);
        }
    }
    if let [point] = named[..]
        && point.ty == Scalar::Bool
        && block.shown.iter().all(|shown| matches!(shown, Shown::Indexed(_)))
    {
        let role = match point.role {
            _ if point.is_input => "input ",
            Role::Output => "output ",
            _ => "",
        };
        text.push_str(&format!(": {role}{} is {}", point.name, value_of(point, plant)));
        let hint = match point.is_input {
            _ if plant.watching().is_some() => "",
            _ if plant.is_forced(point) => "; u lets it go",
            true => "; space switches it",
            false => "",
        };
        text.push_str(hint);
        return text;
    }
    let mut separator = ": ";
    for shown in &block.shown {
        text.push_str(&format!(
            "{separator}{}",
            super::diagram::value_text(shown, scene)
        ));
        separator = ", ";
    }
    for point in named {
        // What has a value of its own was just named.
        if point.ty == Scalar::Bool {
            text.push_str(&format!(
                "{separator}{} is {}",
                point.name,
                value_of(point, plant)
            ));
            separator = ", ";
        }
    }
    text
}

fn value_of(point: &Point, plant: &Plant) -> String {
    let value = plant.value(point);
    let text = if point.ty == Scalar::Time {
        values::short(&value, point.ty)
    } else {
        value_text::display(&value, point.ty)
    };
    if plant.is_forced(point) {
        return format!("{text} (forced)");
    }
    text
}
