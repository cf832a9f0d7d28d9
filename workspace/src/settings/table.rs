//! All settings, in one table.
//!
//! The reader checks values by it. The page of the book about settings, the JSON schema of `ladder.toml` and the
//! settings of the extension for Visual Studio Code are written from it. A test compares the defaults with what the
//! crates do that the settings are for.

/// A table of settings: `[format]` in `ladder.toml`, `ladder.format` in an editor.
#[derive(Debug, Clone, Copy)]
pub struct Section {
    /// Its name.
    pub name: &'static str,
    /// Of one that may be there several times, `[[task]]`, the keys that each must have.
    pub list: Option<&'static [&'static str]>,
    /// What it is for, in Markdown.
    pub about: &'static str,
    /// Its settings. Those of [`LINT`] come on top of the rules, each of which is a setting too.
    pub settings: &'static [Setting],
}

impl Section {
    /// The table of the file that it is, or that it is in; and its name in that: `[serve.modbus]` is `modbus` in `serve`.
    pub fn outer(&self) -> (&'static str, Option<&'static str>) {
        match self.name.split_once('.') {
            Some((outer, inner)) => (outer, Some(inner)),
            None => (self.name, None),
        }
    }
}

/// A setting: a key of a table.
#[derive(Debug, Clone, Copy)]
pub struct Setting {
    /// Its name.
    pub key: &'static str,
    /// What it takes.
    pub kind: Kind,
    /// Who may set it.
    pub place: SetBy,
    /// What holds where it is not set, as it would be written in `ladder.toml`; none if nothing does.
    pub default: Option<&'static str>,
    /// A value to show, as it would be written in `ladder.toml`.
    pub example: &'static str,
    /// What it is for, in Markdown.
    pub about: &'static str,
}

/// What a setting takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A whole number.
    Whole {
        /// The least.
        least: i64,
        /// The most.
        most: i64,
    },
    /// A time longer than 0, as text: `10ms`.
    Duration,
    /// The path of a file, seen from the folder of `ladder.toml`.
    File,
    /// A list of patterns as in `.gitignore`.
    Patterns,
    /// A list of folders, seen from the folder of `ladder.toml`.
    Folders,
    /// A list of programs, seen from the folder of `ladder.toml`.
    Programs,
    /// `true` or `false`.
    Switch,
    /// A text.
    Text,
    /// A text, or a list of texts.
    Texts,
    /// One of these texts.
    Choice(&'static [&'static str]),
    /// Tables, each with `files` and the rules that count differently in those.
    Overrides,
    /// A number from 0 to 255, or a list of them.
    Units,
    /// A table whose keys are places and whose values are tags.
    Places,
    /// A table whose keys are tags and whose values are what a controller calls them.
    Names,
}

impl Kind {
    /// What the entries of a table of such a kind are.
    pub fn entries(self) -> &'static str {
        match self {
            Kind::Names => "tags and names",
            _ => "places and tags",
        }
    }
}

/// Who may set a setting.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SetBy {
    /// The project: only `ladder.toml`.
    File,
    /// The project. What an editor says holds for programs that no `ladder.toml` is above.
    FileOrEditor,
    /// The person at the screen: only the editor.
    Editor,
    /// The person at the screen, for the extension of an editor: the server does not read it.
    Extension,
}

impl SetBy {
    /// Whether `ladder.toml` may have it.
    pub fn is_in_file(self) -> bool {
        matches!(self, SetBy::File | SetBy::FileOrEditor)
    }

    /// Whether an editor may have it.
    pub fn is_in_editor(self) -> bool {
        self != SetBy::File
    }
}

/// What a rule's setting may say.
pub const LEVELS: [&str; 4] = ["error", "warn", "info", "off"];

/// What a whole number may be if nothing bounds it.
const ANY: i64 = i64::MAX;

pub(super) const WIDTH: Setting = Setting {
    key: "width",
    kind: Kind::Whole { least: 40, most: 300 },
    place: SetBy::FileOrEditor,
    default: Some("80"),
    example: "120",
    about: "The column of the right rail. A wider network has its own, at the next multiple of 20.",
};

pub(super) const SPACING: Setting = Setting {
    key: "spacing",
    kind: Kind::Whole { least: 1, most: 40 },
    place: SetBy::FileOrEditor,
    default: Some("2"),
    example: "2",
    about: "The least number of columns between neighbours.",
};

pub(super) const OVERRIDES: Setting = Setting {
    key: "overrides",
    kind: Kind::Overrides,
    place: SetBy::File,
    default: None,
    example: "[{ files = [\"old/**\"], double-coil = \"off\" }]",
    about: "Rules that count differently in some files. The last one that covers a file wins.",
};

pub(super) const INTERVAL: Setting = Setting {
    key: "interval",
    kind: Kind::Duration,
    place: SetBy::FileOrEditor,
    default: Some("\"10ms\""),
    example: "\"20ms\"",
    about: "The time from one scan to the next.",
};

pub(super) const WATCHDOG: Setting = Setting {
    key: "watchdog",
    kind: Kind::Whole { least: 1, most: ANY },
    place: SetBy::FileOrEditor,
    default: Some("1000000"),
    example: "1000000",
    about: "How many blocks a scan may evaluate; 100 elements or characters that a block goes through count as one more. A scan that needs more is stopped with a fault.",
};

pub(super) const HISTORY: Setting = Setting {
    key: "history",
    kind: Kind::Whole { least: 0, most: ANY },
    place: SetBy::FileOrEditor,
    default: None,
    example: "1000",
    about: "How many scans can be stepped back. Without it as many as fit into 64 MiB.",
};

pub(super) const RETAIN: Setting = Setting {
    key: "retain",
    kind: Kind::File,
    place: SetBy::File,
    default: None,
    example: "\"plant.retain\"",
    about: "Where retentive tags are kept over a restart, for the editors' simulations and the interactive screen.",
};

pub(super) const PLANT: Setting = Setting {
    key: "plant",
    kind: Kind::Texts,
    place: SetBy::File,
    default: None,
    example: "\"tank.clad\"",
    about: "A model of the machine, which runs beside each program that is connected with it; or a list of several, each with its name: `\"left.clad as left\"`. For `ladder sim`, the interactive screen and the editors' simulations; scenarios name theirs.",
};

pub(super) const CONNECT: Setting = Setting {
    key: "connect",
    kind: Kind::Texts,
    place: SetBy::File,
    default: None,
    example: "[\"plant.sensor_1 = near\"]",
    about: "Which tags of the plant and of the program are connected though their names differ.",
};

pub(super) const INCLUDE: Setting = Setting {
    key: "include",
    kind: Kind::Patterns,
    place: SetBy::File,
    default: None,
    example: "[\"lines/**\"]",
    about: "Only what matches one of these patterns belongs to the workspace. Without it every program does.",
};

pub(super) const EXCLUDE: Setting = Setting {
    key: "exclude",
    kind: Kind::Patterns,
    place: SetBy::File,
    default: None,
    example: "[\"old/\"]",
    about: "But not what matches one of these.",
};

pub(super) const LIBRARY: Setting = Setting {
    key: "library",
    kind: Kind::Folders,
    place: SetBy::File,
    default: None,
    example: "[\"blocks\", \"shared/plant-blocks\"]",
    about: "Folders of blocks that all programs of the workspace see, like those of the library. They lie inside the workspace; one may be a repository of its own with its own `ladder.toml`, or be left out by `.gitignore`.",
};

pub(super) const INLAY_HINTS: Setting = Setting {
    key: "enable",
    kind: Kind::Switch,
    place: SetBy::Editor,
    default: Some("false"),
    example: "true",
    about: "Hints at the ends of lines. They never are within a drawing, whose columns they would shift.",
};

pub(super) const CODE_LENS: Setting = Setting {
    key: "enable",
    kind: Kind::Switch,
    place: SetBy::Editor,
    default: Some("true"),
    example: "false",
    about: "Lines of commands above networks.",
};

pub(super) const LONGEST_SCAN: Setting = Setting {
    key: "watchdog",
    kind: Kind::Duration,
    place: SetBy::File,
    default: None,
    example: "\"100ms\"",
    about: "How long a scan may take: the program is stopped after one that took longer. Without it ten intervals.",
};

pub(super) const LISTEN: Setting = Setting {
    key: "listen",
    kind: Kind::Text,
    place: SetBy::File,
    default: Some("\"127.0.0.1:1502\""),
    example: "\"127.0.0.1:1502\"",
    about: "Where the server listens: the address of a network card, or `0.0.0.0` for all, and a port. Modbus has no passwords: who reaches it reads all of the map. Port 502 needs a right of its own on most systems.",
};

pub(super) const UNIT: Setting = Setting {
    key: "unit",
    kind: Kind::Units,
    place: SetBy::File,
    default: Some("[1, 255]"),
    example: "[1, 255]",
    about: "The units that answer; others get exception 11.",
};

pub(super) const LAYOUT: Setting = Setting {
    key: "layout",
    kind: Kind::Choice(&["openplc", "factory-io"]),
    place: SetBy::File,
    default: Some("\"openplc\""),
    example: "\"factory-io\"",
    about: "Where direct addresses are. `\"openplc\"`: `%QX` are coils, `%IX` discrete inputs, `%IW` input registers, `%QW`, `%MW`, `%MD` and `%ML` holding registers, with the numbers of OpenPLC. `\"factory-io\"`: the reverse, for Factory I/O as a client, which writes what the program reads.",
};

pub(super) const WORDS: Setting = Setting {
    key: "words",
    kind: Kind::Choice(&["big", "little"]),
    place: SetBy::File,
    default: Some("\"big\""),
    example: "\"little\"",
    about: "Which word of a value comes first that has several: the high one, or the low one as Click has it.",
};

pub(super) const WRITE: Setting = Setting {
    key: "write",
    kind: Kind::Texts,
    place: SetBy::File,
    default: None,
    example: "[\"start\", \"stop\"]",
    about: "The tags that clients may write. Without it none.",
};

pub(super) const HOLD: Setting = Setting {
    key: "hold",
    kind: Kind::Choice(&["last", "initial"]),
    place: SetBy::File,
    default: Some("\"last\""),
    example: "\"initial\"",
    about: "What the written tags do when nobody asks for anything any more: keep their values, or go back to those of a cold start after `timeout`.",
};

pub(super) const TIMEOUT: Setting = Setting {
    key: "timeout",
    kind: Kind::Duration,
    place: SetBy::File,
    default: Some("\"2s\""),
    example: "\"2s\"",
    about: "How long nobody may ask before `hold = \"initial\"` does that.",
};

pub(super) const ALLOW: Setting = Setting {
    key: "allow",
    kind: Kind::Texts,
    place: SetBy::File,
    default: None,
    example: "[\"192.168.1.0/24\"]",
    about: "The networks from which connections are taken. Without it all that reach the address.",
};

pub(super) const MOST_CONNECTIONS: Setting = Setting {
    key: "connections",
    kind: Kind::Whole { least: 1, most: 1000 },
    place: SetBy::File,
    default: Some("16"),
    example: "4",
    about: "How many connections there are at most; further ones are closed.",
};

pub(super) const IDLE: Setting = Setting {
    key: "idle",
    kind: Kind::Duration,
    place: SetBy::File,
    default: Some("\"60s\""),
    example: "\"10s\"",
    about: "A connection that sends nothing for so long is closed.",
};

pub(super) const MAP: Setting = Setting {
    key: "map",
    kind: Kind::Places,
    place: SetBy::File,
    default: None,
    example: "{ \"holding 100\" = \"level\" }",
    about: "Places of tags by name, one a line below `[serve.modbus.map]`: `\"holding 100\" = \"level\"`. The tables are `coil`, `discrete`, `input` and `holding`; numbers are those of the protocol, from 0. A REAL, DINT, TIME (in ms) takes two registers, a LINT or LREAL four; `a[1..8]` takes as many places as it has elements.",
};

/// How programs run in real time.
pub(super) const RUN: Section = Section {
    name: "run",
    list: None,
    about: "How `ladder run` runs programs.",
    settings: &[LONGEST_SCAN],
};

/// What a Modbus server shows.
pub(super) const MODBUS: Section = Section {
    name: "serve.modbus",
    list: None,
    about: "Tags as coils and registers of a Modbus TCP server, while `ladder run` runs a program.",
    settings: &[
        LISTEN,
        UNIT,
        LAYOUT,
        WORDS,
        WRITE,
        HOLD,
        TIMEOUT,
        ALLOW,
        MOST_CONNECTIONS,
        IDLE,
        MAP,
    ],
};

/// How diagrams are laid out.
pub(super) const FORMAT: Section = Section {
    name: "format",
    list: None,
    about: "How diagrams are laid out.",
    settings: &[WIDTH, SPACING],
};

/// How much the findings of rules matter.
pub const LINT: Section = Section {
    name: "lint",
    list: None,
    about: "How much the findings of a rule matter: `error`, `warn`, `info` or `off`; or a table with `level` and the `reason` for it.",
    settings: &[OVERRIDES],
};

/// How programs are run.
pub(super) const SIMULATE: Section = Section {
    name: "simulate",
    list: None,
    about: "How programs are run.",
    settings: &[INTERVAL, WATCHDOG, HISTORY, RETAIN, PLANT, CONNECT],
};

pub(super) const TASK_NAME: Setting = Setting {
    key: "name",
    kind: Kind::Text,
    place: SetBy::File,
    default: None,
    example: "\"fast\"",
    about: "What the task is called.",
};

pub(super) const TASK_INTERVAL: Setting = Setting {
    key: "interval",
    kind: Kind::Duration,
    place: SetBy::File,
    default: None,
    example: "\"10ms\"",
    about: "The time from one run of its programs to the next.",
};

pub(super) const PRIORITY: Setting = Setting {
    key: "priority",
    kind: Kind::Whole { least: 0, most: ANY },
    place: SetBy::File,
    default: Some("0"),
    example: "1",
    about: "Of tasks that are due together the one with the smallest number runs first; of equal ones the one that is written first.",
};

pub(super) const PROGRAMS: Setting = Setting {
    key: "programs",
    kind: Kind::Programs,
    place: SetBy::File,
    default: None,
    example: "[\"motor.clad\", \"pump.clad\"]",
    about: "Its programs, in the order in which they run.",
};

/// Which programs run, and how often.
pub(super) const TASK: Section = Section {
    name: "task",
    list: Some(&["name", "interval", "programs"]),
    about: "Which programs the project runs, and how often: `ladder sim ladder.toml` runs them all, on the tags that they share.",
    settings: &[TASK_NAME, TASK_INTERVAL, PRIORITY, PROGRAMS],
};

pub(super) const DEVICE_NAME: Setting = Setting {
    key: "name",
    kind: Kind::Text,
    place: SetBy::File,
    default: None,
    example: "\"rio\"",
    about: "What the device is called in messages.",
};

pub(super) const AT_MODBUS: Setting = Setting {
    key: "modbus",
    kind: Kind::Text,
    place: SetBy::File,
    default: None,
    example: "\"192.168.1.20:502\"",
    about: "Where it is: a name or an address, and the port, which is 502 for most.",
};

pub(super) const DEVICE_UNIT: Setting = Setting {
    key: "unit",
    kind: Kind::Whole { least: 0, most: 255 },
    place: SetBy::File,
    default: Some("1"),
    example: "1",
    about: "Which unit answers there; what is wired to a gateway has numbers of its own.",
};

pub(super) const OK: Setting = Setting {
    key: "ok",
    kind: Kind::Text,
    place: SetBy::File,
    default: None,
    example: "\"rio_ok\"",
    about: "A BOOL of the program that is high while the device answers.",
};

pub(super) const AGE: Setting = Setting {
    key: "age",
    kind: Kind::Text,
    place: SetBy::File,
    default: None,
    example: "\"rio_age\"",
    about: "A TIME of the program: how long ago the device answered last.",
};

pub(super) const DEVICE_WORDS: Setting = Setting {
    about: "Which word of a value comes first that has several.",
    ..WORDS
};

pub(super) const POLL: Setting = Setting {
    key: "poll",
    kind: Kind::Duration,
    place: SetBy::File,
    default: Some("\"100ms\""),
    example: "\"20ms\"",
    about: "The time from one exchange to the next.",
};

pub(super) const PATIENCE: Setting = Setting {
    key: "timeout",
    kind: Kind::Duration,
    place: SetBy::File,
    default: Some("\"1s\""),
    example: "\"300ms\"",
    about: "How long an answer may take. After that the connection is made again.",
};

pub(super) const REPEAT: Setting = Setting {
    key: "repeat",
    kind: Kind::Duration,
    place: SetBy::File,
    default: Some("\"500ms\""),
    example: "\"500ms\"",
    about: "Outputs are written when they change, and after so long even if they have not.",
};

pub(super) const GAP: Setting = Setting {
    key: "gap",
    kind: Kind::Whole { least: 0, most: 125 },
    place: SetBy::File,
    default: Some("8"),
    example: "0",
    about: "How many places between two that are named are read along, to need fewer requests. 0 for a device that refuses places that it has not.",
};

pub(super) const READ: Setting = Setting {
    key: "read",
    kind: Kind::Places,
    place: SetBy::File,
    default: None,
    example: "{ \"discrete 0..7\" = \"%IX10.0\", \"input 0\" = \"level\" }",
    about: "Places of the device and the tags that they are read into. `\"discrete 0..7\" = \"%IX10.0\"` are eight addresses one after the other, of which the program has those that it uses; an array takes as many places as it has elements.",
};

pub(super) const WRITTEN: Setting = Setting {
    key: "write",
    kind: Kind::Places,
    place: SetBy::File,
    default: None,
    example: "{ \"coil 0..7\" = \"%QX10.0\", \"holding 4\" = \"speed\" }",
    about: "Places of the device and the tags that are written to them: coils and holding registers.",
};

/// What is wired to inputs and outputs of the program.
pub(super) const DEVICE: Section = Section {
    name: "device",
    list: Some(&["name", "modbus"]),
    about: "A Modbus TCP device whose inputs and outputs are the program's, while `ladder run` runs it.",
    settings: &[
        DEVICE_NAME,
        AT_MODBUS,
        DEVICE_UNIT,
        OK,
        AGE,
        DEVICE_WORDS,
        POLL,
        PATIENCE,
        REPEAT,
        GAP,
        READ,
        WRITTEN,
    ],
};

pub(super) const NAME: Setting = Setting {
    key: "name",
    kind: Kind::Text,
    place: SetBy::File,
    default: None,
    example: "\"Pumping station\"",
    about: "What the project is called, in the title block of printed pages.",
};

pub(super) const VERSION: Setting = Setting {
    key: "version",
    kind: Kind::Text,
    place: SetBy::File,
    default: None,
    example: "\"1.2\"",
    about: "The version of its programs, likewise.",
};

/// What the project is.
pub(super) const PROJECT: Section = Section {
    name: "project",
    list: None,
    about: "What the project is, for the title block of `ladder render -o x.pdf`.",
    settings: &[NAME, VERSION],
};

/// Which programs belong to the workspace.
pub(super) const WORKSPACE: Section = Section {
    name: "workspace",
    list: None,
    about: "Which programs belong to the workspace. Patterns are those of `.gitignore`, seen from the folder of `ladder.toml`.",
    settings: &[INCLUDE, EXCLUDE, LIBRARY],
};

/// Every section, in the order of the book.
pub const SECTIONS: &[Section] = &[
    FORMAT,
    LINT,
    SIMULATE,
    TASK,
    RUN,
    MODBUS,
    DEVICE,
    super::online::ONLINE,
    WORKSPACE,
    PROJECT,
    Section {
        name: "inlayHints",
        list: None,
        about: "Hints in the text.",
        settings: &[INLAY_HINTS],
    },
    Section {
        name: "codeLens",
        list: None,
        about: "Commands in the text.",
        settings: &[CODE_LENS],
    },
    Section {
        name: "start",
        list: None,
        about: "How the extension starts simulations.",
        settings: &[Setting {
            key: "paused",
            kind: Kind::Switch,
            place: SetBy::Extension,
            default: Some("false"),
            example: "true",
            about: "*Start Simulation* begins before the first scan and waits, instead of running.",
        }],
    },
    Section {
        name: "diagram",
        list: None,
        about: "The diagram next to the text.",
        settings: &[Setting {
            key: "names",
            kind: Kind::Choice(&["iec", "us"]),
            place: SetBy::Extension,
            default: Some("\"iec\""),
            example: "\"us\"",
            about: "Whose names come first in the palette of the diagram: *Open contact*, with *XIC* in grey, or the other way round. The file is the same either way.",
        }],
    },
    Section {
        name: "server",
        list: None,
        about: "The language server's program.",
        settings: &[Setting {
            key: "path",
            kind: Kind::Text,
            place: SetBy::Extension,
            default: Some("\"\""),
            example: "\"/opt/ladder/bin/ladder\"",
            about: "The program `ladder` that serves the language. Empty: the one that came with the extension, else the one on the `PATH`.",
        }],
    },
    Section {
        name: "trace",
        list: None,
        about: "The talk with the language server.",
        settings: &[Setting {
            key: "server",
            kind: Kind::Choice(&["messages", "verbose"]),
            place: SetBy::Extension,
            default: Some("\"messages\""),
            example: "\"verbose\"",
            about: "How much of the talk with the language server goes into the log: the names of the messages, or all of them. It is logged only while the log's level is *Trace* (command *Developer: Set Log Level*).",
        }],
    },
    Section {
        name: "review",
        list: None,
        about: "What changed since the last commit.",
        settings: &[Setting {
            key: "marks",
            kind: Kind::Switch,
            place: SetBy::Extension,
            default: Some("true"),
            example: "false",
            about: "Marks next to the networks that are not as the last commit has them: whether each does the same (`=`), another thing (`≠`), or that is not decided (`?`), and what is new, gone, or only drawn or placed differently.",
        }],
    },
];

/// The names of the settings in a section, of those that the source may set.
pub(super) fn keys(section: &Section, allowed: impl Fn(SetBy) -> bool) -> Vec<&'static str> {
    let settings = section.settings.iter().filter(|setting| allowed(setting.place));
    settings.map(|setting| setting.key).collect()
}

/// The names of the sections, of those that the source may set.
pub(super) fn sections(allowed: impl Fn(SetBy) -> bool) -> Vec<&'static str> {
    // The rules are not in the table; they may be set everywhere.
    let open = |section: &&Section| section.name == LINT.name || !keys(section, &allowed).is_empty();
    SECTIONS
        .iter()
        .filter(open)
        .map(|section| section.outer().0)
        .collect()
}
