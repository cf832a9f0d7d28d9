//! What the keys do. The same table makes the help and the bar of keys at the bottom.

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// What a person wants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Action {
    Left,
    Right,
    Up,
    Down,
    Next,
    Previous,
    PageUp,
    PageDown,
    First,
    Last,
    /// Switch the selected contact, or set its number.
    Switch,
    /// Switch one of the numbered inputs, from 0.
    Input(usize),
    SetValue,
    Force,
    Unforce,
    UnforceAll,
    RunOrPause,
    Scan,
    StepBlock,
    StepRung,
    Back,
    /// A breakpoint on the selected rung, or none any more.
    BreakAtRung,
    /// A breakpoint on a change of the selected tag, or none any more.
    BreakAtChange,
    Why,
    Faster,
    Slower,
    RestartCold,
    RestartWarm,
    Watch,
    Find,
    FindNext,
    FindPrevious,
    ShorterTime,
    LongerTime,
    GoToFault,
    Reload,
    /// Write what was done as a test.
    Record,
    Help,
    Close,
    Redraw,
    /// Give the terminal to the shell for a while.
    Stop,
    Quit,
}

/// A key and what it does.
pub(super) struct Binding {
    key: Key,
    action: Action,
}

/// A key as terminals report it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Key {
    /// A character, whatever else is held to write it.
    Char(char),
    Ctrl(char),
    Code(KeyCode),
}

const fn char(key: char, action: Action) -> Binding {
    Binding {
        key: Key::Char(key),
        action,
    }
}

const fn ctrl(key: char, action: Action) -> Binding {
    Binding {
        key: Key::Ctrl(key),
        action,
    }
}

const fn code(key: KeyCode, action: Action) -> Binding {
    Binding {
        key: Key::Code(key),
        action,
    }
}

/// Every key of the diagram but the digits.
const BINDINGS: &[Binding] = &[
    code(KeyCode::Left, Action::Left),
    char('h', Action::Left),
    code(KeyCode::Right, Action::Right),
    char('l', Action::Right),
    code(KeyCode::Up, Action::Up),
    char('k', Action::Up),
    code(KeyCode::Down, Action::Down),
    char('j', Action::Down),
    code(KeyCode::Tab, Action::Next),
    code(KeyCode::BackTab, Action::Previous),
    code(KeyCode::PageUp, Action::PageUp),
    ctrl('u', Action::PageUp),
    code(KeyCode::PageDown, Action::PageDown),
    ctrl('d', Action::PageDown),
    code(KeyCode::Home, Action::First),
    char('g', Action::First),
    code(KeyCode::End, Action::Last),
    char('G', Action::Last),
    char(' ', Action::Switch),
    code(KeyCode::Enter, Action::Switch),
    char('v', Action::SetValue),
    char('f', Action::Force),
    char('u', Action::Unforce),
    char('U', Action::UnforceAll),
    char('p', Action::RunOrPause),
    code(KeyCode::F(5), Action::RunOrPause),
    char('s', Action::Scan),
    code(KeyCode::F(10), Action::Scan),
    char('.', Action::StepBlock),
    char(',', Action::StepRung),
    char('B', Action::BreakAtRung),
    char('t', Action::BreakAtChange),
    char('y', Action::Why),
    char('b', Action::Back),
    code(KeyCode::Backspace, Action::Back),
    char('+', Action::Faster),
    char('=', Action::Faster),
    char('-', Action::Slower),
    char('c', Action::RestartCold),
    char('C', Action::RestartWarm),
    char('w', Action::Watch),
    char('/', Action::Find),
    char('n', Action::FindNext),
    char('N', Action::FindPrevious),
    char('[', Action::ShorterTime),
    char(']', Action::LongerTime),
    char('!', Action::GoToFault),
    char('r', Action::Reload),
    char('R', Action::Record),
    char('?', Action::Help),
    code(KeyCode::F(1), Action::Help),
    code(KeyCode::Esc, Action::Close),
    ctrl('l', Action::Redraw),
    ctrl('z', Action::Stop),
    char('q', Action::Quit),
    ctrl('c', Action::Quit),
];

/// What a key does in the diagram.
pub(super) fn action(event: KeyEvent) -> Option<Action> {
    let key = key(event);
    if let Key::Char(digit @ '1'..='9') = key {
        return Some(Action::Input(digit as usize - '1' as usize));
    }
    let found = BINDINGS.iter().find(|binding| binding.key == key);
    found.map(|binding| binding.action)
}

/// Whether a key ends the program, whatever is open.
pub(super) fn quits_at_once(event: KeyEvent) -> bool {
    key(event) == Key::Ctrl('c')
}

fn key(event: KeyEvent) -> Key {
    match event.code {
        KeyCode::Char(letter) if event.modifiers.contains(KeyModifiers::CONTROL) => {
            Key::Ctrl(letter.to_ascii_lowercase())
        }
        KeyCode::Char(letter) => Key::Char(letter),
        // Some terminals report Tab with Shift so.
        KeyCode::Tab if event.modifiers.contains(KeyModifiers::SHIFT) => Key::Code(KeyCode::BackTab),
        code => Key::Code(code),
    }
}

/// A part of the help: its title, and keys with what they do.
pub(super) type HelpGroup = (&'static str, &'static [(&'static str, &'static str)]);

/// The help, in two columns.
pub(super) const HELP: [&[HelpGroup]; 2] = [
    &[
        (
            "Move",
            &[
                ("arrows hjkl", "from block to block"),
                ("Tab, Shift-Tab", "next, previous block"),
                ("PgUp PgDn", "a page"),
                ("g G", "first, last block"),
                ("/ n N", "find tag, next, previous"),
            ],
        ),
        (
            "Inputs",
            &[
                ("space, Enter", "switch, or set a number"),
                ("1 .. 9", "the same for that input"),
                ("mouse click", "the same for that block"),
                ("v", "set the selected tag"),
                ("f", "force the selected tag"),
                ("u U", "let it go, let all go"),
            ],
        ),
    ],
    &[
        (
            "Run",
            &[
                ("p", "run, pause"),
                ("s", "one scan"),
                (". ,", "one block, one rung"),
                ("b", "one scan back"),
                ("+ -", "faster, slower"),
                ("B t", "stop at rung, change"),
                ("c C", "restart cold, warm"),
            ],
        ),
        (
            "Look",
            &[
                ("w", "watch, or no more"),
                ("y", "why is it so?"),
                ("[ ]", "shorter, longer time"),
                ("!", "go to the last fault"),
                ("r R", "load; write a test"),
                ("Esc", "close what is open"),
                ("q, Ctrl-C", "quit"),
            ],
        ),
    ],
];

/// A key at the bottom, and what it does in a word.
pub(super) type Hint = (&'static str, &'static str, Action);

/// The keys that always are at the bottom, most important first. `p` says what it would do now. What is only watched is neither
/// switched nor stepped.
pub(super) fn hints(running: bool, is_watched: bool) -> Vec<Hint> {
    let run = ("p", if running { "pause" } else { "run" }, Action::RunOrPause);
    let watch = ("w", "watch", Action::Watch);
    let [help, quit] = [("?", "help", Action::Help), ("q", "quit", Action::Quit)];
    if is_watched {
        let (why, find) = (("y", "why", Action::Why), ("/", "find", Action::Find));
        return vec![run, why, find, watch, help, quit];
    }
    vec![
        ("space", "switch", Action::Switch),
        run,
        ("s", "step", Action::Scan),
        ("b", "back", Action::Back),
        ("+-", "speed", Action::Faster),
        ("f", "force", Action::Force),
        watch,
        help,
        quit,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Another way to press what the help names.
    const ALSO: [char; 1] = ['='];

    #[test]
    fn the_help_names_every_letter() {
        let named: Vec<&str> = HELP
            .iter()
            .flat_map(|groups| groups.iter())
            .flat_map(|(_, keys)| keys.iter())
            .flat_map(|(keys, _)| keys.split([' ', ',']))
            .collect();
        let letters = BINDINGS.iter().filter_map(|binding| match binding.key {
            Key::Char(' ') => Some("space".to_owned()),
            Key::Char(letter) if !ALSO.contains(&letter) => Some(letter.to_string()),
            _ => None,
        });
        for letter in letters {
            let is_arrow = "hjkl".contains(&letter);
            // The comma itself separates.
            let is_comma = letter == ",";
            assert!(
                is_arrow || is_comma || named.contains(&letter.as_str()) || letter == "?",
                "the help does not name {letter}"
            );
        }
    }

    #[test]
    fn no_key_means_two_things() {
        for (index, binding) in BINDINGS.iter().enumerate() {
            let again = BINDINGS[index + 1..].iter().any(|other| other.key == binding.key);
            assert!(!again, "{:?} appears twice", binding.key);
        }
    }
}
