//! `[CALC]` whole: every operator, precedence, functions, SUM, PI, BOOL and numbers (LANGUAGE §5.2).

use crate::support::{get, simulation};

const TAGS: &str = "a : INT := 7; b : INT := 2; c : INT := -3; p : BOOL := TRUE; q : BOOL; w : WORD := 16#0F0F; \
                    u : UINT := 65535; x : LREAL := 2.5; t : TIME := T#90s; list : ARRAY[1..4] OF INT := [1, 2, 3, 4];";

/// What an expression gives in a type.
#[track_caller]
fn calc(ty: &str, expression: &str, expected: &str) {
    let text =
        format!("VAR y : {ty}; ok : BOOL; {TAGS} END_VAR\n+--[CALC]( y, {expression} )--( )( ok )--+\n");
    let mut simulation = simulation(&text);
    simulation.scan();
    assert_eq!(get(&simulation, "y"), expected, "{expression} in {ty}");
    assert_eq!(get(&simulation, "ok"), "1", "{expression}");
}

#[test]
fn arithmetic() {
    calc("INT", "a + b", "9");
    calc("INT", "a - b - 1", "4");
    calc("INT", "a * b", "14");
    calc("INT", "a / b", "3");
    calc("INT", "c / b", "-1");
    calc("INT", "a MOD b", "1");
    calc("INT", "c MOD b", "-1");
    calc("INT", "b ^ 5", "32");
    calc("LREAL", "x * 2 + a", "12.0");
    calc("LREAL", "a / b", "3.5");
    calc("LREAL", "7.5 MOD 2", "1.5");
    calc("INT", "-a", "-7");
    calc("SINT", "100 + 100", "-56");
}

#[test]
fn loosest_first() {
    calc("INT", "1 + 2 * 3", "7");
    calc("INT", "(1 + 2) * 3", "9");
    calc("INT", "2 * 3 ^ 2", "18");
    calc("INT", "2 ^ 3 ^ 2", "512");
    calc("INT", "-2 ^ 2", "4");
    calc("INT", "20 / 2 * 5", "50");
    calc("INT", "20 - 5 - 5", "10");
    calc("INT", "1 SHL 2 + 1", "8");
    calc("BOOL", "1 + 1 = 2", "1");
    calc("BOOL", "1 SHL 1 < 3", "1");
    calc("BOOL", "a > 5 = TRUE", "1");
    calc("BOOL", "q AND q OR p", "1");
    calc("BOOL", "p OR q AND q", "1");
    calc("BOOL", "p XOR p AND q", "1");
    calc("BOOL", "p OR p XOR p", "1");
    calc("BOOL", "a = 7 AND b = 2", "1");
    calc("BOOL", "NOT q AND p", "1");
    calc("BOOL", "NOT (q OR p)", "0");
}

#[test]
fn comparisons_type_their_own_sides() {
    for (operator, expected) in [
        ("=", "0"),
        ("<>", "1"),
        ("<", "0"),
        ("<=", "0"),
        (">", "1"),
        (">=", "1"),
    ] {
        calc("BOOL", &format!("a {operator} b"), expected);
    }
    // INT -3 with UINT 65535: by value.
    calc("BOOL", "c < u", "1");
    calc("BOOL", "u + c > u + 1", "0");
    calc("BOOL", "x > b", "1");
    calc("BOOL", "t >= T#1m30s", "1");
    calc("BOOL", "x = 2.5 AND t < 2m", "1");
}

#[test]
fn the_sides_of_a_comparison_have_the_smallest_type_that_holds_both() {
    let tags = "g : BOOL; s : SINT := 100; i : INT := 20000; d : DINT := 2000000000; l : LINT; u : UINT := 65535; \
                ul : ULINT := 5; r : REAL";
    let compare = |expression: &str, expected: &str| {
        let text = format!("VAR y : BOOL; {tags}; END_VAR\n+--[CALC]( y, {expression} )--+\n");
        let mut simulation = simulation(&text);
        simulation.scan();
        assert_eq!(get(&simulation, "y"), expected, "{expression}");
    };
    // 40000 is too much for INT, and is no more than DINT holds.
    compare("i + i > d - d", "1");
    compare("i + i > l", "1");
    compare("l < i + i", "1");
    compare("i + i > i", "0");
    compare("s + s > i - i", "1");
    compare("s + s > s - s", "0");
    compare("SEL(i + i > l, FALSE, TRUE)", "1");
    compare("(i + i) * 2 > l AND NOT (i + i > i)", "1");
    // DINT and INT make DINT, not LINT: it wraps.
    compare("d + d > i - i", "0");
    compare("d + d > l", "1");
    // INT and UINT meet in DINT.
    compare("i + u > u - i", "1");
    // What chooses takes no part.
    compare("SEL(g, i, s) + i > d - d", "1");
    compare("MUX(l, i, s) + i > s", "0");
    // No integer holds LINT and ULINT: by value.
    compare("l - 1 < ul", "1");
    compare("ul - 6 > l", "1");
    compare("i + d > r", "1");
}

#[test]
fn logic_is_logical_on_bool_and_bitwise_else() {
    calc("BOOL", "p AND NOT q", "1");
    calc("BOOL", "p XOR p", "0");
    calc("WORD", "w AND 16#00FF", "15");
    calc("WORD", "w OR 16#F000", "65295");
    calc("WORD", "w XOR 16#FFFF", "61680");
    calc("WORD", "NOT w", "61680");
    calc("INT", "NOT 0", "-1");
    calc("INT", "a AND b", "2");
    calc("WORD", "w SHL 4", "61680");
    calc("WORD", "w SHR b", "963");
    calc("WORD", "w SHL 16", "0");
}

#[test]
fn functions_by_name() {
    calc("INT", "ABS(c)", "3");
    calc("LREAL", "SQRT(x * 10)", "5.0");
    calc("INT", "MIN(a, b, c)", "-3");
    calc("INT", "MAX(a, b) + 1", "8");
    calc("INT", "LIMIT(0, a, 5)", "5");
    calc("INT", "SEL(p, a, b)", "2");
    calc("INT", "MUX(1, a, b, c)", "2");
    calc("LREAL", "TRUNC(-2.5)", "-2.0");
    calc("LREAL", "LN(1.0) + LOG(100.0) + EXPE(0.0)", "3.0");
    calc("LREAL", "SIN(0.0) + COS(0.0) + TAN(0.0)", "1.0");
    calc("LREAL", "ASIN(0.0) + ACOS(1.0) + ATAN(0.0)", "0.0");
    calc("LREAL", "DEG(RAD(180.0))", "180.0");
    calc("INT", "min(A, B)", "2");
}

#[test]
fn sum_and_pi() {
    calc("INT", "SUM(list[1..4])", "10");
    calc("DINT", "SUM(list[b..3]) * 2", "10");
    calc("LREAL", "PI", "3.141592653589793");
    calc("REAL", "PI * 2", "6.2831855");
}

#[test]
fn times() {
    calc("TIME", "t + T#30s", "120000");
    calc("TIME", "t - 30s", "60000");
    calc("TIME", "t / 2", "45000");
    calc("TIME", "3 * t", "270000");
    calc("TIME", "t * 0.5", "45000");
    calc("TIME", "-t", "-90000");
}

#[test]
fn elements_members_and_bits() {
    calc("INT", "list[2] + list[b]", "4");
    calc("BOOL", "w.0 AND NOT w.4", "1");
    calc("DINT", "SYS.SCAN + 1", "1");
}
