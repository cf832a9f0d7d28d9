//! How far back is gone for an answer.

use crate::simulation::{Options, Simulation};
use crate::{HistoryLimits, Session};
use expect_test::{Expect, expect};
use ladder_analysis::value::Value;
use std::fmt::Write;

/// A motor that is started in scan 3 and one that never is, behind so many rungs in which something changes all the time.
fn run(rungs: usize, scans: u64, limits: HistoryLimits) -> Session {
    let mut text = String::new();
    for rung in 0..rungs {
        let _ = writeln!(text, "+--[/]( b{rung} )--( )( b{rung} )--+");
    }
    text.push_str("+--[ ]( start )--(S)( run )--+\n+--[ ]( never )--( )( idle )--+\n");
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&text).into(), "test.clad");
    let program = analysis.program().cloned().unwrap();
    let mut session = Session::of(Simulation::new(program, Options::default()).unwrap(), limits);
    let start = session.simulation().resolve("start").unwrap();
    for scan in 0..scans {
        if scan == 3 {
            session.set(&start, Value::Bool(true)).unwrap();
        }
        session.scan();
    }
    session
}

/// How many scans are gone back over, for each tag.
fn check(limits: HistoryLimits, expected: Expect) {
    let mut shown = String::new();
    for (rungs, scans) in [(1, 400), (1, 800), (1, 4000), (200, 4000)] {
        let mut session = run(rungs, scans, limits);
        let _ = write!(
            shown,
            "{rungs} rungs, {scans} scans, {} kept:",
            session.scans_behind()
        );
        for tag in ["idle", "never", "run", "b0"] {
            let point = session.simulation().resolve(tag).unwrap();
            let _ = write!(shown, " {tag} {}", session.inquire(&point).1);
        }
        shown.push('\n');
    }
    expected.assert_eq(&shown);
}

#[test]
fn nothing_is_gone_over_for_what_has_not_changed() {
    check(
        HistoryLimits::default(),
        expect![[r#"
            1 rungs, 400 scans, 400 kept: idle 1 never 0 run 397 b0 2
            1 rungs, 800 scans, 800 kept: idle 1 never 0 run 797 b0 2
            1 rungs, 4000 scans, 4000 kept: idle 1 never 0 run 3997 b0 2
            200 rungs, 4000 scans, 4000 kept: idle 1 never 0 run 3997 b0 2
        "#]],
    );
}

#[test]
fn scans_that_are_kept_are_not_gone_over_for_what_changed_before_them() {
    check(
        HistoryLimits::of_scans(300),
        expect![[r#"
            1 rungs, 400 scans, 300 kept: idle 1 never 0 run 600 b0 2
            1 rungs, 800 scans, 300 kept: idle 1 never 0 run 1 b0 2
            1 rungs, 4000 scans, 300 kept: idle 1 never 0 run 1 b0 2
            200 rungs, 4000 scans, 300 kept: idle 1 never 0 run 1 b0 2
        "#]],
    );
}
