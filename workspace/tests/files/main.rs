//! Files and settings on a disk.

mod disk;
mod editor_settings;
mod retentive;
mod settings;
