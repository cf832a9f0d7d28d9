//! What is looked at after an edit does not grow with the file.

use ladder_analysis::{Analysis, Exported, Others, RuleSettings, Work, analyze_after, analyze_with, exports};
use ladder_syntax::{Parse, parse};
use ladder_tests::typed_programs::{KINDS, Kind, Program, Spot};
use std::sync::Arc;

/// Where in a program a letter comes and goes.
type Place = fn(&Program) -> Spot;

/// What is looked at when a letter comes, and when it goes again, and how many bytes of the text are read.
fn work(kind: Kind, rungs: usize, spot: Place) -> [(Work, usize); 2] {
    let program = Program::new(kind, rungs);
    let spot = spot(&program);
    let line: usize = program
        .text
        .split_inclusive('\n')
        .take(spot.line)
        .map(str::len)
        .sum();
    let mut typed = program.text.clone();
    typed.insert_str(line + spot.column, spot.letter);
    let parsed = Arc::new(parse(&program.text));
    let (others, settings) = (others_of(&program, &parsed), RuleSettings::default());
    let first = analyze_with(&parsed, "main", &others, &settings);
    let next = |before: &Analysis, parse: &Parse, old: &str, new: &str| {
        let parsed = Arc::new(parse.updated(old, new));
        let analysis = analyze_after(Some(before), &parsed, "main", &others, &settings);
        (parsed, analysis)
    };
    let (with, second) = next(&first, &parsed, &program.text, &typed);
    let (without, third) = next(&second, &with, &typed, &program.text);
    [
        (second.work, with.bytes_read()),
        (third.work, without.bytes_read()),
    ]
}

/// What the program sees of the file beside it.
fn others_of(program: &Program, parsed: &Arc<Parse>) -> Others {
    let Some(beside) = &program.beside else {
        return Others::default();
    };
    let beside = exports(&Arc::new(parse(beside)), "beside");
    let exported = Exported::new(vec![Arc::new(beside), Arc::new(exports(parsed, "main"))]);
    Arc::new(exported).others_of("main")
}

#[test]
fn does_not_grow_with_the_file() {
    let spots: [(&str, Place); 12] = [
        ("a number", Program::in_a_number),
        ("a name", Program::in_a_name),
        ("a name without a type", Program::in_a_name_without_type),
        ("a half-typed rung", Program::half_typed),
        ("a declaration", Program::in_a_declaration),
        ("a line of declarations", Program::with_a_declaration),
        ("a half-typed declaration", Program::with_a_half_typed_declaration),
        ("a name declared twice", Program::in_a_name_declared_twice),
        ("names declared twice", Program::with_names_declared_twice),
        ("a type", Program::in_a_type),
        ("the first network", Program::in_the_first_network),
        ("a label", Program::with_a_label),
    ];
    let of_globals: [(&str, Place); 2] = [
        ("a tag for all files", Program::in_a_global),
        ("a declaration for all files", Program::in_a_declaration_for_all),
    ];
    let of_bodies: [(&str, Place); 1] = [("a number in a body", Program::in_a_body)];
    let of_addresses: [(&str, Place); 2] = [
        ("an address", Program::in_an_address),
        ("a declaration at an address", Program::with_an_address),
    ];
    for (name, kind) in KINDS {
        let of_kind: &[(&str, Place)] = match kind {
            Kind::Globals => &of_globals,
            Kind::Bodies => &of_bodies,
            Kind::Addressed => &of_addresses,
            _ => &[],
        };
        for &(what, spot) in spots.iter().chain(of_kind) {
            // All networks that jump are looked at again where a label comes or goes.
            if kind == Kind::Flow && what == "a label" {
                continue;
            }
            let (small, large) = (work(kind, 200, spot), work(kind, 2_000, spot));
            // Comments are read by the part of the text, wherever that is cut.
            let looked_at = |all: [(Work, usize); 2]| all.map(|(work, _)| Work { comments: 0, ..work });
            assert_eq!(
                looked_at(small),
                looked_at(large),
                "{what} in a program of the kind {name}"
            );
            let most = |work: Work| work.networks.max(work.tags).max(work.findings);
            let most = small.iter().map(|(work, _)| most(*work)).max();
            assert!(
                most < Some(20),
                "{what} in a program of the kind {name}: {small:?}"
            );
            assert!(
                large.iter().all(|(work, _)| work.comments < 250),
                "{what} in a program of the kind {name}: {large:?}"
            );
            // Longer numbers in the names make longer lines.
            let read = |all: [(Work, usize); 2]| all.iter().map(|(_, bytes)| *bytes).max();
            assert!(
                read(large) < Some(2_000),
                "{what} in a program of the kind {name}: {large:?}"
            );
        }
    }
}
