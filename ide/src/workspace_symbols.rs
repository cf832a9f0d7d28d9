//! Names in all files of a workspace, found by a few of their letters.

use crate::neighbour::{Which, Workspace, in_each};
use crate::outline::{OutlineKind, Outlined, of_context};
use ladder_analysis::context::Context;
use ladder_syntax::{Name, TextRange};
use std::sync::Arc;

/// A name that was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Named {
    /// The file.
    pub file: Arc<str>,
    /// As written.
    pub name: String,
    /// What it is.
    pub kind: OutlineKind,
    /// Where it is.
    pub range: TextRange,
    /// The function, block definition or type that it belongs to.
    pub container: Option<String>,
}

/// This many are listed: more are no help.
const MOST: usize = 500;

/// The names that have the letters of `query` in their order, the likeliest first; all names for an empty query. They
/// are those of `own` and of the files next to it.
pub fn workspace_symbols(query: &str, own: &Context, workspace: &dyn Workspace) -> Vec<Named> {
    let wanted: Vec<char> = Name::new(query)
        .as_str()
        .chars()
        .filter(|c| !c.is_whitespace())
        .collect();
    let in_file = |file: &Context| {
        let mut found = Vec::new();
        add(&file.name, &of_context(file), None, &wanted, &mut found);
        found
    };
    let mut found = in_file(own);
    found.extend(in_each(workspace, Which::All, in_file).into_iter().flatten());
    found.sort_by(|(a, named_a), (b, named_b)| {
        b.cmp(a)
            .then_with(|| named_a.name.chars().count().cmp(&named_b.name.chars().count()))
            .then_with(|| named_a.file.cmp(&named_b.file))
            .then_with(|| named_a.range.start().cmp(&named_b.range.start()))
    });
    found.truncate(MOST);
    found.into_iter().map(|(_, named)| named).collect()
}

fn add(
    file: &Arc<str>,
    items: &[Outlined],
    container: Option<&str>,
    wanted: &[char],
    found: &mut Vec<(u32, Named)>,
) {
    for item in items {
        let of = match item.kind {
            OutlineKind::Function | OutlineKind::Block | OutlineKind::Type | OutlineKind::Enumeration => {
                Some(item.name.as_str())
            }
            _ => container,
        };
        add(file, &item.children, of, wanted, found);
        let untitled = item.kind == OutlineKind::Network
            && item
                .name
                .strip_prefix("Network ")
                .is_some_and(|number| number.parse::<usize>().is_ok());
        if item.kind == OutlineKind::Section || untitled {
            continue;
        }
        if let Some(score) = likeness(&item.name, wanted) {
            let named = Named {
                file: Arc::clone(file),
                name: item.name.to_string(),
                kind: item.kind,
                range: item.focus,
                container: container.map(str::to_owned),
            };
            found.push((score, named));
        }
    }
}

/// How well a name fits letters that it has in their order: letters in a row, at the start of a word, and at the start
/// of the name count most. None if it lacks one.
fn likeness(name: &str, wanted: &[char]) -> Option<u32> {
    let mut score = 0;
    let mut rest = wanted.iter().peekable();
    let mut row = 0;
    let mut before: Option<char> = None;
    for (index, c) in name.chars().enumerate() {
        let folded = Name::new(c.encode_utf8(&mut [0; 4])).as_str().chars().next();
        if rest.peek().is_some_and(|wanted| folded == Some(**wanted)) {
            rest.next();
            row += 1;
            let begins =
                before.is_none_or(|b| !b.is_alphanumeric() || (b.is_lowercase() && c.is_uppercase()));
            score += row + if begins { 4 } else { 0 } + if index == 0 { 8 } else { 0 };
        } else {
            row = 0;
        }
        before = Some(c);
    }
    rest.peek().is_none().then_some(score)
}

#[cfg(test)]
mod tests {
    use super::workspace_symbols;
    use crate::fixture::Fixture;
    use expect_test::{Expect, expect};

    const PLANT: &str = "%% main.clad\nVAR start, motor_start : BOOL; END_VAR\n# Start of the mill #\n+--<LBL>( restart )--+\n\
        %% sub/lib.clad\n+--<FUN>( StartUp )--( )( y )--+\n# ramp #\n+--( )( z )--+\n\
        FUNCTION_BLOCK [$Ramp]\nVAR_INPUT raw : BOOL; END_VAR\nEND_FUNCTION_BLOCK\nVAR ärger : INT; END_VAR\n";

    fn check(query: &str, expected: Expect) {
        let fixture = Fixture::new(PLANT);
        let shown = workspace_symbols(query, &fixture.files[0].0.context, &fixture.others(0))
            .into_iter()
            .map(|it| {
                let place = fixture.show(&it.file, it.range);
                format!(
                    "{} {:?} {place} {}\n",
                    it.name,
                    it.kind,
                    it.container.unwrap_or_default()
                )
            });
        expected.assert_eq(&shown.collect::<Vec<_>>().concat());
    }

    #[test]
    fn letters_in_their_order() {
        check(
            "start",
            expect![[r#"
            start Tag main.clad:1:5 start 
            StartUp Function sub/lib.clad:1:11 StartUp 
            Start of the mill Network main.clad:3:1 +--<LBL>( restart )--+ 
            motor_start Tag main.clad:1:12 motor_start 
            restart Label main.clad:3:11 restart 
        "#]],
        );
        check(
            "su",
            expect![[r#"
            StartUp Function sub/lib.clad:1:11 StartUp 
        "#]],
        );
        check(
            "$R",
            expect![[r#"
            [$Ramp] Block sub/lib.clad:4:16 [$Ramp] 
        "#]],
        );
        check(
            "Ä",
            expect![[r#"
            ärger Tag sub/lib.clad:7:5 ärger 
        "#]],
        );
        check("xyz", expect![[""]]);
        check(
            "",
            expect![[r#"
            raw Parameter sub/lib.clad:5:11 raw [$Ramp]
            ramp Network sub/lib.clad:3:1 +--( )( z )--+ StartUp
            start Tag main.clad:1:5 start 
            ärger Tag sub/lib.clad:7:5 ärger 
            restart Label main.clad:3:11 restart 
            StartUp Function sub/lib.clad:1:11 StartUp 
            [$Ramp] Block sub/lib.clad:4:16 [$Ramp] 
            motor_start Tag main.clad:1:12 motor_start 
            Start of the mill Network main.clad:3:1 +--<LBL>( restart )--+ 
        "#]],
        );
    }
}
