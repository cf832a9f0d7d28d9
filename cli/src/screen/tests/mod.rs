//! Screens as people see them: a program, what is pressed, and what is on the terminal then.

mod arrays;
mod book;
mod diagrams;
mod navigation;
mod running;
mod switching;
mod watching;

use super::app::{App, Next};
use super::load::{self, Request};
use super::theme::{Charset, Theme};
use crate::run::{Plants, Stimulus};
use expect_test::Expect;
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use ratatui::crossterm::event::{
    Event, KeyCode, KeyEvent, KeyModifiers, MouseButton, MouseEvent, MouseEventKind,
};
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier};
use std::path::PathBuf;
use std::time::Duration;

/// A motor starter: short enough for the smallest screen.
pub(super) const MOTOR: &str = "\
VAR_INPUT  start, stop : BOOL;  END_VAR
VAR  warmup : TON;  END_VAR

# Seal-in #
+--\\--[ ]( start )--\\--[/]( stop )-------------( )( run )--+
|  /--[ ]( run )----/                                      |

# Warm-up #
+--[ ]( run )---------[TON]( warmup, T#5s )--( )( ready )--+
";

const PLAIN: Theme = Theme {
    colour: false,
    charset: Charset::Unicode,
};

/// A screen of 80 columns and 24 lines, or of another size, on which a program is paused before its first scan.
pub(super) struct Bench {
    folder: tempfile::TempDir,
    size: (u16, u16),
    theme: Theme,
    watch: Vec<String>,
    text: String,
}

impl Bench {
    pub(super) fn new(text: &str) -> Bench {
        Bench {
            folder: tempfile::tempdir().unwrap(),
            size: (80, 24),
            theme: PLAIN,
            watch: Vec::new(),
            text: text.to_owned(),
        }
    }

    pub(super) fn size(mut self, width: u16, height: u16) -> Bench {
        self.size = (width, height);
        self
    }

    pub(super) fn theme(mut self, colour: bool, charset: Charset) -> Bench {
        self.theme = Theme { colour, charset };
        self
    }

    pub(super) fn watch(mut self, tags: &[&str]) -> Bench {
        self.watch = tags.iter().map(|&tag| tag.to_owned()).collect();
        self
    }

    fn file(&self) -> PathBuf {
        self.folder.path().join("motor.clad")
    }

    /// Plays what is done at the terminal and hands over the screen. The steps are separated by blanks:
    ///
    /// - a character or the name of a key (`space`, `enter`, `esc`, `tab`, `up`) is pressed; `'text'` is typed;
    /// - `+500ms` lets real time pass;
    /// - `click:5,3` `wheel:5,3` click, and turn the wheel down, in that column and line, from 0;
    /// - `size:40x10` resizes the terminal;
    /// - `write:NAME` puts the text of that name in the file's place, `look` looks at the file.
    pub(super) fn play(&self, steps: &str, look: impl FnOnce(&mut App, &Buffer) -> String) -> String {
        self.play_with(steps, &[], look)
    }

    pub(super) fn play_with(
        &self,
        steps: &str,
        texts: &[(&str, &str)],
        look: impl FnOnce(&mut App, &Buffer) -> String,
    ) -> String {
        let file = self.file();
        std::fs::write(&file, &self.text).unwrap();
        let stimulus = Stimulus::default();
        let request = Request {
            from: None,
            file: &file,
            plants: &Plants::default(),
            stimulus: &stimulus,
            retain: None,
            watch: &self.watch,
        };
        let plant = load::first(&request).unwrap().expect("a program without errors");
        let (width, height) = self.size;
        let mut app = App::new(Rect::new(0, 0, width, height), plant, self.theme, &request);
        app.view.running = false;
        let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
        for step in steps.split_whitespace() {
            if let Some(name) = step.strip_prefix("write:") {
                let (_, text) = texts.iter().find(|(text, _)| *text == name).unwrap();
                std::fs::write(&file, text).unwrap();
            } else if step == "look" {
                app.look_at_file();
            } else if let Some(size) = step.strip_prefix("size:") {
                let (width, height) = size.split_once('x').unwrap();
                terminal
                    .backend_mut()
                    .resize(width.parse().unwrap(), height.parse().unwrap());
                terminal.autoresize().unwrap();
            } else {
                play_step(&mut app, step);
            }
        }
        app.plant.sheet.file = "motor.clad".to_owned();
        let drawn = terminal.draw(|frame| app.draw(frame)).unwrap().buffer.clone();
        look(&mut app, &drawn)
    }

    /// The characters of the screen.
    pub(super) fn check(&self, steps: &str, screen: Expect) {
        screen.assert_eq(&self.play(steps, |_, buffer| characters(buffer)));
    }

    /// Some lines of the screen, from 0.
    pub(super) fn check_lines(&self, steps: &str, lines: std::ops::Range<u16>, screen: Expect) {
        let shown = self.play(steps, |_, buffer| {
            let all = characters(buffer);
            let some: Vec<&str> = all.lines().skip(lines.start as usize).take(lines.len()).collect();
            some.join("\n") + "\n"
        });
        screen.assert_eq(&shown);
    }

    /// The line above the keys.
    pub(super) fn check_info(&self, steps: &str, screen: Expect) {
        let height = self.size.1;
        self.check_lines(steps, height - 2..height - 1, screen);
    }
}

fn play_step(app: &mut App, step: &str) {
    if let Some(time) = step.strip_prefix('+').and_then(|time| time.strip_suffix("ms")) {
        // In frames, as the loop does it.
        let mut left: u64 = time.parse().unwrap();
        while left > 0 {
            let frame = left.min(40);
            app.pass(Duration::from_millis(frame), Duration::MAX);
            left -= frame;
        }
        return;
    }
    if let Some(text) = step.strip_prefix('\'').and_then(|text| text.strip_suffix('\'')) {
        for letter in text.chars() {
            press(app, KeyCode::Char(letter), KeyModifiers::NONE);
        }
        return;
    }
    for (name, kind) in [
        ("click:", MouseEventKind::Down(MouseButton::Left)),
        ("wheel:", MouseEventKind::ScrollDown),
    ] {
        if let Some(place) = step.strip_prefix(name) {
            let (column, row) = place.split_once(',').unwrap();
            app.handle(&Event::Mouse(MouseEvent {
                kind,
                column: column.parse().unwrap(),
                row: row.parse().unwrap(),
                modifiers: KeyModifiers::NONE,
            }));
            return;
        }
    }
    let code = match step {
        "space" => KeyCode::Char(' '),
        "enter" => KeyCode::Enter,
        "esc" => KeyCode::Esc,
        "tab" => KeyCode::Tab,
        "back-tab" => KeyCode::BackTab,
        "backspace" => KeyCode::Backspace,
        "up" => KeyCode::Up,
        "down" => KeyCode::Down,
        "left" => KeyCode::Left,
        "right" => KeyCode::Right,
        "page-up" => KeyCode::PageUp,
        "page-down" => KeyCode::PageDown,
        letter => KeyCode::Char(letter.parse().unwrap()),
    };
    press(app, code, KeyModifiers::NONE);
}

fn press(app: &mut App, code: KeyCode, modifiers: KeyModifiers) -> Next {
    app.handle(&Event::Key(KeyEvent::new(code, modifiers)))
}

/// What is on the screen.
pub(super) fn characters(buffer: &Buffer) -> String {
    grid(buffer, |buffer, x, y| buffer[(x, y)].symbol().to_owned())
}

/// How it is there: `R` reversed, `B` bold, `D` dim, `U` underlined; with colours their first letters, `g` green,
/// `y` on yellow, `r` on red, `c` cyan.
pub(super) fn styles(buffer: &Buffer) -> String {
    grid(buffer, |buffer, x, y| {
        let cell = &buffer[(x, y)];
        let letter = match (cell.bg, cell.fg) {
            (Color::Yellow, _) => 'y',
            (Color::Red, _) => 'r',
            _ if cell.modifier.contains(Modifier::REVERSED) => 'R',
            (_, Color::Green) => 'g',
            (_, Color::Cyan) => 'c',
            _ if cell.modifier.contains(Modifier::UNDERLINED) => 'U',
            _ if cell.modifier.contains(Modifier::BOLD) => 'B',
            _ if cell.modifier.contains(Modifier::DIM) => 'D',
            _ => ' ',
        };
        letter.to_string()
    })
}

fn grid(buffer: &Buffer, show: impl Fn(&Buffer, u16, u16) -> String) -> String {
    let area = buffer.area;
    let mut shown = String::new();
    for y in area.top()..area.bottom() {
        // The edge shows where a line begins that begins with blanks.
        let mut line = String::from("|");
        let mut after = 0;
        for x in area.left()..area.right() {
            // The second column of a wide character holds nothing of its own.
            if x < after {
                continue;
            }
            let symbol = show(buffer, x, y);
            after = x + ladder_format::display_width(buffer[(x, y)].symbol()).max(1) as u16;
            line.push_str(&symbol);
        }
        shown.push_str(line.trim_end());
        shown.push('\n');
    }
    shown
}
