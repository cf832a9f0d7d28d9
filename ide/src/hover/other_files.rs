//! What other files of the workspace do with the thing under the pointer.

use crate::markdown::code;
use crate::neighbour::Workspace;
use crate::symbol::{Found, Usage, find, in_files_of, occurrences};
use ladder_analysis::context::Context;
use ladder_syntax::TextSize;
use std::collections::BTreeMap;
use std::sync::Arc;

/// This many files are named.
const MOST: usize = 6;

/// How often each other file writes, reads or names what is at an offset. None where none does.
pub fn used_in_other_files(context: &Context, offset: TextSize, workspace: &dyn Workspace) -> Option<String> {
    if !context.others.have_files() {
        return None;
    }
    let mut files: BTreeMap<Arc<str>, [usize; 3]> = BTreeMap::new();
    let Found { symbol, .. } = find(context, offset)?;
    // This file is left out: a search of all that it declares takes time.
    let places = |file: &Context| (Arc::clone(&file.name), occurrences(file, &symbol));
    for (file, places) in in_files_of(context, std::slice::from_ref(&symbol), workspace, places) {
        let used = places.iter().filter(|place| !place.usage.declares());
        for place in used.filter(|_| file != context.name) {
            let count = files.entry(Arc::clone(&file)).or_default();
            match place.usage {
                Usage::Write => count[0] += 1,
                Usage::Read => count[1] += 1,
                Usage::ReadWrite => {
                    count[0] += 1;
                    count[1] += 1;
                }
                Usage::Mention | Usage::Definition | Usage::Declaration => count[2] += 1,
            }
        }
    }
    let more = files.len().saturating_sub(MOST);
    let mut lines: Vec<String> = files
        .into_iter()
        .take(MOST)
        .map(|(file, counts)| {
            let told = counts.into_iter().zip(["written", "read", "used"]);
            let told: Vec<String> = told
                .filter(|(count, _)| *count > 0)
                .map(|(count, verb)| match count {
                    1 => format!("{verb} once"),
                    count => format!("{verb} {count} times"),
                })
                .collect();
            format!("In {}: {}", code(&file), told.join(", "))
        })
        .collect();
    if more > 0 {
        lines.push(format!("and in {more} more files"));
    }
    (!lines.is_empty()).then(|| lines.join("  \n"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::Fixture;
    use expect_test::{Expect, expect};

    fn check(text: &str, expected: Expect) {
        let fixture = Fixture::new(text);
        let (context, offset, others) = fixture.ask();
        let shown = used_in_other_files(context, offset, &others);
        expected.assert_eq(&format!("{}\n", shown.unwrap_or_else(|| "nothing".to_owned())));
    }

    const PLANT: &str = "%% library.clad\nVAR_GLOBAL total : DINT; END_VAR\n+--<FUN>( count )--[ADD]( total, total, 1 )--[GT]( total, 3 )--( )( own )--+\n\
                         %% reset.clad\n+--[ ]( a )--[MOV]( total, 0 )--<CALL>( count )--+\n%% aside.clad\n+--[ ]( a )--( )( own )--+\n";

    #[test]
    fn other_files_are_told_apart() {
        check(
            &format!("%% main.clad\n+--[GT]( to$0tal, 3 )--( )( own )--+\n{PLANT}"),
            expect![[r#"
                In `library.clad`: written once, read 2 times  
                In `reset.clad`: written once
            "#]],
        );
        check(
            &format!("%% main.clad\n+--[GT]( total, 3 )--( )( ow$0n )--+\n{PLANT}"),
            expect![[r#"
                nothing
            "#]],
        );
        check(
            &format!("%% main.clad\n+--<CALL>( co$0unt )--+\n{PLANT}"),
            expect![[r#"
                In `reset.clad`: used once
            "#]],
        );
        check(
            "+--[GT]( to$0tal, 3 )--( )( own )--+\n",
            expect![[r#"
            nothing
        "#]],
        );
    }
}
