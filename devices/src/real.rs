//! The loop: scan after scan, in real time.

use crate::lateness::Report;
use crate::pace::Pace;
use crate::stuck::Scanning;
use ladder_analysis::Cancel;
use ladder_simulator::{Simulation, Status, real_time};
use std::sync::mpsc::{Receiver, RecvTimeoutError, TryRecvError};
use std::time::{Duration, Instant};

/// What a run is asked for from outside.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Asked {
    /// To end after the scan that runs.
    End,
    /// How it has been so far.
    Report,
    /// To take the program as it is in its file now.
    Reload,
}

/// Why a run came to an end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// It was asked to.
    Asked,
    /// It was asked to take the program again.
    Reload,
    /// The program ended with `<END>`.
    Program,
    /// A fault stopped it.
    Fault,
    /// A scan took longer than it may.
    TooLong(Duration),
}

/// What happens between scans.
pub trait Between {
    /// Before each scan: what comes from outside is given to the program.
    fn before(&mut self, simulation: &mut Simulation);
    /// After each scan that came to its end.
    fn after(&mut self, simulation: &mut Simulation);
    /// It is asked how the run has been so far.
    fn report(&mut self, report: &Report);
}

/// Runs scans at their times until something ends them. `longest` is how long a scan may take, with what happens before and after it: a
/// program that takes longer is stopped within its scan. `stuck` is called, from another thread, with the time that a scan has taken
/// which has not come back after twice as long: it waits for something, and only the end of the process helps.
///
/// `SYS.SCAN_TIME` and the timers have the time that has really passed, in whole intervals: of slots that were missed, too.
pub fn run(
    simulation: &mut Simulation,
    longest: Duration,
    report: &mut Report,
    asked: &Receiver<Asked>,
    between: &mut dyn Between,
    stuck: &(dyn Fn(Duration) + Sync),
) -> Ended {
    let (scanning, cancel) = (Scanning::default(), Cancel::default());
    simulation.set_cancel(Some(cancel.clone()));
    let ended = std::thread::scope(|scope| {
        let _watched = scanning.watch(scope, longest, &cancel, stuck);
        scan_on(simulation, longest, report, asked, between, &scanning)
    });
    simulation.set_cancel(None);
    ended
}

fn scan_on(
    simulation: &mut Simulation,
    longest: Duration,
    report: &mut Report,
    asked: &Receiver<Asked>,
    between: &mut dyn Between,
    scanning: &Scanning,
) -> Ended {
    let interval = real_time(simulation.options().interval);
    let start = Instant::now();
    let mut pace = Pace::new(start, interval);
    let mut due = start;
    loop {
        if let Some(ended) = wait(due, asked, report, between) {
            return ended;
        }
        let began = Instant::now();
        report.lateness.add(began.saturating_duration_since(due));
        scanning.set(Some(began));
        between.before(simulation);
        simulation.scan();
        between.after(simulation);
        scanning.set(None);
        let took = began.elapsed();
        report.scan_times.add(took);
        report.scans += 1;
        match simulation.status() {
            Status::Faulted if took > longest => return Ended::TooLong(took),
            Status::Faulted => return Ended::Fault,
            Status::Ended => return Ended::Program,
            Status::Ready => {}
        }
        if took > longest {
            return Ended::TooLong(took);
        }
        let next = pace.next(Instant::now());
        report.missed += next.missed;
        simulation.pass(next.missed);
        due = next.at;
    }
}

/// Waits for a time, and does meanwhile what is asked for. What ends the run, if anything does.
fn wait(due: Instant, asked: &Receiver<Asked>, report: &Report, between: &mut dyn Between) -> Option<Ended> {
    loop {
        let left = due.saturating_duration_since(Instant::now());
        let next = if left.is_zero() {
            // Who is late all the time hears what it is asked all the same.
            asked.try_recv().map_err(|error| match error {
                TryRecvError::Empty => RecvTimeoutError::Timeout,
                TryRecvError::Disconnected => RecvTimeoutError::Disconnected,
            })
        } else {
            asked.recv_timeout(left)
        };
        match next {
            Ok(Asked::End) => return Some(Ended::Asked),
            Ok(Asked::Reload) => return Some(Ended::Reload),
            Ok(Asked::Report) => between.report(report),
            Err(RecvTimeoutError::Timeout) => return None,
            // Nobody can ask anything any more.
            Err(RecvTimeoutError::Disconnected) => {
                std::thread::sleep(due.saturating_duration_since(Instant::now()));
                return None;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::simulation;
    use ladder_simulator::Options;
    use std::sync::mpsc;

    /// Keeps the first scan busy for a while, and asks for the end after some scans.
    struct Slow {
        busy: Duration,
        scans: u64,
        ask: mpsc::Sender<Asked>,
        reports: usize,
    }

    impl Between for Slow {
        fn before(&mut self, simulation: &mut Simulation) {
            if simulation.scans() == 0 {
                std::thread::sleep(self.busy);
            }
        }

        fn after(&mut self, simulation: &mut Simulation) {
            if simulation.scans() == self.scans {
                let _ = self.ask.send(Asked::Report);
                let _ = self.ask.send(Asked::End);
            }
        }

        fn report(&mut self, _: &Report) {
            self.reports += 1;
        }
    }

    fn ran(text: &str, busy: Duration, longest: Duration, scans: u64) -> (Ended, Report, Simulation, usize) {
        let mut simulation = simulation(text, 5_000_000);
        let (ask, asked) = mpsc::channel();
        let mut slow = Slow {
            busy,
            scans,
            ask,
            reports: 0,
        };
        let mut report = Report::default();
        let ended = run(&mut simulation, longest, &mut report, &asked, &mut slow, &|_| {});
        (ended, report, simulation, slow.reports)
    }

    const COUNTS: &str = "VAR\n    n : DINT;\nEND_VAR\n+--[ADD]( n, n, 1 )--+\n";

    #[test]
    fn what_was_missed_has_passed_for_the_program() {
        let slow = Duration::from_millis(23);
        let (ended, report, simulation, reports) = ran(COUNTS, slow, Duration::from_secs(10), 3);
        assert_eq!((ended, report.scans, reports), (Ended::Asked, 3, 1));
        // The slots at 5, 10 and 15 ms passed at least; a busy machine may miss more.
        assert!(report.missed >= 3, "{report}");
        assert_eq!(
            simulation.time(),
            i64::try_from(report.scans + report.missed).unwrap() * 5_000_000
        );
    }

    #[test]
    fn a_scan_that_takes_too_long_ends_the_run() {
        let slow = Duration::from_millis(23);
        let (ended, report, ..) = ran(COUNTS, slow, Duration::from_millis(20), 3);
        assert!(matches!(ended, Ended::TooLong(took) if took >= slow), "{ended:?}");
        assert_eq!(report.scans, 1);
    }

    #[test]
    fn a_scan_that_loops_is_stopped_within() {
        let text =
            "VAR\n    n : DINT;\nEND_VAR\n+--<FOR>( 2000000000 )--+\n+--[ADD]( n, n, 1 )--+\n+--<NEXT>--+\n";
        let options = Options {
            interval: 5_000_000,
            watchdog: 1 << 40,
        };
        let program = simulation(text, options.interval).program().clone();
        let mut simulation = Simulation::new(program, options).unwrap();
        let (_ask, asked) = mpsc::channel();
        let mut idle = Idle(Duration::ZERO);
        let mut report = Report::default();
        let longest = Duration::from_millis(40);
        let ended = run(&mut simulation, longest, &mut report, &asked, &mut idle, &|_| {});
        assert!(matches!(ended, Ended::TooLong(_)), "{ended:?}");
    }

    #[test]
    fn a_scan_that_does_not_come_back_is_told_from_another_thread() {
        let mut simulation = simulation(COUNTS, 5_000_000);
        let (_ask, asked) = mpsc::channel();
        let mut idle = Idle(Duration::from_millis(400));
        let (told, mut report) = (std::sync::Mutex::new(Vec::new()), Report::default());
        let stuck = |took: Duration| {
            told.lock()
                .unwrap()
                .push((took, std::thread::current().name().map(str::to_owned)));
        };
        let ended = run(
            &mut simulation,
            Duration::from_millis(20),
            &mut report,
            &asked,
            &mut idle,
            &stuck,
        );
        assert!(matches!(ended, Ended::TooLong(_)), "{ended:?}");
        let told = told.into_inner().unwrap();
        let [(took, thread)] = told.as_slice() else {
            panic!("{told:?}")
        };
        assert!(
            *took > Duration::from_millis(40) && thread.as_deref() == Some("watchdog"),
            "{told:?}"
        );
    }

    /// Waits before each scan.
    struct Idle(Duration);

    impl Between for Idle {
        fn before(&mut self, _: &mut Simulation) {
            std::thread::sleep(self.0);
        }

        fn after(&mut self, _: &mut Simulation) {}

        fn report(&mut self, _: &Report) {}
    }

    #[test]
    fn a_program_that_ends_ends_the_run() {
        let (ended, report, ..) = ran("+--<END>--+\n", Duration::ZERO, Duration::from_secs(10), 9);
        assert_eq!((ended, report.scans), (Ended::Program, 1));
    }
}
