//! The library: user-defined blocks that every workspace sees (LANGUAGE §5.7), written in the language itself.
//!
//! A block is one file here, `NAME.clad`, or `plants/NAME.clad` if it is a machine that plants are made of; the comments in it are its
//! documentation. A program of the same name in `scenarios/` uses it, and scenarios show and test what it does. This crate holds the texts and nothing else. `ladder-analysis` reads them when a program names a block that its workspace does not define, so that a program
//! without one pays nothing.

#![forbid(unsafe_code)]

/// A block of the library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source {
    /// Its name, with the `$`.
    pub name: &'static str,
    /// Whether it is for programs or for plants.
    pub is_for: Use,
    /// The text of its file: the comment that describes it, and its definition.
    pub text: &'static str,
    /// A program that uses it.
    pub example: &'static str,
    /// The scenarios of that program, the first of which shows what the block is for.
    pub scenarios: &'static str,
}

/// What a block is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// Programs of controllers.
    Programs,
    /// Plants: models of machines that run beside a program.
    Plants,
}

impl Source {
    /// What the comment above its definition says, as Markdown.
    pub fn description(&self) -> String {
        let comment = self.text.split('#').nth(1).unwrap_or_default().trim();
        let lines: Vec<&str> = comment
            .lines()
            .map(|line| line.strip_prefix("  ").unwrap_or(line))
            .collect();
        lines.join("\n")
    }

    /// What it is: the description as far as its first colon or full stop.
    pub fn summary(&self) -> String {
        let text = self.description();
        text.split([':', '.']).next().unwrap_or_default().to_owned()
    }

    /// The rows of its first scenario: a timing diagram. A column is one step, as long as [`step`](Source::step) says.
    pub fn diagram(&self) -> &'static str {
        let (_, first) = self.scenarios.split_once("\nscenario ").unwrap_or_default();
        let (_, rows) = first.split_once('\n').unwrap_or_default();
        rows.split("\n\n").next().unwrap_or_default()
    }

    /// How long a step of its scenarios is.
    pub fn step(&self) -> &'static str {
        let line = self.scenarios.lines().find_map(|line| line.strip_prefix("step "));
        line.unwrap_or_default()
    }
}

macro_rules! sources {
    ($($use:ident in $folder:literal: $($name:literal),*;)*) => {
        &[$($(Source {
            name: concat!("$", $name),
            is_for: Use::$use,
            text: include_str!(concat!("../", $folder, $name, ".clad")),
            example: include_str!(concat!("../scenarios/", $name, ".clad")),
            scenarios: include_str!(concat!("../scenarios/", $name, ".ladder-test")),
        },)*)*]
    };
}

/// All blocks: those for each use by their names.
pub const SOURCES: &[Source] = sources! {
    Programs in "":
    "Alarm",
    "Alternate",
    "Average",
    "Blink",
    "Debounce",
    "Drum",
    "FirstOut",
    "Hysteresis",
    "Interval",
    "PID",
    "Ramp",
    "RunTime",
    "Scale",
    "Step",
    "Toggle",
    "Total";
    Plants in "plants/":
    "Amount",
    "Belt",
    "Cylinder",
    "Heater",
    "Motor",
    "Noise",
    "Tank",
    "Valve";
};
