//! Files that are not right.

use super::*;

#[test]
fn errors_of_times() {
    check(
        "\
program motor.clad
step 20ms
scenario \"one\"
time     . 0s _ 15ms x
start    - _  _
run   => - -  _ - -
time
time .
scenario \"two\"
time . 2s
run => - - -
run => - -
time .
run => - ± 1
TIME 1s
time => 2s
",
        expect![[r#"
            4:12-14: `0s` is not a duration longer than 0
                write a duration for each step, and a dot for one as long as `step` says, as in: time . 3s .
            4:15-16: `_` is not a duration longer than 0
                write a duration for each step, and a dot for one as long as `step` says, as in: time . 3s .
            4:22-23: `x` is not a duration longer than 0
                write a duration for each step, and a dot for one as long as `step` says, as in: time . 3s .
            5:10-16: `start` has 3 steps, but `time` has 5
                all rows below a row `time` have its length: a value for each step
            7:1-5: `time` has no durations
                write a duration for each step, and a dot for one as long as `step` says, as in: time . 3s .
            8:1-5: no row is below `time`
                the rows that have these steps are below it; a second `time` goes on with more steps
            11:12-13: `run` has 3 steps, but `time` has 2
                all rows below a row `time` have its length: a value for each step
            4:17-21: a step is a whole number of scans, and 15ms is not a multiple of the scan interval 10ms
                write `10ms`, or give another scan interval, as in: interval 1ms
            12:1-4: run is expected by two rows of this scenario
                leave only one of them
            14:10-13: values of a BOOL are equal or not: they have no tolerance
                take the ± away
            15:1-5: there is no tag `TIME` in this program
            16:1-5: there is no tag `time` in this program
        "#]],
    );
}

#[test]
fn errors_of_the_file() {
    check(
        "\
Program motor.clad
step 15ms
interval soon
step 10ms
tolerance much
run => _-
scenario pump
start _-
run => __-
scenario \"\"
scenario \"twice\" now
=> _-
start
scenario \"twice\"
scenario \"open
text => 'open
run _ => -
run => _- ± 1 2
",
        expect![[r#"
            1:1-8: `Program` is before the first scenario, where only program, plant, connect, step, interval, tolerance and properties are
                write it in small letters: program
            3:10-14: `soon` is not a duration longer than 0
                write it as in: interval 10ms
            4:1-5: `step` appears here a second time
                leave only one of them
            5:11-15: `much` is not a tolerance: write it as in 0.01 or 1%
                write it as in: tolerance 0.001
            6:1-4: `run` is before the first scenario, where only program, plant, connect, step, interval, tolerance and properties are
                a property begins with always, never, when, after, within, possible or no faults; rows are after a line as in: scenario "what is shown"
            7:1-14: a scenario's name is in quotes
                write it as in: scenario "the pump starts"
            9:10-11: `run` has 3 steps, but `start` has 2
                all rows of a scenario have one length: a value for each step
            10:10-12: the scenario has no name
                write it as in: scenario "the pump starts"
            11:18-21: nothing is after the name of a scenario
                write it as in: scenario "the pump starts"
            12:1-3: the row begins with no tag
                a row is a tag and a value for each step, as in: start _-__
            13:1-6: `start` has no values
                give it one for each step: _ low, - high, . as before, or numbers between blanks
            14:10-17: another scenario is called "twice" too
                give each its own name: reports tell them apart by it
            15:10-15: the quote after the name is missing
                write it as in: scenario "the pump starts"
            16:9-14: the quote after the text is missing
                a text is written as in: 'it works'; a quote in it as $'
            17:7-9: the arrow is directly after the tag
                write it as in: run => _--_
            18:11-16: one number after ± says how far the values may be away
                write it last in the row, as in: level => 1.0 2.0 ± 0.01
            2:6-10: a step is a whole number of scans, and 15ms is not a multiple of the scan interval 10ms
                write `step 10ms`, or give another scan interval, as in: interval 1ms
        "#]],
    );
    check(
        "# nothing #\n",
        expect![[r#"
        1:1-1: the program is missing
            name it in the first line, as in: program motor.clad
        2:1-1: there is no scenario in this file
            begin one, as in: scenario "the pump starts"
    "#]],
    );
    check(
        "program motor.clad\nscenario \"a\"\nstart _-\n",
        expect![[r#"
            2:10-13: the scenario "a" expects nothing
                say what must come out, in a row with an arrow, as in: run => _--_
        "#]],
    );
}

#[test]
fn errors_that_the_program_shows() {
    check(
        "\
program motor.clad
step 15ms
scenario \"a\"
strat  _-_
start  _2x
start  _-_
limit  1 2 3
SYS.FAULT _-_
starts => _-_
list => 1 2 3
list[9] => 1 2 3
list[2] => 1 99999 x
warmup => ___
warmup.ET => 10ms x .
run => _-_ ± 1
warmup.PT => 1ms . . ± fast
step 1 2 3
PORT.SERIAL => 'a' 'b' 'c'
ready _-_ ± 1
text => 12 'a' b
",
        expect![[r#"
            5:8-11: `start` has 1 step, but `strat` has 3
                all rows of a scenario have one length: a value for each step
            2:6-10: a step is a whole number of scans, and 15ms is not a multiple of the scan interval 10ms
                write `step 10ms`, or give another scan interval, as in: interval 1ms
            4:1-6: there is no tag `strat`; did you mean start?
            5:8-11: `_2x` is not a waveform
                its letters are _ low, - high and . as before
            6:1-6: start is given by two rows of this scenario
                leave only one of them
            7:1-6: limit can only be read
                write `limit => ...` to expect values of it
            8:1-10: SYS.FAULT can only be read
                write `SYS.FAULT => ...` to expect values of it
            9:11-12: starts is a DINT: _ and - are the levels of a BOOL
                give a value for each step, with blanks between them, as in: 0 1 2
            10:1-5: list is an array: name one of its elements, as in list[1]
            11:1-8: list[9] does not exist: the array goes from 1 to 3
            12:14-19: 99999 does not fit
                INT holds -32768 to 32767
            12:20-21: `x` is not a value for an INT
                write a whole number as in 42 or 16#FF
            13:1-7: warmup is a TON: name one of its members, as in warmup.Q
            14:19-20: `x` is not a value for a TIME
                write a duration as in 5s or T#1h30m, or a number of milliseconds
            15:12-15: values of a BOOL are equal or not: they have no tolerance
                take the ± away
            16:22-28: `fast` is not a tolerance for a TIME: write it as in 20ms or 1%
                the tolerance is last in the row, as in: level => 1.0 2.0 ± 0.01
            17:1-5: there is no tag `step`; did you mean stop?
                `step` is before the first scenario
            18:1-12: the program does not use PORT.SERIAL
                the blocks USND, URCV, FMT and SCANTIME without operand do
            19:11-14: what is given has no tolerance
                ± is in rows with an arrow
        "#]],
    );
}

/// Whatever a file says, it is read to its end, and every error lies in it.
#[test]
fn mutated_files_are_read_to_their_end() {
    const TEXT: &str = "\u{feff}program motor.clad # c\r\nstep 20ms\ntolerance 1%\nscenario \"ä ± b\"\n\
                        start _-.\nlist[ 2 ] => 1 -7 . ± 1\ntext=>'it$'s' '' .\nwarmup.ET => T#5ms .. +-1ms\n";
    let simulation = simulation(MOTOR, None);
    let check = |text: &str| {
        let suite = parse(text);
        let (_, errors) = bind(&suite, &simulation);
        for error in suite.errors.iter().chain(&errors) {
            let range = usize::from(error.range.start())..usize::from(error.range.end());
            assert!(text.get(range.clone()).is_some(), "{range:?} in {text:?}");
        }
    };
    check(TEXT);
    for (at, letter) in TEXT.char_indices() {
        let after = at + letter.len_utf8();
        check(&format!("{}{}", &TEXT[..at], &TEXT[after..]));
        check(&TEXT[..at]);
        for inserted in [
            "\n",
            "\r",
            " ",
            "'",
            "\"",
            "#",
            "=>",
            "±",
            "[",
            "]",
            "_",
            "-",
            ".",
            "scenario \"",
            "9",
            "é",
        ] {
            check(&format!("{}{inserted}{}", &TEXT[..at], &TEXT[at..]));
        }
    }
}

#[test]
fn a_conflict_is_one_error() {
    check(
        "\
program motor.clad
scenario \"one\"
<<<<<<< HEAD
start    - _
||||||| 1f2e3d4
start    _ _
=======
start    - - -
>>>>>>> branch
run   => - - -
<<<<<<< HEAD
stop     - _
=======
scenario \"two\"
>>>>>>> branch
nonsense
",
        expect![[r#"
            3:1-13: a merge left a conflict here: it is not decided which scenarios or rows hold
                keep one of the two forms, or make one of them, and remove the lines of signs around them
            11:1-13: a merge left a conflict here: it is not decided which scenarios or rows hold
                keep one of the two forms, or make one of them, and remove the lines of signs around them
        "#]],
    );
}
