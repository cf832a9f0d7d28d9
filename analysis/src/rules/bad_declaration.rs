//! `bad-declaration`: a section, a declaration or a block definition that cannot be read.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt::shortened;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_syntax::{DeclarationProblem, TextRange};

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Text,
    "bad-declaration",
    Severity::Error,
));

/// A declaration that is well formed but means nothing.
pub(crate) fn wrong(range: TextRange, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(RULE, range, message)
}

/// The name of a user-defined block, on the first line of its definition or where it is used.
pub(crate) fn block_name(header: bool, text: &str, range: TextRange) -> Diagnostic {
    let rule = if header {
        RULE
    } else {
        super::unexpected_character::RULE
    };
    Diagnostic::new(rule, range, format!("`{text}` is not a name for a block"))
        .help("a block's name is a `$` and a letter, then letters, digits and `_`, which is not last and not twice in a row: $FB_Ramp")
}

/// A word where a declaration should be that was probably meant to begin or end something.
pub(crate) fn misspelt(word: &str, keyword: &str, range: TextRange) -> Diagnostic {
    wrong(range, format!("`{word}` is not a declaration"))
        .help(format!("did you mean {keyword}?"))
        .fix(
            Applicability::Unsafe,
            format!("Replace with {keyword}"),
            range,
            keyword,
        )
}

/// What the parser could not read. `text` is what is in the range; `has_text`: a text in quotes is before it.
pub(crate) fn unreadable(
    problem: DeclarationProblem,
    text: &str,
    range: TextRange,
    has_text: bool,
) -> Diagnostic {
    use DeclarationProblem::*;
    let found = shortened(text, 30);
    let instead = |expected: &str| {
        if found.is_empty() {
            format!("expected {expected} here")
        } else {
            format!("expected {expected}, found `{found}`")
        }
    };
    let (message, help) = match problem {
        NameExpected => (
            instead("the name of a tag"),
            "a declaration is written: start, stop : BOOL;",
        ),
        TypeExpected => (
            instead("`:` and a type"),
            "a declaration is written: start : BOOL; the types are BOOL, INT, DINT, REAL, TIME, TON, CTU and others",
        ),
        SemicolonMissing => (
            "`;` is missing here".to_owned(),
            "every declaration ends with `;`",
        ),
        AddressExpected => (
            instead("an address"),
            "after AT comes an address such as %IX0.0, %QW1 or %MD2",
        ),
        ValueExpected => (
            instead("a value"),
            "after `:=` comes the value at the start: limit : INT := 80;",
        ),
        BoundsExpected => (
            instead("a whole number in brackets"),
            "bounds are written ARRAY[1..10] OF INT, lengths STRING[80]",
        ),
        OfExpected => (
            instead("OF and a type"),
            "an array is written ARRAY[1..10] OF INT",
        ),
        Unexpected => (
            format!("`{found}` belongs to no declaration"),
            "write it on a line of its own",
        ),
        SectionNotClosed => (
            "the declarations above are not closed: END_VAR is missing".to_owned(),
            "a section ends with END_VAR on a line of its own",
        ),
        TypesNotClosed => (
            "the types above are not closed: END_TYPE is missing".to_owned(),
            "a section of types ends with END_TYPE on a line of its own",
        ),
        StructNotClosed => (
            "the STRUCT above is not closed: END_STRUCT; is missing".to_owned(),
            "after its last member a structure ends with END_STRUCT; on a line of its own",
        ),
        EndWithoutSection if found.eq_ignore_ascii_case("END_STRUCT") => (
            "END_STRUCT ends no structure".to_owned(),
            "a structure begins in TYPE with its name: Motor : STRUCT",
        ),
        EndWithoutSection if found.eq_ignore_ascii_case("END_TYPE") => (
            "END_TYPE ends no section".to_owned(),
            "a section of types begins with TYPE",
        ),
        EndWithoutSection => (
            "END_VAR ends no section".to_owned(),
            "a section begins with VAR, VAR_INPUT, VAR_OUTPUT, VAR_IN_OUT, VAR_GLOBAL or VAR_EXTERNAL",
        ),
        OtherEnd if found.eq_ignore_ascii_case("END_TYPE") => (
            "END_TYPE does not end this section: it declares tags".to_owned(),
            "a section of tags ends with END_VAR",
        ),
        OtherEnd => (
            "END_VAR does not end this section: it declares types".to_owned(),
            "a section that begins with TYPE ends with END_TYPE",
        ),
        StructOutsideTypes => (
            "a STRUCT is not declared among tags".to_owned(),
            "declare it in a section TYPE .. END_TYPE as Motor : STRUCT, and the tag as pump : Motor;",
        ),
        NestedStruct => (
            "a STRUCT is not declared inside another".to_owned(),
            "declare the inner one as a type of its own, and the member with that type",
        ),
        EnumerationOutsideTypes => (
            "the values of an enumeration are not listed here".to_owned(),
            "declare it in a section TYPE .. END_TYPE as Phase : (IDLE, FILLING); and the tag as step : Phase;",
        ),
        EnumerationValueExpected => (
            instead("the name of a value"),
            "an enumeration is written: Phase : (IDLE, FILLING, MIXING := 10);",
        ),
        MemberExpected => (
            instead("a member with `:=`"),
            "the values of a structure are written: (speed := 20.0, running := TRUE)",
        ),
        LineNotEnded => (
            format!("`{found}` does not belong onto this line"),
            "rungs and sections begin on a line of their own",
        ),
        BlockHeadExpected => (
            instead("the block with its brackets"),
            "a definition begins with its shape: FUNCTION_BLOCK [$Name], ($Name) or <$Name>",
        ),
        BlockNotClosed => (
            "this block definition is not closed: END_FUNCTION_BLOCK is missing".to_owned(),
            "write END_FUNCTION_BLOCK on a line of its own after the last rung of the block",
        ),
        EndWithoutBlock => (
            "END_FUNCTION_BLOCK ends no definition".to_owned(),
            "a definition begins with FUNCTION_BLOCK [$Name]",
        ),
        NestedBlock => (
            "a block cannot be defined inside another".to_owned(),
            "close the definition above with END_FUNCTION_BLOCK first",
        ),
    };
    let diagnostic = Diagnostic::new(RULE, range, message).help(help);
    let applicability = if has_text {
        Applicability::Unsafe
    } else {
        Applicability::Safe
    };
    match problem {
        SemicolonMissing => diagnostic.fix(applicability, "Insert `;`", TextRange::empty(range.start()), ";"),
        _ => diagnostic,
    }
}
