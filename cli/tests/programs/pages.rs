//! `ladder completions` and `ladder man`

use crate::harness::Folder;
use expect_test::expect;

#[test]
fn every_shell_has_completions() {
    let folder = Folder::with(&[]);
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = folder.ladder(&["completions", shell]);
        assert_eq!((run.status, run.stderr.as_str()), (Some(0), ""), "{shell}");
        for word in ["check", "stdin-filename"] {
            assert!(run.stdout.contains(word), "{shell} does not complete {word}");
        }
        let run = folder.ladder(&["completions", shell, "--program", "ldfmt"]);
        assert!(
            run.stdout.contains("ldfmt") && run.stdout.contains("force-exclude"),
            "{shell}"
        );
    }
    let run = folder.ladder(&["completions", "dos"]);
    assert_eq!(run.status, Some(2));
}

/// What bash offers for words of which the last is being typed.
#[cfg(unix)]
fn offered(words: &[&str]) -> String {
    use std::io::Write;
    use std::process::{Command, Stdio};

    let folder = Folder::with(&[]);
    let script = folder.ladder(&["completions", "bash"]).stdout;
    let ask = format!(
        "{script}\nCOMP_WORDS=({words})\nCOMP_CWORD={last}\n_ladder ladder '{typed}' '{before}'\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"\n",
        words = words
            .iter()
            .map(|word| format!("'{word}'"))
            .collect::<Vec<_>>()
            .join(" "),
        last = words.len() - 1,
        typed = words[words.len() - 1],
        before = words[words.len() - 2],
    );
    let mut bash = Command::new("bash")
        .args(["--norc", "--noprofile"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    bash.stdin.take().unwrap().write_all(ask.as_bytes()).unwrap();
    let output = bash.wait_with_output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

#[cfg(unix)]
#[test]
fn bash_completes() {
    expect!["check\n"].assert_eq(&offered(&["ladder", "che"]));
    expect!["--format\n--force-exclude\n"].assert_eq(&offered(&["ladder", "check", "--fo"]));
    expect!["sarif\n"].assert_eq(&offered(&["ladder", "check", "--format", "sa"]));
    expect!["double-coil\n"].assert_eq(&offered(&["ladder", "explain", "doub"]));
}

#[test]
fn manual_pages() {
    let folder = Folder::with(&[]);
    let run = folder.ladder(&["man", "-o", "man/man1"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert_eq!(run.stdout, "");
    let mut pages: Vec<String> = std::fs::read_dir(folder.path("man/man1"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    pages.sort();
    expect![[r#"
        ladder-check.1
        ladder-completions.1
        ladder-convert.1
        ladder-dap.1
        ladder-diff.1
        ladder-explain.1
        ladder-fmt.1
        ladder-git.1
        ladder-lsp.1
        ladder-man.1
        ladder-mcp.1
        ladder-merge.1
        ladder-new.1
        ladder-online.1
        ladder-prove.1
        ladder-render.1
        ladder-run.1
        ladder-sim.1
        ladder-tags.1
        ladder-test.1
        ladder-tree.1
        ladder-why.1
        ladder.1
        ldfmt.1"#]]
    .assert_eq(&pages.join("\n"));
    let page = folder.read("man/man1/ladder-explain.1");
    assert_eq!(folder.ladder(&["man", "explain"]).stdout, page);
    assert_eq!(folder.ladder(&["man", "ladder-explain"]).stdout, page);
    expect![[r#"
        .ie \n(.g .ds Aq \(aq
        .el .ds Aq '
        .TH LADDER-EXPLAIN 1  "ladder 0.1.0" Ladder
        .ie \n(.g .ds Aq \(aq
        .el .ds Aq '
        .SH NAME
        ladder\-explain \- Show what a rule is about, or how an instruction works
        .ie \n(.g .ds Aq \(aq
        .el .ds Aq '
        .SH SYNOPSIS
        \fBladder explain\fR [\fB\-h\fR|\fB\-\-help\fR] [\fIRULE\-OR\-INSTRUCTION\fR] [\fIPROGRAM\fR] 
        .ie \n(.g .ds Aq \(aq
        .el .ds Aq '
        .SH DESCRIPTION
        Show what a rule is about, or how an instruction works
        .PP
        Of a rule: what is wrong, a rung that has it and one that does not, and what to do. Of an instruction: its operands, what it does, what power leaves it, and a rung that shows it. Of a block of a program: its operands with their types. Without a name: what there is.
        .ie \n(.g .ds Aq \(aq
        .el .ds Aq '
        .SH OPTIONS
        .TP
        \fB\-h\fR, \fB\-\-help\fR
        Print help (see a summary with \*(Aq\-h\*(Aq)
        .TP
        [\fIRULE\-OR\-INSTRUCTION\fR]
        The name of a rule, of an instruction with its brackets or without, or of a block of a program
        .TP
        [\fIPROGRAM\fR]
        The program whose block is explained; without it those in this folder are searched
        .ie \n(.g .ds Aq \(aq
        .el .ds Aq '
        .SH EXAMPLES
        .nf
          ladder explain                    all instructions and rules, a line each
          ladder explain TON                an instruction
          ladder explain double\-coil        a rule: a finding shows its name in brackets
          ladder explain \*(Aq[/]\*(Aq              the quotes keep the shell from the brackets
          ladder explain \*(Aq$Alarm\*(Aq           a block of the programs in this folder
          ladder explain \*(Aq$Alarm\*(Aq plant.clad
                                            of this program or its workspace
          ladder explain \*(Aq( S )\*(Aq            the coil, where a name means several things
        .fi
        .SH "EXIT STATUS"
        0 fine, 2 nothing has this name.
        .ie \n(.g .ds Aq \(aq
        .el .ds Aq '
        .SH "SEE ALSO"
        \fBladder\fR(1)
    "#]].assert_eq(&page);
    assert_eq!(folder.ladder(&["man"]).stdout, folder.read("man/man1/ladder.1"));
    folder
        .ladder(&["man", "chekc"])
        .refused_with("there is no command `chekc`; `ladder help` lists the commands");
    folder.write("file", b"");
    assert_eq!(folder.ladder(&["man", "-o", "file"]).status, Some(2));
}
