//! Unread parts: what another system's program says that no reader understands.

use crate::harness::outline;
use expect_test::{Expect, expect};
use ladder_review::report::{Compared, text};
use ladder_review::{Limits, compare};

const CALC: &str = "\
VAR_INPUT
    go : BOOL;
END_VAR
VAR_OUTPUT
    run   : BOOL;
    speed : DINT;
END_VAR

# routine Calc is structured text and was not read. #
FUNCTION_BLOCK [$Calc]
# ladder: unread, writes speed #
# IF go THEN #
#     speed := 10; #
# END_IF; #
END_FUNCTION_BLOCK

+--[ ]( go )--( )( run )--+

+--[$Calc]( )--+
";

fn check(old: &str, new: &str, expected: Expect) {
    let (old, new) = (outline(old), outline(new));
    let mut comparison = compare(&old, &new);
    comparison.decide_whole(Limits::default(), usize::MAX);
    let whole = format!("{:?}", comparison.whole);
    let compared = Compared {
        old: Some("old.clad"),
        new: Some("new.clad"),
        renamed: false,
        comparison,
    };
    let mut lines: Vec<String> = text::report(&compared)
        .into_iter()
        .map(|line| line.text)
        .collect();
    lines.push(whole);
    expected.assert_eq(&(lines.join("\n") + "\n"));
}

#[test]
fn its_text_is_shown_and_a_changed_one_is_not_decided() {
    check(
        CALC,
        &CALC.replace(":= 10", ":= 9000"),
        expect![[r#"
        --- old.clad
        +++ new.clad
            1 edited, 5 the same

        the unread part `Calc` is not run, and what it may write is not known

            ... 3 the same

        edited: unread part, line 11, in block $Calc
            whether it does the same is not decided: routine Calc is structured text and was not read
          # ladder: unread, writes speed #
          # IF go THEN #
        - #     speed := 10; #
                         ^^^
        - # END_IF; #
        + #     speed := 9000; #
                         ^^^^^
        + # END_IF; #

            ... 2 the same

        whether the programs do the same is not decided
            routine Calc is structured text and was not read
        Some(NotDecided(["routine Calc is structured text and was not read"]))
    "#]],
    );
}

#[test]
fn blanks_in_it_are_no_difference() {
    check(
        CALC,
        &CALC.replace("#     speed", "#   speed"),
        expect![[r#"
        --- old.clad
        +++ new.clad
            1 drawn differently, 5 the same

        the unread part `Calc` is not run, and what it may write is not known

            ... 3 the same

        drawn differently: unread part, line 11, in block $Calc

            ... 2 the same
        Some(Same)
    "#]],
    );
}

#[test]
fn a_rung_below_it_does_not_take_its_text() {
    let condition = CALC.replace("# END_IF; #\n", "# END_IF; #\n+--(R)( ENO )--+\n");
    check(
        &condition,
        &condition.replace(":= 10", ":= 9000"),
        expect![[r#"
        --- old.clad
        +++ new.clad
            1 edited, 6 the same

        the unread part `Calc` is not run, and what it may write is not known

            ... 3 the same

        edited: unread part, line 11, in block $Calc
            whether it does the same is not decided: routine Calc is structured text and was not read
          # ladder: unread, writes speed #
          # IF go THEN #
        - #     speed := 10; #
                         ^^^
        - # END_IF; #
        + #     speed := 9000; #
                         ^^^^^
        + # END_IF; #

            ... 3 the same

        whether the programs do the same is not decided
            routine Calc is structured text and was not read
        Some(NotDecided(["routine Calc is structured text and was not read"]))
    "#]],
    );
}
