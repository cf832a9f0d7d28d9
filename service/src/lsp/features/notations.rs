//! `ladder.convert` and `ladder.notations`: programs of other systems.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use ladder_documents::Kind;
use ladder_documents::address::path_of;
use ladder_live::{Failure, argument_of};
use ladder_notations::{Form, Source};
use ladder_workspace::{Disk, FileError, ForeignPrograms, is_ladder_text};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::notation::messages::{Convert, Nothing};
use crate::notation::{Task, known, translate};

/// Writes a program in another notation.
const CONVERT: &str = "ladder.convert";

/// Which notations there are.
const KNOWN: &str = "ladder.notations";

/// The commands of this file.
pub(crate) const COMMANDS: [&str; 2] = [CONVERT, KNOWN];

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    if params.command == KNOWN {
        argument_of::<Nothing>(KNOWN, params.arguments).map_err(error)?;
        return json(&known());
    }
    let wanted: Convert = argument_of(CONVERT, params.arguments).map_err(error)?;
    let open = shared.documents.get(&wanted.uri);
    let open = open.or_else(|| shared.companions.get(&wanted.uri));
    let neighbours = shared.neighbours.clone();
    let converted = blocking(&*shared.host, move |_| {
        let shown = open
            .as_ref()
            .filter(|revision| wanted.text.is_none() && revision.kind() == Kind::Program);
        let analysis = shown.and_then(|revision| revision.analysis());
        let text = wanted.text.clone();
        let text = text.or_else(|| open.as_ref().map(|revision| revision.text()));
        let kind = open.as_ref().map_or(Kind::Program, |revision| revision.kind());
        let program = Program::of(&**neighbours.disk(), &wanted, text, kind)?;
        let task = Task {
            source: &program.source(neighbours.foreign())?,
            from: program.from,
            to: program.to,
        };
        let analysis = analysis.map(|analysis| Arc::clone(analysis.whole()));
        let whole = shown.and_then(|revision| revision.linked()?.ok());
        translate(&task, analysis, whole).map_err(|message| Failure::Failed(program.say(&message)))
    });
    json(&converted.await?.map_err(error)?)
}

/// A program to be translated.
struct Program {
    /// The file as messages name it.
    file: String,
    path: PathBuf,
    is_on_disk: bool,
    bytes: Vec<u8>,
    from: Form,
    to: Form,
}

impl Program {
    /// What is wanted, with the text that the editor has, of this kind; else with what is on disk.
    fn of(
        disk: &dyn Disk,
        wanted: &Convert,
        text: Option<String>,
        kind: Kind,
    ) -> std::result::Result<Program, Failure> {
        let failed = |message: String| Failure::Failed(message);
        let path = path_of(&wanted.uri);
        let bytes = match (text, &path) {
            (Some(text), _) => text.into_bytes(),
            (None, Some(path)) => read(disk, path).map_err(|error| failed(error.to_string()))?,
            (None, None) => {
                return Err(failed(format!("{} is not a file; send its text", wanted.uri)));
            }
        };
        let is_on_disk = path.is_some();
        let path = path.unwrap_or_else(|| PathBuf::from(wanted.uri.rsplit('/').next().unwrap_or_default()));
        let file = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let named = |name: &String| {
            Form::named(name).ok_or_else(|| {
                let names: Vec<&str> = Form::names().collect();
                let names = names.join(", ");
                Failure::Invalid(format!("there is no notation {name}; there are {names}"))
            })
        };
        let from = match (&wanted.from, kind.notation()) {
            (Some(name), _) => named(name)?,
            (None, Some(notation)) => Form::Foreign(notation),
            (None, None) => Form::of(&path, &bytes, is_ladder_text(&path)).ok_or_else(|| {
                failed(format!(
                    "{file}: this is in no notation that is known; if it is, name it"
                ))
            })?,
        };
        let to = wanted.to.as_ref().map_or(Ok(Form::Ladder), named)?;
        if matches!((from, to), (Form::Ladder, Form::Ladder)) {
            return Err(failed(format!(
                "{file}: this is ladder text already; name the notation to write it in"
            )));
        }
        Ok(Program {
            file,
            path,
            is_on_disk,
            bytes,
            from,
            to,
        })
    }

    /// The program with what belongs to it.
    fn source(&self, foreign: &ForeignPrograms) -> std::result::Result<Source<'_>, Failure> {
        if let (Form::Foreign(notation), true) = (self.from, self.is_on_disk) {
            return foreign
                .source(notation, &self.path, &self.bytes)
                .map_err(|error| Failure::Failed(error.to_string()));
        }
        let name = self.path.file_stem().and_then(|stem| stem.to_str());
        Ok(Source::alone(name.unwrap_or_default(), &self.bytes))
    }

    /// `motor.rung:1:7: ...`
    fn say(&self, message: &str) -> String {
        let place = message.starts_with(|c: char| c.is_ascii_digit());
        format!("{}:{}{message}", self.file, if place { "" } else { " " })
    }
}

/// A file of a folder that may be anybody's: a regular one that lies in it.
fn read(disk: &dyn Disk, path: &Path) -> std::result::Result<Vec<u8>, FileError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    disk.read_named(&disk.named_in(path, &name))
}
