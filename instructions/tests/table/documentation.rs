//! What people read of the table: every row must have it, in the form that hover and the reference rely on.

use std::collections::HashSet;

use ladder_instructions::{Accepts, Instruction, Shape, TABLE};

fn rungs(row: &Instruction) -> impl Iterator<Item = &'static str> {
    row.example.lines().filter(|line| line.starts_with(['+', '|']))
}

/// The text of the first fenced block, if there is one.
fn diagram(row: &Instruction) -> Option<&'static str> {
    let (_, rest) = row.doc.split_once("```text\n")?;
    Some(rest.split_once("```").expect("the fence is closed").0)
}

#[test]
fn every_row_is_documented() {
    for row in TABLE {
        let name = row.signature();
        assert!(
            !row.title.is_empty() && !row.title.ends_with('.'),
            "title of {name}"
        );
        assert!(!row.eno.is_empty() && !row.eno.ends_with('.'), "ENO of {name}");
        assert!(!row.doc.is_empty(), "documentation of {name}");
        assert!(!row.example.is_empty(), "example of {name}");
        for operand in row.operands {
            assert!(!operand.name.is_empty(), "a name in {name}");
            assert!(
                operand.doc.ends_with('.') && !operand.doc.contains('\n'),
                "{} of {name}",
                operand.name
            );
        }
    }
}

#[test]
fn titles_and_summaries_differ() {
    let mut seen = HashSet::new();
    for row in TABLE {
        assert!(seen.insert(row.title), "two rows are titled {:?}", row.title);
        assert!(seen.insert(row.summary()), "two rows begin {:?}", row.summary());
    }
}

#[test]
fn a_summary_is_one_line_and_one_sentence() {
    for row in TABLE {
        let summary = row.summary();
        assert!(summary.ends_with('.'), "{summary}");
        assert!(!summary.contains('\n'), "{summary}");
        assert!(!summary.trim_end_matches('.').contains(". "), "{summary}");
    }
}

#[test]
fn texts_are_tidy() {
    for row in TABLE {
        for line in row.doc.lines().chain(row.example.lines()) {
            assert_eq!(line, line.trim_end(), "{}", row.signature());
            assert!(line.chars().count() <= 110, "{line}");
        }
        for text in [row.doc, row.example] {
            assert!(
                !text.contains("\n\n\n") && !text.starts_with('\n') && !text.ends_with('\n'),
                "{text}"
            );
        }
    }
}

#[test]
fn every_example_shows_its_block() {
    for row in TABLE {
        let block = if row.operands.is_empty() || row.takes(0) {
            row.block()
        } else {
            format!("{}( ", row.block())
        };
        assert!(
            rungs(row).any(|rung| rung.contains(&block)),
            "{block} in\n{}",
            row.example
        );
        for spelling in row.synonyms.iter().chain(row.aliases) {
            let (open, close) = row.shape.brackets();
            assert!(
                !row.example.contains(&format!("{open}{spelling}{close}")),
                "canonical spellings only"
            );
        }
    }
}

/// The formatter's own tests say more; this keeps an error near its row.
#[test]
fn the_rungs_of_an_example_end_at_one_rail() {
    for row in TABLE {
        let widths: HashSet<_> = rungs(row).map(|rung| rung.chars().count()).collect();
        assert_eq!(widths.len(), 1, "{}", row.example);
        assert!(
            widths.iter().all(|width| width % 20 == 0 && *width >= 40),
            "{}",
            row.example
        );
    }
}

#[test]
fn every_timer_has_a_timing_diagram() {
    for row in TABLE {
        let is_timer = row
            .operands
            .iter()
            .any(|operand| matches!(operand.accepts, Accepts::State(kind) if kind.is_timer()));
        let Some(diagram) = diagram(row) else {
            assert!(!is_timer, "{}", row.signature());
            continue;
        };
        let widths: HashSet<_> = diagram.lines().skip(1).map(str::len).collect();
        assert_eq!(widths.len(), 1, "rows of one length in\n{diagram}");
    }
}

#[test]
fn blocks_named_in_a_text_exist() {
    for row in TABLE {
        let mut rest = row.doc;
        while let Some((_, after)) = rest.split_once('`') {
            let Some((code, after)) = after.split_once('`') else {
                break;
            };
            rest = after;
            // The comparison operators of `[CALC]` look like a function block.
            if code.starts_with("< ") {
                continue;
            }
            for shape in [Shape::Logical, Shape::Coil, Shape::Function] {
                let (open, close) = shape.brackets();
                let Some((mnemonic, _)) = code.strip_prefix(open).and_then(|inner| inner.split_once(close))
                else {
                    continue;
                };
                let known = mnemonic.starts_with('$')
                    || ladder_instructions::lookup(shape, mnemonic).next().is_some();
                assert!(known, "{code} in the text of {}", row.signature());
            }
        }
    }
}
