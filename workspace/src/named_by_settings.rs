//! What a settings file names, as it is on a disk: folders of blocks, the programs of tasks, and plants.

use crate::disk::Disk;
use crate::error::Problem;
use crate::settings::{self, LibraryFolder, SettingError, Settings};

/// What is wrong with the folders and programs that a settings file names, of which this is the text. Its text alone does not tell.
pub fn errors_on_disk(settings: &Settings, text: &str, disk: &dyn Disk) -> Vec<SettingError> {
    let cannot = |name: &str, why: &str| format!("`{name}` cannot be used: {why}");
    let folders = settings.files.library().iter();
    let folders = folders.filter_map(|folder| {
        let why = problem(folder, disk)?;
        Some((folder.range.clone(), cannot(&folder.name, &why)))
    });
    let programs = settings.simulate.tasks.iter().flat_map(|task| &task.programs);
    let programs = programs.map(|(program, range)| (program, range));
    let plants = settings.simulate.plants.iter();
    let programs = programs.chain(plants.map(|plant| (&plant.file, &plant.range)));
    let programs = programs.filter_map(|(program, range)| {
        let why = match disk.locate(program) {
            Ok(path) if disk.is_file(&path) => return None,
            Ok(_) => Problem::Missing,
            Err(error) => error.problem,
        };
        let path = program.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        Some((range.clone(), cannot(&name, &why.to_string())))
    });
    settings::errors(text, folders.chain(programs).collect())
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
