//! What the other files of a project declare that a block may use.

use crate::model::Unit;
use crate::read::resource::Texts;
use crate::{bounded, head, read, xml};
use ladder_notation::{Bytes, Companion, ReadError, Source, text_of};
use std::sync::Arc;

/// How the names of files end that declare something, or have texts of a document.
const ENDS: [&str; 6] = [".s7dcl", ".s7res", ".xml", ".scl", ".udt", ".db"];

/// A declared name, and what it is of, or why that cannot be read.
pub(crate) type Declared = (String, Result<Unit, String>);

/// Whether a file may declare something that a block uses, or has its texts.
pub(crate) fn is_file(name: &str) -> bool {
    ENDS.iter().any(|end| stem(name, end).is_some())
}

/// A file's name without this end.
fn stem<'f>(file: &'f str, end: &str) -> Option<&'f str> {
    let (stem, own) = file.split_at_checked(file.len().checked_sub(end.len())?)?;
    own.eq_ignore_ascii_case(end).then_some(stem)
}

/// What the other files of a block's project declare, the nearest first. Each file is read once for all blocks.
pub(crate) fn declared(source: &Source<'_>) -> Vec<Arc<(Option<Bytes>, Vec<Declared>)>> {
    let files = source
        .companions
        .iter()
        .filter(|file| stem(&file.name, ".s7res").is_none());
    files.map(|file| held(file, source)).collect()
}

/// What a file declares, with the texts that it was read with.
fn held(file: &Companion, source: &Source<'_>) -> Arc<(Option<Bytes>, Vec<Declared>)> {
    let texts = stem(&file.name, ".s7dcl")
        .and_then(|stem| resource(source, stem))
        .cloned();
    let make = |bytes: &[u8]| Arc::new((texts.clone(), in_file(&file.name, bytes, texts.as_deref())));
    let made = file.bytes.made(make);
    // Texts may have become others, next to a document that has not changed.
    if made.0 == texts { made } else { make(&file.bytes) }
}

fn in_file(name: &str, bytes: &[u8], texts: Option<&[u8]>) -> Vec<Declared> {
    let source = Source::alone("", bytes);
    let units = || -> Result<Vec<Unit>, ReadError> {
        if stem(name, ".s7dcl").is_some() {
            return Ok(vec![read::unit(bounded(&source)?, &texts_of(texts)?)?]);
        }
        if stem(name, ".xml").is_none() {
            return read::source(bounded(&source)?);
        }
        let head = head(bytes);
        if xml::holds_tags(&head) {
            return xml::tags(bounded(&source)?);
        }
        // Any other XML is of something else.
        xml::recognises(&head)
            .then(|| xml::unit(bounded(&source)?))
            .into_iter()
            .collect()
    };
    match units() {
        Ok(units) => units
            .into_iter()
            .map(|unit| (unit.name.clone(), Ok(unit)))
            .collect(),
        // A block is kept in a file of its name.
        Err(error) => {
            let name = name.rsplit('/').next().unwrap_or(name);
            let name = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
            vec![(name.to_owned(), Err(error.to_string()))]
        }
    }
}

/// The texts of the document with this stem.
pub(crate) fn texts(source: &Source<'_>, document: &str) -> Result<Texts, ReadError> {
    texts_of(resource(source, document).map(|bytes| &**bytes))
}

fn texts_of(bytes: Option<&[u8]>) -> Result<Texts, ReadError> {
    bytes.map_or_else(|| Ok(Texts::default()), |bytes| Ok(Texts::of(text_of(bytes)?)))
}

fn resource<'s>(source: &'s Source<'_>, document: &str) -> Option<&'s Bytes> {
    let is_of = |file: &&Companion| {
        stem(&file.name, ".s7res").is_some_and(|stem| stem.eq_ignore_ascii_case(document))
    };
    source.companions.iter().find(is_of).map(|file| &file.bytes)
}
