//! Click's instructions do what they did where they were measured. Each trace's program is written in the DSL, converted,
//! fed with what the trace sets, and compared scan by scan.

use ladder_analysis::analyze;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_notations::{Source, by_name, convert};
use ladder_simulator::{Options, Point, Simulation};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::sync::Arc;

/// The traces were made with scans of 100 ms.
const INTERVAL: i64 = 100_000_000;

/// The program of a trace.
struct Measured {
    trace: &'static str,
    /// In the DSL, without `main` and its end.
    rungs: &'static str,
    /// What the trace calls things, and what they are here.
    names: &'static [(&'static str, &'static str)],
}

const PROGRAMS: &[Measured] = &[
    Measured {
        trace: "calc_div",
        rungs: "
    if c.A:
        calc('ds.D / 2', ds.D2)
        calc('ds.D / 2', df.FL)
        calc('ds.D MOD 2', dd.L)
",
        names: &[],
    },
    Measured {
        trace: "calc_wrap",
        rungs: "
    if c.A:
        calc('ds.D + 1', ds.D2)
        calc('ds.D * 2', dd.L)
",
        names: &[],
    },
    Measured {
        trace: "copy_neg",
        rungs: "
    if c.A:
        copy(ds.D, dd.L)
        copy(ds.D, dh.H)
        copy(ds.D, df.FL)
",
        names: &[],
    },
    Measured {
        trace: "ctd_edge",
        rungs: "
    if re(x.A):
        ctd(ct[3], 2, reset=lambda: x.R)
",
        names: &[("C3_Acc", "CT3.ACC"), ("C3_Done", "CT3.DN")],
    },
    Measured {
        trace: "ctu_level",
        rungs: "
    if x.A:
        ctu(ct[1], 3, reset=lambda: x.R)
",
        names: &[("C1_Acc", "CT1.ACC"), ("C1_Done", "CT1.DN")],
    },
    Measured {
        trace: "edges",
        rungs: "
    if re(x.A):
        set(y.Y)

    if fe(x.A):
        reset(y.Y)
",
        names: &[("Y", "Y_2")],
    },
    Measured {
        trace: "forloop",
        rungs: "
    if c.A:
        for _ in range(3):
            pass

    if True:
        calc('ds.D + 1', ds.D)

    if True:
        next_loop()
",
        names: &[],
    },
    Measured {
        trace: "pack_unpack",
        rungs: "
    if c.A:
        copy_pack(c[1:17], dh.H)

    if c.B:
        copy_unpack(dh.H, c[1:17])
",
        names: &[("C1", "C[1]"), ("C2", "C[2]"), ("C3", "C[3]"), ("C16", "C[16]")],
    },
    Measured {
        trace: "search_continuous",
        rungs: "
    if c.A:
        search('ge', 5, ds[1], ds[6], ds.X, c.Fd, continuous=True)
",
        names: &[
            ("DS1", "DS[1]"),
            ("DS2", "DS[2]"),
            ("DS3", "DS[3]"),
            ("DS4", "DS[4]"),
            ("DS5", "DS[5]"),
            ("DS6", "DS[6]"),
            ("X", "X_2"),
        ],
    },
    Measured {
        trace: "shift",
        rungs: "
    if x.A:
        shift(c[2:6], clock=lambda: x.Ck, reset=lambda: x.R)
",
        names: &[("C2", "C[2]"), ("C3", "C[3]"), ("C4", "C[4]"), ("C5", "C[5]")],
    },
    Measured {
        trace: "ton",
        rungs: "
    if x.A:
        ton(t[1], 300, Tms)

    if t[1]:
        out(y.Y)
",
        names: &[("T1_Acc", "T1.ACC"), ("T1_Done", "T1.DN"), ("Y", "Y_2")],
    },
];

/// Where what was measured differs from what the maker of the controllers describes: there the maker's word holds.
struct Difference {
    trace: &'static str,
    /// By the name that the trace has: the scans in which it differs, each with its value here.
    values: &'static [(u64, &'static str, &'static str)],
    why: &'static str,
}

const DIFFERENCES: &[Difference] = &[
    Difference {
        trace: "ctd_edge",
        values: &[
            (1, "C3_Done", "1"),
            (2, "C3_Done", "1"),
            (3, "C3_Done", "1"),
            (11, "C3_Done", "1"),
        ],
        why: "a counter that counts down is on while its value is the set point or less, which 0 is, also after a reset; \
              there it was on from -2 down",
    },
    Difference {
        trace: "ctu_level",
        values: &[
            (3, "C1_Acc", "1"),
            (4, "C1_Acc", "1"),
            (4, "C1_Done", "0"),
            (5, "C1_Acc", "1"),
            (5, "C1_Done", "0"),
            (6, "C1_Acc", "1"),
            (6, "C1_Done", "0"),
            (7, "C1_Acc", "1"),
            (7, "C1_Done", "0"),
        ],
        why: "a counter counts when its rung goes on; there it counted every scan with power",
    },
];

#[test]
fn all_traces() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/click/traces");
    let mut names: Vec<String> = fs::read_dir(&folder)
        .expect("the folder can be read")
        .map(|entry| entry.expect("an entry can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "txt"))
        .map(|path| {
            path.file_stem()
                .expect("it has a name")
                .to_string_lossy()
                .into_owned()
        })
        .collect();
    names.sort();
    let programs: Vec<&str> = PROGRAMS.iter().map(|program| program.trace).collect();
    assert_eq!(names, programs, "each trace has its program");
    let mut wrong = Vec::new();
    for program in PROGRAMS {
        let text =
            fs::read_to_string(folder.join(program.trace).with_extension("txt")).expect("it can be read");
        let found = |in_steps| {
            differences(program, &text, in_steps).unwrap_or_else(|error| panic!("{}: {error}", program.trace))
        };
        let (found, in_steps) = (found(false), found(true));
        assert_eq!(found, in_steps, "{}: in both of its codes", program.trace);
        let known = DIFFERENCES.iter().find(|known| known.trace == program.trace);
        let known: Vec<String> = known
            .map_or(&[][..], |known| known.values)
            .iter()
            .map(shown)
            .collect();
        if found != known {
            wrong.push(format!("{}: {found:#?}", program.trace));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    for difference in DIFFERENCES {
        println!("{}: {}", difference.trace, difference.why);
    }
    println!("{} traces, {} differ", names.len(), DIFFERENCES.len());
}

fn shown((scan, name, value): &(u64, &str, &str)) -> String {
    format!("{scan}: {name} is {value}")
}

/// Where a program does otherwise than its trace tells: the scan, the name, and the value here.
fn differences(program: &Measured, trace: &str, in_steps: bool) -> Result<Vec<String>, String> {
    let python = format!("def main():{}\n    if True:\n        end()\n", program.rungs);
    let source = Source::alone("test", python.as_bytes());
    let notation = by_name("click").expect("the notation is registered");
    let converted =
        convert(notation, &source, &ladder_format::Options::default()).map_err(|error| error.to_string())?;
    let ladder = &converted.written.text;
    let analysis = analyze(&ladder_syntax::parse(ladder).into(), "test.clad");
    let errors: Vec<String> = analysis.errors().map(|error| error.message.clone()).collect();
    let Some(compiled) = analysis.program() else {
        return Err(format!("it has errors: {errors:?}\n{ladder}"));
    };
    let options = Options {
        interval: INTERVAL,
        ..Options::default()
    };
    let mut simulation = Simulation::new(Arc::clone(compiled), options).map_err(|error| error.message)?;
    let point = |simulation: &Simulation, name: &str| {
        let here = program.names.iter().find(|(own, _)| *own == name);
        let here = here.map_or(name, |(_, here)| here);
        simulation
            .resolve(here)
            .map_err(|error| format!("{}\n{ladder}", error.message))
    };
    let end = trace
        .lines()
        .find(|line| line.starts_with("END"))
        .ok_or("there is no end")?;
    // What the trace knows, 0 at first.
    let mut known: BTreeMap<&str, &str> = changes(end).map(|(name, _)| (name, "0")).collect();
    let mut found = Vec::new();
    for line in trace.lines() {
        if let Some(settings) = line.strip_prefix("set ") {
            for setting in settings.split_whitespace() {
                let (name, value) = setting.split_once('=').ok_or_else(|| setting.to_owned())?;
                let point = point(&simulation, name)?;
                let value = value_of(&point, value)?;
                simulation
                    .set(&point, value)
                    .map_err(|error| format!("{error:?}"))?;
            }
            continue;
        }
        let Some(number) = line
            .split_once(':')
            .and_then(|(head, _)| head.parse::<u64>().ok())
        else {
            continue;
        };
        let ran = if in_steps {
            simulation.begin_scan() && simulation.finish_scan()
        } else {
            simulation.scan()
        };
        if !ran {
            return Err("it stops".to_owned());
        }
        known.extend(changes(line));
        for (name, expected) in &known {
            let here = text(&simulation.value(&point(&simulation, name)?));
            if here != *expected {
                found.push(shown(&(number, name, &here)));
            }
        }
    }
    let faults: Vec<String> = simulation
        .take_faults()
        .into_iter()
        .map(|fault| fault.message)
        .collect();
    if faults.is_empty() {
        Ok(found)
    } else {
        Err(faults.join("; "))
    }
}

/// What a line of the trace tells: `4: A=1 C1_Done=1 C1_Acc=3`.
fn changes(line: &str) -> impl Iterator<Item = (&str, &str)> {
    let (_, changes) = line.split_once(':').unwrap_or_default();
    changes
        .split_whitespace()
        .filter_map(|change| change.split_once('='))
}

fn value_of(point: &Point, text: &str) -> Result<Value, String> {
    let number: i64 = text.parse().map_err(|_| text.to_owned())?;
    Ok(match point.ty {
        Scalar::Bool => Value::Bool(number != 0),
        _ => Value::Int(number),
    })
}

fn text(value: &Value) -> String {
    match value {
        Value::Bool(high) => u8::from(*high).to_string(),
        Value::Int(number) => number.to_string(),
        Value::Real(real) => format!("{real:?}"),
        text @ Value::Text(_) => format!("{text:?}"),
    }
}
