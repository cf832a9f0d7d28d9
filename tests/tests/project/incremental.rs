//! After every edit the analysis that takes over what an earlier one found says the same as one from scratch.

use ladder_analysis::context::Context;
use ladder_analysis::scope::{Scope, Use};
use ladder_analysis::{
    Analysis, Diagnostic, Exports, Level, Others, Rule, RuleSettings, Severity, analyze_after, analyze_with,
    exports,
};
use ladder_syntax::{Parse, TextRange, TextSize, parse};
use ladder_tests::generator::{Dice, Mode, program};
use std::sync::Arc;

/// What a hand puts in.
const PIECES: [&str; 47] = [
    "",
    "",
    "",
    "",
    "\\",
    "/",
    "-",
    "--",
    "+",
    "|",
    " ",
    "\n",
    "(",
    ")",
    "[",
    "]",
    "<",
    ">",
    "#",
    "# note #",
    ",",
    ":=",
    ";",
    "'",
    "a",
    "5",
    "T#5s",
    "é",
    "\r\n",
    "END_VAR\n",
    "VAR\n",
    "VAR\n    b : INT;\nEND_VAR\n",
    "FUNCTION_BLOCK [$F]\n",
    "END_FUNCTION_BLOCK\n",
    "+--[ ]( a )--( )( b )--+\n",
    "+--<FUN>( f )--+\n",
    "+--<LBL>( l )--+\n",
    "--<CALL>( f )--",
    "--[$F]( a )--",
    "# ladder: allow(never-read) #\n",
    "# ladder: allow-file(double-coil) #\n",
    "# ladder: profile ldmicro #\n",
    "VAR CONSTANT\n    n : INT := 5;\nEND_VAR\n",
    "[GT]( n, 5 )--",
    "[ ]( a )--[/]( a )--",
    "+--<MCR>--+\n",
    "+--\\--[ ]( a )--\\--( )( b )--+\n|  /--[ ]( A )--/\n",
];

/// Words of declarations, to be exchanged for each other.
const WORDS: [&str; 12] = [
    "BOOL",
    "INT",
    "DINT",
    "REAL",
    "TIME",
    "STRING",
    "TON",
    "CTU",
    "RETAIN",
    "CONSTANT",
    "VAR_INPUT",
    "VAR_OUTPUT",
];

/// A text with its analysis, edited step by step.
pub(crate) struct Document {
    pub(crate) text: String,
    parse: Arc<Parse>,
    analysis: Analysis,
    settings: RuleSettings,
}

impl Document {
    pub(crate) fn new(text: String) -> Document {
        Document::with(text, RuleSettings::default())
    }

    pub(crate) fn with(text: String, settings: RuleSettings) -> Document {
        let parse = Arc::new(parse(&text));
        let analysis = analyze_with(&parse, "main", &Others::default(), &settings);
        Document {
            text,
            parse,
            analysis,
            settings,
        }
    }

    /// The settings change, and the text stays.
    pub(crate) fn is_set(&mut self, settings: RuleSettings) {
        self.settings = settings;
        self.becomes(self.text.clone());
    }

    pub(crate) fn becomes(&mut self, text: String) {
        let parsed = Arc::new(self.parse.updated(&self.text, &text));
        assert_eq!(parsed.to_string(), text);
        let (others, rules) = (Others::default(), &self.settings);
        let before = Some(&self.analysis);
        let analysis = analyze_after(before, &parsed, "main", &others, rules);
        let fresh = analyze_with(&Arc::new(parse(&text)), "main", &others, rules);
        assert_eq!(
            show(&analysis),
            show(&fresh),
            "after an edit from\n{}\nto\n{text}",
            self.text
        );
        for place in [0, text.len() / 2, text.len()] {
            assert_eq!(near(&analysis, place), near(&fresh, place), "{text}");
        }
        let shown = Exports::of_edited(&analysis.context, "main");
        assert!(
            shown.says_the_same(&exports(&parsed, "main")),
            "{shown:#?}\n{text}"
        );
        (self.text, self.parse, self.analysis) = (text, parsed, analysis);
    }
}

/// The findings that are shown where there is room for few, and how many there are.
fn near(analysis: &Analysis, place: usize) -> (usize, Vec<(Rule, TextRange)>) {
    let found = analysis.findings_near(3, TextSize::new(place as u32));
    let found = found.iter().map(|found| (found.rule, found.range));
    (analysis.count(), found.collect())
}

/// All that an analysis says. Where things are in other files is not kept up to date.
pub(crate) fn show(analysis: &Analysis) -> String {
    let context = &analysis.context;
    let here = |found: &Diagnostic| {
        let mut found = found.clone();
        let elsewhere = found.related.iter_mut().filter(|related| related.file.is_some());
        elsewhere.for_each(|related| related.range = TextRange::default());
        found
    };
    format!(
        "{:#?}\n{:#?}\n{:?}\n{:?}\n{:?}",
        analysis.diagnostics().iter().map(here).collect::<Vec<_>>(),
        analysis.hidden_errors().iter().map(here).collect::<Vec<_>>(),
        analysis.program(),
        tags(context),
        context
            .networks
            .iter()
            .map(|network| {
                let blocks: Vec<_> = network
                    .blocks()
                    .map(|b| (&b.bound().facts, b.base, b.meaning, &b.bound().formals))
                    .collect();
                (
                    network.first_line,
                    network.range,
                    network.scope,
                    network.broken,
                    &network.facts().wiring,
                    &network.facts().order,
                    blocks,
                )
            })
            .collect::<Vec<_>>(),
    )
}

/// The tags of each scope, and where they are used.
fn tags(context: &Context) -> Vec<String> {
    let of_scope = |scope: &Scope| {
        let tags = scope.tags.iter().map(|tag| {
            let uses: Vec<Use> = context.uses(tag).collect();
            let what = (&tag.name, tag.ty, tag.role, tag.origin, tag.mistyped);
            let declared = (tag.retain, tag.constant, &tag.rare.initial, &tag.rare.address);
            let elsewhere = (context.leads_to(tag), &tag.rare.foreign);
            let place = context.place_of(tag);
            format!("{what:?} {declared:?} {elsewhere:?} {place:?} {uses:?}")
        });
        tags.collect::<Vec<_>>().join("\n")
    };
    context.scopes.iter().map(of_scope).collect()
}

fn somewhere(text: &str, dice: &mut Dice) -> usize {
    let mut at = dice.below(text.len() + 1);
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// One to three pieces put in, taken out or exchanged; now and then lines are doubled, moved or taken away.
pub(crate) fn edited(text: &str, dice: &mut Dice) -> String {
    let mut text = text.to_owned();
    for _ in 0..=dice.below(3) {
        if dice.one_in(4) {
            let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
            if lines.is_empty() {
                continue;
            }
            let from = dice.below(lines.len());
            let taken = lines[from];
            if dice.one_in(2) {
                lines.remove(from);
            }
            if dice.one_in(2) {
                lines.insert(dice.below(lines.len() + 1), taken);
            }
            text = lines.concat();
            continue;
        }
        // A declaration that changes says something of networks that do not.
        let word = dice.of(&WORDS);
        let from = somewhere(&text, dice);
        if dice.one_in(3)
            && let Some(at) = text[from..].find(word)
        {
            let at = from + at;
            text.replace_range(at..at + word.len(), dice.of(&WORDS));
            continue;
        }
        let at = somewhere(&text, dice);
        let mut end = (at + dice.below(4) * dice.below(3)).min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        text.replace_range(at..end.max(at), dice.of(&PIECES));
    }
    text
}

/// Puts one of the letters behind the first one of an operand.
pub(crate) fn type_in_an_operand(rung: &mut String, letters: &[&str], dice: &mut Dice) {
    let places: Vec<usize> = rung.match_indices("( ").map(|(at, _)| at + 3).collect();
    if let Some(place) = places.get(dice.below(places.len().max(1))) {
        rung.insert_str(*place, dice.of(letters));
    }
}

fn steps(mode: Mode, seeds: std::ops::Range<u64>, count: usize) {
    for seed in seeds {
        let mut dice = Dice::new(seed);
        let original = program(seed, mode);
        let mut document = Document::new(original.clone());
        for step in 0..count {
            // Mistakes come and go, as when somebody types.
            let next = if step % 5 == 4 {
                original.clone()
            } else {
                edited(&document.text, &mut dice)
            };
            document.becomes(next);
            if dice.one_in(8) {
                document.is_set(settings(&mut dice));
            }
        }
    }
}

#[test]
fn edits_of_sensible_programs() {
    steps(Mode::Sensible, 0..asked(40), 25);
}

#[test]
fn edits_of_wild_programs() {
    steps(Mode::Wild, 0..asked(40), 25);
}

/// Programs of several parts, in which somebody types: letters come and go in one place, and now and then elsewhere.
#[test]
fn typing_in_long_programs() {
    for seed in 0..asked(40) / 4 {
        let mut dice = Dice::new(seed);
        let rungs = [
            "+--[ ]( a )--[/]( b )--( )( c )--+\n",
            "+--\\--[ ]( b )--\\--[TON]( t, T#1s )--( )( d )--+\n|  /--[ ]( d )--/                            |\n",
            "# note #\n",
            "\n",
            "|\n",
            "+--[ ]( e )--[/]( e )--(S)( f )--+\n\n",
            "+--[ ]( t.Q )--(R)( f )--( )( d )--+ # ladder: allow(double-coil) #\n",
            "+--[GT]( n, 5 )--[MOV]( 3, n )--+\n",
            "+--[P]( g )--<LBL>( here )--( )( h )--+\n",
            "+--[ ]( i )--<JMP>( here )--+\n\n",
            "+--[ ]( i )--<JMP>( there )--+\n\n",
            "+--<LBL>( there )--[ ]( a )--( )( j )--+\n\n",
            "+--[$F]( a )--( )( j )--+\n",
        ];
        // Few kinds of rungs in one program: there are programs without a jump, and without a mistake.
        let mut kinds: Vec<&str> = (0..2 + dice.below(6)).map(|_| dice.of(&rungs)).collect();
        kinds.push(rungs[0]);
        let body: String = (0..80).map(|_| dice.of(&kinds)).collect();
        let declared = dice.of(&[
            "",
            "VAR\n    a, b, c : BOOL;\n    t : TON;\nEND_VAR\n\n",
            "VAR\n    a, b, c, d, e, f, g, h, i, j : BOOL;\n    t : TON;\n    n : INT;\nEND_VAR\n\n",
            "VAR_INPUT\n    a, b, e, new_one : BOOL;\nEND_VAR\nVAR_OUTPUT\n    c, d, h, j : BOOL;\nEND_VAR\n\
             VAR\n    f, g, i, unused : BOOL;\n    t : TON;\n    n : INT;\nEND_VAR\n\n",
            "FUNCTION_BLOCK [$F]\nVAR_INPUT\n    x : BOOL;\nEND_VAR\n+--[ ]( x )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n",
        ]);
        let declared = format!("{declared}+--[ ]( a )--( )( b )--+\n\n");
        // Some programs have their definitions at the end, and more declarations with them.
        let behind = dice.of(&[
            "",
            "\nFUNCTION_BLOCK [$G]\nVAR_INPUT\n    x : BOOL;\nEND_VAR\nVAR\n    unused : INT;\nEND_VAR\n\
             +--[ ]( x )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
            "\nVAR\n    late, d : BOOL;\nEND_VAR\n\n+--[ ]( late )--( )( b )--+\n",
        ]);
        let mut document = Document::with(format!("{declared}{body}{behind}"), settings(&mut dice));
        for _ in 0..6 {
            let mut at = match dice.below(4) {
                // Around the first network.
                0 => declared.len() - declared.len().min(dice.below(30)),
                _ => somewhere(&document.text, &mut dice),
            };
            while !document.text.is_char_boundary(at.min(document.text.len())) {
                at -= 1;
            }
            at = at.min(document.text.len());
            for letter in dice
                .of(&[
                    "--[ ]( new_one )--",
                    "5",
                    "x",
                    "\n",
                    "# note #",
                    "--[/]( a )",
                    "\\",
                    "(S)( A )",
                    "+--( )( c )--+\n",
                    "+--<LBL>( there )--( )( c )--+\n\n",
                    "--<JMP>( here )",
                ])
                .chars()
            {
                let mut text = document.text.clone();
                text.insert(at, letter);
                at += letter.len_utf8();
                document.becomes(text);
            }
            for _ in 0..dice.below(6) {
                let mut text = document.text.clone();
                let Some((last, _)) = text[..at].char_indices().next_back() else {
                    break;
                };
                text.replace_range(last..at, "");
                at = last;
                document.becomes(text);
            }
            if dice.one_in(3) {
                let next = edited(&document.text, &mut dice);
                document.becomes(next);
            }
            if dice.one_in(4) {
                document.is_set(settings(&mut dice));
            }
        }
    }
}

/// As the table of rules says, or everything, or with some rules off or counting otherwise.
pub(crate) fn settings(dice: &mut Dice) -> RuleSettings {
    let mut settings = if dice.one_in(3) {
        RuleSettings::everything()
    } else {
        RuleSettings::default()
    };
    for _ in 0..dice.below(6) {
        let level = dice.of(&[
            Level::Off,
            Level::Shown(Severity::Error),
            Level::Shown(Severity::Info),
        ]);
        settings.set(dice.of(Rule::ALL), level);
    }
    settings
}

/// What decides about findings in a network beside its own lines: it must not keep them when that changes.
#[test]
fn findings_whose_reasons_stand_elsewhere() {
    let constant = |value| {
        format!(
            "VAR CONSTANT n : INT := {value}; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\n\n\
             +--[GT]( n, 5 )--( )( y )--+\n"
        )
    };
    let spelled = |name| {
        format!(
            "VAR_INPUT {name} : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\n\n\
             +--[ ]( start )--[/]( START )--( )( y )--+\n"
        )
    };
    let typed = |ty| format!("VAR a : {ty}; END_VAR\n\n+--[MOV]( a, 300 )--[EQ]( a, 1.5 )--( )( y )--+\n");
    let with_rail = |above| format!("{above}\n+--[ ]( a )--[/]( a )--( )( y )--+\n");
    let profile =
        |name| format!("# ladder: profile {name} #\n\n+--[TON]( t, T#1s, B := T#10ms )--( )( y )--+\n");
    let called = |parameters| {
        format!(
            "FUNCTION_BLOCK [$F]\n{parameters}\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n\
             VAR a : INT; END_VAR\n\n+--[$F]( a, b )--( )( y )--+\n\n+--[$F]( a )--[ ]( c )--[/]( c )--( )( z )--+\n"
        )
    };
    let signatures = [
        "VAR_INPUT p : INT; q : BOOL; END_VAR",
        "VAR_INPUT p : INT; r : BOOL; END_VAR",
        "VAR_INPUT p : BOOL; r : BOOL; END_VAR",
        "VAR_INPUT p : INT; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR",
        "VAR_INPUT p : INT; q : BOOL := TRUE; END_VAR",
        "VAR_INPUT p : INT; q : BOOL := TRUE END_VAR",
        "VAR_INPUT p : INT; END_VAR",
        "",
    ]
    .map(called)
    .to_vec();
    let constants = ["5", "6", "-32768", "5"].map(constant).to_vec();
    let spellings = ["start", "Start", "stop"].map(spelled).to_vec();
    let types = ["INT", "SINT", "REAL", "BOOL", "LREAL"].map(typed).to_vec();
    let rails = ["", "+--[ ]( b )--<MCR>--+\n", "+--[ ]( b )--( )( c )--+\n"]
        .map(with_rail)
        .to_vec();
    let profiles = ["iec", "iot", "ldmicro", "iec"].map(profile).to_vec();
    for texts in [constants, spellings, types, rails, profiles, signatures] {
        let mut document = Document::new(String::new());
        for text in texts {
            document.becomes(text);
        }
    }
}

/// An edit in one network that decides about findings in another, which is not looked at for its own sake.
/// What an unknown word in brackets could be is not another one because of what is elsewhere in the file.
#[test]
fn a_word_in_brackets_that_a_tag_has_as_well() {
    let text = "+--[TOM]--( )( y )--+\n\n+--[ ]( a )--( )( b )--+\n".to_owned();
    let mut document = Document::new(text.clone());
    document.becomes(text.replace("( a )", "( TOM )"));
    document.becomes(text.clone());
    document.becomes(format!("VAR TOM : BOOL; END_VAR\n{text}"));
    document.becomes(text);
}

#[test]
fn edits_that_decide_about_other_networks() {
    let network = |drawn: &str| format!("+--[ ]( first )--( )( second )--+\n\n{drawn}\n");
    // Messages spell a tag as it is first.
    let spelled = |name| {
        network(&format!(
            "+--[ ]( {name} )--( )( x )--+\n\n+--[ ]( a )--( )( m )--[/]( m )--( )( y )--+"
        ))
    };
    // A second block of a timer is an error: of that network no more is said.
    let timed = |timer| {
        network(&format!(
            "+--[ ]( a )--[TON]( {timer}, T#1s )--+\n\n+--[ ]( b )--[/]( b )--[TON]( t, T#1s )--( )( y )--+"
        ))
    };
    // In a program without outputs its internal tags are what people look at.
    let led_out = |tag| {
        network(&format!(
            "+--[ ]( I1 )--( )( {tag} )--+\n\n+--[ ]( I2 )--( )( M2 )--+"
        ))
    };
    // Behind a way out two coils may be two cases.
    let left = |block| {
        network(&format!(
            "+--[ ]( a )--( )( y )--+\n\n+--[ ]( b )--{block}--+\n\n+--[ ]( c )--( )( y )--+"
        ))
    };
    // The nearest timer is the one that is meant.
    let meant = |timer| {
        network(&format!(
            "+--[ ]( a )--[TON]( {timer}, T#1s )--+\n\n+--[ ]( wait1.Q )--( )( y )--+"
        ))
    };
    for texts in [
        ["wait", "other", "waits", "wait1"].map(meant),
        ["y", "Y", "y", "other"].map(spelled),
        ["u", "t", "u", "t"].map(timed),
        ["Q1", "M1", "Q1", "M2"].map(led_out),
        ["( )( z )", "<END>", "( )( z )", "( )( y )"].map(left),
    ] {
        let mut document = Document::with(String::new(), RuleSettings::everything());
        for text in texts {
            document.becomes(text);
        }
    }
}

/// `GENERATED_PROGRAMS` asks for more of them.
pub(crate) fn asked(usual: u64) -> u64 {
    let asked = std::env::var("GENERATED_PROGRAMS");
    asked.ok().and_then(|count| count.parse().ok()).unwrap_or(usual)
}
