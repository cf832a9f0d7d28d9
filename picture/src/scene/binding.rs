//! The attributes that make a drawing a scene.

use super::colour::is_colour;
use super::finding::Finding;
use super::names::own_names;
use super::source::{Expression, Raw};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::scenario::Written;
use ladder_simulator::value_text;
use ladder_syntax::TextRange;

/// An attribute of the namespace `l`, for those who help to write it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Attribute {
    /// Its name, with `l:`.
    pub name: &'static str,
    /// What it does.
    pub about: &'static str,
    /// Whether expressions are written in it.
    pub takes_expression: bool,
}

const fn bound(name: &'static str, about: &'static str) -> Attribute {
    Attribute {
        name,
        about,
        takes_expression: true,
    }
}

const fn plain(name: &'static str, about: &'static str) -> Attribute {
    Attribute {
        name,
        about,
        takes_expression: false,
    }
}

/// All of them.
pub const ATTRIBUTES: [Attribute; 20] = [
    bound("l:show", "It is shown while this is TRUE: `l:show=\"late\"`."),
    bound(
        "l:fill",
        "What it is filled with: `l:fill=\"late: red; run: #2b2; #888\"`. The first condition that is TRUE wins; the last colour has none.",
    ),
    bound("l:stroke", "The colour of its line, as `l:fill`."),
    bound(
        "l:move-x",
        "How far it is to the right of where it is drawn, in units of the drawing: `l:move-x=\"plant.front * 2 / 5\"`.",
    ),
    bound(
        "l:move-y",
        "How far it is below where it is drawn, in units of the drawing.",
    ),
    bound(
        "l:rotate",
        "How far it is turned, in degrees, about the point of `l:at`.",
    ),
    bound(
        "l:scale-x",
        "How wide it is, as a part of how it is drawn, seen from the point of `l:at`: 0.5 is half.",
    ),
    bound(
        "l:scale-y",
        "How high it is, as a part of how it is drawn, seen from the point of `l:at`: `l:scale-y=\"level / 1000.0\"`.",
    ),
    plain(
        "l:at",
        "The point that stays where it is, of `l:rotate` and `l:scale-`: `l:at=\"120 80\"`.",
    ),
    bound("l:text", "What is written in it: `l:text=\"plant.level\"`."),
    plain(
        "l:format",
        "How `l:text` writes a number: `0` without and `0.00` with two decimals, `000` with at least three digits.",
    ),
    plain("l:unit", "What follows the number of `l:text`: `l:unit=\"mm\"`."),
    bound(
        "l:opacity",
        "How dense it is, from 0, where it is not seen, to 1.",
    ),
    plain(
        "l:blink",
        "It blinks, once in this time: `l:blink=\"500ms\"`. It does not for those who ask for less motion.",
    ),
    bound(
        "l:press",
        "The tag that is TRUE while it is pressed: `l:press=\"start\"`.",
    ),
    bound(
        "l:toggle",
        "The tag that changes with each click: `l:toggle=\"plant.stuck\"`.",
    ),
    bound(
        "l:set",
        "The tag that gets a value with each click: `l:set=\"wanted := 50\"`.",
    ),
    plain(
        "l:alt",
        "What it is, for those who do not see it; its state is told after it: `l:alt=\"near sensor\"`.",
    ),
    plain(
        "l:program",
        "The program, seen from this file's folder. Without it the program has the name of the scene.",
    ),
    plain(
        "l:plant",
        "The model of the machine that runs beside the program: `l:plant=\"tank.clad\"`, of several `a.clad as a; b.clad as b`.",
    ),
];

/// What one attribute does.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum What {
    Show(Expression),
    Paint { is_stroke: bool, cases: Vec<Case> },
    MoveX(Expression),
    MoveY(Expression),
    Rotate(Expression),
    ScaleX(Expression),
    ScaleY(Expression),
    Text(Expression),
    Opacity(Expression),
    Press(Expression),
    Toggle(Expression),
    Set(Expression, Expression),
}

/// A colour, and when.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Case {
    pub(super) condition: Option<Expression>,
    pub(super) colour: String,
}

/// An attribute as it is written.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct One {
    pub(super) name: &'static str,
    /// Its value.
    pub(super) range: TextRange,
    /// The same as text.
    pub(super) value: String,
    pub(super) what: What,
}

/// How a number is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Digits {
    pub(super) before: usize,
    pub(super) after: usize,
}

/// All that one element has of them.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Binding {
    pub(super) all: Vec<One>,
    /// The element.
    pub(super) inner: usize,
    /// What is around it, or itself.
    pub(super) outer: usize,
    /// The element that has its text.
    pub(super) text: usize,
    pub(super) at: (f64, f64),
    pub(super) digits: Option<Digits>,
    pub(super) unit: String,
    pub(super) blink: Option<u64>,
    pub(super) alt: Option<String>,
    /// What it is called in a table.
    pub(super) name: String,
}

impl Binding {
    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty() && self.alt.is_none() && self.blink.is_none()
    }

    pub(super) fn expressions(&self) -> impl Iterator<Item = &Written> {
        self.all.iter().flat_map(One::expressions)
    }

    /// Whether a group around the element shows it.
    pub(super) fn wants_group(&self) -> bool {
        self.blink.is_some() || self.all.iter().any(|one| one.what.is_of_group())
    }

    pub(super) fn acts(&self) -> bool {
        let is_act = |one: &One| matches!(one.what, What::Press(_) | What::Toggle(_) | What::Set(..));
        self.all.iter().any(is_act)
    }

    /// Whether it has a state that can be told in words.
    pub(super) fn tells(&self) -> bool {
        let is_told = |one: &One| matches!(one.what, What::Paint { .. } | What::Text(_));
        self.all.iter().any(is_told)
    }

    /// Reads an attribute.
    pub(super) fn read(&mut self, name: &str, raw: Raw<'_>, findings: &mut Vec<Finding>) {
        let mut add = |name: &'static str, what: What| {
            let (range, value) = (raw.range(), raw.value());
            self.all.push(One {
                name,
                range,
                value,
                what,
            });
        };
        if raw.trimmed().is_empty() {
            return findings.push(Finding::error(
                raw.range(),
                format!("l:{name} is empty"),
                "write an expression as in [CALC], such as level > 80, or take the attribute out",
            ));
        }
        let wrong = |message: String, help| Finding::error(raw.range(), message, help);
        match name {
            "show" => add("l:show", What::Show(raw.expression())),
            "fill" | "stroke" => {
                let is_stroke = name == "stroke";
                let cases = cases(raw, findings);
                add(if is_stroke { "l:stroke" } else { "l:fill" }, What::Paint { is_stroke, cases });
            }
            "move-x" => add("l:move-x", What::MoveX(raw.expression())),
            "move-y" => add("l:move-y", What::MoveY(raw.expression())),
            "rotate" => add("l:rotate", What::Rotate(raw.expression())),
            "scale-x" => add("l:scale-x", What::ScaleX(raw.expression())),
            "scale-y" => add("l:scale-y", What::ScaleY(raw.expression())),
            "text" => add("l:text", What::Text(raw.expression())),
            "opacity" => add("l:opacity", What::Opacity(raw.expression())),
            "press" => add("l:press", What::Press(raw.expression())),
            "toggle" => add("l:toggle", What::Toggle(raw.expression())),
            "set" => match raw.split_once(":=") {
                Some((tag, value)) => add("l:set", What::Set(tag.expression(), value.expression())),
                None => findings.push(wrong(
                    "l:set has no `:=`".to_owned(),
                    "write the tag and its new value, as in wanted := 50",
                )),
            },
            "at" => match numbers(&raw.value()) {
                Some(at) => self.at = at,
                None => findings.push(wrong(
                    format!("`{}` is not a point", raw.value()),
                    "write two numbers, as in l:at=\"120 80\"",
                )),
            },
            "format" => match digits(&raw.value()) {
                Some(digits) => self.digits = Some(digits),
                None => findings.push(wrong(
                    format!("`{}` is not a form of numbers", raw.value()),
                    "write 0, or zeros with a point between them, as in 0.00",
                )),
            },
            "unit" => self.unit = raw.value(),
            "blink" => match value_text::parse(raw.value().trim(), Scalar::Time) {
                Ok(Value::Int(nanoseconds)) if nanoseconds >= 100_000_000 => {
                    self.blink = Some(nanoseconds.unsigned_abs() / 1_000_000);
                }
                _ => findings.push(wrong(
                    format!("`{}` is not a time of 100 ms or more", raw.value()),
                    "write how long it is from one flash to the next, as in l:blink=\"500ms\"",
                )),
            },
            "alt" => self.alt = Some(raw.value().trim().to_owned()),
            "program" | "plant" => findings.push(wrong(
                format!("l:{name} belongs to the element `svg` at the beginning"),
                "move it there",
            )),
            other => findings.push(wrong(
                format!("there is no attribute l:{other}"),
                "the attributes are show, fill, stroke, move-x, move-y, rotate, scale-x, scale-y, at, text, format, unit, opacity, \
                 blink, press, toggle, set and alt",
            )),
        }
    }
}

impl One {
    fn expressions(&self) -> impl Iterator<Item = &Written> {
        let (first, second, cases): (_, _, &[Case]) = match &self.what {
            What::Paint { cases, .. } => (None, None, cases),
            What::Set(tag, value) => (Some(tag), Some(value), &[]),
            What::Show(it)
            | What::MoveX(it)
            | What::MoveY(it)
            | What::Rotate(it)
            | What::ScaleX(it)
            | What::ScaleY(it)
            | What::Text(it)
            | What::Opacity(it)
            | What::Press(it)
            | What::Toggle(it) => (Some(it), None, &[]),
        };
        let conditions = cases.iter().filter_map(|case| case.condition.as_ref());
        let all = first.into_iter().chain(second).chain(conditions);
        all.map(|it| &it.written)
    }
}

impl What {
    fn is_of_group(&self) -> bool {
        matches!(
            self,
            What::Show(_)
                | What::MoveX(_)
                | What::MoveY(_)
                | What::Rotate(_)
                | What::ScaleX(_)
                | What::ScaleY(_)
                | What::Opacity(_)
        )
    }
}

/// `near: #2b2; far: red; #888`
fn cases(raw: Raw<'_>, findings: &mut Vec<Finding>) -> Vec<Case> {
    let mut cases = Vec::new();
    let parts = raw.split(';');
    let last = parts.len() - 1;
    for (number, part) in parts.into_iter().enumerate() {
        let part = part.trimmed();
        if part.is_empty() {
            // A sign at the end is not an error.
            continue;
        }
        let (condition, colour) = match part.rsplit_once(':') {
            Some((condition, colour)) => (Some(condition.expression()), colour.trimmed()),
            None => (None, part),
        };
        let value = colour.value();
        if !is_colour(&value) {
            findings.push(Finding::error(
                colour.range(),
                format!("`{value}` is not a colour"),
                "write a name, #rgb, #rrggbb, or var(--ladder-on), -off, -warning or -alarm; a condition has a colon after it",
            ));
        }
        if condition.is_none() && number < last {
            findings.push(Finding::error(
                part.range(),
                format!("`{value}` has no condition, and so what follows is never seen"),
                "write the colour without a condition at the end",
            ));
        }
        cases.push(Case {
            condition,
            colour: own_names("fill", &value),
        });
    }
    cases
}

fn numbers(text: &str) -> Option<(f64, f64)> {
    let mut numbers = text.split([' ', ',']).filter(|part| !part.is_empty());
    let mut next = || {
        numbers
            .next()?
            .parse::<f64>()
            .ok()
            .filter(|number| number.is_finite())
    };
    let at = (next()?, next()?);
    numbers.next().is_none().then_some(at)
}

fn digits(text: &str) -> Option<Digits> {
    let text = text.trim();
    let (before, after) = text.split_once('.').unwrap_or((text, ""));
    let is_zeros = |part: &str| part.len() <= 12 && part.chars().all(|c| c == '0');
    (!before.is_empty() && is_zeros(before) && is_zeros(after)).then_some(Digits {
        before: before.len(),
        after: after.len(),
    })
}
