//! The notations of other systems that this build knows: the one place that names them.
//!
//! Each is a feature, in the list [`NOTATIONS`]; the order there is the order in which they are asked whether a text is theirs.
//! [`recognise`] finds the one of a file, [`Form`] is that or ladder text.
#![forbid(unsafe_code)]

mod conversion;
mod form;

pub use conversion::{CONVERSION, conversion_of_cplc_draft};
pub use form::Form;
pub use ladder_notation::{
    Bytes, Companion, Converted, Entry, Finding, Foreign, LineColumn, Lines, Mark, Names, Notation, OneFile,
    Outcome, ProjectTask, Reach, ReadError, Remark, Report, Source, Tally, WriteError, Writing, convert,
    has_extension, remarks, write_checked, write_one_file,
};

use ladder_notation::in_utf8;
use std::path::Path;

/// All of them, in the order in which they are asked whether a text is theirs.
pub const NOTATIONS: &[&dyn Notation] = &[
    #[cfg(feature = "textbook")]
    &ladder_notation_textbook::Textbook,
    #[cfg(feature = "cplc-draft")]
    &ladder_notation_cplc_draft::CplcDraft,
    #[cfg(feature = "ldmicro")]
    &ladder_notation_ldmicro::Ldmicro,
    #[cfg(feature = "ldmicro")]
    &ladder_notation_ldmicro::LdmicroText,
    #[cfg(feature = "logix")]
    &ladder_notation_logix::L5x,
    #[cfg(feature = "logix")]
    &ladder_notation_logix::L5k,
    #[cfg(feature = "logix")]
    &ladder_notation_logix::Rslogix500,
    #[cfg(feature = "iot")]
    &ladder_notation_iot::Iot,
    #[cfg(feature = "click")]
    &ladder_notation_click::Click,
    #[cfg(feature = "click")]
    &ladder_notation_click::ClickGrid,
    #[cfg(feature = "openplc")]
    &ladder_notation_openplc::OpenPlc,
    #[cfg(feature = "plcopen")]
    &ladder_notation_plcopen::Plcopen,
    #[cfg(feature = "simatic")]
    &ladder_notation_simatic::Simatic,
    #[cfg(feature = "simatic")]
    &ladder_notation_simatic::SimaticMl,
    #[cfg(feature = "simatic")]
    &ladder_notation_simatic::SimaticScl,
    #[cfg(feature = "twincat")]
    &ladder_notation_twincat::TwinCat,
    #[cfg(feature = "c")]
    &ladder_notation_c::C,
    #[cfg(feature = "st")]
    &ladder_notation_st::St,
    // Last: what looks drawn may be one of the others.
    #[cfg(feature = "ascii")]
    &ladder_notation_ascii::Ascii,
];

/// The name of this project's own notation, next to those of [`NOTATIONS`].
pub const LADDER: &str = "clad";

/// The notation with this name.
pub fn by_name(name: &str) -> Option<&'static dyn Notation> {
    NOTATIONS.iter().copied().find(|notation| notation.name() == name)
}

/// The notation that a file is in: by the end of its name, if no other system's files are called so; else by its content, since
/// other systems share their file names.
pub fn recognise(path: &Path, bytes: &[u8]) -> Option<&'static dyn Notation> {
    let mut all = NOTATIONS.iter().copied();
    let extension = path.extension().and_then(|extension| extension.to_str());
    let is_named = |notation: &&dyn Notation| {
        notation.owns_extension() && extension.is_some_and(|extension| has_extension(*notation, extension))
    };
    all.clone().find(is_named).or_else(|| {
        let bytes = in_utf8(bytes);
        all.find(|notation| notation.recognises(&bytes))
    })
}

/// The notation of a file that is a program of a workspace without being ladder text, by its name.
pub fn of_workspaces(path: &Path) -> Option<&'static dyn Notation> {
    let extension = path.extension()?.to_str()?;
    let mut all = NOTATIONS.iter().copied();
    all.find(|notation| notation.is_in_workspaces() && has_extension(*notation, extension))
}

/// The notation that a file's name asks for when it is written: the only one, or the first, whose names end so.
pub fn by_extension(extension: &str) -> Option<&'static dyn Notation> {
    NOTATIONS
        .iter()
        .copied()
        .find(|notation| has_extension(*notation, extension))
}

/// The notation whose programs an editor opens under the name of this language.
pub fn by_language(language: &str) -> Option<&'static dyn Notation> {
    NOTATIONS
        .iter()
        .copied()
        .find(|notation| notation.editor_language() == Some(language))
}
