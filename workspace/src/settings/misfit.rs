//! What settings ask of programs that no program has: tags of `[serve.modbus]` and `[[device]]`.

use super::error::SettingError;
use super::{Settings, errors};
use std::ops::Range;

/// Something that was asked of a program and does not fit it: where it is written, in bytes, and what to do.
pub type Misfit = (Range<usize>, String);

impl Settings {
    /// Whether they ask anything of programs that may not fit them.
    pub fn may_misfit(&self) -> bool {
        self.modbus.is_some() || !self.devices.is_empty()
    }

    /// What fits none of the programs that settings with this text are for; nothing where it fits one. It is told of the program that
    /// comes nearest: the settings are for the one that is run, and do not say which that is.
    ///
    /// Nothing is known of a program with errors, which are told elsewhere, and then nothing is told.
    pub fn fit_none(
        text: &str,
        programs: impl IntoIterator<Item = Option<Vec<Misfit>>>,
    ) -> Vec<SettingError> {
        let mut nearest: Option<Vec<Misfit>> = None;
        for misfits in programs {
            let Some(misfits) = misfits.filter(|misfits| !misfits.is_empty()) else {
                return Vec::new();
            };
            if nearest.as_ref().is_none_or(|other| misfits.len() < other.len()) {
                nearest = Some(misfits);
            }
        }
        let mut nearest = nearest.unwrap_or_default();
        nearest.sort_by_key(|(at, _)| at.start);
        errors(text, nearest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(programs: &[Option<&[&str]>]) -> Vec<String> {
        let misfits = |messages: &&[&str]| messages.iter().map(|it| (0..1, (*it).to_owned())).collect();
        let programs = programs.iter().map(|program| program.as_ref().map(misfits));
        let told = Settings::fit_none("x", programs);
        told.into_iter().map(|error| error.message).collect()
    }

    #[test]
    fn the_nearest_program_is_meant() {
        assert_eq!(told(&[Some(&["a", "b"]), Some(&["c"]), Some(&["d"])]), ["c"]);
        assert_eq!(told(&[Some(&["a", "b"]), Some(&[])]), <[&str; 0]>::default());
        assert_eq!(told(&[Some(&["a", "b"]), None]), <[&str; 0]>::default());
        assert_eq!(told(&[]), <[&str; 0]>::default());
    }
}
