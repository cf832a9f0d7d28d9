//! C libraries do what the simulator shows: generated programs, compiled and run.
//!
//! Where no C compiler is, the test says so and skips. `CC` names another one than the first that is found, and
//! `LADDER_C_PROGRAMS` is how many programs are tried.

use ladder_analysis::program::Program;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_analysis::{Analysis, analyze};
use ladder_invariants::generator::{Dice, Mode, program};
use ladder_simulator::compiled::{Compiled, Home, compile};
use ladder_simulator::{Options, Simulation};
use std::fmt::Write;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::Arc;

const SCANS: usize = 12;

/// The flags under which a library compiles without a word.
const STRICT: [&str; 7] = [
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Werror",
    "-fsanitize=undefined,address",
];

/// A value that can be seen, and set: its name, and where it is in the memory of the library.
struct Place {
    name: String,
    bank: &'static str,
    at: u32,
    ty: Scalar,
    may_be_set: bool,
}

fn compiler() -> Option<String> {
    let works = |name: &String| Command::new(name).arg("--version").output().is_ok();
    let named = std::env::var("CC").ok();
    named
        .into_iter()
        .chain(["clang", "gcc", "cc"].map(str::to_owned))
        .find(works)
}

fn places(program: &Program, compiled: &Compiled) -> Vec<Place> {
    let mut places = Vec::new();
    for (tag, home) in program
        .tags
        .iter()
        .zip(&compiled.homes)
        .filter(|(tag, _)| tag.block.is_none())
    {
        let name = |n: u32, first: i64| match tag.ty {
            Type::Array { .. } => tag.element_name(first + i64::from(n)),
            _ => tag.name.clone(),
        };
        let mut add = |name: String, bank, at, ty, may_be_set| {
            places.push(Place {
                name,
                bank,
                at,
                ty,
                may_be_set,
            });
        };
        match *home {
            Home::Bits { at, first, len } => {
                (0..len).for_each(|n| add(name(n, first), "b", at.0 + n, Scalar::Bool, !tag.constant));
            }
            Home::Words { at, first, len, ty } => {
                (0..len).for_each(|n| add(name(n, first), "w", at.0 + n, ty, !tag.constant));
            }
            Home::Texts { at, first, len, max } => {
                (0..len).for_each(|n| add(name(n, first), "t", at.0 + n, Scalar::String(max), false));
            }
            Home::State { state, bits, words } => {
                let member = |member: &str| format!("{}.{member}", tag.name);
                if state.is_timer() {
                    add(member("Q"), "b", bits.0 + 1, Scalar::Bool, false);
                    add(member("ET"), "w", words.0 + 1, Scalar::Lint, false);
                } else if state.is_counter() {
                    add(member("CV"), "w", words.0 + 1, Scalar::Dint, false);
                } else {
                    add(member("Q1"), "b", bits.0, Scalar::Bool, false);
                }
            }
            Home::Borrowed(_) => {}
        }
    }
    places
}

fn value(dice: &mut Dice, ty: Scalar) -> Option<Value> {
    Some(match ty {
        Scalar::Bool => Value::Bool(dice.one_in(2)),
        Scalar::Real | Scalar::Lreal => Value::Real([0.0, 1.5, -2.25, 1000.0, 0.1_f32.into()][dice.below(5)]),
        Scalar::Time => Value::Int(dice.between(0, 50) * 1_000_000),
        _ if ty.is_integer() || ty.is_bits() => Value::Int(dice.between(0, 12)),
        _ => return None,
    })
}

fn word(value: &Value) -> String {
    match value {
        Value::Bool(high) => u8::from(*high).to_string(),
        Value::Int(number) => number.to_string(),
        Value::Real(real) => (real.to_bits() as i64).to_string(),
        Value::Text(bytes) => bytes.iter().fold(String::new(), |mut text, byte| {
            let _ = write!(text, "{byte:02x}");
            text
        }),
    }
}

/// What the simulator shows, and the C program that shows the same of the library.
fn both(analysis: &Analysis, seed: u64) -> Option<(String, String)> {
    let program: &Arc<Program> = analysis.program()?;
    let compiled = compile(program, 10_000_000).ok()?;
    let mut simulation = Simulation::new(program.clone(), Options::default()).ok()?;
    let places = places(program, &compiled);
    let mut dice = Dice::new(seed);
    let (mut shown, mut c) = (String::new(), String::new());
    for scan in 0..SCANS {
        for place in places.iter().filter(|place| place.may_be_set) {
            if !dice.one_in(3) {
                continue;
            }
            let Some(value) = value(&mut dice, place.ty) else {
                continue;
            };
            let point = simulation.resolve(&place.name).expect("the name of a tag");
            if simulation.set(&point, value.clone()).is_ok() {
                let _ = writeln!(c, "    s.{}[{}] = {};", place.bank, place.at, word(&value));
            }
        }
        let ran = simulation.scan();
        if simulation.take_faults().iter().any(|fault| fault.stops) {
            // Loops without an end are stopped sooner here, later there.
            break;
        }
        let _ = write!(shown, "{scan} {}", u8::from(ran));
        let _ = writeln!(
            c,
            "    show_inputs(&s);\n    printf(\"{scan} %d\", one_scan(&s, {scan}));"
        );
        for place in &places {
            let point = simulation.resolve(&place.name).expect("the name of a tag");
            let _ = write!(shown, " {}={}", place.name, word(&simulation.value(&point)));
            let name = place.name.replace('%', "%%");
            let _ = match place.bank {
                "t" => writeln!(c, "    printf(\" {name}=\"); show_text(&s, {});", place.at),
                bank => writeln!(
                    c,
                    "    printf(\" {name}=%lld\", (long long)s.{bank}[{}]);",
                    place.at
                ),
            };
        }
        shown.push('\n');
        c.push_str("    puts(\"\");\n");
    }
    Some((shown, c))
}

fn harness(statements: &str, has_texts: bool) -> String {
    let text = if has_texts {
        "static void show_text(const program *s, int slot)\n{\n    int n;\n    for (n = 0; n < s->length[slot]; n++) printf(\"%02x\", s->chars[text_at[slot] + (unsigned)n]);\n}\n"
    } else {
        ""
    };
    format!(
        "#include \"program.c\"\n#include <stdio.h>\n{text}static int one_scan(program *s, int scan)\n{{\n    return program_scan(s, (int64_t)scan * 10000000);\n}}\n\n\
         int main(void)\n{{\n    static program s;\n    program_init(&s);\n{statements}    return 0;\n}}\n"
    )
}

/// Whether the library was made and did the same; what it says where it does not.
fn check(folder: &Path, compiler: &str, text: &str, seed: u64) -> Result<bool, String> {
    let analysis = analyze(&Arc::new(ladder_syntax::parse(text)), "program");
    let Some((shown, statements)) = both(&analysis, seed) else {
        return Ok(false);
    };
    let notation = ladder_notations::by_name("c").expect("C is known");
    let Ok(writing) = notation.write(&analysis) else {
        return Ok(false);
    };
    let has_texts = String::from_utf8_lossy(&writing.bytes).contains("text_at");
    std::fs::write(folder.join("program.c"), &writing.bytes).map_err(|error| error.to_string())?;
    for companion in &writing.companions {
        std::fs::write(folder.join(&companion.name), &companion.bytes).map_err(|error| error.to_string())?;
    }
    std::fs::write(folder.join("main.c"), harness(&statements, has_texts))
        .map_err(|error| error.to_string())?;
    let run = |arguments: &[&str]| {
        let output = Command::new(compiler)
            .current_dir(folder)
            .args(arguments)
            .output();
        output.map_err(|error| error.to_string())
    };
    let mut arguments = STRICT.to_vec();
    arguments.extend(["-O1", "-Wno-unused-function", "main.c", "-o", "main", "-lm"]);
    let compiled = run(&arguments)?;
    if !compiled.status.success() {
        return Err(String::from_utf8_lossy(&compiled.stderr).into_owned());
    }
    let ran = Command::new(folder.join("main"))
        .output()
        .map_err(|error| error.to_string())?;
    let said = String::from_utf8_lossy(&ran.stdout);
    if said == shown && ran.stderr.is_empty() {
        return Ok(true);
    }
    let line = shown
        .lines()
        .zip(said.lines())
        .find(|(own, other)| !is_same(own, other));
    if line.is_none() && shown.lines().count() == said.lines().count() && ran.stderr.is_empty() {
        return Ok(true);
    }
    let differs = line.map(|(own, other)| {
        let pairs = own
            .split(' ')
            .zip(other.split(' '))
            .filter(|(own, other)| own != other);
        let pairs: Vec<String> = pairs.map(|(own, other)| format!("{own}, in C {other}")).collect();
        format!(
            "scan {}: {}",
            own.split(' ').next().unwrap_or_default(),
            pairs.join("; ")
        )
    });
    Err(format!(
        "{}\n{}",
        differs.unwrap_or_else(|| format!("{} lines, in C {}", shown.lines().count(), said.lines().count())),
        String::from_utf8_lossy(&ran.stderr)
    ))
}

/// Whether two lines show the same, but for the last digits of what functions such as SIN give: each C library has its own.
fn is_same(own: &str, other: &str) -> bool {
    let is_near = |(own, other): (&str, &str)| {
        let number = |pair: &str| pair.rsplit_once('=')?.1.parse::<i64>().ok();
        own == other
            || number(own).zip(number(other)).is_some_and(|(own, other)| {
                own.abs_diff(other) < 64 && f64::from_bits(own as u64).abs() > 1e-300
            })
    };
    own.split(' ').count() == other.split(' ').count() && own.split(' ').zip(other.split(' ')).all(is_near)
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
    let said = run("./linux", &[], "start\n\nstop\n");
    assert_eq!(said, "run 1, ready 0\nrun 1, ready 0\nrun 0, ready 0\n");
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
    let said = compiled_and_run(&compiler, folder.path(), text, "kept", main);
    // 610 ms had passed when the power came back, as the edge at once did; what another program kept is refused.
    assert_eq!(said, "1\n40 9\n0\n");
}

/// Compiles a library and a program around it, and runs that.
fn compiled_and_run(compiler: &str, folder: &Path, text: &str, name: &str, main: &str) -> String {
    let analysis = analyze(&Arc::new(ladder_syntax::parse(text)), name);
    let writing = ladder_notations::by_name("c").unwrap().write(&analysis).unwrap();
    std::fs::write(folder.join("library.c"), &writing.bytes).unwrap();
    let header = &writing.companions[0];
    std::fs::write(folder.join(&header.name), &header.bytes).unwrap();
    std::fs::write(folder.join("main.c"), main).unwrap();
    let mut arguments = STRICT.to_vec();
    arguments.extend(["main.c", "library.c", "-o", "main", "-lm"]);
    let compiled = Command::new(compiler)
        .current_dir(folder)
        .args(arguments)
        .output()
        .unwrap();
    assert!(
        compiled.status.success(),
        "{}",
        String::from_utf8_lossy(&compiled.stderr)
    );
    let ran = Command::new(folder.join("main")).output().unwrap();
    String::from_utf8(ran.stdout).unwrap()
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
    let main = "#include \"main_program.h\"\n#include <stdio.h>\nint main(void)\n{\n    static main_program one, two;\n    \
        uint8_t bytes[MAIN_PROGRAM_RETAINED];\n    int n;\n    main_program_init(&one);\n    one.in.FAULT_RESET = true;\n    main_program_scan(&one, 0);\n    \
        main_program_save(&one, bytes);\n    main_program_init(&two);\n    if (!main_program_restore(&two, bytes)) return 1;\n    \
        for (n = 0; n < 12; n++) {\n        main_program_scan(&two, n * INT64_C(10000000));\n        printf(\"%d\", two.out.on);\n    }\n    return 0;\n}\n";
    let said = compiled_and_run(&compiler, folder.path(), text, "main", main);
    assert_eq!(said, "111111111100");
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
    let said = compiled_and_run(&compiler, folder.path(), text, "sends", main);
    let analysis = analyze(&Arc::new(ladder_syntax::parse(text)), "sends");
    let mut simulation = Simulation::new(analysis.program().unwrap().clone(), Options::default()).unwrap();
    simulation.scan();
    assert_eq!(said.as_bytes(), simulation.take_serial());
    assert!(!said.is_empty());
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
    assert_eq!(check(folder.path(), &compiler, text, 0), Ok(true));
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
        match check(folder.path(), &compiler, &text, 1) {
            Ok(is_made) => count += usize::from(is_made),
            Err(why) => panic!("{}: {why}", path.display()),
        }
    }
    assert!(count > 5, "only {count} examples were written as C");
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
        .unwrap_or(24);
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
        match check(folder.path(), &compiler, &text, seed) {
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
