//! `ladder.diagramEdit` and `ladder.diagramOffer`: changes of a drawing in the diagram, as edits that the client makes in one
//! step. `docs/protocol.md` shows the messages.

use std::sync::Arc;

use ladder_documents::Revision;
use ladder_documents::position::{self, Position, Range};
use ladder_ide::{Asked, Change, Given, Redrawn, Side, change, offer};
use ladder_live::{Failure, argument_of};
use ladder_syntax::{TextRange, TextSize};
use serde::de::DeserializeOwned;
use tower_lsp::jsonrpc::{Error, Result};
use tower_lsp::ls_types::{
    ExecuteCommandParams, LSPAny, TextDocumentIdentifier, TextDocumentPositionParams, Uri,
};

use super::rename;
use crate::drawing_messages::{
    BranchSide, Commented, DeclarationCells, Declare, Declared, DeclaredTag, Deleted, DiagramEdit,
    DiagramEdited, DiagramOffer, DiagramOffered, DrawingEdit, FileEdits, Neighbours, NetworkPlace,
    NewNetwork, Offer, OfferedSide, Span,
};
use crate::lsp::answers::{error, json};
use crate::lsp::convert;
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::typing_messages::Replacement;

/// The commands.
pub(crate) const DIAGRAM_EDIT: &str = "ladder.diagramEdit";
/// See above.
pub(crate) const DIAGRAM_OFFER: &str = "ladder.diagramOffer";

fn failed(why: impl Into<String>) -> Error {
    error(Failure::Failed(why.into()))
}

/// The document, if it is the one that the client means.
fn revision(shared: &Shared, uri: &str, version: i32) -> Result<Arc<Revision>> {
    let revision = shared.documents.get(uri);
    let revision = revision.ok_or_else(|| failed(format!("{uri} is not open in the editor")))?;
    if revision.version != version {
        return Err(Error::content_modified());
    }
    Ok(revision)
}

fn argument<T: DeserializeOwned>(command: &str, params: ExecuteCommandParams) -> Result<T> {
    argument_of(command, params.arguments).map_err(error)
}

pub(crate) async fn edit(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let DiagramEdit { uri, version, edit } = argument(DIAGRAM_EDIT, params)?;
    let revision = revision(shared, &uri, version)?;
    if let DrawingEdit::Rename { what, text } = edit {
        return renamed(shared, &revision, what, text).await;
    }
    let edited = blocking(&*shared.host, move |_| {
        let context = revision.context().ok_or("the file is too large")?;
        let wanted = change_of(&revision, edit)?;
        let done = change(context, &wanted, &revision.format_options())?;
        Ok(answer(&revision, &done))
    });
    json(&edited.await?.map_err(|why: String| failed(why))?)
}

pub(crate) async fn offered(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: DiagramOffer = argument(DIAGRAM_OFFER, params)?;
    let revision = revision(shared, &asked.uri, asked.version)?;
    let offered = blocking(&*shared.host, move |_| {
        let context = revision.context().ok_or("the file is too large")?;
        let place = |at: Position| revision.offset(at);
        let what = match (asked.at, asked.what, asked.network) {
            (Some(at), None, None) => Asked::At(place(at)),
            (None, Some(what), None) => Asked::What(ranges(&revision, what)),
            (None, None, Some(line)) => Asked::Network(revision.line_start(line)),
            _ => return Err("ask about one of `at`, `what` and `network`".to_owned()),
        };
        let found = offer(context, &what, asked.text.as_deref(), &revision.format_options())?;
        let position = |at: TextSize| revision.range(TextRange::empty(at)).start;
        let span = |range: TextRange| revision.range(range);
        let offers = found.offers.into_iter().map(|offer| Offer {
            op: offer.op.to_owned(),
            why: offer.why,
        });
        Ok(DiagramOffered {
            version: revision.version,
            offers: offers.collect(),
            text: found.text,
            points: found
                .before
                .zip(found.behind)
                .map(|(before, behind)| OfferedSide {
                    before: position(before),
                    behind: position(behind),
                }),
            larger: found.larger.map(span),
            larger_things: found.larger_things.into_iter().map(span).collect(),
            acting: found.acting.map(|range| Span {
                from: span(range).start,
                to: span(range).end,
            }),
            neighbours: found.neighbours.map(|next| {
                let line = |at: Option<TextSize>| at.map(|at| position(at).line);
                Neighbours {
                    above: line(next.above),
                    below: line(next.below),
                    after: line(next.after),
                }
            }),
            declares: found.declares.into_iter().map(declared).collect(),
            name: found.name,
        })
    });
    json(&offered.await?.map_err(failed)?)
}

fn range(revision: &Revision, range: Range) -> TextRange {
    let (start, end) = (revision.offset(range.start), revision.offset(range.end));
    TextRange::new(start.min(end), end.max(start))
}

fn ranges(revision: &Revision, what: Vec<Range>) -> Vec<TextRange> {
    what.into_iter().map(|one| range(revision, one)).collect()
}

fn given(text: String, copied: bool, declare: Option<Declare>) -> std::result::Result<Given, String> {
    let declare = declare.map(|Declare { section, ty }| {
        let kind = ladder_analysis::names::scope::SectionKind::from_keyword(&section);
        let kind = kind.ok_or_else(|| format!("`{section}` is not a section"))?;
        Ok::<_, String>((kind, ty))
    });
    Ok(Given {
        text,
        copied,
        declare: declare.transpose()?,
    })
}

fn change_of(revision: &Revision, edit: DrawingEdit) -> std::result::Result<Change, String> {
    let place = |at: Position| revision.offset(at);
    let line = |line: u32| revision.line_start(line);
    Ok(match edit {
        DrawingEdit::Insert { at, put } => Change::Insert {
            at: place(at),
            given: given(put.text, put.copied, put.declare)?,
        },
        DrawingEdit::Parallel { from, to, side, put } => Change::Parallel {
            from: place(from),
            to: place(to),
            side: match side {
                BranchSide::Below => Side::Below,
                BranchSide::Above => Side::Above,
            },
            given: given(put.text, put.copied, put.declare)?,
        },
        DrawingEdit::Delete(Deleted::What { what }) => Change::Delete {
            what: ranges(revision, what),
        },
        DrawingEdit::Delete(Deleted::Network { network }) => Change::DeleteNetwork {
            network: line(network),
        },
        DrawingEdit::Operand { what, text, declare } => Change::Operand {
            what: range(revision, what),
            given: given(text, false, declare)?,
        },
        DrawingEdit::Head { what, text } => Change::Head {
            what: range(revision, what),
            text,
        },
        DrawingEdit::Move { what, to } => Change::Move {
            what: ranges(revision, what),
            to: place(to.at),
        },
        DrawingEdit::BranchEnd { what, to } => Change::BranchEnd {
            what: place(what),
            to: place(to),
        },
        DrawingEdit::Close { what, to } => Change::Close {
            what: place(what),
            to: place(to),
        },
        DrawingEdit::Network(NewNetwork {
            network,
            place,
            text,
            entry,
            copied,
            declare,
        }) => {
            let text = text
                .or(entry)
                .ok_or("say what the network is: `text` or `entry`")?;
            Change::Network {
                near: network.map(line),
                is_above: place == NetworkPlace::Above,
                given: given(text, copied, declare)?,
            }
        }
        DrawingEdit::Comment(Commented::Above { network, text }) => Change::Comment {
            network: line(network),
            text,
        },
        DrawingEdit::Comment(Commented::What { what, text }) => Change::EditComment {
            what: range(revision, what),
            text,
        },
        DrawingEdit::Declaration(Declared::New { block, row }) => Change::Declare {
            block,
            row: row_of(row),
        },
        DrawingEdit::Declaration(Declared::At { what, row }) => Change::Redeclare {
            what: range(revision, what),
            row: row.map(row_of),
        },
        DrawingEdit::MoveNetwork { network, before } => Change::MoveNetwork {
            network: line(network),
            before: before.map(line),
        },
        DrawingEdit::Duplicate { network } => Change::Duplicate {
            network: line(network),
        },
        DrawingEdit::Split { at } => Change::Split { at: place(at) },
        DrawingEdit::Merge { networks } => Change::Merge {
            networks: networks.into_iter().map(line).collect(),
        },
        DrawingEdit::Rename { .. } => return Err("names are changed in all files".to_owned()),
    })
}

fn row_of(cells: DeclarationCells) -> ladder_ide::Row {
    let DeclarationCells {
        section,
        name,
        address,
        ty,
        initial,
        comment,
    } = cells;
    ladder_ide::Row {
        section,
        name,
        address,
        ty,
        initial,
        comment,
    }
}

fn declared(declared: ladder_ide::Declared) -> DeclaredTag {
    DeclaredTag {
        name: declared.name,
        section: declared.section.keyword().to_owned(),
        ty: declared.ty,
    }
}

/// The edits with what is selected in the text that they make.
fn answer(revision: &Revision, done: &Redrawn) -> DiagramEdited {
    let new = revision.after(&done.edits);
    let position = |at: TextSize| position::position(&new, revision.encoding(), at.into());
    let range = |range: TextRange| Range {
        start: position(range.start()),
        end: position(range.end()),
    };
    DiagramEdited {
        version: revision.version,
        edits: done
            .edits
            .iter()
            .map(|edit| replacement(revision, edit))
            .collect(),
        select: done.select.iter().map(|select| range(*select)).collect(),
        focus: done.focus.map(position),
        said: done.said.clone(),
        declared: done.declared.iter().cloned().map(declared).collect(),
        also: Vec::new(),
    }
}

/// An edit as the protocol has it.
pub(super) fn replacement(revision: &Revision, edit: &ladder_format::Edit) -> Replacement {
    Replacement {
        range: revision.range(edit.range),
        new_text: edit.text.clone(),
    }
}

/// A tag gets another name, everywhere.
async fn renamed(shared: &Arc<Shared>, revision: &Arc<Revision>, what: Range, new: String) -> Result<LSPAny> {
    let no_place = || failed("this document cannot be renamed in");
    let uri: Uri = revision.uri.parse().map_err(|_| no_place())?;
    let place = TextDocumentPositionParams {
        text_document: TextDocumentIdentifier { uri: uri.clone() },
        position: convert::position(what.start),
    };
    let said = format!("Renamed to {new}");
    let changes = rename::everywhere(shared, place, new)
        .await?
        .ok_or_else(no_place)?;
    let mut edited = DiagramEdited {
        version: revision.version,
        edits: Vec::new(),
        select: Vec::new(),
        focus: None,
        said,
        declared: Vec::new(),
        also: Vec::new(),
    };
    for (file, open, edits) in changes {
        let edits = edits.into_iter().map(|edit| Replacement {
            range: convert::our_range(edit.range),
            new_text: edit.new_text,
        });
        if file == uri {
            edited.edits = edits.collect();
        } else {
            edited.also.push(FileEdits {
                uri: file.to_string(),
                version: open.map(|open| open.version),
                edits: edits.collect(),
            });
        }
    }
    json(&edited)
}
