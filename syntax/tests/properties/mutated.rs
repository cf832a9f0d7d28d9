//! Programs with pieces inserted, deleted, replaced, doubled and moved.

use crate::invariants::check;
use crate::programs::PROGRAMS;
use proptest::prelude::*;
use proptest::sample::Index;

/// One change. Places are given as shares of the text, so that they fit whatever came before.
#[derive(Debug, Clone)]
pub(crate) enum Mutation {
    Insert(Index, String),
    Delete(Index, usize),
    Replace(Index, usize, String),
    Double(Index, usize),
    Move(Index, usize, Index),
}

pub(crate) fn mutation() -> impl Strategy<Value = Mutation> {
    let piece = || {
        prop_oneof![
            8 => prop::sample::select(vec![
                "(", ")", "[", "]", "<", ">", "-", "--", "+", "|", "\\", "/", "#", "'", ",", ";", ":", ":=", "=>", ".", "..",
                " ", "\n", "\r", "\r\n", "\t", "$", "%", "5", "a", "T#", "END_VAR", "VAR\n", "TYPE\n", "END_TYPE", "STRUCT\n", "END_STRUCT;", "FUNCTION_BLOCK [$X]\n", "NOT ",
                "[ ]( x )", "( )( y )", "# c #", "é", "\u{feff}", "*", "^",
                "\n<<<<<<< a\n", "\n=======\n", "\n>>>>>>> b\n", "\n# ======= #\n",
            ]).prop_map(str::to_owned),
            1 => any::<String>(),
        ]
    };
    let place = any::<Index>;
    prop_oneof![
        (place(), piece()).prop_map(|(at, piece)| Mutation::Insert(at, piece)),
        (place(), 1..12usize).prop_map(|(at, len)| Mutation::Delete(at, len)),
        (place(), 1..12usize, piece()).prop_map(|(at, len, piece)| Mutation::Replace(at, len, piece)),
        (place(), 1..40usize).prop_map(|(at, len)| Mutation::Double(at, len)),
        (place(), 1..40usize, place()).prop_map(|(at, len, to)| Mutation::Move(at, len, to)),
    ]
}

/// The byte range of `len` characters from `at` on.
fn range(text: &str, at: Index, len: usize) -> std::ops::Range<usize> {
    let mut start = at.index(text.len() + 1);
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    let end = text[start..]
        .char_indices()
        .nth(len)
        .map_or(text.len(), |(n, _)| start + n);
    start..end
}

/// Carries a change out.
pub(crate) fn mutate(text: &mut String, mutation: &Mutation) {
    match mutation {
        Mutation::Insert(at, piece) => text.insert_str(range(text, *at, 0).start, piece),
        Mutation::Delete(at, len) => text.replace_range(range(text, *at, *len), ""),
        Mutation::Replace(at, len, piece) => text.replace_range(range(text, *at, *len), piece),
        Mutation::Double(at, len) => {
            let range = range(text, *at, *len);
            let piece = text[range.clone()].to_owned();
            text.insert_str(range.end, &piece);
        }
        Mutation::Move(at, len, to) => {
            let from = range(text, *at, *len);
            let piece = text[from.clone()].to_owned();
            text.replace_range(from, "");
            text.insert_str(range(text, *to, 0).start, &piece);
        }
    }
}

#[test]
fn programs_are_fine() {
    for program in PROGRAMS {
        assert_eq!(check(program).errors().first(), None, "{program}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn mutated(program in 0..PROGRAMS.len(), mutations in prop::collection::vec(mutation(), 1..5)) {
        let mut text = PROGRAMS[program].to_owned();
        for step in &mutations {
            mutate(&mut text, step);
            check(&text);
        }
    }
}
