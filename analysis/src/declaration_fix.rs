//! Where a new declaration goes, and the text that puts it there.

use crate::context::Context;
use crate::diagnostic::Fix;
use crate::scope::SectionKind;
use ladder_format::Edit;
use ladder_syntax::ast::{AstNode, SectionHeader};
use ladder_syntax::{LineKind, Parse, Section, TextRange, TextSize};

/// A tag that is to be declared.
pub(crate) struct NewTag<'t> {
    /// The scope: 0 the file's, else that of block definition `scope - 1`.
    pub(crate) scope: usize,
    pub(crate) section: SectionKind,
    pub(crate) name: &'t str,
    /// As it is written: `ARRAY[1..9] OF INT`.
    pub(crate) ty: &'t str,
}

/// The fix that declares a tag: in the last section of its kind, else in a new one. None if a section that is not
/// closed leaves no place for it.
pub(crate) fn declare(context: &Context, tag: &NewTag<'_>) -> Option<Fix> {
    let parse = &*context.parse;
    let block = tag.scope.checked_sub(1);
    let line_end = line_end(parse);
    let (name, ty, keyword) = (tag.name, tag.ty, tag.section.keyword());
    let mut last = None;
    let mut same = None;
    for section in parse
        .structure()
        .sections
        .iter()
        .filter(|section| section.block == block)
    {
        if !section.closed {
            return None;
        }
        last = Some(section);
        if is_plain(parse, section, tag.section) {
            same = Some(section);
        }
    }
    let (at, text) = if let Some(section) = same {
        let end = section.lines.end - 1;
        let at = parse.line_start(end);
        if begins_line(parse, end) {
            (at, format!("    {name} : {ty};{line_end}"))
        } else {
            (at, format!(" {name} : {ty}; "))
        }
    } else {
        let section = format!("{keyword}{line_end}    {name} : {ty};{line_end}END_VAR{line_end}");
        match last {
            Some(last) => {
                let behind = last.lines.end;
                let at = parse.line_range(behind - 1).end();
                // END_VAR on the last line of the text, or with something behind it.
                let before = if begins_line(parse, behind) { "" } else { line_end };
                (at, format!("{before}{section}"))
            }
            None => (first_place(parse, block), format!("{section}{line_end}")),
        }
    };
    Some(Fix {
        title: format!("Declare `{name} : {ty}` in {keyword}"),
        edits: vec![Edit {
            range: TextRange::empty(at),
            text,
        }],
    })
}

/// Whether a section is of a kind, and neither RETAIN nor CONSTANT.
fn is_plain(parse: &Parse, section: &Section, kind: SectionKind) -> bool {
    let header = SectionHeader::cast(parse.lines()[section.lines.start].syntax());
    header.is_some_and(|header| {
        let keyword = header
            .section()
            .and_then(|token| SectionKind::from_keyword(token.text()));
        keyword == Some(kind) && header.qualifiers().next().is_none()
    })
}

/// Whether a logical line, or the end of the text, begins a physical one.
fn begins_line(parse: &Parse, line: usize) -> bool {
    line.checked_sub(1).is_none_or(|before| {
        let text = parse.lines()[before].syntax().text().to_string();
        text.ends_with(['\n', '\r'])
    })
}

/// Where the first section goes: before the first rung with the comments right above it; in a body behind the
/// block's header.
fn first_place(parse: &Parse, block: Option<usize>) -> TextSize {
    if let Some(block) = block {
        let header = parse.structure().blocks[block].lines.start;
        return parse.line_range(header).end();
    }
    let lines = parse.lines();
    let behind_mark = |offset: TextSize| {
        let marked =
            parse.text_len() > TextSize::new(0) && parse.lines()[0].syntax().text().contains_char('\u{feff}');
        if marked {
            offset.max(TextSize::of('\u{feff}'))
        } else {
            offset
        }
    };
    let first = lines
        .iter()
        .position(|line| !line.kind.is_decoration())
        .unwrap_or(lines.len());
    let above = lines[..first]
        .iter()
        .rev()
        .take_while(|line| line.kind == LineKind::Comment)
        .count();
    if above == first {
        // Nothing parts the comments at the head of the file from those of the rung.
        return behind_mark(parse.line_start(first));
    }
    behind_mark(parse.line_start(first - above))
}

/// The line end that the text uses.
fn line_end(parse: &Parse) -> &'static str {
    let first = parse.lines().first().map(|line| line.syntax().text().to_string());
    match first {
        Some(line) if line.ends_with("\r\n") => "\r\n",
        Some(line) if line.ends_with('\r') => "\r",
        _ => "\n",
    }
}
