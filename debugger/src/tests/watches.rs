//! What expressions are.

use super::Client;

const TEXT: &str = "VAR
    high : BOOL := TRUE;
    small : SINT := 100;
    count : INT := 7;
    big : LINT := 5_000_000_000;
    ratio : REAL := 0.5;
    bits : WORD := 16#00FF;
    wait : TIME := T#1s500ms;
    name : STRING := 'pump';
    i : INT := 2;
    a : ARRAY[1..3] OF INT := [10, 20, 30];
    t : TON;
END_VAR
+--[TON]( t, wait )--+
";

#[track_caller]
fn check(expressions: &[(&str, &str)]) {
    let mut client = Client::launched(TEXT);
    for (expression, wanted) in expressions {
        assert_eq!(client.evaluate(expression, "watch"), *wanted, "{expression}");
    }
}

#[test]
fn values_have_the_types_of_the_language() {
    check(&[
        ("count > 5 AND high", "TRUE"),
        ("count + 1", "8"),
        ("small + 100", "-56"),
        ("count + big", "5000000007"),
        ("ratio * 3.0", "1.5"),
        ("bits AND 16#0F", "16#000F"),
        ("wait + T#500ms", "T#2s"),
        ("wait > T#1s", "TRUE"),
        ("name = 'pump'", "TRUE"),
        ("a[i] + a[3]", "50"),
        ("SUM(a[1..3])", "60"),
        ("count.0 AND NOT count.3", "TRUE"),
        ("MAX(count, a[1])", "10"),
        ("2 * 21", "42"),
        ("2.0 ^ 3.0", "8.0"),
        ("t.ET < wait", "TRUE"),
        ("COUNT >= 7", "TRUE"),
    ]);
}

#[test]
fn errors_are_reported_in_words() {
    check(&[
        ("cuont > 5", "error: there is no tag `cuont`; did you mean count?"),
        (
            "count / 0",
            "error: division by zero: nothing was written; check the divisor before this block",
        ),
        (
            "a[i + 2]",
            "error: index 4 is outside the array [1..3]: nothing was written; limit the index before this block",
        ),
    ]);
}

#[test]
fn the_console_changes_tags() {
    let mut client = Client::launched(TEXT);
    let mut says = |text: &str| client.evaluate(text, "repl");
    assert_eq!(says("count := 3"), "3");
    assert_eq!(says("count := count * 2"), "6");
    assert_eq!(says("force count"), "6 (forced)");
    assert_eq!(says("force count := 9"), "9 (forced)");
    assert_eq!(says("unforce count"), "9");
    assert_eq!(says("a[2] := 5"), "5");
    assert_eq!(says("a"), "ARRAY[1..3] OF INT");
    assert_eq!(says("t"), "Q=FALSE ET=T#0s");
    assert_eq!(says("wait := T#2s"), "T#2s");
    assert_eq!(says("name := 'valve'"), "'valve'");
    assert!(says("count := 99999").starts_with("error: "));
    assert!(says("SYS.SCAN := 1").starts_with("error: SYS.SCAN is read-only"));
    assert!(says("help").contains("unforce"));
}
