//! Declarations of new names, in one step with what brings them.

use super::fragment::Copied;
use super::layout::formatted;
use super::lines::gone;
use super::piece::Piece;
use ladder_analysis::context::Context;
use ladder_analysis::names::declaring::Places;
use ladder_analysis::names::scope::SectionKind;
use ladder_format::{Edit, Options, apply, is_switched_off};
use ladder_syntax::{Name, TextRange};

/// A tag that is declared.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Declared {
    /// Its name.
    pub name: String,
    /// The section.
    pub section: SectionKind,
    /// Its type.
    pub ty: String,
}

/// What declares copies next to what they are copies of, and new names in the sections that they ask for.
///
/// # Errors
/// Why nothing can be declared.
pub(super) fn pieces(
    context: &Context,
    scope: usize,
    copies: &[Copied],
    new: &[Declared],
    options: &Options,
) -> Result<Vec<Piece>, String> {
    let mut edits: Vec<Edit> = Vec::new();
    let mut others: Vec<(SectionKind, String, String)> = Vec::new();
    for copy in copies {
        match beside(context, scope, copy) {
            Some(edit) => edits.push(edit),
            None => others.push((copy.new.section, copy.new.name.clone(), copy.new.ty.clone())),
        }
    }
    others.extend(
        new.iter()
            .map(|new| (new.section, new.name.clone(), new.ty.clone())),
    );
    if !others.is_empty() {
        let places = Places::new(context, scope);
        let declared = places.declare_all(&others);
        edits.extend(declared.ok_or("a section of declarations is not closed: put that right first")?);
    }
    Ok(laid_out(context, scope, edits, options))
}

/// The name of a copy in the list in which the original is declared.
fn beside(context: &Context, scope: usize, copy: &Copied) -> Option<Edit> {
    let scope = &context.scopes[scope];
    let tag = &scope.tags[scope.find(&Name::new(&copy.of))?];
    // One address is one tag's.
    let is_alone = tag.cold.address.is_some() || tag.constant || !tag.is_declared() || tag.is_alias();
    (!is_alone).then(|| Edit {
        range: TextRange::empty(context.place_of(tag).end()),
        text: format!(", {}", copy.new.name),
    })
}

/// Edits of declarations, each with the section that it is in laid out again.
pub(super) fn laid_out(
    context: &Context,
    scope: usize,
    mut edits: Vec<Edit>,
    options: &Options,
) -> Vec<Piece> {
    let parse = &context.parse;
    edits.sort_by_key(|edit| edit.range.start());
    let mut pieces: Vec<Piece> = Vec::new();
    let mut sections = parse.frame().sections.iter().peekable();
    let mut edits = edits.into_iter().peekable();
    while let Some(edit) = edits.peek() {
        let at = edit.range.start();
        let last = |section: &ladder_syntax::Section| section.lines.end.max(section.lines.start + 1) - 1;
        while sections
            .next_if(|section| parse.line_range(last(section)).end() <= at)
            .is_some()
        {}
        let around = sections.peek().and_then(|section| {
            let range = parse
                .line_range(section.lines.start)
                .cover(parse.line_range(last(section)));
            (range.start() < at || (range.start() == at && !edit.range.is_empty()))
                .then_some((section.lines.start, range))
        });
        let Some((line, range)) = around else {
            pieces.extend(edits.next().map(|edit| Piece::plain(edit.range, edit.text)));
            continue;
        };
        let mut own = Vec::new();
        while let Some(edit) = edits.next_if(|edit| edit.range.end() <= range.end()) {
            own.push(Edit {
                range: edit.range - range.start(),
                text: edit.text,
            });
        }
        let new = apply(&parse.text_in(range), &own);
        if new.is_empty() {
            let lines = line..parse.line_at(range.end()).unwrap_or(parse.lines().len());
            pieces.push(Piece::gone(gone(context, lines)));
            continue;
        }
        let is_by_hand = is_switched_off(parse, line);
        let new = if is_by_hand {
            new
        } else {
            formatted(&new, scope > 0, options)
        };
        pieces.push(Piece::plain(range, new));
    }
    pieces
}
