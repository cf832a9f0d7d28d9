//! The expressions of a scene, compiled for a program.

use super::Scene;
use super::binding::{Binding, Case, One, What};
use super::bound::{Act, Bound, Row, Slot, Use};
use super::finding::Finding;
use super::part::{Does, Live, NOWHERE, Part};
use super::source::Expression as Source;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::expression::{Expression, Scope, names};
use ladder_simulator::{Simulation, value_text};
use std::collections::HashMap;

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
        self.lend_states(&mut binder.bound);
        (binder.bound, binder.findings)
    }

    /// What has no state of its own has that of the first part in it that has one.
    fn lend_states(&self, bound: &mut Bound) {
        let without = self
            .bindings
            .iter()
            .enumerate()
            .filter(|(_, binding)| !binding.tells());
        let without: HashMap<usize, usize> =
            without.map(|(number, binding)| (binding.outer, number)).collect();
        let with = self
            .bindings
            .iter()
            .enumerate()
            .filter(|(_, binding)| binding.tells());
        for (inside, binding) in with {
            let mut above = self.nodes[binding.inner].parent;
            while let Some(at) = above {
                if let Some(number) = without.get(&at) {
                    bound.parts[*number].within.get_or_insert(inside);
                }
                above = self.nodes[at].parent;
            }
        }
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
            within: None,
            state: None,
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
        if binding.alt.is_some() {
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
                // A number alone has the type of what is there.
                if value_text::parse(&value.text, given.ty()).is_ok() {
                    self.bound.acts.push(Act::Set { node, tag: name });
                    return Some((Does::Give(value.text.clone()), self.slot(node, Use::Given)));
                }
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
        let number = source
            .text
            .parse::<f64>()
            .ok()
            .filter(|_| wanted == Wanted::Number);
        let text = number.map_or_else(|| source.text.clone(), |number| format!("{number:?}"));
        let expression = match Expression::new(&text, scope) {
            Ok(expression) => expression,
            Err(problem) => {
                let problem = self.in_plant(&source.text).unwrap_or(problem);
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

    /// What a text names of a plant, if that does not have it.
    fn in_plant(&self, text: &str) -> Option<String> {
        let names = names(text).into_iter().map(|name| &text[name]);
        let plants = &self.simulation.program().plants;
        names
            .filter(|name| self.simulation.resolve(name).is_err())
            .find_map(|name| {
                let (plant, tag) = name.split_once('.')?;
                let plant = plants.iter().find(|it| it.name.eq_ignore_ascii_case(plant))?;
                Some(format!("{} has no tag `{tag}`", plant.name))
            })
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
