//! Ladder files on disk.
//!
//! The inner crates know texts, not files. This one is between them and the disk:
//!
//! ```text
//! paths --search--> the programs that are meant --read--> text, or an error that says what to do
//!                                                        text --write--> the same file, whole or not at all
//! program --root--> the folder whose programs share their globals, functions and blocks
//! ```
//!
//! - [`find_programs`] turns what a person named (files, folders) into a sorted list of files, by the rules of
//!   `.gitignore`.
//! - [`is_excluded`] says of a file that was named whether a search would pass over it.
//! - [`read`] and [`decode`] are the one gate for text: nothing that is not UTF-8, and nothing larger than
//!   [`MAX_FILE_BYTES`], goes past it.
//! - [`ForeignPrograms`] has programs of other systems with the files that belong to them.
//! - [`Named`] is a file that a workspace names, in its settings or scenarios: it lies inside of that, whatever links lead
//!   to it, and is a regular file.
//! - [`write()`] puts a new text in a file's place in one step: a reader, or a power cut, sees the old text or the
//!   new one, never a half.
//! - [`address`] is a file's address as editors have it.
//! - [`shown`] is what others wrote, on its way to a terminal or a log.
//! - [`Root::of`] finds the folder that a program belongs to (LANGUAGE §4), which is where the settings file
//!   [`SETTINGS_FILE`] is.
//! - [`RetentiveFile`] keeps the values of retentive tags over a restart.
//!
//! - [`Disk`] is what the language server asks of all this, so that it works on files in memory, too.
//! - [`Workspace`] has the programs of a workspace, analysed together, as those who check and run them need them.
//!
//! Every error is a [`FileError`]: it names the file and says in plain words what is wrong with it.

pub mod address;
mod disk;
mod error;
mod excluded;
mod foreign;
mod lock;
mod member;
mod named;
mod named_by_settings;
mod plan;
mod programs;
mod regular;
mod retentive;
mod root;
mod search;
mod settings;
pub mod shown;
mod stamp;
mod text;
mod write;

pub use disk::{Disk, Keeper, MemoryDisk, SystemDisk};
pub use error::{FileError, Problem, Special};
pub use excluded::is_excluded;
pub use foreign::{ForeignPrograms, belonging};
pub use ladder_syntax::MAX_FILE_BYTES;
pub use member::Member;
pub use named::{Named, read_own};
pub use named_by_settings::errors_on_disk;
pub use plan::Plan;
pub use programs::{Source, Workspace};
pub use retentive::{Found, RetentiveFile};
pub use root::{Root, SETTINGS_FILE, is_ladder_text, is_program};
pub use search::{
    SCENARIO_EXTENSION, Survey, find_files, find_ladder_text, find_programs, find_scenarios, is_scenario,
    is_scene, scene_stem, survey,
};
pub use settings::table;
pub use settings::{
    Device, EditorSettings, Files, Levels, Lint, Misfit, Online, Placed, Plant, Project, Run, ServeModbus,
    SettingError, Settings, SettingsError, Simulate, Task, Tree,
};
pub use stamp::Stamp;
pub use text::{decode, read, read_bytes};
pub use write::{Replacement, write, write_made};
