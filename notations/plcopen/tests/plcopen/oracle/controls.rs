//! The additional blocks, as the annex of the standard writes them. Times are in milliseconds, and count as seconds.

use std::collections::HashMap;

pub(super) const NAMES: &[&str] = &["SEMA", "HYSTERESIS", "INTEGRAL", "DERIVATIVE", "PID", "RAMP"];

/// One run of a block, whose values have these names in small letters.
pub(super) fn run(name: &str, values: &mut HashMap<String, f64>) {
    let mut all = |name: &str| *values.entry(name.to_owned()).or_default();
    let truth = |it: bool| f64::from(u8::from(it));
    let cycle = all("cycle") / 1000.0;
    let (run, q, xin, xout) = (all("run") != 0.0, all("q"), all("xin"), all("xout"));
    let (x1, x2, x3) = (all("was1"), all("was2"), all("was3"));
    let rate = |now: f64| (3.0 * (now - x3) + x1 - x2) / (10.0 * cycle);
    let mut out: Vec<(&str, f64)> = Vec::new();
    match name {
        "sema" => {
            let busy = all("claim") != 0.0 || (all("busy") != 0.0 && all("release") == 0.0);
            out.push(("busy", truth(busy)));
        }
        "hysteresis" => {
            let (one, other, eps) = (all("xin1"), all("xin2"), all("eps"));
            let is_high = q != 0.0;
            let high = if is_high {
                one >= other - eps
            } else {
                one > other + eps
            };
            out.push(("q", truth(high)));
        }
        "integral" => {
            let reset = all("r1") != 0.0;
            out.push(("q", truth(!reset)));
            if reset {
                out.push(("xout", all("x0")));
            } else if run {
                out.push(("xout", xout + xin * cycle));
            }
        }
        "derivative" if run => {
            out.extend([("xout", rate(xin)), ("was3", x2), ("was2", x1), ("was1", xin)]);
        }
        "derivative" => out.extend([("xout", 0.0), ("was3", xin), ("was2", xin), ("was1", xin)]),
        "pid" => {
            let error = all("pv") - all("sp");
            let is_auto = all("auto") != 0.0;
            let (tr, sum) = (all("tr"), all("sum"));
            let sum = if is_auto {
                sum + error * cycle
            } else {
                tr * (all("x0") - error)
            };
            let slope = if is_auto { rate(error) } else { 0.0 };
            let shifted = if is_auto { (x2, x1) } else { (error, error) };
            out.extend([
                ("sum", sum),
                ("was3", shifted.0),
                ("was2", shifted.1),
                ("was1", error),
            ]);
            out.push(("xout", all("kp") * (error + sum / tr + slope * all("td"))));
        }
        _ => {
            let (first, last, passed, whole) = (all("x0"), all("x1"), all("t"), all("tr"));
            let from = all("from");
            out.push(("busy", truth(run && passed < whole)));
            if !run {
                out.extend([("xout", first), ("from", first), ("t", 0.0)]);
            } else if passed >= whole {
                out.push(("xout", last));
            } else {
                out.extend([
                    ("xout", from + (last - from) * passed / whole),
                    ("t", passed + all("cycle")),
                ]);
            }
        }
    }
    values.extend(out.into_iter().map(|(name, value)| (name.to_owned(), value)));
}
