//! A library that is compiled and run next to the simulator.

use super::run::Told;
use ladder_analysis::{Analysis, analyze};
use std::path::Path;
use std::process::Command;
use std::sync::Arc;

/// The flags under which a library compiles without a word.
const STRICT: [&str; 8] = [
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wshadow",
    "-Werror",
    "-fsanitize=undefined,address",
];

/// The compiler that `CC` names, or the first that is found.
pub(super) fn compiler() -> Option<String> {
    std::env::var("CC")
        .ok()
        .or_else(|| compilers().into_iter().next())
}

/// All that are found. `cc` is another name of one of the others on most machines, and only counts where they are missing.
pub(super) fn compilers() -> Vec<String> {
    let works = |name: &&str| Command::new(name).arg("--version").output().is_ok();
    let found: Vec<&str> = ["gcc", "clang"].into_iter().filter(works).collect();
    let found = if found.is_empty() {
        Some("cc").into_iter().filter(works).collect()
    } else {
        found
    };
    found.into_iter().map(str::to_owned).collect()
}

/// What compilers say of a library under any of the options that people use; nothing if all is well.
pub(super) fn complaints(folder: &Path, analysis: &Analysis) -> String {
    let Ok(writing) = ladder_notations::by_name("c")
        .expect("C is known")
        .write(analysis)
    else {
        return String::new();
    };
    let header = &writing.companions[0].name;
    let source = header.strip_suffix('h').expect("a header").to_owned() + "c";
    std::fs::write(folder.join(header), &writing.companions[0].bytes).expect("a folder");
    std::fs::write(folder.join(&source), &writing.bytes).expect("a folder");
    let mut told = String::new();
    for compiler in compilers() {
        for options in OPTIONS {
            let mut command = Command::new(&compiler);
            command
                .current_dir(folder)
                .args(["-fsyntax-only", &source])
                .args(*options);
            let output = command.output().expect("a compiler");
            if !output.status.success() || !output.stderr.is_empty() {
                told += &format!(
                    "{compiler} {options:?}\n{}",
                    String::from_utf8_lossy(&output.stderr)
                );
            }
        }
    }
    told
}

/// Without any, and all warnings in each of the languages.
const OPTIONS: &[&[&str]] = &[
    &[],
    &[
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Wconversion",
        "-Wshadow",
    ],
    &["-std=c11", "-Wall", "-Wextra", "-Wconversion", "-Wshadow"],
    &["-std=gnu17", "-Wall", "-Wextra", "-Wconversion", "-Wshadow"],
];

fn harness(statements: &str, has_texts: bool) -> String {
    let text = if has_texts {
        "static void show_text(const program *s, int slot)\n{\n    int n;\n    for (n = 0; n < s->length[slot]; n++) printf(\"%02x\", s->chars[text_at[slot] + (unsigned)n]);\n}\n"
    } else {
        ""
    };
    format!(
        "#include \"program.c\"\n#include <stdio.h>\n{text}static int some_scans(program *s, int first, int end, int64_t interval)\n{{\n    int ran = 0;\n    \
         for (; first < end; first++) ran = program_scan(s, first * interval);\n    return ran;\n}}\n\n\
         int main(void)\n{{\n    static program s;\n    program_init(&s);\n{statements}    return 0;\n}}\n"
    )
}

/// Whether the library was made and did the same; what it says where it does not.
pub(super) fn check(folder: &Path, compiler: &str, analysis: &Analysis, told: &Told) -> Result<bool, String> {
    let Told {
        shown, statements, ..
    } = told;
    let notation = ladder_notations::by_name("c").expect("C is known");
    let Ok(writing) = notation.write(analysis) else {
        return Ok(false);
    };
    let has_texts = String::from_utf8_lossy(&writing.bytes).contains("text_at");
    std::fs::write(folder.join("program.c"), &writing.bytes).map_err(|error| error.to_string())?;
    for companion in &writing.companions {
        std::fs::write(folder.join(&companion.name), &companion.bytes).map_err(|error| error.to_string())?;
    }
    std::fs::write(folder.join("main.c"), harness(statements, has_texts))
        .map_err(|error| error.to_string())?;
    let run = |arguments: &[&str]| {
        let output = Command::new(compiler)
            .current_dir(folder)
            .args(arguments)
            .output();
        output.map_err(|error| error.to_string())
    };
    let mut arguments = STRICT.to_vec();
    // Compiled once, run once: what the sanitizers look for does not need what optimising takes.
    arguments.extend(["-O0", "-Wno-unused-function", "main.c", "-o", "main", "-lm"]);
    let compiled = run(&arguments)?;
    if !compiled.status.success() {
        return Err(String::from_utf8_lossy(&compiled.stderr).into_owned());
    }
    let ran = Command::new(folder.join("main"))
        .output()
        .map_err(|error| error.to_string())?;
    let told = String::from_utf8_lossy(&ran.stdout);
    if told == *shown && ran.stderr.is_empty() {
        return Ok(true);
    }
    let line = shown
        .lines()
        .zip(told.lines())
        .find(|(own, other)| !is_same(own, other));
    if line.is_none() && shown.lines().count() == told.lines().count() && ran.stderr.is_empty() {
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
        differs.unwrap_or_else(|| format!("{} lines, in C {}", shown.lines().count(), told.lines().count())),
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

/// Compiles a library and a program around it, and runs that.
pub(super) fn compiled_and_run(compiler: &str, folder: &Path, text: &str, name: &str, main: &str) -> String {
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
