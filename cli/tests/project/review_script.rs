//! What the action for GitHub posts: its script, with git, and with a `gh` that writes down what it is asked.

use ladder_tests::project;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::Command;

const BASE: &str = "+--[ ]( a )--( )( x )--+\n";

/// A `gh` that notes its arguments and the comment. `earlier` is the number of a comment that is there; without a right to
/// write it fails.
const GH: &str = "#!/bin/sh\necho \"$@\" | sed 's,@.*/,@,' >> \"$NOTED\"\ncase \"$*\" in\n*--paginate*) echo $EARLIER ;;\n\
                  *) [ \"$MAY_WRITE\" = 1 ] || exit 1; for a in \"$@\"; do case $a in body=@*) cat \"${a#body=@}\" > \"$NOTED.body\" ;; esac; done ;;\nesac\n";

struct Posted {
    status: Option<i32>,
    told: String,
    summary: String,
    asked: String,
    comment: String,
}

fn posted(new: &str, earlier: &str, may_write: bool) -> Posted {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let noted = folder.path().join("noted");
    let bin = folder.path().join("bin");
    let repository = folder.path().join("repository");
    for made in [&bin, &repository] {
        std::fs::create_dir(made).expect("a folder");
    }
    let gh = bin.join("gh");
    std::fs::write(&gh, GH).expect("gh is written");
    std::fs::set_permissions(&gh, PermissionsExt::from_mode(0o755)).expect("gh can be run");
    let script = project::root().join("packages/review");
    let commands = format!(
        "set -e\ngit init -q -b main . && git config user.name t && git config user.email t@example.com\n\
         mkdir plant && printf '%s' \"$OLD\" > plant/p.clad && git add -A && git commit -qm old\n\
         base=$(git rev-parse HEAD)\n\
         printf '%s' \"$NEW\" > plant/p.clad && git add -A && git commit -qm new --allow-empty\n\
         cd plant\n{} {} \"$base\" 7\n",
        script.display(),
        env!("CARGO_BIN_EXE_ladder"),
    );
    let path = std::env::var("PATH").unwrap_or_default();
    let output = Command::new("sh")
        .args(["-c", &commands])
        .current_dir(&repository)
        .env("PATH", format!("{}:{path}", bin.display()))
        .env("GIT_CONFIG_GLOBAL", "/dev/null")
        .env("GIT_CONFIG_SYSTEM", "/dev/null")
        .env("GITHUB_STEP_SUMMARY", folder.path().join("summary"))
        .env("GITHUB_REPOSITORY", "someone/plant")
        .envs([("OLD", BASE), ("NEW", new), ("EARLIER", earlier)])
        .env("MAY_WRITE", if may_write { "1" } else { "0" })
        .env("NOTED", &noted)
        .output()
        .expect("sh runs");
    let read = |path: &Path| std::fs::read_to_string(path).unwrap_or_default();
    Posted {
        status: output.status.code(),
        told: String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned(),
        summary: read(&folder.path().join("summary")),
        asked: read(&noted),
        comment: read(&folder.path().join("noted.body")),
    }
}

fn edited() -> String {
    BASE.replace("[ ]", "[/]")
}

#[test]
fn a_comment_and_the_summary() {
    let posted = posted(&edited(), "", true);
    assert_eq!(posted.status, Some(0), "{}", posted.told);
    assert!(
        posted.summary.starts_with("### `p.clad`\n\n1 edited\n"),
        "{}",
        posted.summary
    );
    assert_eq!(
        posted.comment,
        format!("<!-- ladder review -->\n{}", posted.summary)
    );
    let last = posted.asked.lines().last();
    assert_eq!(
        last,
        Some("api --method POST repos/someone/plant/issues/7/comments --field body=@comment")
    );
}

#[test]
fn a_comment_that_is_there_is_updated() {
    for new in [&edited(), BASE] {
        let posted = posted(new, "42", true);
        assert_eq!(posted.status, Some(0), "{}", posted.told);
        let last = posted.asked.lines().last();
        assert_eq!(
            last,
            Some("api --method PATCH repos/someone/plant/issues/comments/42 --field body=@comment")
        );
    }
}

#[test]
fn nothing_is_said_of_nothing_and_a_fork_has_the_summary() {
    let same = posted(BASE, "", true);
    assert_eq!((same.status, same.comment.as_str()), (Some(0), ""));
    let fork = posted(&edited(), "", false);
    assert_eq!(fork.status, Some(0), "{}", fork.told);
    assert!(fork.summary.contains("1 edited") && fork.told.contains("pull-requests: write"));
}
