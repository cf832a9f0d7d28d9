//! How things look. Nothing is shown by colour alone: what is live is also heavier, what is high has a dot, what is
//! forced has an `F`.

use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::border;

/// Which characters a terminal shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Charset {
    Unicode,
    Ascii,
}

/// What the terminal can do.
#[derive(Debug, Clone, Copy)]
pub(super) struct Theme {
    pub(super) colour: bool,
    pub(super) charset: Charset,
}

/// A title, also on a quiet line.
pub(super) fn heading() -> Style {
    Style::new()
        .add_modifier(Modifier::BOLD)
        .remove_modifier(Modifier::DIM)
}

/// What is written next to the program: comments, rules, explanations. Dim, not grey: that can be read on light and on
/// dark ground.
pub(super) fn quiet() -> Style {
    Style::new().add_modifier(Modifier::DIM)
}

/// The bar on top, and what is selected.
pub(super) fn reversed() -> Style {
    Style::new().add_modifier(Modifier::REVERSED)
}

impl Theme {
    /// As the environment has it. `NO_COLOR` is respected; characters beyond ASCII are used where the locale says that
    /// the terminal knows them.
    pub(super) fn of_environment() -> Theme {
        let set = |name: &str| std::env::var(name).ok().filter(|value| !value.is_empty());
        let locale = set("LC_ALL").or_else(|| set("LC_CTYPE")).or_else(|| set("LANG"));
        let utf8 = locale.is_some_and(|locale| {
            let locale = locale.to_ascii_lowercase();
            locale.contains("utf-8") || locale.contains("utf8")
        });
        // The Linux console has a font of 256 or 512 characters.
        let console = set("TERM").is_some_and(|terminal| terminal == "linux");
        Theme {
            colour: set("NO_COLOR").is_none() && set("TERM").is_none_or(|terminal| terminal != "dumb"),
            charset: if (utf8 || cfg!(windows)) && !console {
                Charset::Unicode
            } else {
                Charset::Ascii
            },
        }
    }

    fn style(self, colour: Color) -> Style {
        if self.colour {
            Style::new().fg(colour)
        } else {
            Style::new()
        }
    }

    /// What has power, or is high.
    pub(super) fn live(self) -> Style {
        self.style(Color::Green).add_modifier(Modifier::BOLD)
    }

    /// A value at the end of a line.
    pub(super) fn value(self) -> Style {
        self.style(Color::Cyan)
    }

    /// A forced tag.
    pub(super) fn forced(self) -> Style {
        if self.colour {
            Style::new()
                .fg(Color::Black)
                .bg(Color::Yellow)
                .add_modifier(Modifier::BOLD)
        } else {
            Style::new().add_modifier(Modifier::REVERSED | Modifier::BOLD)
        }
    }

    /// A fault, or an error in what was typed.
    pub(super) fn alarm(self) -> Style {
        if self.colour {
            Style::new()
                .fg(Color::White)
                .bg(Color::Red)
                .add_modifier(Modifier::BOLD)
        } else {
            Style::new().add_modifier(Modifier::REVERSED | Modifier::BOLD)
        }
    }

    /// Something worth knowing.
    pub(super) fn note(self) -> Style {
        self.style(Color::Yellow).add_modifier(Modifier::BOLD)
    }

    /// A key that can be pressed.
    pub(super) fn key(self) -> Style {
        let style = self.style(Color::Yellow).add_modifier(Modifier::BOLD);
        if self.colour {
            style
        } else {
            style.add_modifier(Modifier::UNDERLINED)
        }
    }

    /// The past of a tag.
    pub(super) fn wave(self) -> Style {
        self.style(Color::Cyan)
    }

    /// The lines around what is over the screen.
    pub(super) fn border(self) -> border::Set<'static> {
        match self.charset {
            Charset::Unicode => border::PLAIN,
            Charset::Ascii => border::Set {
                top_left: "+",
                top_right: "+",
                bottom_left: "+",
                bottom_right: "+",
                vertical_left: "|",
                vertical_right: "|",
                horizontal_top: "-",
                horizontal_bottom: "-",
            },
        }
    }

    /// The lines of a heading.
    pub(super) fn rule(self) -> &'static str {
        match self.charset {
            Charset::Unicode => "─",
            Charset::Ascii => "-",
        }
    }

    /// A tag that opens, or is open.
    pub(super) fn fold(self, is_open: bool) -> &'static str {
        match (self.charset, is_open) {
            (Charset::Unicode, false) => "▸",
            (Charset::Unicode, true) => "▾",
            (Charset::Ascii, false) => "+",
            (Charset::Ascii, true) => "-",
        }
    }

    /// A rung that a run stops at.
    pub(super) fn breakpoint(self) -> &'static str {
        match self.charset {
            Charset::Unicode => "◆",
            Charset::Ascii => "#",
        }
    }

    /// The line of the block that runs next.
    pub(super) fn next(self) -> &'static str {
        match self.charset {
            Charset::Unicode => "▶",
            Charset::Ascii => "@",
        }
    }

    /// The line goes on to the right.
    pub(super) fn more(self) -> &'static str {
        match self.charset {
            Charset::Unicode => "»",
            Charset::Ascii => ">",
        }
    }

    /// A wire without power, and with power.
    pub(super) fn wire(self, live: bool) -> char {
        match (self.charset, live) {
            (Charset::Unicode, true) => '═',
            (Charset::Unicode, false) => '─',
            (Charset::Ascii, true) => '=',
            (Charset::Ascii, false) => '-',
        }
    }

    /// What is before a tag: low or high.
    pub(super) fn dot(self, high: bool) -> char {
        match (self.charset, high) {
            (Charset::Unicode, true) => '●',
            (Charset::Unicode, false) => '○',
            (Charset::Ascii, true) => '*',
            (Charset::Ascii, false) => '.',
        }
    }
}
