//! A scene with the program whose values it shows.

use super::Scene;
use super::binding::{Binding, Case, Digits, One, What};
use super::finding::Finding;
use super::source::Expression as Source;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::expression::{Expression, Scope, Typed};
use ladder_simulator::{Simulation, value_text};

/// A place of the picture that gets a value after each scan.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Slot {
    /// The number of the element; of a row of the table that of the row.
    pub node: usize,
    /// What the value is for.
    pub used: Use,
}

/// What a value is for. An empty value means: as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// `none`: it is not shown.
    Display,
    /// Where it is, how it is turned, how large.
    Transform,
    /// How dense it is.
    Opacity,
    /// What it is filled with.
    Fill,
    /// The colour of its line.
    Stroke,
    /// What is written in it, even if that is nothing.
    Text,
    /// Its name and state, for those who do not see it.
    Label,
    /// Whether a switch is on.
    Checked,
    /// What a click gives its tag.
    Given,
    /// The value of a row of the table.
    Row,
}

impl Use {
    /// The attribute that has the value.
    pub fn attribute(self) -> &'static str {
        match self {
            Use::Display => "display",
            Use::Transform => "transform",
            Use::Opacity => "opacity",
            Use::Fill => "fill",
            Use::Stroke => "stroke",
            Use::Label => "aria-label",
            Use::Checked => "aria-checked",
            Use::Text => "text",
            Use::Given => "given",
            Use::Row => "row",
        }
    }
}

/// What a person can do with an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Act {
    /// The tag is TRUE while it is pressed.
    Press {
        /// The element.
        node: usize,
        /// The tag.
        tag: String,
    },
    /// The tag changes.
    Toggle {
        /// The element.
        node: usize,
        /// The tag.
        tag: String,
    },
    /// The tag gets the value of the element's place of that use.
    Set {
        /// The element.
        node: usize,
        /// The tag.
        tag: String,
    },
}

/// A row of the table that has the same values as text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Row {
    /// What the element is called.
    pub name: String,
    /// The attribute.
    pub attribute: &'static str,
    /// What is written in it.
    pub expression: String,
}

/// A scene bound to a program.
#[derive(Debug, Default)]
pub struct Bound {
    /// The places that get values.
    pub slots: Vec<Slot>,
    /// What can be done.
    pub acts: Vec<Act>,
    /// The rows of the table.
    pub rows: Vec<Row>,
    parts: Vec<Part>,
}

/// An element that is bound.
#[derive(Debug)]
struct Part {
    all: Vec<Live>,
    transform: Option<usize>,
    label: Option<usize>,
    alt: String,
    at: (f64, f64),
    digits: Option<Digits>,
    unit: String,
}

/// An attribute that is bound, and where its values go.
#[derive(Debug)]
struct Live {
    row: usize,
    slot: usize,
    does: Does,
}

#[derive(Debug)]
enum Does {
    Show(Expression),
    Paint(Vec<(Option<Expression>, String, String)>),
    MoveX(Expression),
    MoveY(Expression),
    Rotate(Expression),
    ScaleX(Expression),
    ScaleY(Expression),
    Text(Expression),
    Opacity(Expression),
    Press(Expression),
    Toggle(Expression),
    Set(Expression),
}

/// No slot: the value goes into the transformation of the element, or nowhere.
const NOWHERE: usize = usize::MAX;

impl Scene {
    /// Binds it to a program. What does not fit is left as it is drawn.
    pub fn bind(&self, simulation: &Simulation) -> (Bound, Vec<Finding>) {
        let mut binder = Binder {
            simulation,
            bound: Bound::default(),
            findings: Vec::new(),
        };
        for binding in &self.bindings {
            binder.binding(binding);
        }
        (binder.bound, binder.findings)
    }
}

struct Binder<'s> {
    simulation: &'s Simulation,
    bound: Bound,
    findings: Vec<Finding>,
}

/// What an expression must be of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Wanted {
    Condition,
    Number,
    Anything,
}

impl Binder<'_> {
    fn slot(&mut self, node: usize, used: Use) -> usize {
        self.bound.slots.push(Slot { node, used });
        self.bound.slots.len() - 1
    }

    fn binding(&mut self, binding: &Binding) {
        let mut part = Part {
            all: Vec::new(),
            transform: None,
            label: None,
            alt: binding.alt.clone().unwrap_or_default(),
            at: binding.at,
            digits: binding.digits,
            unit: binding.unit.clone(),
        };
        for one in &binding.all {
            let Some((does, slot)) = self.one(binding, one) else {
                continue;
            };
            let row = self.slot(self.bound.rows.len(), Use::Row);
            self.bound.rows.push(Row {
                name: binding.name.clone(),
                attribute: one.name,
                expression: one.value.clone(),
            });
            if does.is_transform() && part.transform.is_none() {
                part.transform = Some(self.slot(binding.outer, Use::Transform));
            }
            part.all.push(Live { row, slot, does });
        }
        if binding.alt.is_some() && !part.all.is_empty() {
            part.label = Some(self.slot(binding.outer, Use::Label));
        }
        self.bound.parts.push(part);
    }

    fn one(&mut self, binding: &Binding, one: &One) -> Option<(Does, usize)> {
        let node = binding.outer;
        Some(match &one.what {
            What::Show(e) => (
                Does::Show(self.expression(e, Wanted::Condition)?),
                self.slot(node, Use::Display),
            ),
            What::Paint { is_stroke, cases } => {
                let used = if *is_stroke { Use::Stroke } else { Use::Fill };
                let cases = cases.iter().map(|case| self.case(case)).collect::<Option<_>>()?;
                (Does::Paint(cases), self.slot(binding.inner, used))
            }
            What::MoveX(e) => (Does::MoveX(self.expression(e, Wanted::Number)?), NOWHERE),
            What::MoveY(e) => (Does::MoveY(self.expression(e, Wanted::Number)?), NOWHERE),
            What::Rotate(e) => (Does::Rotate(self.expression(e, Wanted::Number)?), NOWHERE),
            What::ScaleX(e) => (Does::ScaleX(self.expression(e, Wanted::Number)?), NOWHERE),
            What::ScaleY(e) => (Does::ScaleY(self.expression(e, Wanted::Number)?), NOWHERE),
            What::Text(e) => {
                let text = self.expression(e, Wanted::Anything)?;
                if binding.digits.is_some() && !text.ty().is_number() {
                    self.findings.push(Finding::error(
                        e.written.range,
                        format!("this is of type {}, and l:format is for numbers", text.ty()),
                        "take l:format out",
                    ));
                }
                (Does::Text(text), self.slot(binding.text, Use::Text))
            }
            What::Opacity(e) => (
                Does::Opacity(self.expression(e, Wanted::Number)?),
                self.slot(node, Use::Opacity),
            ),
            What::Press(e) => {
                let (tag, does) = self.tag(e, Some(Scalar::Bool))?;
                self.bound.acts.push(Act::Press { node, tag });
                (Does::Press(does), NOWHERE)
            }
            What::Toggle(e) => {
                let (tag, does) = self.tag(e, Some(Scalar::Bool))?;
                self.bound.acts.push(Act::Toggle { node, tag });
                (Does::Toggle(does), self.slot(node, Use::Checked))
            }
            What::Set(tag, value) => {
                let (name, given) = self.tag(tag, None)?;
                let value_of = self.expression(value, Wanted::Anything)?;
                if !fits(value_of.ty(), given.ty()) {
                    self.findings.push(Finding::error(
                        value.written.range,
                        format!(
                            "this is of type {}, and {name} of type {}",
                            value_of.ty(),
                            given.ty()
                        ),
                        "give it a value of its own type",
                    ));
                    return None;
                }
                self.bound.acts.push(Act::Set { node, tag: name });
                (Does::Set(value_of), self.slot(node, Use::Given))
            }
        })
    }

    fn case(&mut self, case: &Case) -> Option<(Option<Expression>, String, String)> {
        let condition = match &case.condition {
            Some(condition) => Some(self.expression(condition, Wanted::Condition)?),
            None => None,
        };
        let told = case
            .condition
            .as_ref()
            .map_or(String::new(), |condition| condition.text.clone());
        Some((condition, case.colour.clone(), told))
    }

    fn expression(&mut self, source: &Source, wanted: Wanted) -> Option<Expression> {
        let scope = Scope {
            simulation: self.simulation,
            instance: None,
        };
        let range = source.written.range;
        let expression = match Expression::new(&source.text, scope) {
            Ok(expression) => expression,
            Err(problem) => {
                let help = "an expression is written as in [CALC], over the program's tags and those of its plant: plant.level";
                self.findings.push(Finding::error(range, problem, help));
                return None;
            }
        };
        let ty = expression.ty();
        let (is_right, message, help) = match wanted {
            Wanted::Condition => (
                ty == Scalar::Bool,
                format!("a condition is TRUE or FALSE, and this is of type {ty}"),
                "compare it with something, as in level > 80",
            ),
            Wanted::Number => (
                ty.is_number(),
                format!("a number is wanted here, and this is of type {ty}"),
                "write a number, a tag that is one, or what is computed of such tags",
            ),
            Wanted::Anything => (true, String::new(), ""),
        };
        if is_right {
            return Some(expression);
        }
        self.findings.push(Finding::error(range, message, help));
        None
    }

    /// A tag that a person gives a value.
    fn tag(&mut self, source: &Source, ty: Option<Scalar>) -> Option<(String, Expression)> {
        let wanted = if ty.is_some() {
            Wanted::Condition
        } else {
            Wanted::Anything
        };
        let expression = self.expression(source, wanted)?;
        let range = source.written.range;
        let Some(point) = expression.point().cloned() else {
            self.findings.push(Finding::error(
                range,
                format!("`{}` is not a tag", source.text),
                "name an input of the program, a disturbance of its plant, or an internal tag",
            ));
            return None;
        };
        if point.read_only {
            self.findings.push(Finding::error(
                range,
                format!("{} cannot be written", point.name),
                "name an input of the program, a disturbance of its plant, or an internal tag",
            ));
            return None;
        }
        if point.role == Role::Output {
            self.findings.push(Finding::warning(
                range,
                format!("{} is an output: the program writes it in each scan", point.name),
                "name an input of the program, a disturbance of its plant, or an internal tag",
            ));
        }
        Some((point.name, expression))
    }
}

/// Whether a tag of a type takes values of another.
fn fits(value: Scalar, tag: Scalar) -> bool {
    value == tag
        || (tag.is_real() && value.is_number())
        || (tag.is_integer() && value.is_integer())
        || (tag.is_bits() && (value.is_bits() || value.is_integer()))
        || (tag.is_string() && value.is_string())
}

impl Does {
    fn is_transform(&self) -> bool {
        matches!(
            self,
            Does::MoveX(_) | Does::MoveY(_) | Does::Rotate(_) | Does::ScaleX(_) | Does::ScaleY(_)
        )
    }
}

impl Bound {
    /// What each place shows now.
    pub fn values(&mut self, simulation: &Simulation) -> Vec<String> {
        let mut values = vec![String::new(); self.slots.len()];
        for part in &mut self.parts {
            part.values(simulation, &mut values);
        }
        values
    }
}

/// How an element is moved, turned and stretched.
struct Moved {
    x: f64,
    y: f64,
    turned: f64,
    wide: f64,
    high: f64,
}

impl Part {
    fn values(&mut self, simulation: &Simulation, values: &mut [String]) {
        let mut moved = Moved {
            x: 0.0,
            y: 0.0,
            turned: 0.0,
            wide: 1.0,
            high: 1.0,
        };
        let mut state: Option<String> = None;
        for live in &mut self.all {
            let number = |e: &mut Expression| e.evaluate(simulation).map(|it| (shown(&it), number(&it)));
            let (row, slot) = match &mut live.does {
                Does::Show(e) => flag(e, simulation).map_or_else(failed, |high| {
                    (truth(high), if high { String::new() } else { "none".to_owned() })
                }),
                Does::Paint(cases) => match painted(cases, simulation) {
                    Ok(Some((colour, told))) => {
                        state.get_or_insert(told);
                        (colour.clone(), colour)
                    }
                    Ok(None) => {
                        state.get_or_insert("off".to_owned());
                        ("as drawn".to_owned(), String::new())
                    }
                    Err(problem) => failed(problem),
                },
                Does::MoveX(e) => number(e).map_or_else(failed, |(text, by)| {
                    moved.x = by;
                    (text, String::new())
                }),
                Does::MoveY(e) => number(e).map_or_else(failed, |(text, by)| {
                    moved.y = by;
                    (text, String::new())
                }),
                Does::Rotate(e) => number(e).map_or_else(failed, |(text, by)| {
                    moved.turned = by;
                    (text, String::new())
                }),
                Does::ScaleX(e) => number(e).map_or_else(failed, |(text, by)| {
                    moved.wide = by.max(0.0);
                    (text, String::new())
                }),
                Does::ScaleY(e) => number(e).map_or_else(failed, |(text, by)| {
                    moved.high = by.max(0.0);
                    (text, String::new())
                }),
                Does::Text(e) => match e.evaluate(simulation) {
                    Ok(value) => {
                        let text = written(&value, self.digits, &self.unit);
                        state.get_or_insert(text.clone());
                        (text.clone(), text)
                    }
                    Err(problem) => (problem, "?".to_owned()),
                },
                Does::Opacity(e) => {
                    number(e).map_or_else(failed, |(text, by)| (text, short(by.clamp(0.0, 1.0))))
                }
                Does::Press(e) => {
                    flag(e, simulation).map_or_else(failed, |high| (truth(high), String::new()))
                }
                Does::Toggle(e) => {
                    flag(e, simulation).map_or_else(failed, |high| (truth(high), high.to_string()))
                }
                Does::Set(e) => match e.evaluate(simulation) {
                    Ok(value) => (shown(&value), shown(&value)),
                    Err(problem) => failed(problem),
                },
            };
            values[live.row] = row;
            if live.slot != NOWHERE {
                values[live.slot] = slot;
            }
        }
        if let Some(slot) = self.transform {
            values[slot] = moved.transform(self.at);
        }
        if let Some(slot) = self.label {
            values[slot] = match state {
                Some(state) if !state.is_empty() => format!("{}, {state}", self.alt),
                _ => self.alt.clone(),
            };
        }
    }
}

/// What a row and a place show where a fault happens: the place what is drawn.
fn failed(problem: String) -> (String, String) {
    (problem, String::new())
}

fn flag(e: &mut Expression, simulation: &Simulation) -> Result<bool, String> {
    e.holds(simulation)
}

fn truth(high: bool) -> String {
    if high { "TRUE" } else { "FALSE" }.to_owned()
}

/// The colour of the first condition that is TRUE, and the state in words: on or off of one condition, which it is of several.
fn painted(
    cases: &mut [(Option<Expression>, String, String)],
    simulation: &Simulation,
) -> Result<Option<(String, String)>, String> {
    let is_one = cases.iter().filter(|(condition, ..)| condition.is_some()).count() == 1;
    for (condition, colour, told) in cases {
        let holds = match condition {
            Some(condition) => condition.holds(simulation)?,
            None => return Ok(Some((colour.clone(), "off".to_owned()))),
        };
        if holds {
            let told = if is_one { "on".to_owned() } else { told.clone() };
            return Ok(Some((colour.clone(), told)));
        }
    }
    Ok(None)
}

fn number(typed: &Typed) -> f64 {
    match typed.value {
        Value::Int(number) if typed.ty == Scalar::Ulint => number as u64 as f64,
        Value::Int(number) => number as f64,
        Value::Real(number) => number,
        Value::Bool(_) | Value::Text(_) => 0.0,
    }
}

fn shown(typed: &Typed) -> String {
    value_text::display(&typed.value, typed.ty)
}

/// A value with its unit, as `l:format` has it.
fn written(typed: &Typed, digits: Option<Digits>, unit: &str) -> String {
    let text = match (digits, &typed.value) {
        (Some(Digits { before, after }), _) if typed.ty.is_number() => {
            let number = number(typed);
            let width = before + if after > 0 { after + 1 } else { 0 } + usize::from(number < 0.0);
            format!("{number:0width$.after$}")
        }
        // Without the quotes of a program.
        (_, Value::Text(bytes)) => String::from_utf8_lossy(bytes).into_owned(),
        _ => shown(typed),
    };
    if unit.is_empty() {
        text
    } else {
        format!("{text} {unit}")
    }
}

/// A number in as few digits as a drawing needs.
fn short(number: f64) -> String {
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text.is_empty() || text == "-0" {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}

impl Moved {
    fn transform(&self, (x, y): (f64, f64)) -> String {
        let mut steps = Vec::new();
        if self.x != 0.0 || self.y != 0.0 {
            steps.push(format!("translate({} {})", short(self.x), short(self.y)));
        }
        if self.turned != 0.0 {
            steps.push(format!(
                "rotate({} {} {})",
                short(self.turned),
                short(x),
                short(y)
            ));
        }
        if self.wide != 1.0 || self.high != 1.0 {
            steps.push(format!(
                "translate({} {}) scale({} {}) translate({} {})",
                short(x),
                short(y),
                short(self.wide),
                short(self.high),
                short(-x),
                short(-y)
            ));
        }
        steps.join(" ")
    }
}
