//! `ladder.toml`, compared line by line.

use similar::{ChangeTag, TextDiff};

/// What changed in a settings file.
pub(super) struct SettingsDiff {
    pub(super) old: Option<String>,
    pub(super) new: Option<String>,
    /// Its lines with their signs; what is the same is left out but for some lines around what is not.
    pub(super) lines: Vec<String>,
}

impl SettingsDiff {
    /// What the file is called now, or was.
    pub(super) fn name(&self) -> &str {
        self.new.as_deref().or(self.old.as_deref()).unwrap_or_default()
    }

    /// Compares two texts. None: they are the same.
    pub(super) fn new(old: Option<(String, String)>, new: Option<(String, String)>) -> Option<SettingsDiff> {
        let split = |side: Option<(String, String)>| {
            side.map_or((None, String::new()), |(name, text)| (Some(name), text))
        };
        let ((old, was), (new, is)) = (split(old), split(new));
        if was == is && old.is_some() == new.is_some() {
            return None;
        }
        let mut lines = Vec::new();
        for hunk in TextDiff::from_lines(&was, &is).unified_diff().iter_hunks() {
            for change in hunk.iter_changes() {
                let sign = match change.tag() {
                    ChangeTag::Delete => '-',
                    ChangeTag::Insert => '+',
                    ChangeTag::Equal => ' ',
                };
                lines.push(format!("{sign} {}", change.value().trim_end()));
            }
        }
        Some(SettingsDiff { old, new, lines })
    }
}
