//! Folders of blocks that a settings file names, as they are on a disk.

use crate::disk::Disk;
use crate::error::Problem;
use crate::settings::{self, LibraryFolder, SettingError, Settings};

/// What is wrong with the folders that a settings file names, of which this is the text. Its text alone does not tell.
pub fn folder_errors(settings: &Settings, text: &str, disk: &dyn Disk) -> Vec<SettingError> {
    let folders = settings.files.library().iter();
    let problems = folders.filter_map(|folder| {
        let why = problem(folder, disk)?;
        Some((
            folder.range.clone(),
            format!("`{}` cannot be used: {why}", folder.name),
        ))
    });
    settings::errors(text, problems.collect())
}

/// Why a folder cannot be used.
fn problem(folder: &LibraryFolder, disk: &dyn Disk) -> Option<String> {
    match disk.locate(&folder.named) {
        Err(error) => Some(error.problem.to_string()),
        Ok(located) if located != folder.path => {
            Some("a link leads to it: name the folder itself".to_owned())
        }
        Ok(located) if disk.is_file(&located) => {
            Some("this is a file, and a folder is expected here".to_owned())
        }
        Ok(located) => (!disk.is_there(&located)).then(|| Problem::Missing.to_string()),
    }
}
