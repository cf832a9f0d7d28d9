//! C libraries do what the simulator shows: examples, their scenarios, generated programs, compiled and run.
//!
//! Where no C compiler is, the test says so and skips. `CC` names another one than the first that is found, and
//! `LADDER_C_PROGRAMS` is how many programs are tried.

mod compared;
mod run;

use compared::{check, compiled_and_run, compiler, compilers, complaints};
use ladder_analysis::{Analysis, analyze, link_files};
use ladder_invariants::generator::{Mode, program};
use ladder_simulator::{Options, Simulation, scenario};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;

/// A program with what it uses of the library.
fn analysis(text: &str) -> Analysis {
    let alone = Arc::new(analyze(&Arc::new(ladder_syntax::parse(text)), "program"));
    match link_files(&alone, &|_| None) {
        Ok(linked) => alone.with_others(linked),
        Err(_) => Analysis::clone(&alone),
    }
}

/// Whether a library was made that does the same while values come and go at random.
fn at_random(folder: &Path, compiler: &str, text: &str, seed: u64) -> Result<bool, String> {
    let analysis = analysis(text);
    match analysis
        .program()
        .and_then(|program| run::at_random(program, seed))
    {
        Some(told) => check(folder, compiler, &analysis, &told),
        None => Ok(false),
    }
}

const MOTOR: &str = include_str!("../../../examples/motor.clad");

/// What an Arduino has, for a computer.
const ARDUINO: &str = "#include <stdint.h>\n#include <stdio.h>\nenum { LOW, HIGH, INPUT_PULLUP, OUTPUT };\n\
    static unsigned long passed;\nstatic unsigned long millis() { return passed++; }\nstatic void pinMode(int, int) {}\n\
    static int digitalRead(int pin) { return pin == 2 && passed > 20 && passed < 60 ? LOW : HIGH; }\n\
    static void digitalWrite(int pin, int value) { static int was[32]; if (was[pin] != value) printf(\"%d %lu %d\\n\", pin, passed / 10, value); was[pin] = value; }\n";

#[test]
fn the_examples_of_the_book_compile_and_run() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let analysis = analyze(&Arc::new(ladder_syntax::parse(MOTOR)), "motor");
    let writing = ladder_notations::by_name("c").unwrap().write(&analysis).unwrap();
    std::fs::write(folder.path().join("motor.c"), &writing.bytes).unwrap();
    std::fs::write(folder.path().join("motor.h"), &writing.companions[0].bytes).unwrap();
    let root = ladder_tests::project::root();
    std::fs::copy(root.join("examples/c/linux.c"), folder.path().join("linux.c")).unwrap();
    let sketch = ladder_tests::project::read(&root.join("examples/c/motor/motor.ino"));
    let main = "int main() { setup(); for (int n = 0; n < 5400; n++) loop(); }\n";
    std::fs::write(
        folder.path().join("sketch.cpp"),
        format!("{ARDUINO}{sketch}{main}"),
    )
    .unwrap();
    let run = |program: &str, arguments: &[&str], input: &str| {
        let mut child = Command::new(program)
            .current_dir(folder.path())
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        std::io::Write::write_all(&mut child.stdin.take().unwrap(), input.as_bytes()).unwrap();
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success(), "{program} {arguments:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    run(
        &compiler,
        &[
            "-std=c11", "-Wall", "-Wextra", "-Werror", "linux.c", "motor.c", "-o", "linux", "-lm",
        ],
        "",
    );
    let told = run("./linux", &[], "start\n\nstop\n");
    assert_eq!(told, "run 1, ready 0\nrun 1, ready 0\nrun 0, ready 0\n");
    run(&compiler, &["-c", "-std=c99", "motor.c", "-o", "motor.o"], "");
    run(
        &compiler,
        &[
            "-Wall",
            "-Werror",
            "-x",
            "c++",
            "sketch.cpp",
            "-x",
            "none",
            "motor.o",
            "-o",
            "sketch",
            "-lm",
        ],
        "",
    );
    // Pin, time in hundredths of a second, level: the motor runs when the button is pressed, and is warm 5 s later.
    assert_eq!(run("./sketch", &[], ""), "12 2 1\n13 502 1\n");
}

#[test]
fn what_is_kept_comes_back() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let text = "VAR_INPUT\n    go : BOOL;\nEND_VAR\nVAR RETAIN\n    count : INT := 7;\n    t : RTO;\n    note : STRING[8] := 'cold';\nEND_VAR\n\
        +--[ ]( go )--[RTO]( t, T#1s )--( )( done )--+\n+--[P]( go )--[ADD]( count, count, 1 )--[MOV]( note, 'warm' )--+\n";
    let main = "#include \"kept.h\"\n#include <stdio.h>\nint main(void)\n{\n    static kept one, two;\n    uint8_t bytes[KEPT_RETAINED];\n    int n;\n    \
        kept_init(&one);\n    one.in.go = true;\n    for (n = 0; n <= 60; n++) kept_scan(&one, n * INT64_C(10000000));\n    kept_save(&one, bytes);\n    \
        kept_init(&two);\n    printf(\"%d\\n\", kept_restore(&two, bytes));\n    two.in.go = true;\n    for (n = 0; !two.out.done && n < 200; n++) kept_scan(&two, n * INT64_C(10000000));\n    \
        printf(\"%d %d\\n\", n, (int)two.w[KEPT_count]);\n    bytes[0] ^= 1;\n    printf(\"%d\\n\", kept_restore(&two, bytes));\n    return 0;\n}\n";
    let told = compiled_and_run(&compiler, folder.path(), text, "kept", main);
    // 610 ms had passed when the power came back, as the edge at once did; what another program kept is refused.
    assert_eq!(told, "1\n40 9\n0\n");
}

/// The examples, the library's programs, and what has been wrong: under the usual options of each compiler that is here.
#[test]
fn compilers_have_nothing_to_say() {
    if compilers().is_empty() {
        eprintln!("skipped: there is no C compiler here");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let root = ladder_tests::project::root();
    let folders = ["examples", "library/scenarios"].map(|name| root.join(name));
    let files = folders
        .iter()
        .flat_map(|folder| ladder_tests::project::files(folder, "clad"));
    let mut texts: Vec<String> = files.map(|path| ladder_tests::project::read(&path)).collect();
    assert!(texts.len() > 20, "{}", texts.len());
    texts.extend([
        // Nothing but bits is kept.
        "VAR RETAIN m : BOOL; END_VAR\n+--[ ]( a )--(S)( m )--+\n".to_owned(),
        // Tags that are called as the header, the runtime or C calls something.
        "VAR_INPUT EOF, errno, linux, _Bool, class, I, PROGRAM_H, self : BOOL; END_VAR\nVAR program_in, init, FAULT_RANGE, H, RETAINED : DINT; END_VAR\n\
         VAR_OUTPUT put_real, NULL, stdin : REAL; END_VAR\nVAR RETAIN kept : DINT; END_VAR\n\
         +--[ ]( EOF )--[MOV]( put_real, 1.5 )--[DIV]( NULL, put_real, stdin )--[ADD]( kept, init, H )--+\n"
            .to_owned(),
    ]);
    let told: Vec<String> = texts
        .iter()
        .map(|text| complaints(folder.path(), &analysis(text)))
        .filter(|told| !told.is_empty())
        .collect();
    assert!(told.is_empty(), "{}", told.join("\n"));
}

/// What no statement needs is not there: a text that nothing uses, a clock where only a number is kept.
#[test]
fn small_programs_compile_without_a_warning() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let text =
        "VAR RETAIN\n    n : DINT;\nEND_VAR\nVAR\n    note : STRING;\nEND_VAR\n+--[ADD]( n, n, 1 )--+\n";
    let main = "#include \"small.h\"\n#include <stdio.h>\nint main(void)\n{\n    static small plant;\n    small_init(&plant);\n    \
        small_scan(&plant, 0);\n    printf(\"%d\", (int)plant.out.n);\n    return 0;\n}\n";
    let told = compiled_and_run(&compiler, folder.path(), text, "small", main);
    assert_eq!(told, "1");
}

/// An off-delay that was armed when the power went is over in time after it came back; and a program that is called `main` has a tag
/// that is called as the library calls its faults.
#[test]
fn what_timers_do_is_kept_and_names_do_not_clash() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let text = "VAR_INPUT\n    FAULT_RESET : BOOL;\nEND_VAR\nVAR RETAIN\n    t : TOF;\nEND_VAR\nVAR_OUTPUT\n    on : BOOL;\nEND_VAR\n\
        +--[ ]( FAULT_RESET )--# goto stopped; note( frame &held ++turns (fault = #--[TOF]( t, T#100ms )--( )( on )--+\n";
    let main = "#include \"main.h\"\n#include <stdio.h>\nint main(void)\n{\n    static main_program one, two;\n    \
        uint8_t bytes[MAIN_PROGRAM_RETAINED];\n    int n;\n    main_program_init(&one);\n    one.in.FAULT_RESET = true;\n    main_program_scan(&one, 0);\n    \
        main_program_save(&one, bytes);\n    main_program_init(&two);\n    if (!main_program_restore(&two, bytes)) return 1;\n    \
        for (n = 0; n < 12; n++) {\n        main_program_scan(&two, n * INT64_C(10000000));\n        printf(\"%d\", two.out.on);\n    }\n    return 0;\n}\n";
    let told = compiled_and_run(&compiler, folder.path(), text, "main", main);
    assert_eq!(told, "111111111100");
}

/// What is sent: numbers as the simulator writes them.
#[test]
fn texts_are_sent() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let text = "VAR\n    n : INT := -7;\n    u : ULINT := 18446744073709551615;\nEND_VAR\n+--[FMT]( 'n %d u %d, %d', n, u )--[USND]( 33 )--+\n";
    let main = "#include \"sends.h\"\n#include <stdio.h>\nstatic void send(void *user, uint8_t byte)\n{\n    (void)user;\n    putchar(byte);\n}\n\
        int main(void)\n{\n    static sends plant;\n    sends_init(&plant);\n    plant.send = send;\n    sends_scan(&plant, 0);\n    return 0;\n}\n";
    let told = compiled_and_run(&compiler, folder.path(), text, "sends", main);
    let analysis = analyze(&Arc::new(ladder_syntax::parse(text)), "sends");
    let mut simulation = Simulation::new(analysis.program().unwrap().clone(), Options::default()).unwrap();
    simulation.scan();
    assert_eq!(told.as_bytes(), simulation.take_serial());
    assert!(!told.is_empty());
}

/// What does not fit is a fault, and nothing is written.
#[test]
fn a_fault_writes_nothing() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let text = "VAR\n    small : SINT := 10;\nEND_VAR\nVAR CONSTANT\n    x : LREAL := 1000.5;\nEND_VAR\n+--[TRUNC]( small, x )--+\n";
    assert_eq!(at_random(folder.path(), &compiler, text, 0), Ok(true));
}

/// Arithmetic that notes a division by zero and what does not fit, and goes on.
#[test]
fn arithmetic_of_logix_does_the_same_in_c() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    for (seed, ty) in ["SINT", "DINT", "LINT", "UDINT", "ULINT", "REAL", "LREAL"]
        .iter()
        .enumerate()
    {
        let sum = if ty.ends_with("REAL") {
            "a / b"
        } else {
            "a MOD b + a / b"
        };
        let text = format!(
            "# ladder: profile logix #\nVAR_INPUT\n    a, b : {ty};\nEND_VAR\nVAR\n    c, d, e, f, g, h : {ty};\n    s : SINT;\n    u : UINT;\n    l : LINT;\n    r : REAL;\nEND_VAR\n\
             +--[ADD]( c, a, b )--[SUB]( d, a, b )--[MUL]( e, a, b )--[DIV]( f, a, b )--+\n\
             +--[CALC]( g, {sum} )--[CALC]( h, a ^ 3 )--+\n\
             +--[MUL]( h, h, e )--[TYP]( s, a )--[TYP]( u, a )--[TYP]( l, h )--[TYP]( r, a )--+\n"
        );
        let made = at_random(folder.path(), &compiler, &text, seed as u64);
        assert_eq!(made, Ok(true), "{ty}");
    }
}

#[test]
fn examples_do_the_same_in_c() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let root = ladder_tests::project::root();
    let mut count = 0;
    for path in ladder_tests::project::files(&root.join("examples"), "clad") {
        let text = ladder_tests::project::read(&path);
        match at_random(folder.path(), &compiler, &text, 1) {
            Ok(is_made) => count += usize::from(is_made),
            Err(why) => panic!("{}: {why}", path.display()),
        }
    }
    assert!(count > 8, "only {count} examples were written as C");
}

#[test]
fn scenarios_of_the_examples_do_the_same_in_c() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let folder = tempfile::tempdir().unwrap();
    let examples = ladder_tests::project::root().join("examples");
    let mut count = 0;
    for path in ladder_tests::project::files(&examples, "ladder-test") {
        let suite = scenario::parse(&ladder_tests::project::read(&path));
        if !suite.plants.is_empty() {
            // What runs beside a program is not part of it.
            continue;
        }
        let (name, _) = suite.program.as_ref().expect("a program");
        let analysis = analysis(&ladder_tests::project::read(&examples.join(name)));
        let program = analysis.program().expect("an example without errors");
        let usual = program.cycle.unwrap_or(Options::default().interval);
        let interval = suite.interval.map_or(usual, |(interval, _)| interval);
        let options = Options {
            interval,
            ..Options::default()
        };
        let simulation = Simulation::new(program.clone(), options).expect("an example that runs");
        let (cases, errors) = scenario::bind(&suite, &simulation);
        assert!(errors.is_empty(), "{}", path.display());
        count += cases.len();
        let told = cases
            .iter()
            .map(|case| run::as_played(program, interval, case).expect("a scenario that passes"));
        let told = told.reduce(run::Told::then).expect("a scenario");
        let made = check(folder.path(), &compiler, &analysis, &told);
        assert_eq!(made, Ok(true), "{}", path.display());
    }
    assert!(count > 20, "only {count} scenarios were run in C");
}

#[test]
fn generated_programs_do_the_same_in_c() {
    let Some(compiler) = compiler() else {
        eprintln!("skipped: there is no C compiler here");
        return;
    };
    let count = std::env::var("LADDER_C_PROGRAMS")
        .ok()
        .and_then(|count| count.parse().ok())
        .unwrap_or(10);
    let folder = tempfile::tempdir().unwrap();
    let (mut checked, mut wrong) = (0, Vec::new());
    let profiles = ["iec", "iec", "ldmicro", "iot", "logix"];
    for seed in 0..count {
        let mode = if seed % 2 == 0 { Mode::Wild } else { Mode::Typed };
        let text = format!(
            "# ladder: profile {} #\n{}",
            profiles[seed as usize / 2 % profiles.len()],
            program(seed, mode)
        );
        match at_random(folder.path(), &compiler, &text, seed) {
            Ok(is_made) => checked += usize::from(is_made),
            Err(why) => wrong.push(format!("seed {seed}: {why}")),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(
        checked * 2 > count as usize,
        "only {checked} of {count} programs were written as C"
    );
    println!("{checked} of {count} programs do the same");
}
