//! Files on disk for a test.

use std::fs;

use tempfile::TempDir;

/// A folder of files.
pub(crate) struct Plant {
    pub(crate) folder: TempDir,
}

impl Plant {
    /// Files with their texts.
    pub(crate) fn with(files: &[(&str, &str)]) -> Plant {
        let plant = Plant {
            folder: tempfile::tempdir().unwrap(),
        };
        for (name, text) in files {
            plant.write(name, text);
        }
        plant
    }

    /// Writes a file.
    pub(crate) fn write(&self, name: &str, text: &str) {
        let path = self.folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// The names of what is in the folder, in their order.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<_> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// The address of a file.
    pub(crate) fn uri(&self, name: &str) -> String {
        format!("file://{}", self.folder.path().join(name).display())
    }
}
