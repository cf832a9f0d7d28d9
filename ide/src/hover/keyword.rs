//! Hover on the keywords of sections, declarations and block definitions.

use super::Hover;
use ladder_syntax::{Parse, SyntaxKind, TextSize};

pub(super) fn hover(parse: &Parse, line: usize, offset: TextSize) -> Option<Hover> {
    let start = parse.line_start(line);
    let root = parse.lines()[line].syntax();
    let token = root
        .token_at_offset(offset - start)
        .find(|token| token.kind() == SyntaxKind::KEYWORD)?;
    Some(Hover {
        range: token.text_range() + start,
        markdown: card(token.text())?,
    })
}

/// What a keyword means.
pub(crate) fn card(word: &str) -> Option<String> {
    let word = word.to_ascii_uppercase();
    let meaning = meaning(&word)?;
    Some(format!("```clad\n{word}\n```\n{meaning}"))
}

fn meaning(word: &str) -> Option<&'static str> {
    Some(match word {
        "VAR" => "Begins a section of internal tags, up to END_VAR.",
        "VAR_INPUT" => {
            "Begins a section of inputs: tags that the outside writes. In a block definition: values that the caller gives."
        }
        "VAR_OUTPUT" => {
            "Begins a section of outputs: tags that the outside reads. In a block definition: values that the caller gets."
        }
        "VAR_IN_OUT" => "Begins a section of parameters that are the caller's own tags, read and written.",
        "VAR_GLOBAL" => "Begins a section of tags that every file of the workspace sees.",
        "VAR_EXTERNAL" => {
            "Begins a section that names tags which a VAR_GLOBAL section of the workspace declares."
        }
        "TYPE" => "Begins a section of types of your own, up to END_TYPE.",
        "END_TYPE" => "Ends a section of types.",
        "STRUCT" => "Begins a structure: a type with members, up to END_STRUCT.",
        "END_STRUCT" => "Ends a structure.",
        "END_VAR" => "Ends a section of declarations.",
        "RETAIN" => "The tags of this section keep their values over a warm restart.",
        "CONSTANT" => "The tags of this section keep their initial values: no block may write them.",
        "AT" => {
            "Gives a tag a direct address such as %IX0.0: input I, output Q or memory M; X one bit, B 8, W 16, D 32, L 64."
        }
        "ARRAY" => "A row of elements of one type, with the first and last index: ARRAY[1..10] OF INT.",
        "OF" => "The type of an array's elements follows.",
        "FUNCTION_BLOCK" => {
            "Begins the definition of a block of your own, with its name in the brackets that show its shape."
        }
        "END_FUNCTION_BLOCK" => "Ends the definition of a block.",
        "BOOL" => "One bit: TRUE or FALSE.",
        "BYTE" => "A bit string of 8 bits.",
        "WORD" => "A bit string of 16 bits.",
        "DWORD" => "A bit string of 32 bits.",
        "LWORD" => "A bit string of 64 bits.",
        "SINT" => "An integer of 8 bits: -128 to 127.",
        "INT" => "An integer of 16 bits: -32768 to 32767.",
        "DINT" => "An integer of 32 bits: -2147483648 to 2147483647.",
        "LINT" => "An integer of 64 bits.",
        "USINT" => "An unsigned integer of 8 bits: 0 to 255.",
        "UINT" => "An unsigned integer of 16 bits: 0 to 65535.",
        "UDINT" => "An unsigned integer of 32 bits: 0 to 4294967295.",
        "ULINT" => "An unsigned integer of 64 bits.",
        "REAL" => "A real number of 32 bits, about 7 digits.",
        "LREAL" => "A real number of 64 bits, about 16 digits.",
        "TIME" => "A duration, such as T#1h30m, kept in nanoseconds.",
        "DATE" => "A day, such as D#2026-11-21.",
        "TOD" | "TIME_OF_DAY" => "A time of day, such as TOD#13:45:00.",
        "DT" | "DATE_AND_TIME" => "A day and time, such as DT#2026-11-21-13:45:00.",
        "STRING" => "A text of at most 80 characters, or of as many as STRING[n] says.",
        "TON" => "The state of an on-delay timer.",
        "TOF" => "The state of an off-delay timer.",
        "TP" => "The state of a pulse timer.",
        "RTO" => "The state of a retentive on-delay timer.",
        "RTOF" => "The state of a retentive off-delay timer.",
        "CTU" => "The state of an up counter.",
        "CTD" => "The state of a down counter.",
        "CTUD" => "The state of an up and down counter.",
        "CTC" => "The state of a circular counter.",
        "SR" => "The state of a bistable in which set dominates.",
        "RS" => "The state of a bistable in which reset dominates.",
        _ => return None,
    })
}
