//! What an instruction does, scan by scan: its example is run, and its page shows what comes of it.

use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_instructions::{Instruction, Op, TABLE};
use ladder_simulator::value_text::{display, parse};
use ladder_simulator::{Options, Point, Simulation};
use std::sync::Arc;

const STIMULI: &str = include_str!("instruction_runs.txt");

/// Waves for examples whose inputs are BOOLs: all combinations, rises and falls.
const WAVES: [&[&str]; 4] = [
    &[],
    &["_--__-__"],
    &["_--__--_--", "__--_____-"],
    &["_-----_-__", "___--___--", "_-_-_--_-_"],
];

/// The table: a row for each tag, a column for each scan. BOOLs are waves.
///
/// # Panics
/// The example does not run, or its entry in the list of stimuli names what it does not have.
pub fn table(row: &Instruction) -> String {
    let parsed = Arc::new(ladder_syntax::parse(row.example));
    let program = ladder_analysis::analyze(&parsed, "example").program().cloned();
    let program = program.unwrap_or_else(|| panic!("the example of {}", row.signature()));
    let options = Options {
        interval: 1_000_000_000,
        ..Options::default()
    };
    let mut simulation = Simulation::new(program, options).expect("examples are small");
    let stimulus = Stimulus::of(row, &simulation);
    let watched = stimulus.watched(&simulation);
    let before = |name: &String| {
        let changes = watched.iter().any(|point| point.name == *name);
        if changes {
            format!("{name} before")
        } else {
            name.clone()
        }
    };
    let inputs = stimulus.inputs.iter();
    let mut lines: Vec<Line> = inputs.map(|(name, _)| Line::new(&before(name))).collect();
    lines.extend(watched.iter().map(|point| Line::new(&point.name)));
    let (mut sent, mut faults, mut runs) = (Line::new("sent"), Line::new("fault"), Line::new("runs"));
    for scan in 0..stimulus.scans {
        for (name, cells) in &stimulus.inputs {
            give(&mut simulation, name, &cells[scan]);
        }
        let inputs = stimulus.inputs.iter();
        let inputs = inputs.map(|(name, cells)| match simulation.resolve(name) {
            Ok(point) => shown(&simulation, &point),
            Err(_) => cells[scan].replace('.', ""),
        });
        let mut cells: Vec<String> = inputs.collect();
        let ran = simulation.scan();
        cells.extend(watched.iter().map(|point| shown(&simulation, point)));
        for (line, cell) in lines.iter_mut().zip(cells) {
            line.cells.push(cell);
        }
        let bytes = simulation.take_serial();
        sent.cells
            .push(display(&Value::Text(bytes.as_slice().into()), Scalar::String(80)));
        let level = |high: bool| if high { "-" } else { "_" }.to_owned();
        faults.cells.push(level(!simulation.take_faults().is_empty()));
        runs.cells.push(level(ran));
    }
    lines.extend((sent.cells.iter().any(|cell| cell != "''")).then_some(sent));
    lines.extend((faults.cells.iter().any(|cell| cell == "-")).then_some(faults));
    lines.extend((runs.cells.iter().any(|cell| cell == "_")).then_some(runs));
    draw(&lines)
}

/// What an entry of the list says.
struct Stimulus {
    scans: usize,
    inputs: Vec<(String, Vec<String>)>,
    watch: Option<Vec<String>>,
}

impl Stimulus {
    fn of(row: &Instruction, simulation: &Simulation) -> Stimulus {
        let signature = row.signature();
        // The inverter and the bitwise instruction differ in their signatures.
        let entry = STIMULI
            .split("\n\n")
            .find(|entry| entry.lines().next() == Some(&signature));
        let mut stimulus = Stimulus {
            scans: 0,
            inputs: Vec::new(),
            watch: None,
        };
        for line in entry.unwrap_or_default().lines().skip(1) {
            let mut words = line.split(' ').map(str::to_owned);
            let name = words.next().expect("a name");
            let cells: Vec<String> = words.collect();
            if name == "watch" {
                stimulus.watch = Some(cells);
                continue;
            }
            let is_wave = |cells: &[String]| matches!(cells, [one] if one.len() > 1 && one.chars().all(|c| matches!(c, '_' | '-')));
            let cells: Vec<String> = if is_wave(&cells) {
                cells[0].chars().map(String::from).collect()
            } else {
                cells
            };
            stimulus.scans = stimulus.scans.max(cells.len());
            // A tag may be given in two rows.
            match stimulus.inputs.iter_mut().find(|(there, _)| *there == name) {
                Some((_, there)) => {
                    for (there, cell) in there.iter_mut().zip(cells).filter(|(_, cell)| cell != ".") {
                        *there = cell;
                    }
                }
                None => stimulus.inputs.push((name, cells)),
            }
        }
        if stimulus.inputs.is_empty() {
            stimulus.all_combinations(simulation);
        }
        stimulus
    }

    fn all_combinations(&mut self, simulation: &Simulation) {
        let is_input = |point: &&Point| point.role == Role::Input && point.ty == Scalar::Bool;
        let inputs: Vec<&Point> = simulation.points().iter().filter(is_input).collect();
        let waves = WAVES.get(inputs.len()).copied().unwrap_or_default();
        for (input, wave) in inputs.iter().zip(waves) {
            self.inputs
                .push((input.name.clone(), wave.chars().map(String::from).collect()));
        }
        self.scans = waves.first().map_or(3, |wave| wave.len());
    }

    /// What is shown below the inputs: all other values, unless the entry names them.
    fn watched(&self, simulation: &Simulation) -> Vec<Point> {
        if let Some(watch) = &self.watch {
            return watch
                .iter()
                .map(|name| simulation.resolve(name).expect("a tag of the example"))
                .collect();
        }
        let is_given = |point: &Point| self.inputs.iter().any(|(name, _)| *name == point.name);
        let points = simulation.points().iter();
        // Of an array of which some elements are given, the others are at rest.
        let is_of_given = |point: &Point| {
            let mut given = self.inputs.iter().filter_map(|(name, _)| name.split_once('['));
            given.any(|(array, _)| point.name.contains('[') && point.is_in(array))
        };
        points
            .filter(|point| !point.read_only && !is_given(point) && !is_of_given(point))
            .cloned()
            .collect()
    }
}

fn give(simulation: &mut Simulation, name: &str, cell: &str) {
    match (name, cell) {
        (_, ".") => {}
        ("restart", "-") => simulation.warm_restart(),
        ("restart", _) => {}
        ("receive", byte) => simulation.feed_serial(&[byte.parse().expect("a byte")]),
        _ => {
            let point = simulation.resolve(name).expect("a tag of the example");
            let text = match cell {
                "_" => "0",
                "-" => "1",
                other => other,
            };
            let value = parse(text, point.ty).unwrap_or_else(|problem| panic!("{name}: {problem}"));
            simulation.set(&point, value).expect("a value of its type");
        }
    }
}

fn shown(simulation: &Simulation, point: &Point) -> String {
    match simulation.value(point) {
        Value::Bool(true) => "-".to_owned(),
        Value::Bool(false) => "_".to_owned(),
        value => display(&value, point.ty),
    }
}

struct Line {
    name: String,
    cells: Vec<String>,
}

impl Line {
    fn new(name: &str) -> Line {
        Line {
            name: name.to_owned(),
            cells: Vec::new(),
        }
    }
}

/// All columns are as wide as the widest value; waves go through.
fn draw(lines: &[Line]) -> String {
    let names = lines
        .iter()
        .map(|line| line.name.chars().count())
        .max()
        .unwrap_or(0);
    let widest = lines
        .iter()
        .flat_map(|line| &line.cells)
        .map(|cell| cell.chars().count())
        .max();
    let is_wave = |cell: &String| cell == "_" || cell == "-";
    let only_waves = lines.iter().flat_map(|line| &line.cells).all(is_wave);
    let width = if only_waves { 1 } else { widest.unwrap_or(0) + 2 };
    let mut text = String::new();
    for line in lines {
        let cells: String = line
            .cells
            .iter()
            .map(|cell| match cell.as_str() {
                "_" | "-" => cell.repeat(width),
                value => format!("{value:width$}"),
            })
            .collect();
        text.push_str(format!("{:names$}  {cells}", line.name).trim_end());
        text.push('\n');
    }
    text
}

/// Entries of the list that are no instruction's: a slip in a signature.
pub fn strays() -> Vec<&'static str> {
    let heads = STIMULI
        .split("\n\n")
        .skip(1)
        .filter_map(|entry| entry.lines().next());
    let is_known = |head: &&str| TABLE.iter().any(|row| row.signature() == **head);
    heads.filter(|head| !is_known(head)).collect()
}

/// Whether the text of an instruction has a diagram of its own, which another test plays.
pub fn has_diagram(row: &Instruction) -> bool {
    row.doc.contains("```text\nPT = ")
}

/// Instructions that only mark a place: nothing is to be seen of them but where power goes.
pub fn only_marks(row: &Instruction) -> bool {
    matches!(row.op, Op::Lbl | Op::Fun)
}
