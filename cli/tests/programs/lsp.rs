//! `ladder lsp`: that it is there; the server's own tests speak with it at length.

use crate::harness::Folder;

#[test]
fn it_answers_and_ends_as_the_protocol_asks() {
    let message = |body: &str| format!("Content-Length: {}\r\n\r\n{body}", body.len());
    let initialize =
        message(r#"{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}"#);
    let shutdown = message(r#"{"jsonrpc":"2.0","id":2,"method":"shutdown"}"#);
    let exit = message(r#"{"jsonrpc":"2.0","method":"exit"}"#);
    let folder = Folder::with(&[]);
    let ladder = env!("CARGO_BIN_EXE_ladder");

    let session = format!("{initialize}{shutdown}{exit}");
    for arguments in [&["lsp"][..], &["lsp", "--stdio"]] {
        let run = folder.run(ladder, arguments, session.as_bytes(), &[]);
        assert_eq!(run.status, Some(0), "{run}");
        assert!(run.stdout.contains(r#""capabilities":"#), "{run}");
    }
    let abrupt = folder.run(ladder, &["lsp"], (initialize + &exit).as_bytes(), &[]);
    assert_eq!(abrupt.status, Some(1), "{abrupt}");
}
