//! The places where declarations of a file go, and the text that puts them there.

use crate::names::context::Context;
use crate::names::scope::SectionKind;
use ladder_format::Edit;
use ladder_syntax::ast::{AstNode, NodeView, SectionHeader};
use ladder_syntax::{LineKind, Parse, Section, TextRange, TextSize};
use std::collections::HashMap;

/// Where declarations of a scope go.
#[derive(Debug, Clone)]
pub struct Places {
    /// The last section of each header that takes them, as in `VAR RETAIN`: the place, and whether it begins a line.
    sections: HashMap<String, (TextSize, bool)>,
    /// Where a new section goes, what must be before it, and whether a blank line follows it.
    new: TextSize,
    before_new: &'static str,
    blank_after: bool,
    line_end: &'static str,
    /// A section is not closed: nobody knows where it ends.
    open: bool,
}

impl Places {
    /// The places of scope 0, the file's, or of block definition `scope - 1`.
    pub fn new(context: &Context, scope: usize) -> Places {
        let parse = &*context.parse;
        let block = scope.checked_sub(1);
        let line_end = line_end(parse);
        let sections = || {
            parse
                .frame()
                .sections
                .iter()
                .filter(|section| section.block == block)
        };
        let (new, before_new, blank_after) = match sections().next_back() {
            Some(last) => {
                let after = last.lines.end;
                let at = parse.line_range(after - 1).end();
                // END_VAR on the last line of the text, or with something after it.
                let before = if begins_line(parse, after) { "" } else { line_end };
                (at, before, false)
            }
            None => (first_place(parse, block), "", true),
        };
        Places {
            sections: sections()
                .filter_map(|section| {
                    let end = section.lines.end - 1;
                    Some((
                        header_of(parse, section)?,
                        (parse.line_start(end), begins_line(parse, end)),
                    ))
                })
                .collect(),
            new,
            before_new,
            blank_after,
            line_end,
            open: sections().any(|section| !section.closed),
        }
    }

    /// The edits that declare a tag: in the last section of its kind, else in a new one. None if a section that is not closed
    /// leaves no place for it.
    pub fn declare(&self, section: SectionKind, name: &str, ty: &str) -> Option<Vec<Edit>> {
        self.declare_all(&[(section, name.to_owned(), ty.to_owned())])
    }

    /// The edits that declare some tags, each with its section, name and type: those of one section together, in the
    /// order given; new sections in the order of inputs, outputs and others.
    pub fn declare_all(&self, tags: &[(SectionKind, String, String)]) -> Option<Vec<Edit>> {
        let declarations = tags
            .iter()
            .map(|(section, name, ty)| (section.keyword().to_owned(), format!("{name} : {ty};")));
        self.put(&declarations.collect::<Vec<_>>())
    }

    /// The same for whole declarations, each with the header of its section, as in `VAR RETAIN`.
    pub fn put(&self, declarations: &[(String, String)]) -> Option<Vec<Edit>> {
        if self.open {
            return None;
        }
        let line_end = self.line_end;
        let mut headers: Vec<&String> = declarations.iter().map(|(header, _)| header).collect();
        headers.sort_by_key(|header| (order_of(header), *header));
        headers.dedup();
        let mut edits = Vec::new();
        let mut new = String::new();
        for header in headers {
            let own = declarations.iter().filter(|(of, _)| of == header);
            let place = self.sections.get(header);
            let lines: String = own
                .map(|(_, declaration)| match place {
                    Some((_, false)) => format!(" {declaration} "),
                    _ => format!("    {declaration}{line_end}"),
                })
                .collect();
            match place {
                Some((at, _)) => edits.push(Edit {
                    range: TextRange::empty(*at),
                    text: lines,
                }),
                None => new.extend([header, line_end, &lines, "END_VAR", line_end]),
            }
        }
        if !new.is_empty() {
            let blank = if self.blank_after { line_end } else { "" };
            edits.push(Edit {
                range: TextRange::empty(self.new),
                text: format!("{}{new}{blank}", self.before_new),
            });
        }
        edits.sort_by_key(|edit| edit.range.start());
        Some(edits)
    }
}

/// Where a new section with a header comes among others: inputs first.
fn order_of(header: &str) -> usize {
    let keyword = header.split(' ').next().unwrap_or_default();
    let order = [
        SectionKind::Input,
        SectionKind::Output,
        SectionKind::InOut,
        SectionKind::Var,
        SectionKind::Global,
    ];
    let found = order.iter().position(|section| section.keyword() == keyword);
    found.unwrap_or(order.len())
}

/// The words of a section's first line, in capitals and one blank apart: `VAR RETAIN`. None of one that declares no tags.
pub fn header_of(parse: &Parse, section: &Section) -> Option<String> {
    let line = parse.lines()[section.lines.start].tree();
    let header = SectionHeader::cast(NodeView::root(&line))?;
    let mut words = SectionKind::from_keyword(header.section()?.text())?
        .keyword()
        .to_owned();
    for qualifier in header.qualifiers() {
        words.push(' ');
        words.push_str(&qualifier.text().to_ascii_uppercase());
    }
    Some(words)
}

/// Whether a logical line, or the end of the text, begins a physical one.
fn begins_line(parse: &Parse, line: usize) -> bool {
    line.checked_sub(1).is_none_or(|before| {
        let text = parse.lines()[before].text().to_owned();
        text.ends_with(['\n', '\r'])
    })
}

/// Where the first section goes: before the first rung with the comments right above it; in a body after the
/// block's header.
fn first_place(parse: &Parse, block: Option<usize>) -> TextSize {
    if let Some(block) = block {
        let header = parse.frame().blocks[block].lines.start;
        return parse.line_range(header).end();
    }
    let lines = parse.lines();
    let after_mark = |offset: TextSize| {
        let marked = parse.text_len() > TextSize::new(0) && parse.lines()[0].text().contains('\u{feff}');
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
    let above = (0..first)
        .rev()
        .take_while(|&line| lines[line].kind == LineKind::Comment)
        .count();
    if above == first {
        // Nothing parts the comments at the head of the file from those of the rung.
        return after_mark(parse.line_start(first));
    }
    after_mark(parse.line_start(first - above))
}

/// The line end that the text uses: that of its first line.
pub fn line_end(parse: &Parse) -> &'static str {
    let first = parse.lines().first().map(|line| line.text().to_owned());
    match first {
        Some(line) if line.ends_with("\r\n") => "\r\n",
        Some(line) if line.ends_with('\r') => "\r",
        _ => "\n",
    }
}
