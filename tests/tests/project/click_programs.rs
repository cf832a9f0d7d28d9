//! Whole programs of Click run as they are imported, and keep over a restart what Click keeps.

use ladder_analysis::program::Program;
use ladder_analysis::values::value::Value;
use ladder_analysis::{Severity, analyze};
use ladder_notations::{Companion, Converted, Source, by_name, convert};
use ladder_simulator::{Options, Simulation};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

fn program_of(notation: &str, source: &Source<'_>) -> (Converted, Arc<Program>) {
    let notation = by_name(notation).expect("the notation is registered");
    let converted = convert(notation, source, &ladder_format::Options::default())
        .unwrap_or_else(|error| panic!("{}: {error}", source.name));
    let text = &converted.written.text;
    let analysis = analyze(&ladder_syntax::parse(text).into(), "test.clad");
    let complaints: Vec<&str> = analysis
        .diagnostics()
        .iter()
        .filter(|found| found.severity == Severity::Error)
        .map(|found| found.message.as_str())
        .collect();
    assert!(complaints.is_empty(), "{complaints:#?}\n{text}");
    let program = analysis.program().expect("it has no errors").clone();
    (converted, program)
}

fn running(python: &str) -> Simulation {
    let (_, program) = program_of("click", &Source::alone("test", python.as_bytes()));
    Simulation::new(program, Options::default()).unwrap_or_else(|error| panic!("{error}\n{python}"))
}

fn set(simulation: &mut Simulation, name: &str, value: Value) {
    let point = simulation
        .resolve(name)
        .unwrap_or_else(|error| panic!("{}", error.message));
    simulation.set(&point, value).expect("it takes the value");
}

fn get(simulation: &Simulation, name: &str) -> Value {
    let point = simulation
        .resolve(name)
        .unwrap_or_else(|error| panic!("{}", error.message));
    simulation.value(&point)
}

/// The programs of these tests, and where there are any those of other people.
fn programs() -> Vec<PathBuf> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../notations/click/tests/click");
    let mut out = vec![own.join("bottling.py"), own.join("grid/washer/main.csv")];
    let Some(corpus) = std::env::var_os("LADDER_CORPUS") else {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
        return out;
    };
    let folder = fs::read_dir(Path::new(&corpus).join("click/csv")).expect("the folder can be read");
    out.extend(folder.map(|entry| entry.expect("an entry can be read").path()));
    out.sort();
    out
}

#[test]
fn whole_programs_run() {
    for path in programs() {
        let bytes = fs::read(&path).expect("it can be read");
        let name = path
            .file_stem()
            .expect("it has a name")
            .to_string_lossy()
            .into_owned();
        let is_python = path.extension().is_some_and(|extension| extension == "py");
        let notation = if is_python { "click" } else { "click-csv" };
        let next_to =
            fs::read_dir(path.parent().expect("it lies in a folder")).expect("the folder can be read");
        let companions: Vec<Companion> = next_to
            .map(|entry| entry.expect("an entry can be read").path())
            .filter_map(|next_to| {
                let file = next_to.file_name()?.to_string_lossy().into_owned();
                let belongs = by_name(notation)?.has_companion(&name, &file);
                belongs.then(|| Companion {
                    name: file,
                    bytes: fs::read(&next_to).unwrap_or_default().into(),
                })
            })
            .collect();
        let source = Source {
            name: name.as_str().into(),
            bytes: &bytes,
            companions,
        };
        let (converted, program) = program_of(notation, &source);
        let mut simulation = Simulation::new(program, Options::default())
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        for scan in 0..200 {
            let inputs: Vec<_> = simulation
                .points()
                .iter()
                .filter(|point| point.role == ladder_analysis::program::Role::Input)
                .cloned()
                .collect();
            for (number, input) in inputs.iter().enumerate() {
                if input.ty == ladder_analysis::values::types::Scalar::Bool {
                    let high = (scan / (number + 2)) % 2 == 1;
                    simulation
                        .set(input, Value::Bool(high))
                        .expect("an input takes a BOOL");
                }
            }
            let faults = simulation.take_faults();
            assert!(
                faults.is_empty(),
                "{}: {faults:?}\n{}",
                path.display(),
                converted.written.text
            );
            if !simulation.scan() {
                break;
            }
        }
        assert!(simulation.scans() > 0, "{}", path.display());
    }
}

#[test]
fn what_a_bank_keeps_outlasts_a_restart() {
    let python = "
def main():
    if c.Go:
        copy(5, ds[1])
        copy(6, dd.Total)
        copy(0x7, dh.Bits)
        copy(1.5, df.Flow)
        copy('A', txt[1])
        set(c.Seen)
        set(y.Lamp)
        ton(t.Warm, 20, Tms)

    if re(c.Go):
        ctu(ct.Parts, 1, reset=lambda: c.New)

    if all(c.Seen, y.Lamp, t.Warm, ct.Parts, ds[1] == 5, dd.Total == 6, dh.Bits == 0x7, df.Flow > 1.0, txt[1] == 'A'):
        out(y.All)

    if True:
        end()
";
    let mut simulation = running(python);
    set(&mut simulation, "Go", Value::Bool(true));
    for _ in 0..5 {
        assert!(simulation.scan());
    }
    assert_eq!(get(&simulation, "All"), Value::Bool(true));
    simulation.warm_restart();
    let kept = [
        "DS[1]",
        "Total",
        "Bits",
        "Parts.ACC",
        "Seen",
        "Lamp",
        "Warm.ACC",
        "Go",
    ];
    let kept: Vec<Value> = kept.iter().map(|name| get(&simulation, name)).collect();
    assert_eq!(
        kept,
        [
            Value::Int(5),
            Value::Int(6),
            Value::Int(7),
            Value::Int(1),
            Value::Bool(false),
            Value::Bool(false),
            Value::Int(0),
            Value::Bool(false),
        ]
    );
}

#[test]
fn a_register_shifts_downwards() {
    let python = "
def main():
    if x.Data:
        shift(c[5:1:-1], clock=lambda: x.Clock, reset=lambda: x.Clear)

    if True:
        end()
";
    let mut simulation = running(python);
    let mut shown = Vec::new();
    for (data, clock, clear) in [
        (true, false, false),
        (true, true, false),
        (true, true, false),
        (false, false, false),
        (false, true, false),
        (true, false, false),
        (true, true, false),
        (true, false, true),
    ] {
        set(&mut simulation, "Data", Value::Bool(data));
        set(&mut simulation, "Clock", Value::Bool(clock));
        set(&mut simulation, "Clear", Value::Bool(clear));
        assert!(simulation.scan());
        let bits = (2..=5).map(|bit| match get(&simulation, &format!("C[{bit}]")) {
            Value::Bool(true) => '1',
            _ => '0',
        });
        shown.push(bits.collect::<String>());
    }
    // C2 on the left.
    assert_eq!(
        shown,
        ["0000", "0001", "0001", "0001", "0010", "0010", "0101", "0000"]
    );
}

#[test]
fn errors_are_relays_that_a_program_reads() {
    let python = "
def main():
    if c.Go:
        calc('ds.A / ds.B', ds.Q)
        copy(dd.Large, ds.Small)
        copy(ds[ds.Where], ds.Got)

    if sc[40]:
        set(c.Divided)

    if sc[43]:
        set(c.Clamped)

    if sc[44]:
        set(c.Lost)

    if True:
        end()
";
    let mut simulation = running(python);
    for (name, number) in [
        ("A", 5),
        ("Large", 1_000_000),
        ("Where", 4501),
        ("Q", 3),
        ("Got", 9),
    ] {
        set(&mut simulation, name, Value::Int(number));
    }
    set(&mut simulation, "Go", Value::Bool(true));
    assert!(simulation.scan());
    let shown = ["Q", "Small", "Got"].map(|name| get(&simulation, name));
    assert_eq!(shown, [Value::Int(0), Value::Int(32767), Value::Int(9)]);
    let values = ["Divided", "Clamped", "Lost"].map(|name| get(&simulation, name));
    assert_eq!(values, [Value::Bool(true), Value::Bool(true), Value::Bool(true)]);
    set(&mut simulation, "Go", Value::Bool(false));
    assert!(simulation.scan());
    assert_eq!(get(&simulation, "SC[40]"), Value::Bool(false));
    assert!(simulation.take_faults().is_empty());
}

#[test]
fn all_contacts_of_a_rung_are_looked_at_before_it_acts() {
    let wire = ",-".repeat(29);
    let grid = format!(
        "marker,A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z,AA,AB,AC,AD,AE,AF\n\
         R,X001,T{wire},out(C1)\n,,C1{wire},out(Y001)\n,C1,-{wire},out(Y002)\nR,-,-{wire},end()\n"
    );
    let (converted, program) = program_of("click-csv", &Source::alone("main", grid.as_bytes()));
    let mut simulation = Simulation::new(program, Options::default()).expect("it runs");
    set(&mut simulation, "X[1]", Value::Bool(true));
    let mut shown = Vec::new();
    for _ in 0..2 {
        assert!(simulation.scan());
        shown.push(["C[1]", "Y[1]", "Y[2]"].map(|name| get(&simulation, name) == Value::Bool(true)));
    }
    // As pyrung has it.
    assert_eq!(shown, [[true, false, false], [true, true, true]]);
    let analysis = analyze(&ladder_syntax::parse(&converted.written.text).into(), "main.clad");
    let write = |notation: &str| {
        let notation = by_name(notation).expect("the notation is registered");
        let writing = notation.write(&analysis).expect("it is written");
        let remarks = writing.report.remarks().count();
        (String::from_utf8(writing.bytes).expect("it is text"), remarks)
    };
    assert_eq!(write("click-csv"), (grid, 0));
    // The DSL has no branches: two conditions, and that a branch becomes a rung.
    assert_eq!(write("click").1, 3);
}
