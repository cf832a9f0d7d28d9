//! What the job for GitLab in the book posts: its script, with git, and with a `curl` that writes down what it is asked.

use ladder_tests::{book, project};
use std::os::unix::fs::PermissionsExt;
use std::process::Command;

/// A `curl` that lists the notes that are there, and notes what it is to send.
const CURL: &str = "#!/bin/sh\nfor a in \"$@\"; do last=$a; done\ncase \"$*\" in\n\
                    *-X*) echo \"$@\" | sed 's/.* -X \\([A-Z]*\\) .* /\\1 /' > \"$NOTED\"; cat review.md > \"$NOTED.body\" ;;\n\
                    *) printf '%s' \"$NOTES\" ;;\nesac\n";

/// The commands of the job's script.
fn recipe() -> Vec<String> {
    let page = project::read(&book::source().join("guide/reviewing.md"));
    let (_, job) = page.split_once("  image: python:3\n").expect("the job is there");
    let (_, script) = job.split_once("  script:\n").expect("it has a script");
    let (script, _) = script.split_once("```").expect("it ends");
    let mut commands: Vec<String> = Vec::new();
    for line in script.lines().map(str::trim) {
        match line.strip_prefix("- ") {
            _ if line.starts_with('#') => {}
            Some(">-") => commands.push(String::new()),
            Some(command) => commands.push(command.to_owned()),
            None => {
                let command = commands.last_mut().expect("a command goes on");
                if !command.is_empty() {
                    command.push(' ');
                }
                command.push_str(line);
            }
        }
    }
    commands
}

/// What was sent where, and the note.
fn posted(notes: &str) -> (String, String) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (bin, repository) = (folder.path().join("bin"), folder.path().join("repository"));
    for made in [&bin, &repository] {
        std::fs::create_dir(made).expect("a folder");
    }
    let ladder = format!("#!/bin/sh\nexec {} \"$@\"\n", env!("CARGO_BIN_EXE_ladder"));
    for (name, script) in [("curl", CURL), ("pip", "#!/bin/sh\n"), ("ladder", &ladder)] {
        std::fs::write(bin.join(name), script).expect("it is written");
        std::fs::set_permissions(bin.join(name), PermissionsExt::from_mode(0o755)).expect("it can be run");
    }
    let commands = format!(
        "set -e\ngit init -q -b main . && git config user.name t && git config user.email t@example.com\n\
         echo '+--[ ]( a )--( )( x )--+' > p.clad && git add -A && git commit -qm old\n\
         export CI_MERGE_REQUEST_DIFF_BASE_SHA=$(git rev-parse HEAD)\n\
         echo '+--[/]( a )--( )( x )--+' > p.clad\n{}\n",
        recipe().join("\n")
    );
    let path = std::env::var("PATH").unwrap_or_default();
    let noted = folder.path().join("noted");
    let output = Command::new("sh")
        .args(["-c", &commands])
        .current_dir(&repository)
        .env("PATH", format!("{}:{path}", bin.display()))
        .envs([
            ("GIT_CONFIG_GLOBAL", "/dev/null"),
            ("GIT_CONFIG_SYSTEM", "/dev/null"),
        ])
        .envs([
            ("CI_API_V4_URL", "https://gitlab.example/api/v4"),
            ("CI_PROJECT_ID", "3"),
        ])
        .envs([
            ("CI_MERGE_REQUEST_IID", "7"),
            ("LADDER_TOKEN", "t"),
            ("NOTES", notes),
        ])
        .env("NOTED", &noted)
        .output()
        .expect("sh runs");
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap_or_default();
    (read("noted").trim().to_owned(), read("noted.body"))
}

#[test]
fn the_first_run_posts_a_note() {
    let (asked, note) = posted(r#"[{"id": 5, "body": "who wrote <!-- ladder review --> here"}]"#);
    assert_eq!(
        asked,
        "POST https://gitlab.example/api/v4/projects/3/merge_requests/7/notes"
    );
    assert!(
        note.starts_with("<!-- ladder review -->\n### `p.clad`\n\n1 edited\n"),
        "{note}"
    );
}

#[test]
fn the_note_of_an_earlier_run_is_updated() {
    let (asked, _) = posted(
        r#"[{"id": 5, "body": "hello"}, {"id": 6, "body": "<!-- ladder review -->\nold"}, {"id": 8, "body": "<!-- ladder review -->\nolder"}]"#,
    );
    assert_eq!(
        asked,
        "PUT https://gitlab.example/api/v4/projects/3/merge_requests/7/notes/6"
    );
}
