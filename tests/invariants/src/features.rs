//! What an editor asks of a text, at a place and as a whole.

use ladder_analysis::Analysis;
use ladder_format::{Edit, Options, apply};
use ladder_ide::{
    Alone, Asked, Change, Given, Redraw, Side, TRIGGERS, callers_at, change, completions, declaration,
    definition, documentation, fix_all, folds, highlights, hover, implementation, incoming_calls, inlays,
    lenses, links, offer, on_type, outgoing_calls, outline, points_of, prepare_rename, quick_fixes, redraw,
    refactorings, references, rename, selections, semantic_tokens, signature_help, type_definition,
    workspace_symbols,
};
use ladder_picture::live::pieces;
use ladder_syntax::{TextRange, TextSize};

/// Asks at an offset; `end` is the end of the text.
pub type Ask = fn(&Analysis, TextSize, TextSize);

/// All features that are asked at a place.
pub const FEATURES: [(&str, Ask); 21] = [
    ("hover", |it, at, _| drop(hover(&it.context, at))),
    ("completion", |it, at, end| {
        for item in completions(&it.context, at, None).items {
            assert!(item.range.contains_inclusive(at) && item.range.end() <= end);
            drop(item.text.snippet());
        }
        drop(completions(&it.context, at, Some('.')));
    }),
    ("documentation", |it, at, _| {
        for item in completions(&it.context, at, None).items.iter().take(5) {
            drop(documentation(&it.context, &item.topic));
        }
    }),
    ("signature help", |it, at, _| {
        drop(signature_help(&it.context, at));
    }),
    ("definition", |it, at, _| {
        drop(definition(&it.context, at, &Alone));
    }),
    ("declaration", |it, at, _| {
        drop(declaration(&it.context, at, &Alone));
    }),
    ("type definition", |it, at, _| {
        drop(type_definition(&it.context, at, &Alone));
    }),
    ("implementation", |it, at, _| {
        drop(implementation(&it.context, at, &Alone));
    }),
    ("references", |it, at, _| {
        drop(references(&it.context, at, &Alone));
    }),
    ("highlights", |it, at, end| {
        for highlight in highlights(&it.context, at) {
            assert!(highlight.range.end() <= end);
        }
    }),
    ("selections", |it, at, end| {
        let ranges = selections(&it.context, at);
        assert!(!ranges.is_empty());
        assert!(ranges[0].contains_inclusive(at), "{ranges:?} around {at:?}");
        for pair in ranges.windows(2) {
            assert!(
                pair[1].contains_range(pair[0]) && pair[1] != pair[0],
                "{ranges:?}"
            );
        }
        assert_eq!(ranges.last(), Some(&TextRange::up_to(end)));
    }),
    ("calls", |it, at, _| {
        for caller in callers_at(&it.context, at, &Alone) {
            drop(incoming_calls(&it.context, &caller, &Alone));
            drop(outgoing_calls(&it.context, &caller, &Alone));
        }
    }),
    ("prepare rename", |it, at, _| {
        drop(prepare_rename(&it.context, at));
    }),
    ("rename", |it, at, end| {
        if let Ok(files) = rename(&it.context, at, "a_new_name", &Alone, &Options::default()) {
            for file in files {
                apart(&file.edits, end);
            }
        }
    }),
    ("while typing", |it, at, end| {
        for typed in TRIGGERS {
            let edits = on_type(&it.context, at, typed, &Options::default());
            apart(&edits, end);
            nothing_is_lost(it, &edits);
        }
    }),
    ("fixes", |it, at, _| drop(quick_fixes(it, TextRange::empty(at)))),
    ("refactorings", |it, at, end| {
        let here = refactorings(it, TextRange::empty(at));
        for action in here.iter().chain(&refactorings(it, TextRange::new(at, end))) {
            apart(&action.edits(it), end);
        }
    }),
    ("hints from there on", |it, at, end| {
        drop(inlays(&it.context, TextRange::new(at, end)));
    }),
    ("the diagram from there on", |it, at, end| {
        let text = it.context.parse.to_string();
        let mut after = TextSize::new(0);
        for piece in pieces(&it.context, TextRange::new(at, end), 60) {
            assert!(
                piece.range.start() >= after && piece.range.end() <= end,
                "{:?} after {after:?} in {text:?}",
                piece.range
            );
            after = piece.range.end();
            let place = |offset: TextSize| {
                assert!(piece.range.contains_inclusive(offset));
                String::new()
            };
            let points = piece.network().map(|network| points_of(&it.context, network));
            let points = points.and_then(Result::ok).unwrap_or_default();
            drop(piece.svg(&it.context, &points, &place));
        }
    }),
    ("what is drawn there", |it, at, end| {
        let what = TextRange::new(at, end.min(at + TextSize::new(24)));
        let given = Given {
            text: "[ ]( drawn )".to_owned(),
            ..Given::default()
        };
        let changes = [
            Change::Insert {
                at,
                given: given.clone(),
            },
            Change::Parallel {
                from: what.start(),
                to: what.end(),
                side: Side::Below,
                given: given.clone(),
            },
            Change::Delete { what: vec![what] },
            Change::Network {
                near: Some(at),
                is_above: true,
                given,
            },
        ];
        for wanted in changes {
            if let Ok(done) = change(&it.context, &wanted, &Options::default()) {
                apart(&done.edits, end);
                let new = apply(&it.context.parse.to_string(), &done.edits);
                let is_there = |range: &TextRange| new.get(std::ops::Range::<usize>::from(*range)).is_some();
                assert!(done.select.iter().all(is_there), "{wanted:?}");
            }
        }
        drop(offer(
            &it.context,
            &Asked::What(vec![what]),
            None,
            &Options::default(),
        ));
        for key in [Redraw::Branch, Redraw::Left, Redraw::Down, Redraw::Delete] {
            if let Ok(done) = redraw(&it.context, what, key, &Options::default()) {
                apart(&done.edits, end);
            }
        }
    }),
    ("tokens from there on", |it, at, end| {
        drop(semantic_tokens(&it.context, Some(TextRange::new(at, end))));
    }),
];

/// Those that are asked once for a text.
pub fn whole(analysis: &Analysis) {
    drop(folds(&analysis.context));
    drop(outline(&analysis.context));
    drop(links(&analysis.context));
    drop(lenses(&analysis.context));
    drop(semantic_tokens(&analysis.context, None));
    drop(fix_all(analysis));
    drop(workspace_symbols("a", &analysis.context, &Alone));
}

/// Checks that edits are sorted and disjoint, and end within the text.
pub(crate) fn apart(edits: &[Edit], end: TextSize) {
    for pair in edits.windows(2) {
        assert!(pair[0].range.end() <= pair[1].range.start(), "{pair:?}");
    }
    assert!(edits.iter().all(|edit| edit.range.end() <= end), "{edits:?}");
}

/// While a person types only blanks, wires and rails may come and go, and connectors may come: a branch is closed on the line
/// above. Where there is nothing but a branch, on the line that Enter begins or gives up, it may go.
fn nothing_is_lost(analysis: &Analysis, edits: &[Edit]) {
    let text = analysis.context.parse.to_string();
    let solid = |text: &str| -> String {
        text.chars()
            .filter(|c| !matches!(c, ' ' | '\t' | '-' | '|' | '+' | '\n' | '\r'))
            .flat_map(char::to_uppercase)
            .collect()
    };
    let is_connector = |c: char| matches!(c, '/' | '\\');
    for edit in edits {
        let (old, new) = (solid(&text[edit.range]), solid(&edit.text));
        // All that was there is there still, in its order, with connectors between.
        let mut left = old.chars().peekable();
        let only_connectors_come = new
            .chars()
            .all(|c| left.next_if_eq(&c).is_some() || is_connector(c));
        let nothing_goes = left.peek().is_none() || old.chars().all(is_connector);
        assert!(
            only_connectors_come && nothing_goes,
            "{edit:?} for {:?}",
            &text[edit.range]
        );
    }
}
