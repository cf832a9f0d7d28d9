//! `ladder tree`

use crate::harness::Folder;
use expect_test::expect;

#[test]
fn the_tree_of_a_rung_and_its_errors() {
    let folder = Folder::with(&[("a.clad", "+--[ ]( a\n")]);
    expect![[r#"
        exit status 0
        -- stdout
        SOURCE_FILE@0..10
          RUNG@0..10
            RAIL_CONNECTOR@0..1 "+"
            WIRE@1..3 "--"
            LOGICAL_BLOCK@3..9
              BLOCK_HEAD@3..6
                L_BRACKET@3..4 "["
                WHITESPACE@4..5 " "
                R_BRACKET@5..6 "]"
              OPERAND_LIST@6..9
                L_PAREN@6..7 "("
                WHITESPACE@7..8 " "
                NAME_EXPR@8..9
                  IDENT@8..9 "a"
            NEWLINE@9..10 "\n"
        error@6..9 UnclosedBlock { closing: R_PAREN }
    "#]]
    .assert_eq(&folder.ladder(&["tree", "a.clad"]).to_string());
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_error() {
    use std::io::Read;
    use std::process::Stdio;

    let folder = Folder::with(&[("a.clad", &"+--[ ]( a )--( )( b )--+\n".repeat(2_000))]);
    let mut child = folder
        .command(env!("CARGO_BIN_EXE_ladder"), &["tree", "a.clad"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut first = [0; 11];
    child.stdout.take().unwrap().read_exact(&mut first).unwrap();
    assert_eq!(&first, b"SOURCE_FILE");
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
}
