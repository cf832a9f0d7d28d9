//! Keywords of sections, declarations and block definitions, and the addresses after AT.

use super::item::{CompletionKind, Snippet, Topic};
use super::proposals::Proposals;
use super::{drawings, initial};
use crate::typing::{Declaration, Typing};
use ladder_analysis::values::types::Type;
use ladder_instructions::{Shape, StateType};
use ladder_syntax::{Mode, Name};
use rustc_hash::FxHashSet;

/// The sections, with what their first declaration looks like.
const SECTIONS: [(&str, &str); 6] = [
    ("VAR_INPUT", "inputs"),
    ("VAR_OUTPUT", "outputs"),
    ("VAR", "internal tags"),
    ("VAR_IN_OUT", "the caller's own tags"),
    ("VAR_GLOBAL", "tags of the whole workspace"),
    ("VAR_EXTERNAL", "tags of a VAR_GLOBAL section"),
];

const TYPES: [&str; 20] = [
    "BOOL", "INT", "DINT", "REAL", "TIME", "BYTE", "WORD", "DWORD", "LWORD", "SINT", "LINT", "USINT", "UINT",
    "UDINT", "ULINT", "LREAL", "STRING", "DATE", "TOD", "DT",
];

fn keyword(out: &mut Proposals<'_>, word: &str, detail: &str) {
    out.word(
        (0, 0),
        CompletionKind::Keyword,
        word,
        detail,
        Topic::Keyword(word.to_owned()),
    );
}

/// Where a section, a block definition or a rung may begin.
pub(super) fn at_line_start(typing: &Typing<'_>, out: &mut Proposals<'_>) {
    let in_block = typing.scope > 0;
    for (word, detail) in SECTIONS {
        let of_blocks = word == "VAR_IN_OUT";
        if of_blocks && !in_block {
            continue;
        }
        let text = Snippet::default()
            .text(word)
            .text("\n    ")
            .stop("name")
            .text(" : ")
            .stop("BOOL")
            .text(";\nEND_VAR")
            .end();
        out.snippet(
            (0, 0),
            CompletionKind::Keyword,
            word,
            detail,
            text,
            Topic::Keyword(word.to_owned()),
        );
    }
    if !in_block {
        let text = Snippet::default()
            .text("TYPE\n    ")
            .stop("Name")
            .text(" : STRUCT\n        ")
            .stop("member")
            .text(" : ")
            .stop("BOOL")
            .text(";\n    END_STRUCT;\nEND_TYPE")
            .end();
        out.snippet(
            (0, 0),
            CompletionKind::Keyword,
            "TYPE",
            "types of your own",
            text,
            Topic::Keyword("TYPE".to_owned()),
        );
    }
    if in_block {
        keyword(out, "END_FUNCTION_BLOCK", "end of a block definition");
    } else {
        block_definitions(out);
    }
    let empty = typing.rest(typing.word.end).trim().is_empty();
    if empty {
        drawings::propose(out, in_block);
    }
}

fn block_definitions(out: &mut Proposals<'_>) {
    for shape in Shape::ALL {
        let (open, close) = shape.brackets();
        let text = Snippet::default()
            .text(&format!("FUNCTION_BLOCK {open}$"))
            .stop("Name")
            .text(&format!("{close}\nVAR_INPUT\n    "))
            .stop("a")
            .text(" : BOOL;\nEND_VAR\nVAR_OUTPUT\n    ")
            .stop("y")
            .text(" : BOOL;\nEND_VAR\n\n+--[ ]( EN )--[ ]( a )-----------( )( y )--+\n\nEND_FUNCTION_BLOCK")
            .end();
        let label = format!("FUNCTION_BLOCK {open}$Name{close}");
        out.snippet(
            (1, 0),
            CompletionKind::Keyword,
            &label,
            "block definition",
            text,
            Topic::Keyword("FUNCTION_BLOCK".to_owned()),
        );
    }
}

/// On a line of declarations.
pub(super) fn in_declaration(typing: &Typing<'_>, place: Declaration, out: &mut Proposals<'_>) {
    match place {
        Declaration::Header => {
            keyword(out, "RETAIN", "values are kept over a warm restart");
            keyword(out, "CONSTANT", "values are never written");
        }
        Declaration::Names(true) => match typing.section() {
            Mode::Types => keyword(out, "END_TYPE", "end of the section"),
            Mode::Struct { .. } => keyword(out, "END_STRUCT", "end of the structure"),
            Mode::Section | Mode::Network => keyword(out, "END_VAR", "end of the section"),
        },
        // New names cannot be guessed.
        Declaration::Names(false) => {}
        Declaration::AfterNames => keyword(out, "AT", "a direct address"),
        Declaration::Address => addresses(out),
        Declaration::Of => {
            keyword(out, "OF", "the type of the elements");
        }
        Declaration::Type => types(typing, out),
        Declaration::Bounds => constants(typing, out),
        Declaration::Initial => initial::propose(typing, out),
    }
}

/// The whole numbers that bounds may name: those of the file itself.
fn constants(typing: &Typing<'_>, out: &mut Proposals<'_>) {
    let tags = typing.context.scopes.first().map_or(&[][..], |scope| &scope.tags);
    let own = tags
        .iter()
        .filter(|tag| tag.constant && tag.cold.foreign.is_none());
    for tag in own.filter(|tag| matches!(tag.ty, Some(Type::Scalar(ty)) if ty.is_integer())) {
        let ty = tag.ty.map(|ty| ty.to_string()).unwrap_or_default();
        out.word(
            (0, 0),
            CompletionKind::Constant,
            &tag.name,
            &ty,
            Topic::Tag(0, tag.name.to_string()),
        );
    }
}

fn types(typing: &Typing<'_>, out: &mut Proposals<'_>) {
    let before = typing.text[..typing.word.start].trim_end();
    let of_elements = before.to_ascii_uppercase().ends_with("OF");
    for word in TYPES {
        out.word(
            (0, 0),
            CompletionKind::Type,
            word,
            "type",
            Topic::Keyword(word.to_owned()),
        );
    }
    for (ty, file) in typing.context.types.all() {
        let detail = file.map_or("type of this file", |file| file);
        let name = &ty.name;
        out.word((0, 0), CompletionKind::Type, name, detail, Topic::Nothing);
    }
    blocks(typing, out);
    let array = Snippet::default()
        .text("ARRAY[")
        .stop("1")
        .text("..")
        .stop("8")
        .text("] OF ")
        .stop("INT")
        .end();
    if !of_elements {
        out.snippet(
            (0, 1),
            CompletionKind::Type,
            "ARRAY",
            "a row of elements",
            array,
            Topic::Keyword("ARRAY".to_owned()),
        );
    }
    for state in StateType::ALL {
        let detail = if state.is_timer() {
            "timer"
        } else if state.is_counter() {
            "counter"
        } else {
            "bistable"
        };
        out.word(
            (1, 0),
            CompletionKind::Type,
            state.name(),
            detail,
            Topic::Keyword(state.name().to_owned()),
        );
    }
}

/// User-defined blocks, for tags that keep the state of one.
fn blocks(typing: &Typing<'_>, out: &mut Proposals<'_>) {
    let own = typing.context.user_blocks.iter().map(|block| block.name.as_str());
    let others = typing
        .context
        .others
        .all_blocks()
        .map(|(_, block)| block.facts.name.as_str());
    let mut seen = FxHashSet::default();
    for name in own.chain(others).filter(|name| seen.insert(Name::new(name))) {
        let topic = Topic::UserBlock(name.to_owned());
        out.word((2, 0), CompletionKind::UserBlock, name, "state of a block", topic);
    }
}

/// The areas and sizes of direct addresses.
pub(super) fn addresses(out: &mut Proposals<'_>) {
    for (area, name) in [("I", "input"), ("Q", "output"), ("M", "memory")] {
        for (size, bits) in [
            ("X", "bit"),
            ("B", "8 bits"),
            ("W", "16 bits"),
            ("D", "32 bits"),
            ("L", "64 bits"),
        ] {
            let number = if size == "X" { "0.0" } else { "0" };
            let text = Snippet::default()
                .text(&format!("%{area}{size}"))
                .stop(number)
                .end();
            let label = format!("%{area}{size}");
            out.snippet(
                (0, 0),
                CompletionKind::Tag,
                &label,
                &format!("{name}, {bits}"),
                text,
                Topic::Nothing,
            );
        }
    }
}
