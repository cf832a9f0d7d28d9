//! Programs with functions, and with blocks and types of other files, in notations that have blocks of one's own alone: what comes
//! back is one file, and does the same.

use super::says::{Says, networks};
use super::tables::{PLCOPEN, SIMATIC};
use ladder_analysis::{Analysis, AnalyzeOptions, Exported, analyze, exports, link_files};
use ladder_format::Options;
use ladder_invariants::generator::Dice;
use ladder_invariants::trace::{Stimulus, compile, next_to, programs_next_to};
use ladder_notations::{Source, by_name, convert, write_checked};
use ladder_syntax::{Item, parse};
use std::sync::Arc;

/// The first of several files, with what it uses of the others.
fn linked(files: &[(&str, &str)]) -> Analysis {
    let parsed = files.iter().map(|(name, text)| (*name, Arc::new(parse(text))));
    let parsed: Vec<_> = parsed.collect();
    let summaries = parsed.iter().map(|(name, parse)| Arc::new(exports(parse, name)));
    let exported = Arc::new(Exported::new(summaries.collect()));
    let analysis = |wanted: &str| {
        let (name, parse) = parsed.iter().find(|(name, _)| *name == wanted)?;
        Some(Arc::new(analyze(
            parse,
            AnalyzeOptions::new(name).among(&exported.others_of(name)),
        )))
    };
    let own = analysis(files[0].0).expect("the first file is one of them");
    let linked = link_files(&own, &analysis).unwrap_or_else(|why| panic!("{why:?} {:#?}", own.diagnostics()));
    own.with_others(linked)
}

/// Writes a program of several files, reads it again, and compares what it does with one file that has all texts. Comes back the
/// text that was read, and what there was to say.
#[track_caller]
fn check(notation: &str, files: &[(&str, &str)]) -> (String, String) {
    let notation = by_name(notation).expect("the notation is registered");
    let writing = write_checked(notation, &linked(files), "plant").unwrap_or_else(|error| panic!("{error}"));
    let shown = String::from_utf8_lossy(&writing.bytes).into_owned();
    let told = writing.report.remarks();
    let told = told.map(|entry| format!("{} {}: {:?}\n", entry.place, entry.element, entry.outcome));
    let told: String = told.collect();
    let source = Source {
        companions: writing.companions,
        ..Source::alone("plant", &writing.bytes)
    };
    let back =
        convert(notation, &source, &Options::default()).unwrap_or_else(|error| panic!("{error}\n{shown}"));
    let ladder = back.written.text;
    let program = Arc::clone(linked(files).program().expect("the program is whole"));
    let read = compile(&ladder).unwrap_or_else(|| panic!("this is no program:\n{ladder}"));
    // A tag of another file has the name of that before it, and another name in one text.
    let named = |name: &str| match name.split_once('.') {
        Some(("rinse", "count")) => Some("count_2".to_owned()),
        Some(("rinse" | "help", name)) => Some(name.to_owned()),
        _ => Some(name.to_owned()),
    };
    for seed in 0..20 {
        let programs = (Arc::clone(&program), Arc::clone(&read));
        let different = programs_next_to(programs, &named, Stimulus { seed, scans: 60 });
        assert_eq!(different, None, "{ladder}\nof\n{shown}\n{told}");
    }
    (ladder, told)
}

const PLANT: &[(&str, &str)] = &[
    (
        "plant.clad",
        "VAR_INPUT\n    go, stop : BOOL;\nEND_VAR\nVAR_OUTPUT\n    run, warn : BOOL;\nEND_VAR\nVAR\n    m1 : Drive;\nEND_VAR\n\n\
         +--[ ]( go )--[$Motor]( stop, run )--( )( warn )--+\n\
         +--[ ]( go )--[ADD]( m1.speed, m1.speed, 1 )--+\n\
         +--[GT]( m1.speed, 5 )--[$Motor]( stop, run )--+\n",
    ),
    (
        "blocks.clad",
        "# Runs a motor #\nFUNCTION_BLOCK [$Motor]\nVAR_INPUT\n    stop : BOOL;\nEND_VAR\nVAR_OUTPUT\n    run : BOOL;\nEND_VAR\nVAR\n    d : Drive;\nEND_VAR\n\
         +--[ ]( EN )--[/]( stop )--[$Late]( T#20ms )--( )( run )--+\n+--[ ]( run )--[ADD]( d.speed, d.speed, 1 )--+\nEND_FUNCTION_BLOCK\n\n\
         FUNCTION_BLOCK [$Late]\nVAR_INPUT\n    wait : TIME;\nEND_VAR\nVAR\n    t : TON;\nEND_VAR\n+--[ ]( EN )--[TON]( t, wait )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
    ),
    (
        "types.clad",
        "TYPE\n    Drive : STRUCT\n        speed : DINT;  # rpm #\n        ready : BOOL;\n    END_STRUCT;\nEND_TYPE\n",
    ),
];

#[test]
fn blocks_and_types_of_other_files_are_written_along() {
    for (notation, expected) in [
        ("plcopen", ""),
        ("simatic", ""),
        ("twincat", ""),
        (
            "l5x",
            "11:15 [$Late]: Approximated(\"there a time is a DINT in milliseconds\")\n",
        ),
    ] {
        let (_, told) = check(notation, PLANT);
        assert_eq!(told, expected, "{notation}");
    }
}

/// What the page of each block of the library shows does the same there.
#[test]
fn blocks_of_the_library_do_the_same() {
    for notation in ["plcopen", "simatic", "twincat"] {
        let mut account = String::new();
        for source in ladder_analysis::library::SOURCES {
            let own = linked(&[("plant.clad", source.example)]);
            let written = by_name(notation).expect("the notation is registered");
            let writing = write_checked(written, &own, "plant").unwrap_or_else(|error| panic!("{error}"));
            let refused = writing.report.tally().refused;
            if refused > 0 {
                account.push_str(&format!("{}: {refused} refused\n", source.name));
                continue;
            }
            let source_of = Source {
                companions: writing.companions,
                ..Source::alone("plant", &writing.bytes)
            };
            let back = convert(written, &source_of, &Options::default());
            let ladder = back.unwrap_or_else(|error| panic!("{error}")).written.text;
            let read = compile(&ladder).unwrap_or_else(|| panic!("this is no program:\n{ladder}"));
            let program = Arc::clone(own.program().expect("the program is whole"));
            // Instances have other insides there.
            let is_tag = |name: &str| {
                read.tags
                    .iter()
                    .any(|tag| tag.name == name && tag.block.is_none())
            };
            let named = |name: &str| (is_tag(name) && !name.contains('.')).then(|| name.to_owned());
            for seed in 0..3 {
                let programs = (Arc::clone(&program), Arc::clone(&read));
                let different = programs_next_to(programs, &named, Stimulus { seed, scans: 300 });
                assert_eq!(different, None, "{notation}: {}\n{ladder}", source.name);
            }
        }
        assert_eq!(account, "", "{notation}");
    }
}

/// The functions of other files have tags of their own, which may be called as those of the program are.
const SHARED: &[(&str, &str)] = &[
    (
        "plant.clad",
        "VAR_INPUT\n    go : BOOL;\nEND_VAR\nVAR_OUTPUT\n    run, lamp : BOOL;\nEND_VAR\nVAR\n    count : INT;\nEND_VAR\n\n\
         +--[ ]( go )--<CALL>( Rinse )--( )( run )--+\n\
         +--[P]( go )--[ADD]( count, count, 1 )--+\n\
         +--[GT]( count, 2 )--<CALL>( Own )--+\n\
         +--[GT]( total, 4 )--( )( lamp )--+\n\n\
         +--<FUN>( Own )--<CALL>( Help )--+\n\n\
         +--<FUN>( Step )--+\n",
    ),
    (
        "rinse.clad",
        "VAR\n    count : DINT := 3;  # turns #\n    m : $Motor;\n    d : Drive;\nEND_VAR\nVAR_GLOBAL\n    total : DINT;\nEND_VAR\n\n\
         # Rinses #\n+--<FUN>( Rinse )--[P]( pressed )--[ADD]( count, count, 1 )--+\n\
         +--[$Motor]( m, pressed )--+\n+--[ ]( pressed )--<CALL>( Help )--<CALL>( Step )--+\n\n\
         +--<FUN>( Step )--[GT]( count, 5 )--[ADD]( d.speed, d.speed, count )--+\n",
    ),
    (
        "help.clad",
        "FUNCTION_BLOCK [$Motor]\nVAR_INPUT\n    moves : BOOL;\nEND_VAR\nVAR\n    n : DINT;\nEND_VAR\n+--[ ]( moves )--[ADD]( n, n, 1 )--+\nEND_FUNCTION_BLOCK\n\n\
         TYPE\n    Drive : STRUCT\n        speed : DINT;\n    END_STRUCT;\nEND_TYPE\n\n\
         +--<FUN>( Help )--[ADD]( total, total, 1 )--+\n",
    ),
];

#[test]
fn functions_of_other_files_are_written_along() {
    for notation in ["plcopen", "simatic", "l5x", "twincat"] {
        let (ladder, told) = check(notation, SHARED);
        expect_test::expect_file![format!("{notation}_shared.txt")].assert_eq(&format!("{told}{ladder}"));
    }
}

/// A block of another file counts scans, which only ladder text has.
const COUNTS: &[(&str, &str)] = &[
    (
        "plant.clad",
        "VAR_INPUT\n    go : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\nVAR\n    w : $Wait;\nEND_VAR\n\n\
         +--[$Wait]( w )--( )( y )--+\n",
    ),
    (
        "wait.clad",
        "FUNCTION_BLOCK [$Wait]\nVAR_OUTPUT\n    n : DINT;\nEND_VAR\n+--[TYP]( n, SYS.SCAN )--+\nEND_FUNCTION_BLOCK\n",
    ),
];

#[test]
fn what_a_pass_remarks_on_a_block_of_another_file_is_told_at_its_call() {
    for notation in ["simatic", "simaticml"] {
        let notation = by_name(notation).expect("the notation is registered");
        let writing = write_checked(notation, &linked(COUNTS), "plant").expect("it is written");
        let remarks = writing.report.remarks();
        let remarks: Vec<String> = remarks
            .map(|entry| format!("{} {}: {:?}", entry.place, entry.element, entry.outcome))
            .collect();
        let why = "the block counts scans and time only while it runs";
        assert_eq!(remarks, [format!("11:4 [$Wait]: Approximated({why:?})")]);
    }
}

const FUNCTIONS: &str = "VAR_INPUT
    go, wash : BOOL;
    n        : INT;
END_VAR
VAR_OUTPUT
    pump, lamp : BOOL;
END_VAR
VAR
    t     : TON;
    count : DINT;
    last  : ARRAY[1..3] OF INT;
END_VAR

+--[ ]( go )--<CALL>( Rinse )--( )( called )--+
+--[ ]( wash )--<CALL>( Rinse )--+
+--[/]( go )--<CALL>( Count )--+
+--[GT]( count, 5 )--( )( Many )--+

# Rinses #
+--<FUN>( Rinse )--+
+--[ ]( wash )--[TON]( t, T#20ms )--( )( pump )--+
# Not twice #
+--[P]( go )--<CALL>( Count )--+
+--[GT]( n, 100 )--<RET>--+
+--[ ]( pump )--[$Toggle]( )--( )( lamp )--+
+--[MOV]( last[2], n )--+

+--<FUN>( Count )--[P]( wash )--[ADD]( count, count, 1 )--+
+--[ ]( t.Q )--[ADD]( count, count, last[2] )--+
";

#[test]
fn functions_are_blocks_and_functions_again() {
    for notation in ["plcopen", "simatic", "twincat"] {
        let (ladder, told) = check(notation, &[("plant.clad", FUNCTIONS)]);
        expect_test::expect_file![format!("{notation}_functions.txt")].assert_eq(&format!("{told}{ladder}"));
    }
}

/// The text with a loop around its last networks, or around those of its last function.
fn with_loop(text: &str, dice: &mut Dice) -> String {
    let parsed = parse(text);
    let networks = &parsed.structure().networks;
    let is_function = |number: &usize| {
        let lines = networks[*number].lines.clone();
        lines
            .into_iter()
            .any(|line| parsed.lines()[line].text().contains("<FUN>"))
    };
    let after = (0..networks.len())
        .rev()
        .find(is_function)
        .map_or(0, |function| function + 1);
    let first = networks.get(after).map(|network| network.lines.start);
    let head = ["<FOR>( 3 )", "<FOR>( 2, I => m )", "<FOR>( n )"][dice.below(3)];
    let before = ["", "[ ]( start )--", "[/]( level )--[ADD]( n, 1, 2 )--"][dice.below(3)];
    let mut out = String::new();
    for line in 0..parsed.lines().len() {
        if Some(line) == first {
            out.push_str(&format!("+--{before}{head}--+\n\n"));
        }
        out.push_str(parsed.lines()[line].text());
    }
    if first.is_none() {
        out.push_str(&format!("\n+--{before}{head}--+\n"));
    }
    out.push_str("\n+--<NEXT>--+\n");
    out
}

#[test]
fn functions_in_formulas_are_instructions_there() {
    const FORMULAS: &str = "VAR_INPUT\n    start, level : BOOL;\n    a, b, c : DINT;\nEND_VAR\nVAR\n    n, m, k : DINT;\nEND_VAR\n\n\
         +--[ ]( start )--[CALC]( n, LIMIT(0, a * 2 + MIN(b, c, 7), 50) )--( )( lamp )--+\n\n\
         +--[CALC]( m, MAX(a, n) - SEL(level, b, -c) )--+\n\n\
         +--[CALC]( k, 100 / (MAX(a, 3) + 2) )--( )( divides )--+\n";
    for notation in ["l5x", "simatic"] {
        let notation = by_name(notation).expect("the notation is registered");
        let analysis = ladder_analysis::analyze(&Arc::new(parse(FORMULAS)), "test.clad");
        let writing = notation.write(&analysis).expect("it has no errors");
        let refused: Vec<_> = writing.report.remarks().collect();
        assert_eq!(writing.report.tally().refused, 0, "{refused:?}");
        let source = Source {
            companions: writing.companions,
            ..Source::alone("test", &writing.bytes)
        };
        let back = convert(notation, &source, &Options::default()).expect("what is written is read");
        let ladder = back.written.text;
        for seed in 0..20 {
            let different = next_to(FORMULAS, &ladder, Stimulus { seed, scans: 60 });
            assert_eq!(different, None, "seed {seed}\n{ladder}");
        }
    }
}

#[test]
fn loops_come_back_from_logix_and_go_there_again() {
    const LOOP: &str = "VAR_INPUT\n    go : BOOL;\nEND_VAR\nVAR\n    n, k : DINT;\n    a : ARRAY[0..9] OF DINT;\nEND_VAR\n\n\
         # Sums them #\n+--<FOR>( 9, I => k )--+\n\n+--[ ]( go )--[ADD]( n, n, a[k] )--+\n\n+--<NEXT>--+\n\n+--[GT]( n, 5 )--[MOV]( n, 0 )--+\n";
    let notation = by_name("l5x").expect("the notation is registered");
    let mut text = LOOP.to_owned();
    for _ in 0..2 {
        let analysis = ladder_analysis::analyze(&Arc::new(parse(&text)), "test.clad");
        let writing = notation.write(&analysis).expect("it has no errors");
        assert_eq!(writing.report.remarks().count(), 0);
        let source = Source::alone("test", &writing.bytes);
        let back = convert(notation, &source, &Options::default()).expect("what is written is read");
        text = back.written.text;
        assert_eq!(networks(&text), networks(LOOP));
    }
}

/// A generated program whose last networks are functions, which its first networks call; one calls the other.
fn with_functions(says: &Says, seed: u64) -> String {
    let mut dice = Dice::new(seed);
    let text = says.program(&mut dice);
    let parsed = parse(&text);
    let items = parsed.structure().items.iter();
    let firsts: Vec<usize> = items
        .filter_map(|item| match item {
            Item::Network(number) => Some(parsed.structure().networks[*number].lines.start),
            _ => None,
        })
        .collect();
    let mut out = String::new();
    let mut functions = ["Rinse", "Count_2"].into_iter();
    for line in 0..parsed.lines().len() {
        if line == firsts[0] {
            out.push_str("+--[/]( level )--<CALL>( Rinse )--( )( lamp )--+\n\n+--<CALL>( Count_2 )--+\n\n");
        } else if firsts.contains(&line)
            && let Some(name) = functions.next()
        {
            match (name, dice.one_in(2)) {
                ("Rinse", true) => out.push_str("+--<FUN>( Rinse )--[ ]( level )--<CALL>( Count_2 )--+\n\n"),
                ("Rinse", false) => out.push_str("+--<FUN>( Rinse )--+\n\n+--<CALL>( Count_2 )--+\n\n"),
                _ => out.push_str(&format!("+--<FUN>( {name} )--+\n\n")),
            }
        }
        out.push_str(parsed.lines()[line].text());
    }
    for name in functions {
        out.push_str(&format!("\n+--<FUN>( {name} )--+\n"));
    }
    out
}

#[test]
fn generated_functions_and_loops_come_back() {
    for says in [&PLCOPEN, &SIMATIC] {
        let notation = by_name(says.notation).expect("the notation is registered");
        let mut same = 0;
        for seed in 0..60 {
            let mut text = with_functions(says, seed);
            let has_loop = seed % 2 == 1;
            if has_loop {
                text = with_loop(&text, &mut Dice::new(seed));
            }
            let analysis = ladder_analysis::analyze(&Arc::new(parse(&text)), "test.clad");
            assert!(
                !analysis.has_errors(),
                "{:?}\n{text}",
                analysis.errors().collect::<Vec<_>>()
            );
            let writing = notation
                .write(&analysis)
                .unwrap_or_else(|error| panic!("{error}\n{text}"));
            let remarks: Vec<_> = writing.report.remarks().collect();
            // Jumps are remarked on.
            let is_whole = remarks.is_empty() || has_loop && writing.report.tally().refused == 0;
            assert!(is_whole, "{remarks:?}\n{text}");
            let shown = String::from_utf8_lossy(&writing.bytes).into_owned();
            let source = Source {
                companions: writing.companions,
                ..Source::alone("test", &writing.bytes)
            };
            let back = convert(notation, &source, &Options::default());
            let ladder = back
                .unwrap_or_else(|error| panic!("{error}\n{shown}"))
                .written
                .text;
            let loops = ladder.matches("<NEXT>").count();
            assert_eq!(loops, usize::from(has_loop), "seed {seed}\n{ladder}\nof\n{text}");
            assert_eq!(
                ladder.matches("<FUN>").count(),
                2,
                "seed {seed}\n{ladder}\nof\n{text}"
            );
            assert!(
                !ladder.contains("FUNCTION_BLOCK"),
                "seed {seed}\n{ladder}\nof\n{text}"
            );
            let different = next_to(&text, &ladder, Stimulus { seed, scans: 60 });
            assert_eq!(different, None, "seed {seed}\n{ladder}\nof\n{text}");
            // See the test of PLCopen: what goes through tags there, and what is drawn otherwise.
            let is_otherwise = ["power at a point", "at the last evaluation"]
                .iter()
                .any(|word| ladder.contains(word))
                || ["[NOT]", "[TON]( t1, T#"].iter().any(|word| text.contains(word));
            if says.notation == "simatic" || !is_otherwise {
                same += 1;
                assert_eq!(networks(&ladder), networks(&text), "seed {seed}");
            }
        }
        assert!(same > 5, "{}: only {same}", says.notation);
    }
}
