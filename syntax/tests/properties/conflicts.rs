//! A text with a conflict in it is read as with ours alone, wherever the conflict is.

use crate::invariants::check;
use crate::programs::PROGRAMS;
use ladder_syntax::{NodeOrToken, Parse, Sign, SyntaxKind};
use proptest::prelude::*;
use proptest::sample::Index;

/// The lines of signs of a form: ours, base, theirs, end.
const FORMS: [[&str; 4]; 3] = [
    [
        "<<<<<<< HEAD",
        "||||||| 1a2b3c4",
        "=======",
        ">>>>>>> their branch",
    ],
    ["<<<<<<<", "|||||||", "=======", ">>>>>>>"],
    [
        "# <<<<<<< ours #",
        "# ||||||| base #",
        "  # ======= #",
        "# >>>>>>> theirs: removed #",
    ],
];

/// The tokens but for those of conflicts; a comment that spans lines may hold one.
fn tokens(parse: &Parse) -> Vec<(SyntaxKind, String)> {
    let tokens = parse.syntax().descendants_with_tokens();
    let tokens = tokens.filter_map(NodeOrToken::into_token);
    let read = tokens.filter(|token| token.kind() != SyntaxKind::CONFLICT);
    read.map(|token| {
        let text = match token.kind() {
            SyntaxKind::COMMENT => String::new(),
            _ => token.text().to_owned(),
        };
        (token.kind(), text)
    })
    .collect()
}

/// Whether a comment is open where a line begins.
fn in_comment(above: &str) -> bool {
    // In these programs every `#` of a literal is in the middle of a word.
    let comment = |(at, _): &(usize, &str)| !above[..*at].ends_with(|c: char| c.is_alphanumeric());
    above.match_indices('#').filter(comment).count() % 2 == 1
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn ours_is_read(
        program in 0..PROGRAMS.len(),
        form in 0..FORMS.len(),
        (from, to) in any::<(Index, Index)>(),
        theirs in prop::sample::select(vec![
            "", "+--[ ]( z )--( )( y )--+\n", "# open\n", "# closed #\n", "VAR\n", "END_VAR\n", "END_FUNCTION_BLOCK\n",
            "  /--(\n", "'\n", "<<<<<<< inner\n+\n=======\n-\n>>>>>>> inner\n",
        ]),
        base in any::<bool>(),
        finished in any::<bool>(),
    ) {
        let program = PROGRAMS[program].replace("'it$'s # not a comment'", "'it$'s'");
        let starts: Vec<usize> = std::iter::once(0).chain(program.match_indices('\n').map(|(n, _)| n + 1)).collect();
        let (a, b) = (starts[from.index(starts.len())], starts[to.index(starts.len())]);
        let (from, to) = (a.min(b), a.max(b));
        // The last line has no line end, so that nothing can be put after it.
        prop_assume!(to < program.len());
        let signs = FORMS[form];
        let is_comment = signs[0].starts_with('#');
        prop_assume!(!is_comment || !in_comment(&program[..from]) && !in_comment(&program[..to]));
        let [ours, base_sign, theirs_sign, end] = signs;
        let hidden = match (base, finished) {
            (true, true) => format!("{base_sign}\n+-\n{theirs_sign}\n{theirs}{end}\n"),
            (false, true) => format!("{theirs_sign}\n{theirs}{end}\n"),
            (_, false) => String::new(),
        };
        let text = format!("{}{ours}\n{}{hidden}{}", &program[..from], &program[from..to], &program[to..]);
        let (alone, both) = (check(&program), check(&text));
        prop_assert_eq!(tokens(&alone), tokens(&both), "{}", text);
        prop_assert_eq!(both.errors().len(), 0, "{}", text);
        let conflicts = both.conflicts();
        prop_assert_eq!(conflicts.len(), 1, "{}", text);
        prop_assert_eq!(conflicts[0].line(Sign::End).is_some(), finished, "{}", text);
    }
}
