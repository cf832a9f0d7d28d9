//! `$PID` against what control theory says of it.
//!
//! The plant is of first order, T·dx/dt + x = K·u. Between two scans u does not change, so the plant moves exactly by
//! x' = a·x + (1 - a)·K·u with a = exp(-dt/T): nothing here is integrated numerically, and every difference from the solution of
//! the differential equation is that of the sampled controller. It holds u for dt, so it lags by at most dt, and its integral is
//! a sum: the error is of the first order in dt. Of the sampled loop the solution is known as well, and is met to rounding.

use ladder_analysis::values::value::Value;
use ladder_analysis::{analyze, link};
use ladder_simulator::{Options, Point, Simulation};
use ladder_syntax::parse;
use std::sync::Arc;

const PROGRAM: &str = "\
VAR_INPUT sp, pv, kp, ki, kd, low, high, hand : LREAL; manual : BOOL; END_VAR
VAR_OUTPUT y : LREAL; END_VAR
+--[$PID]( sp, pv, kp, ki, kd, low, high, manual, hand, y )--+
";

/// The time constant of the plant, in seconds.
const T: f64 = 10.0;
/// Its gain.
const K: f64 = 2.0;

/// The controller with the plant.
struct Loop {
    simulation: Simulation,
    y: Point,
    /// Seconds from scan to scan.
    dt: f64,
    x: f64,
    /// What is taken from the controller's output on its way to the plant.
    load: f64,
}

impl Loop {
    fn new(dt: f64, kp: f64, ki: f64, kd: f64) -> Loop {
        let analysis = Arc::new(analyze(&Arc::new(parse(PROGRAM)), "program"));
        let program = link(&analysis, &|_| None).expect("the program is whole");
        let options = Options {
            interval: (dt * 1e9).round() as i64,
            ..Options::default()
        };
        let simulation = Simulation::new(program, options).expect("it compiles");
        let y = simulation.resolve("y").expect("a tag of the program");
        let mut made = Loop {
            simulation,
            y,
            dt,
            x: 0.0,
            load: 0.0,
        };
        let settings = [("kp", kp), ("ki", ki), ("kd", kd), ("low", -1e6), ("high", 1e6)];
        for (name, value) in settings {
            made.give(name, value);
        }
        made
    }

    fn give(&mut self, name: &str, value: f64) {
        let point = self.simulation.resolve(name).expect("a tag of the program");
        self.simulation.set(&point, Value::Real(value)).expect("an input");
    }

    fn by_hand(&mut self, manual: bool) {
        let point = self.simulation.resolve("manual").expect("a tag of the program");
        self.simulation
            .set(&point, Value::Bool(manual))
            .expect("an input");
    }

    fn output(&self) -> f64 {
        match self.simulation.value(&self.y) {
            Value::Real(y) => y,
            other => panic!("{other:?}"),
        }
    }

    /// One scan, and the plant as far as the next. The output.
    fn scan(&mut self) -> f64 {
        self.give("pv", self.x);
        assert!(self.simulation.scan());
        assert!(self.simulation.take_faults().is_empty());
        let y = self.output();
        let a = (-self.dt / T).exp();
        self.x = a * self.x + (1.0 - a) * K * (y - self.load);
        y
    }

    /// The largest difference of x from `expected`, a function of the time, over some seconds with this setpoint.
    fn farthest(&mut self, seconds: f64, sp: impl Fn(f64) -> f64, expected: impl Fn(f64) -> f64) -> f64 {
        let scans = (seconds / self.dt).round() as usize;
        let mut farthest: f64 = 0.0;
        for scan in 0..scans {
            let time = scan as f64 * self.dt;
            self.give("sp", sp(time));
            farthest = farthest.max((self.x - expected(time)).abs());
            self.scan();
        }
        farthest
    }
}

/// Equal but for rounding.
fn is_close(one: f64, other: f64) -> bool {
    (one - other).abs() < 1e-12
}

/// 1 + A·exp(s1·t) + B·exp(s2·t), where s1 and s2 are the roots of T·s² + (1 + K·kp)·s + K·ki: it is 0 at 0, and grows there
/// with `slope`.
fn second_order(kp: f64, ki: f64, slope: f64) -> impl Fn(f64) -> f64 {
    let damping = (1.0 + K * kp) / (2.0 * T);
    let square = damping * damping - K * ki / T;
    let root = square.abs().sqrt();
    move |t| {
        let (even, odd) = if square > 0.0 {
            ((root * t).cosh(), (root * t).sinh() / root)
        } else {
            ((root * t).cos(), (root * t).sin() / root)
        };
        1.0 - (-damping * t).exp() * (even + (damping - slope) * odd)
    }
}

/// A step of the setpoint to 5 with a proportional controller: x goes to 5·L/(1 + L), L = K·kp, with the time constant T/(1 + L).
#[test]
fn proportional_control_is_the_closed_form() {
    let (kp, sp) = (1.5, 5.0);
    let gain = K * kp;
    let end = sp * gain / (1.0 + gain);
    for dt in [0.1, 0.01] {
        let continuous = |t: f64| end * (1.0 - (-(1.0 + gain) * t / T).exp());
        // u is held for dt, in which x moves by at most dt·L·sp/T. That much times kp is wrong in u, and K/(1 + L) of it in x.
        let bound = dt * gain * sp / T * gain / (1.0 + gain);
        let error = Loop::new(dt, kp, 0.0, 0.0).farthest(40.0, |_| sp, continuous);
        assert!(error <= bound, "dt {dt}: {error} is more than {bound}");
        // The sampled loop: a geometric series.
        let a = (-dt / T).exp();
        let ratio: f64 = a - (1.0 - a) * gain;
        let sampled = |t: f64| end * (1.0 - ratio.powf(t / dt));
        let error = Loop::new(dt, kp, 0.0, 0.0).farthest(40.0, |_| sp, sampled);
        assert!(error < 1e-9, "dt {dt}: {error}");
    }
}

/// The response to a step, overdamped and oscillating. Half of dt halves the error, which is at most what x moves in dt.
#[test]
fn proportional_and_integral_control_is_the_closed_form() {
    for (kp, ki) in [(2.0, 0.2), (0.5, 0.5)] {
        let sp = 5.0;
        let step = second_order(kp, ki, K * kp / T);
        let error_of = |dt| Loop::new(dt, kp, ki, 0.0).farthest(100.0, |_| sp, |t| sp * step(t));
        let (coarse, fine) = (error_of(0.1), error_of(0.05));
        let fastest = sp * (K * kp / T).max(ki);
        assert!(coarse <= 0.1 * fastest, "{kp}, {ki}: {coarse}");
        assert!(
            (0.45..0.55).contains(&(fine / coarse)),
            "{kp}, {ki}: {}",
            fine / coarse
        );
    }
}

/// In the sampled loop d = x - sp obeys d'' = (1 + r - g)·d' - r·d, with r = a - (1 - a)·K·kp and g = (1 - a)·K·ki·dt.
#[test]
fn the_sampled_loop_is_met_to_rounding() {
    let (dt, kp, ki, sp) = (0.1, 2.0, 0.2, 5.0);
    let a = (-dt / T).exp();
    let (r, g) = (a - (1.0 - a) * K * kp, (1.0 - a) * K * ki * dt);
    let half = (1.0 + r - g) / 2.0;
    let root = (half * half - r).sqrt();
    let (z1, z2): (f64, f64) = (half + root, half - root);
    // d is -sp at first, and then what the proportional part alone has done.
    let second = (1.0 - a) * K * kp * sp - sp;
    let weight = (second + sp * z2) / (z1 - z2);
    let d = move |n: f64| weight * z1.powf(n) + (-sp - weight) * z2.powf(n);
    let error = Loop::new(dt, kp, ki, 0.0).farthest(100.0, |_| sp, |t| sp + d((t / dt).round()));
    assert!(error < 1e-9, "{error}");
}

/// On a ramp of c a second x lags by c/(K·ki), whatever dt is.
#[test]
fn a_ramp_is_followed_at_its_distance() {
    let (kp, ki, c) = (2.0, 0.2, 0.3);
    let lag = c / (K * ki);
    // The error e is 0 at first and grows with c.
    let shape = second_order(kp, ki, c / lag);
    let ramp = move |t: f64| c * t;
    for dt in [0.1, 0.05] {
        let mut control = Loop::new(dt, kp, ki, 0.0);
        let error = control.farthest(200.0, ramp, |t| c * t - lag * shape(t));
        assert!(error <= dt * c, "dt {dt}: {error}");
        let distance = ramp(200.0) - control.x;
        assert!((distance - lag).abs() < 1e-6, "dt {dt}: {distance}, not {lag}");
    }
}

#[test]
fn no_bump_from_automatic_to_manual_and_back() {
    for (kp, ki, kd) in [(2.0, 0.2, 0.0), (2.0, 0.2, 4.0), (-1.0, -0.1, 0.5)] {
        let dt = 0.1;
        let mut control = Loop::new(dt, kp, ki, kd);
        control.give("sp", 5.0);
        let mut before = 0.0;
        for _ in 0..37 {
            before = control.scan();
        }
        // The panel follows the output as long as nobody turns the knob.
        control.give("hand", before);
        control.by_hand(true);
        assert!(is_close(control.scan(), before));
        control.give("hand", before + 1.0);
        for _ in 0..50 {
            control.scan();
        }
        // The setpoint is another one by now, and the measurement still moves.
        control.give("sp", -3.0);
        let x0 = control.x;
        let before = control.scan();
        control.by_hand(false);
        let x1 = control.x;
        let after = control.scan();
        assert!(
            is_close(after, before),
            "{kp}, {ki}, {kd}: {before}, then {after}"
        );
        // From there it goes on as the formula says.
        let x2 = control.x;
        let expected = ki * (-3.0 - x2) * dt - kp * (x2 - x1) - kd * ((x2 - x1) - (x1 - x0)) / dt;
        let change = control.scan() - after;
        assert!(
            is_close(change, expected),
            "{kp}, {ki}, {kd}: by {change}, not {expected}"
        );
    }
}

/// The setpoint is out of reach for 20 time constants. When it is in reach again the output leaves its limit in the same scan.
#[test]
fn a_setpoint_out_of_reach_winds_nothing_up() {
    let mut control = Loop::new(0.1, 2.0, 0.2, 0.0);
    control.give("low", 0.0);
    control.give("high", 1.0);
    control.give("sp", 3.0);
    for _ in 0..2000 {
        control.scan();
    }
    assert!(is_close(control.output(), 1.0));
    assert!((control.x - K).abs() < 1e-6, "{}", control.x);
    control.give("sp", 1.5);
    assert!(control.scan() < 1.0);
    let error = control.farthest(60.0, |_| 1.5, |_| 1.5);
    assert!(error <= K - 1.5, "{error}");
    assert!((control.x - 1.5).abs() < 0.01, "{}", control.x);
}

/// A load is too much for the actuator for 20 time constants. When it has gone the output leaves its limit before the measurement
/// has got where it shall be, within one time constant, and x swings over by little.
#[test]
fn a_load_that_was_too_much_winds_nothing_up() {
    for dt in [0.1, 0.01] {
        let mut control = Loop::new(dt, 2.0, 0.2, 0.0);
        control.give("low", 0.0);
        control.give("high", 1.0);
        control.give("sp", 1.5);
        control.load = 0.5;
        for _ in 0..(20.0 * T / dt) as usize {
            control.scan();
        }
        assert!(is_close(control.output(), 1.0));
        control.load = 0.0;
        let mut left = None;
        let mut highest: f64 = 0.0;
        for scan in 0..(10.0 * T / dt) as usize {
            if control.scan() < 1.0 {
                left = left.or(Some(scan as f64 * dt));
            }
            highest = highest.max(control.x);
        }
        let left = left.expect("it leaves the limit");
        assert!(left <= T, "dt {dt}: after {left} s");
        assert!(highest < 1.5 * 1.05, "dt {dt}: {highest}");
        assert!((control.x - 1.5).abs() < 0.01, "dt {dt}: {}", control.x);
    }
}
