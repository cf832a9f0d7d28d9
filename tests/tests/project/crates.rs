//! What each crate may use of the others: text flows one way, and a notation is known to the list of notations alone.

use ladder_tests::project;
use std::collections::BTreeSet;

/// The crates of the language itself.
const LANGUAGE: [&str; 6] = [
    "syntax",
    "instructions",
    "format",
    "drawings",
    "library",
    "analysis",
];

/// What a crate may use: those of the language only what is here, the others also all of the language.
const RULES: [(&str, &[&str]); 22] = [
    ("syntax", &[]),
    ("instructions", &[]),
    ("library", &[]),
    ("format", &["syntax", "instructions"]),
    ("drawings", &["syntax", "instructions", "format"]),
    (
        "analysis",
        &["syntax", "instructions", "format", "drawings", "library"],
    ),
    ("simulator", &[]),
    ("prover", &["simulator"]),
    ("picture", &["simulator"]),
    ("review", &["simulator", "picture", "prover", "ide"]),
    ("notation", &[]),
    ("ide", &["simulator"]),
    ("workspace", &["simulator", "notations"]),
    ("host", &["simulator", "workspace"]),
    (
        "documents",
        &["simulator", "picture", "ide", "notations", "workspace"],
    ),
    (
        "live",
        &["simulator", "ide", "picture", "workspace", "host", "documents"],
    ),
    (
        "debugger",
        &["simulator", "notations", "workspace", "host", "live"],
    ),
    (
        "service",
        &[
            "simulator",
            "prover",
            "review",
            "ide",
            "picture",
            "notations",
            "workspace",
            "host",
            "documents",
            "live",
            "debugger",
        ],
    ),
    ("devices", &["simulator", "workspace"]),
    (
        "server",
        &["simulator", "workspace", "host", "debugger", "service", "devices"],
    ),
    ("playground", &["workspace", "host", "service"]),
    (
        "cli",
        &[
            "simulator",
            "prover",
            "ide",
            "picture",
            "review",
            "notations",
            "workspace",
            "devices",
            "server",
        ],
    ),
];

/// A crate as its manifest has it.
struct Manifest {
    name: String,
    /// What it uses when it is built, not when it is tested.
    uses: BTreeSet<String>,
}

/// All crates of the project.
fn manifests() -> Vec<Manifest> {
    let files = project::files(&project::root(), "toml").into_iter();
    let files = files.filter(|path| path.ends_with("Cargo.toml"));
    let read = files.map(|path| project::read(&path));
    read.filter_map(|text| manifest(&text)).collect()
}

/// None: it is not one of a crate.
fn manifest(text: &str) -> Option<Manifest> {
    let name = text
        .lines()
        .find_map(|line| line.strip_prefix("name = \"ladder-"))?;
    let mut uses = BTreeSet::new();
    let mut section = "";
    for line in text.lines() {
        if line.starts_with('[') {
            section = line;
        } else if section.ends_with("dependencies]") && !section.contains("dev-") {
            let used = line.split(['.', ' ']).next().unwrap_or_default();
            uses.insert(used.to_owned());
        }
    }
    Some(Manifest {
        name: name.trim_end_matches('"').to_owned(),
        uses,
    })
}

/// Whether a crate may use another of the project.
fn may_use(name: &str, used: &str) -> bool {
    match name {
        // Tests use what they test; the fuzzer does nothing else.
        "tests" | "invariants" | "generator" | "fuzz" => true,
        "notations" => LANGUAGE.contains(&used) || used == "notation" || used.starts_with("notation-"),
        // What it writes is a picture.
        "notation-ascii" if used == "picture" => true,
        // It translates what the simulator runs.
        "notation-c" if used == "simulator" => true,
        // The same networks in other files.
        "notation-openplc" | "notation-twincat" if used == "notation-plcopen" => true,
        // Their files have bodies in Structured Text.
        "notation-logix" | "notation-plcopen" | "notation-simatic" if used == "notation-st" => true,
        _ if name.starts_with("notation-") => LANGUAGE.contains(&used) || used == "notation",
        _ => {
            let (_, own) = RULES.iter().find(|(other, _)| *other == name).expect(name);
            own.contains(&used) || (!LANGUAGE.contains(&name) && LANGUAGE.contains(&used))
        }
    }
}

/// What is used that may not be.
fn wrong(manifests: &[Manifest]) -> Vec<String> {
    let mut wrong = Vec::new();
    for Manifest { name, uses } in manifests {
        for used in uses {
            let allowed = match used.strip_prefix("ladder-") {
                Some(used) => may_use(name, used),
                // The parser of Python is larger than everything else together.
                None => !used.contains("ruff") || name == "notation-click",
            };
            if !allowed {
                wrong.push(format!("{name} uses {used}"));
            }
        }
    }
    wrong
}

#[test]
fn crates_use_only_what_is_above_them() {
    let manifests = manifests();
    assert!(manifests.len() > 15, "only {} were found", manifests.len());
    assert_eq!(wrong(&manifests), Vec::<String>::new());
}

#[test]
fn what_may_not_be_used_is_found() {
    let planted = [
        "name = \"ladder-syntax\"\n[dependencies]\nladder-format.workspace = true\n",
        "name = \"ladder-cli\"\n[dependencies]\nladder-notation-iot = { workspace = true, optional = true }\n",
        "name = \"ladder-picture\"\n[dependencies]\nlittrs-ruff-python-ast.workspace = true\n",
        "name = \"ladder-notation-iot\"\n[dev-dependencies]\nladder-cli.workspace = true\n",
    ];
    let planted: Vec<Manifest> = planted.iter().filter_map(|text| manifest(text)).collect();
    assert_eq!(
        wrong(&planted),
        [
            "syntax uses ladder-format",
            "cli uses ladder-notation-iot",
            "picture uses littrs-ruff-python-ast",
        ]
    );
}

/// A manifest may say that a library has no tests of its own and none in its documentation, so that nothing is built for them.
#[test]
fn what_is_not_tested_has_no_tests() {
    let has_example = |text: &str| {
        let mut is_inside = false;
        let fences = text.lines().filter_map(|line| {
            let line = line.trim_start();
            let comment = line.strip_prefix("///").or_else(|| line.strip_prefix("//!"))?;
            comment.trim().strip_prefix("```")
        });
        fences.fold(false, |found, language| {
            is_inside = !is_inside;
            found || is_inside && matches!(language, "" | "rust" | "no_run" | "should_panic")
        })
    };
    for manifest in project::files(&project::root(), "toml") {
        let source = manifest.with_file_name("src");
        if !manifest.ends_with("Cargo.toml") || !source.is_dir() {
            continue;
        }
        let settings = project::read(&manifest);
        for file in project::files(&source, "rs") {
            let text = project::read(&file);
            let in_unit = settings.contains("\ntest = false") && text.contains("#[test]");
            let in_docs = settings.contains("\ndoctest = false") && has_example(&text);
            assert!(
                !in_unit && !in_docs,
                "{} has tests that do not run",
                file.display()
            );
        }
    }
}
