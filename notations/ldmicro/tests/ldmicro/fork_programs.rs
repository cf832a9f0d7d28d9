//! Whole programs that only LDmicro's fork reads, from ladder text and back.

use crate::fork_lines::program;
use crate::programs::{Numbers, converted, write};
use expect_test::expect;
use ladder_notation::Notation;
use ladder_notation_ldmicro::{LdmicroText, resaved};

#[test]
fn ladder_programs_become_programs_of_the_fork() {
    let rungs = "VAR\n    n : INT;\nEND_VAR\n+--[ ]( Xa )--[AND]( n, n, 15 )--(S)( n.3 )--<CALL>( part )--+\n\n\
                 +--[ ]( Xa )--[TON]( Ta, T#1s )--( )( Ya )--<JMP>( over )--+\n\n+--<LBL>( over )--<RET>--+\n\n\
                 +--<FUN>( part )--+\n+--[ ]( Xa )--<RET>--+\n";
    let fork = write(&format!(
        "# ldmicro: LDmicro0.2 #\n# ladder: profile ldmicro #\n{rungs}"
    ));
    expect![[r#"
        LDmicro0.2
        CYCLE=10000
        CRYSTAL=4000000
        BAUD=2400

        IO LIST
        END

        PROGRAM
        RUNG 1
          CONTACTS Xa 0 0
          AND n n 15
          SET_BIT n 3
          GOSUB part
        END
        RUNG 2
          CONTACTS Xa 0 0
          TON Ta 990000 0
          COIL Ya 0 0 0 0
          GOTO over
        END
        RUNG 3
          LABEL over
          GOTO 7
        END
        RUNG 4
          SUBPROG part
        END
        RUNG 5
          CONTACTS Xa 0 0
          RETURN
        END
        RUNG 6
          ENDSUB part
        END
    "#]]
    .assert_eq(&fork.expect("it can be written"));
    let older = write(&format!("# ladder: profile ldmicro #\n{rungs}")).expect("it can be written");
    assert!(older.contains("COMMENT +--[ ]( Xa )--[AND]"), "{older}");
}

/// What is between rungs' ends; `#` is a number of a name, so that some are met twice.
const ELEMENTS: &[&str] = &[
    "CONTACTS Xa 0 0",
    "CONTACTS Xa 1 1",
    "OSL",
    "ODR",
    "OSC",
    "OSR",
    "IF_BIT_SET n# 3",
    "IF_BIT_CLEAR n# 15",
    "EQU n# 0x1F",
    "TON Ta# 100000 0",
    "TON Tb# n# 0",
    "RTL Tc# 40000 0",
    "TCY Td# 30000 1",
    "THI Te# n# 0",
    "TLO Tf# 50000 0",
    "CTU Ca# 5 # /",
    "CTD Ca# -5 # \\",
    "CTC Cb# n# # -",
    "CTR Cc# 0 n# o",
    "GOTO here",
    "GOTO #",
    "GOTO 99",
    "GOSUB part#",
    "GOSUB no",
    "RETURN",
    "SWAP n# n1",
    "PARALLEL\nCOIL Ya 0 0 0 1\nSERIES\nOSR\nSET_BIT n# 2\nEND\nGOTO #\nEND",
    "SET_PWM n# 1000 P# 8",
    "RES Ca#",
    "RES P1",
    "MOD n# n1 7",
    "SHL n# n1 3",
    "SHR n# n# 1",
    "BIN2BCD n1 n#",
    "SET_BIT n1 n#",
    "IF_BIT_CLEAR n# n1",
    "COIL Ya# 0 0 0 0",
    "COIL Yb 0 1 0 0",
    "MASTER_RELAY",
];

#[test]
fn any_program_comes_back() {
    for seed in 0..200 {
        let mut numbers = Numbers(seed);
        let mut rungs: Vec<String> = Vec::new();
        for part in 0..4 {
            let is_sub = numbers.below(3) == 0;
            let (begin, end) = (format!("SUBPROG part{part}"), format!("ENDSUB part{part}"));
            rungs.extend(is_sub.then_some(begin));
            for _ in 0..numbers.below(4) {
                let mut elements: Vec<String> = Vec::new();
                for _ in 0..=numbers.below(4) {
                    let element = ELEMENTS[numbers.below(ELEMENTS.len())];
                    elements.push(element.replace('#', &(1 + numbers.below(9)).to_string()));
                }
                rungs.push(elements.join("\n"));
            }
            rungs.extend((numbers.below(4) == 0).then(|| format!("COMMENT Part {part}.")));
            rungs.extend(is_sub.then_some(end));
            rungs.extend((part == numbers.below(4)).then(|| "LABEL here".to_owned()));
        }
        let rungs: Vec<&str> = rungs.iter().map(String::as_str).collect();
        let text = resaved(program(&rungs).as_bytes()).expect("it can be read");
        let shown = String::from_utf8_lossy(&text).into_owned();
        let converted = converted(&text).expect("it can be read");
        let ladder = converted.written.text;
        let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&ladder).into(), "test.clad");
        let errors: Vec<String> = analysis.errors().map(|error| error.message.clone()).collect();
        assert!(errors.is_empty(), "{errors:?}\n{ladder}");
        assert_eq!(write(&ladder), Ok(shown), "{ladder}");
    }
}

#[test]
fn the_drawing_is_that_of_ldmicro_without_the_fork() {
    let text = program(&[
        "CONTACTS Xa 0 0\nTON Ta 100000 0\nTON Tb 100000 -1\nTCY Tc 100000 0\nCTU Ca 5 0 /\nCOIL Ya 0 0 0 1",
    ]);
    let ladder = converted(text.as_bytes()).expect("it can be read").written.text;
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&ladder).into(), "test.clad");
    let written = LdmicroText.write(&analysis).expect("it can be written");
    let remarks: Vec<String> = written
        .report
        .remarks()
        .map(|entry| format!("{}: {:?}\n", entry.element, entry.outcome))
        .collect();
    expect![[r#"
        TON Ta 100000 0: Approximated("the drawing does not hold how many cycles are added to its delay")
        TCY Tc 100000 0: Approximated("LDmicro 2.2 has no such element")
        CTU Ca 5 0 /: Approximated("LDmicro 2.2 has no such element")
        COIL Ya 0 0 0 1: Approximated("LDmicro 2.2 has no such element")
    "#]]
    .assert_eq(&remarks.concat());
}
