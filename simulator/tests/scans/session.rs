//! Sessions: going back to earlier scans and forward again, whatever the program does.

use crate::support::simulation;
use ladder_analysis::Cancel;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::value_text::cell;
use ladder_simulator::{HistoryLimits, Options, Point, Session, Status, Stop};
use std::path::{Path, PathBuf};

/// Numbers that look random and are the same in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % sides
    }
}

fn session(text: &str, limits: HistoryLimits) -> Session {
    Session::of(simulation(text), limits)
}

fn point(session: &Session, name: &str) -> Point {
    session
        .simulation()
        .resolve(name)
        .unwrap_or_else(|error| panic!("{error}"))
}

fn set(session: &mut Session, name: &str, high: bool) {
    let point = point(session, name);
    session.set(&point, Value::Bool(high)).unwrap();
}

fn get(session: &Session, name: &str) -> String {
    let point = point(session, name);
    cell(&session.simulation().value(&point), point.ty)
}

/// Everything that a session shows.
#[derive(Debug, Clone, PartialEq)]
struct Seen {
    scans: u64,
    time: i64,
    status: Status,
    values: Vec<Value>,
    power: Vec<bool>,
    forced: Vec<String>,
    faults: Vec<String>,
    serial: Vec<u8>,
}

fn see(session: &Session, points: &[Point]) -> Seen {
    let simulation = session.simulation();
    Seen {
        scans: simulation.scans(),
        time: simulation.time(),
        status: simulation.status(),
        values: points.iter().map(|point| simulation.value(point)).collect(),
        power: simulation.power().map(|(_, _, on)| on).collect(),
        forced: simulation.forced().map(|point| point.name.clone()).collect(),
        faults: session
            .faults()
            .iter()
            .map(|fault| format!("{fault:?}"))
            .collect(),
        serial: session.serial(),
    }
}

/// Everything that has a name: scalars, members, elements of small arrays.
fn all_points(session: &Session) -> Vec<Point> {
    let simulation = session.simulation();
    let mut points = simulation.points().to_vec();
    for tag in &simulation.program().tags {
        for part in [
            "Q", "ET", "PT", "IN", "CV", "PV", "CU", "CD", "R", "LD", "QU", "QD", "Q1", "TT", "CC",
        ] {
            points.extend(simulation.resolve(&format!("{}.{part}", tag.name)));
        }
        for index in -3..20 {
            points.extend(simulation.resolve(&format!("{}[{index}]", tag.name)));
        }
    }
    points.extend(
        ["SYS.SCAN", "SYS.TIME", "SYS.FAULT", "SYS.SCAN_TIME"].map(|name| simulation.resolve(name).unwrap()),
    );
    points
}

/// What is given from outside before a scan.
#[derive(Debug, Clone)]
enum Given {
    Set(Point, Value),
    Force(Point, Value),
    Unforce(Point),
    UnforceAll,
    Serial(u8),
}

fn give(session: &mut Session, all: &[Given]) {
    for given in all {
        match given {
            Given::Set(point, value) => session.set(point, value.clone()).unwrap(),
            // Bits, and members of timers and blocks, take no force.
            Given::Force(point, value) => drop(session.force(point, value.clone())),
            Given::Unforce(point) => session.unforce(point),
            Given::UnforceAll => session.unforce_all(),
            Given::Serial(byte) => session.feed_serial(&[*byte]),
        }
    }
}

fn throw(dice: &mut Dice, points: &[Point]) -> Vec<Given> {
    let mut all = Vec::new();
    for point in points.iter().filter(|point| !point.read_only) {
        let value = match point.ty {
            Scalar::Bool => Value::Bool(dice.roll(2) == 1),
            Scalar::Real | Scalar::Lreal => Value::Real(dice.roll(9) as f64 - 2.5),
            Scalar::Time => Value::Int(dice.roll(50) as i64 * 1_000_000),
            ty if ty.is_string() => Value::Text(format!("{}", dice.roll(99)).into_bytes().into()),
            ty if ty.is_date() => continue,
            Scalar::Enum(id) => {
                let values = &id.get().values;
                Value::Int(i64::from(values[dice.roll(values.len() as u64) as usize].1))
            }
            _ => Value::Int(dice.roll(5) as i64),
        };
        match (point.role, dice.roll(40)) {
            (Role::Input, 0..12) => all.push(Given::Set(point.clone(), value)),
            (_, 12) => all.push(Given::Set(point.clone(), value)),
            (_, 13) => all.push(Given::Force(point.clone(), value)),
            (_, 14..17) => all.push(Given::Unforce(point.clone())),
            _ => {}
        }
    }
    match dice.roll(30) {
        0 => all.push(Given::UnforceAll),
        1..4 => all.push(Given::Serial(dice.roll(256) as u8)),
        _ => {}
    }
    all
}

/// Runs a program with random inputs, walks about in its history, and compares every stop with what was seen there
/// the first time.
fn walk_about(name: &str, text: &str, seed: u64) {
    const SCANS: usize = 40;
    let mut dice = Dice(seed);
    let mut session = session(text, HistoryLimits::default());
    let points = all_points(&session);
    let inputs = session.simulation().points().to_vec();
    let mut seen = vec![see(&session, &points)];
    let mut given = Vec::new();
    for _ in 0..SCANS {
        let all = throw(&mut dice, &inputs);
        give(&mut session, &all);
        session.scan();
        given.push(all);
        seen.push(see(&session, &points));
        if session.simulation().status() != Status::Ready {
            break;
        }
    }
    let last = seen.len() - 1;
    let mut at = last;
    for step in 0..60 {
        let context = |at: usize| format!("{name}, seed {seed}, step {step}, after {at} scans");
        match dice.roll(8) {
            // Part of a scan, which is then finished or given up.
            5..8 => {
                for _ in 0..=dice.roll(4) {
                    if dice.roll(2) == 0 {
                        session.step_block();
                    } else {
                        session.step_network();
                    }
                    if !session.is_open() {
                        break;
                    }
                }
                if session.is_open() && dice.roll(2) == 0 {
                    session.step_back(1);
                    assert_eq!(see(&session, &points), seen[at], "{}", context(at));
                } else if session.simulation().status() == Status::Ready || at < last {
                    if session.is_open() {
                        session.scan();
                    }
                    // Beyond what was run before there is nothing to compare with.
                    if at == last {
                        session.step_back(1);
                        session.forget_ahead();
                    } else {
                        at += 1;
                    }
                }
            }
            0 => {
                let wanted = dice.roll(last as u64 + 3);
                let is_kept = wanted <= last as u64;
                assert_eq!(session.go_to(wanted), is_kept, "{}", context(at));
                at = if is_kept { wanted as usize } else { at };
            }
            1 => {
                let wanted = dice.roll(12) as usize;
                let gone = session.step_back(wanted);
                assert_eq!(gone, wanted.min(at), "{}", context(at));
                at -= gone;
            }
            2 | 3 if at < last => {
                session.scan();
                at += 1;
            }
            // The same inputs once more, for real: whatever lies ahead is forgotten first.
            _ if at < last => {
                assert_eq!(session.scans_ahead(), last - at, "{}", context(at));
                session.feed_serial(&[7]);
                assert_eq!(session.scans_ahead(), 0);
                assert_eq!(session.step_back(1), at.min(1));
                at = at.saturating_sub(1);
                if at == 0 && session.scans_behind() == 0 {
                    // The byte is still there before the first scan.
                    break;
                }
                for all in &given[at..] {
                    // Forgets the byte and the scan that is still kept.
                    session.forget_ahead();
                    give(&mut session, all);
                    session.scan();
                    at += 1;
                    assert_eq!(see(&session, &points), seen[at], "{}", context(at));
                }
            }
            _ => {}
        }
        // Asking changes nothing.
        let why = session.why(&points[dice.roll(points.len() as u64) as usize]);
        assert!(!why.text(&[text], &[]).is_empty());
        assert_eq!(see(&session, &points), seen[at], "{}", context(at));
        assert_eq!(session.scans_behind(), at, "{}", context(at));
        let past = session.past(&points, 5);
        for back in 0..at.min(5) {
            let values: Vec<&Value> = past.iter().map(|values| &values[at.min(5) - 1 - back]).collect();
            assert_eq!(
                values,
                seen[at - back].values.iter().collect::<Vec<_>>(),
                "{}",
                context(at)
            );
        }
        let future = session.future(&points);
        for ahead in 0..session.scans_ahead() {
            let values: Vec<&Value> = future.iter().map(|values| &values[ahead]).collect();
            let then = &seen[at + 1 + ahead].values;
            assert_eq!(values, then.iter().collect::<Vec<_>>(), "{}", context(at));
        }
    }
}

fn programs_in(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "clad"))
        .collect();
    files.sort();
    assert!(!files.is_empty());
    files
}

#[test]
fn every_instruction_goes_back_and_forward() {
    for row in ladder_instructions::TABLE {
        for seed in 0..3 {
            walk_about(row.block().as_ref(), row.example, seed);
        }
    }
}

#[test]
fn whole_programs_go_back_and_forward() {
    for folder in ["../examples", "../tests/corpus/semantics"] {
        for path in programs_in(folder) {
            let text = std::fs::read_to_string(&path).unwrap();
            for seed in 0..2 {
                walk_about(&path.display().to_string(), &text, seed);
            }
        }
    }
}

const COUNT: &str =
    "VAR_INPUT x : BOOL; END_VAR\nVAR n : DINT; END_VAR\n+--[ADD]( n, n, 1 )--[ ]( x )--( )( y )--+\n";

#[test]
fn what_was_given_is_given_again() {
    let mut session = session(COUNT, HistoryLimits::default());
    session.scan();
    set(&mut session, "x", true);
    session.scan();
    session.scan();
    assert_eq!(session.step_back(2), 2);
    assert_eq!((get(&session, "x"), get(&session, "y")), ("0".into(), "0".into()));
    session.scan();
    assert_eq!((get(&session, "x"), get(&session, "y")), ("1".into(), "1".into()));
    assert_eq!(session.scans_ahead(), 1);
}

#[test]
fn what_waits_for_the_next_scan_waits_again() {
    let mut session = session(COUNT, HistoryLimits::default());
    session.scan();
    session.scan();
    set(&mut session, "x", true);
    let x = point(&session, "x");
    let n = point(&session, "n");
    session.force(&n, Value::Int(50)).unwrap();
    session.step_back(1);
    assert_eq!(
        (get(&session, "x"), session.simulation().is_forced(&n)),
        ("0".into(), false)
    );
    session.scan();
    assert_eq!(
        (get(&session, "x"), get(&session, "n")),
        ("1".into(), "50".into())
    );
    assert!(session.simulation().is_forced(&n));
    session.scan();
    assert_eq!(
        (get(&session, "y"), get(&session, "n")),
        ("1".into(), "50".into())
    );
    assert_eq!(
        session.past(&[x, n], 9),
        [
            vec![Value::Bool(false), Value::Bool(false), Value::Bool(true)],
            vec![Value::Int(1), Value::Int(2), Value::Int(50)],
        ]
    );
}

#[test]
fn something_else_in_the_past_makes_another_future() {
    let mut session = session(COUNT, HistoryLimits::default());
    for _ in 0..5 {
        session.scan();
    }
    session.step_back(3);
    // The same value again changes nothing.
    set(&mut session, "x", false);
    assert_eq!(session.scans_ahead(), 3);
    set(&mut session, "x", true);
    assert_eq!(session.scans_ahead(), 0);
    session.scan();
    assert_eq!((get(&session, "n"), get(&session, "y")), ("3".into(), "1".into()));
    session.step_back(1);
    assert_eq!((get(&session, "n"), get(&session, "y")), ("2".into(), "0".into()));
}

#[test]
fn the_history_is_bounded_by_scans_and_by_bytes() {
    let mut session = session(
        COUNT,
        HistoryLimits {
            scans: 7,
            bytes: 1 << 20,
        },
    );
    for _ in 0..20 {
        session.scan();
    }
    assert_eq!(session.step_back(100), 7);
    assert_eq!(get(&session, "n"), "13");
    assert_eq!(session.past(&[point(&session, "n")], 9), [[Value::Int(13)]]);

    let mut session = Session::of(
        simulation(COUNT),
        HistoryLimits {
            scans: 1000,
            bytes: 2000,
        },
    );
    for _ in 0..1000 {
        session.scan();
    }
    assert!(session.history_size() <= 2000, "{}", session.history_size());
    let kept = session.scans_behind();
    assert!((5..100).contains(&kept), "{kept}");
    assert_eq!(session.step_back(1000), kept);
    assert_eq!(get(&session, "n"), (1000 - kept).to_string());
    assert_eq!(session.step_back(1), 0);

    let mut session = Session::of(simulation(COUNT), HistoryLimits::of_scans(0));
    session.scan();
    assert_eq!((session.step_back(1), get(&session, "n")), (0, "1".into()));
    assert_eq!(session.past(&[point(&session, "n")], 9), [[]]);
}

#[test]
fn a_scan_that_is_kept_allocates_nothing_once_there_is_room() {
    let mut session = session(
        "VAR_INPUT a : BOOL; END_VAR\nVAR t : TON; s : STRING; n : INT; END_VAR\n\
         +--[NOT]--[ ]( SYS.ON )--( )( z )--+\n+--\\--[ ]( a )--\\--[TON]( t, T#30ms )--( )( y )--+\n\
         |  /--[ ]( y )--/\n+--[ADD]( n, n, 1 )--[TYP]( s, n )--[USND]( n )--+\n",
        HistoryLimits {
            scans: 64,
            bytes: 1 << 20,
        },
    );
    let a = point(&session, "a");
    let mut run = |scans| {
        for scan in 0..scans {
            session.set(&a, Value::Bool(scan % 7 == 0)).unwrap();
            session.scan();
        }
    };
    run(70_000);
    let info = allocation_counter::measure(|| run(1000));
    assert_eq!(info.count_total, 0);
}

#[test]
fn a_run_says_why_it_stopped() {
    let never = Cancel::default();
    let mut counting = session(COUNT, HistoryLimits::default());
    assert_eq!(counting.run(5, &never), (5, Stop::Done));
    assert_eq!(counting.run(5, &Cancel::when(|| true)), (0, Stop::Cancelled));
    let ending = "VAR n : DINT; END_VAR\n+--[ADD]( n, n, 1 )--[GE]( n, 3 )--<END>--+\n";
    let mut ending = session(ending, HistoryLimits::default());
    assert_eq!(ending.run(9, &never), (3, Stop::Ended));
    assert_eq!(ending.step_back(1), 1);
    assert_eq!(ending.simulation().status(), Status::Ready);
    assert_eq!(ending.run(9, &never), (1, Stop::Ended));
    let hanging = "+--<LBL>( again )--<JMP>( again )--+\n";
    let mut hanging = Session::of(
        crate::support::simulation_with(
            hanging,
            Options {
                watchdog: 100,
                ..Options::default()
            },
        ),
        HistoryLimits::default(),
    );
    assert_eq!(hanging.run(9, &never), (0, Stop::Faulted));
    assert_eq!(hanging.faults().len(), 1);
    assert_eq!(hanging.step_back(1), 1);
    assert_eq!(
        (hanging.simulation().status(), hanging.faults().len()),
        (Status::Ready, 0)
    );
}

#[test]
fn a_restart_begins_the_history_again() {
    let mut session = session(
        "VAR RETAIN kept : DINT; END_VAR\nVAR n : DINT; END_VAR\n+--[ADD]( n, n, 1 )--[ADD]( kept, kept, 1 )--+\n",
        HistoryLimits::default(),
    );
    for _ in 0..5 {
        session.scan();
    }
    session.warm_restart();
    assert_eq!(
        (get(&session, "n"), get(&session, "kept")),
        ("0".into(), "5".into())
    );
    assert_eq!((session.scans_behind(), session.step_back(1)), (0, 0));
    session.scan();
    session.reset();
    assert_eq!(
        (get(&session, "n"), get(&session, "kept")),
        ("0".into(), "0".into())
    );
    assert_eq!(session.simulation().scans(), 0);
}
