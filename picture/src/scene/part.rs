//! An element that is bound, and what it shows of a running program.

use super::binding::Digits;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::expression::{Expression, Typed};
use ladder_simulator::{Simulation, value_text};

/// An element that is bound.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) all: Vec<Live>,
    pub(super) transform: Option<usize>,
    pub(super) label: Option<usize>,
    pub(super) alt: String,
    /// The part in it whose state is its own.
    pub(super) within: Option<usize>,
    /// What it told of itself last.
    pub(super) state: Option<String>,
    pub(super) at: (f64, f64),
    pub(super) digits: Option<Digits>,
    pub(super) unit: String,
}

/// An attribute that is bound, and where its values go.
#[derive(Debug)]
pub(super) struct Live {
    pub(super) row: usize,
    pub(super) slot: usize,
    pub(super) does: Does,
}

#[derive(Debug)]
pub(super) enum Does {
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
    Give(String),
}

/// No slot: the value goes into the transformation of the element, or nowhere.
pub(super) const NOWHERE: usize = usize::MAX;

impl Does {
    pub(super) fn is_transform(&self) -> bool {
        matches!(
            self,
            Does::MoveX(_) | Does::MoveY(_) | Does::Rotate(_) | Does::ScaleX(_) | Does::ScaleY(_)
        )
    }
}

/// How an element is moved, turned and stretched.
struct Moved {
    x: f64,
    y: f64,
    turned: f64,
    /// As a part of how it is drawn; none of what is not stretched.
    wide: Option<f64>,
    high: Option<f64>,
}

impl Part {
    pub(super) fn values(&mut self, simulation: &Simulation, inside: Option<String>, values: &mut [String]) {
        let mut moved = Moved {
            x: 0.0,
            y: 0.0,
            turned: 0.0,
            wide: None,
            high: None,
        };
        let mut state = inside;
        for live in &mut self.all {
            let number = |e: &mut Expression| e.evaluate(simulation).map(|it| (shown(&it), number(&it)));
            let (row, slot) = match &mut live.does {
                Does::Show(e) => e.holds(simulation).map_or_else(failed, |high| {
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
                    moved.wide = Some(by.max(0.0));
                    (text, String::new())
                }),
                Does::ScaleY(e) => number(e).map_or_else(failed, |(text, by)| {
                    moved.high = Some(by.max(0.0));
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
                Does::Press(e) => e
                    .holds(simulation)
                    .map_or_else(failed, |high| (truth(high), String::new())),
                Does::Toggle(e) => e
                    .holds(simulation)
                    .map_or_else(failed, |high| (truth(high), high.to_string())),
                Does::Give(value) => (value.clone(), value.clone()),
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
            values[slot] = match &state {
                Some(state) if !state.is_empty() => format!("{}, {state}", self.alt),
                _ => self.alt.clone(),
            };
        }
        self.state = state;
    }
}

/// What a row and a place show where a fault happens: the place what is drawn.
fn failed(problem: String) -> (String, String) {
    (problem, String::new())
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
        if self.wide.is_some() || self.high.is_some() {
            steps.push(format!(
                "translate({} {}) scale({} {}) translate({} {})",
                short(x),
                short(y),
                short(self.wide.unwrap_or(1.0)),
                short(self.high.unwrap_or(1.0)),
                short(-x),
                short(-y)
            ));
        }
        steps.join(" ")
    }
}
