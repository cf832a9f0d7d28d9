//! The instructions of the DSL, and the arguments of their calls by name.

use super::super::address::{Span, Tag};
use super::super::conversion::Convert;
use super::super::model::{Condition, Constant, CopyOptions, Operand};
use super::condition::{self, operand, shown, span, tag};
use super::problems::{Problems, Unread, expression};
use ruff_python_ast::{Expr, ExprCall};

/// The instructions and the names of their arguments, in the order in which they may be given by place. The first ones
/// must be given; how many says the number.
const SIGNATURES: &[(&str, usize, &[&str])] = &[
    ("out", 1, &["address", "oneshot"]),
    ("set", 1, &["address", "oneshot"]),
    ("reset", 1, &["address", "oneshot"]),
    ("ton", 3, &["timer", "setpoint", "unit"]),
    ("tof", 3, &["timer", "setpoint", "unit"]),
    ("rton", 3, &["timer", "setpoint", "unit", "reset"]),
    ("rtof", 3, &["timer", "setpoint", "unit", "reset"]),
    ("ctu", 2, &["counter", "setpoint", "reset"]),
    ("ctd", 2, &["counter", "setpoint", "reset"]),
    ("ctud", 2, &["counter", "setpoint", "count_down", "reset"]),
    (
        "copy",
        2,
        &["source", "destination", "oneshot", "options", "convert"],
    ),
    (
        "copy_block",
        2,
        &[
            "source_range",
            "destination_start",
            "oneshot",
            "options",
            "convert",
        ],
    ),
    (
        "copy_fill",
        2,
        &["source", "destination_range", "oneshot", "options"],
    ),
    (
        "copy_pack",
        2,
        &[
            "source_range",
            "destination",
            "oneshot",
            "options",
            "allow_whitespace",
        ],
    ),
    (
        "copy_unpack",
        2,
        &["source", "destination_range", "oneshot", "options"],
    ),
    ("shift", 1, &["range", "clock", "reset"]),
    (
        "search",
        6,
        &[
            "condition",
            "search_value",
            "start_address",
            "end_address",
            "result_address",
            "result_flag",
            "continuous",
            "oneshot",
        ],
    ),
    (
        "event_drum",
        5,
        &[
            "outputs",
            "events",
            "pattern",
            "current_step",
            "completion_flag",
            "reset",
            "jump",
            "jump_step",
            "jog",
        ],
    ),
    (
        "time_drum",
        7,
        &[
            "outputs",
            "presets",
            "unit",
            "pattern",
            "current_step",
            "accumulator",
            "completion_flag",
            "reset",
            "jump",
            "jump_step",
            "jog",
        ],
    ),
    ("calc", 2, &["formula", "result_destination", "one_shot"]),
    ("math_hex", 2, &["formula", "result_destination", "one_shot"]),
    ("call", 1, &["subroutine_name"]),
    ("next_loop", 0, &[]),
    ("end", 0, &[]),
];

/// Whether the DSL has an instruction of this name.
pub(super) fn is_instruction(name: &str) -> bool {
    SIGNATURES.iter().any(|(own, ..)| *own == name)
}

/// The arguments of a call by name.
pub(super) struct Arguments<'e> {
    call: &'e ExprCall,
    given: Vec<(&'static str, &'e Expr)>,
}

impl<'e> Arguments<'e> {
    pub(super) fn of(
        problems: &mut Problems<'_>,
        call: &'e ExprCall,
    ) -> Result<(&'static str, Arguments<'e>), Unread> {
        let word = match &*call.func {
            Expr::Name(name) => name.id.as_str(),
            _ => "",
        };
        let Some((word, least, names)) = SIGNATURES.iter().find(|(own, ..)| *own == word) else {
            let shown = shown(problems.source(&*call.func));
            return Err(problems.note(call, format!("`{shown}` is not an instruction of the DSL")));
        };
        let mut given: Vec<(&'static str, &Expr)> = Vec::with_capacity(names.len());
        for (place, argument) in call.arguments.args.iter().enumerate() {
            if let Expr::Starred(_) = argument {
                return Err(problems.note(argument, "`*` is not in the DSL: give the arguments one by one"));
            }
            let Some(name) = names.get(place) else {
                let message = format!("`{word}` has no more than {} arguments", names.len());
                return Err(problems.note(argument, message));
            };
            given.push((name, argument));
        }
        for keyword in &call.arguments.keywords {
            let written = keyword.arg.as_ref().map_or("**", |name| name.as_str());
            // The page writes it both ways.
            let meant = match written {
                "oneshot" if names.contains(&"one_shot") => "one_shot",
                "one_shot" if names.contains(&"oneshot") => "oneshot",
                written => written,
            };
            let Some(name) = names.iter().find(|name| **name == meant) else {
                return Err(problems.note(keyword, format!("`{word}` has no argument `{written}`")));
            };
            if given.iter().any(|(there, _)| there == name) {
                return Err(problems.note(keyword, format!("`{written}` is given twice")));
            }
            given.push((name, &keyword.value));
        }
        for name in &names[..*least] {
            if !given.iter().any(|(there, _)| there == name) {
                return Err(problems.note(call, format!("`{word}` lacks its argument `{name}`")));
            }
        }
        Ok((word, Arguments { call, given }))
    }

    pub(super) fn get(&self, name: &str) -> Option<&'e Expr> {
        let row = self.given.iter().find(|(own, _)| *own == name)?;
        Some(row.1)
    }

    /// An argument that is known to be given.
    pub(super) fn must(&self, problems: &mut Problems<'_>, name: &str) -> Result<&'e Expr, Unread> {
        let lacks = || format!("the argument `{name}` is missing");
        self.get(name).ok_or_else(|| problems.note(self.call, lacks()))
    }

    pub(super) fn operand(&self, problems: &mut Problems<'_>, name: &str) -> Result<Operand, Unread> {
        let argument = self.must(problems, name)?;
        operand(problems, argument)
    }

    pub(super) fn tag(&self, problems: &mut Problems<'_>, name: &str) -> Result<Tag, Unread> {
        let argument = self.must(problems, name)?;
        tag(problems, argument)
    }

    pub(super) fn span(&self, problems: &mut Problems<'_>, name: &str) -> Result<Span, Unread> {
        let argument = self.must(problems, name)?;
        span(problems, argument)
    }

    pub(super) fn flag(&self, problems: &mut Problems<'_>, name: &str) -> Result<bool, Unread> {
        match self.get(name) {
            None => Ok(false),
            Some(Expr::BooleanLiteral(literal)) => Ok(literal.value),
            Some(other) => Err(problems.note(other, format!("`{name}` is True or False"))),
        }
    }

    /// A condition under a lambda, so that Python does not look at it at once.
    pub(super) fn pin(&self, problems: &mut Problems<'_>, name: &str) -> Result<Option<Condition>, Unread> {
        match self.get(name) {
            None => Ok(None),
            Some(Expr::Lambda(lambda)) if lambda.parameters.is_none() => {
                condition::condition(problems, &lambda.body).map(Some)
            }
            Some(other) => Err(problems.note(
                other,
                format!("`{name}` is a condition under a lambda: {name}=lambda: c.Name"),
            )),
        }
    }

    pub(super) fn options(&self, problems: &mut Problems<'_>) -> Result<CopyOptions, Unread> {
        let own = CopyOptions {
            convert: self.convert(problems)?,
            allow_whitespace: self.flag(problems, "allow_whitespace")?,
            named: Vec::new(),
        };
        match self.get("options") {
            None | Some(Expr::NoneLiteral(_)) => Ok(own),
            Some(Expr::StringLiteral(literal)) => {
                let parts = literal
                    .value
                    .to_str()
                    .split(',')
                    .map(str::trim)
                    .filter(|part| !part.is_empty());
                let named = parts.map(|part| match part.split_once('=') {
                    Some((name, value)) => (name.trim().to_owned(), value.trim().to_owned()),
                    None => (part.to_owned(), "True".to_owned()),
                });
                Ok(CopyOptions {
                    named: named.collect(),
                    ..own
                })
            }
            Some(other) => Err(problems.note(other, "`options` is None or a text")),
        }
    }

    /// `to_value`, `to_text(suppress_zero=False)`
    fn convert(&self, problems: &mut Problems<'_>) -> Result<Option<Convert>, Unread> {
        let Some(given) = self.get("convert") else {
            return Ok(None);
        };
        let (name, call) = match given {
            Expr::NoneLiteral(_) => return Ok(None),
            Expr::Call(call) => (&*call.func, Some(call)),
            other => (other, None),
        };
        let found = match name {
            Expr::Name(name) => Convert::named(&name.id),
            _ => None,
        };
        let Some(mut convert) = found else {
            let message = "a copy converts with to_value, to_ascii, to_binary or to_text(..)";
            return Err(problems.note(given, message));
        };
        let Some(call) = call else {
            return Ok(Some(convert));
        };
        if let Some(argument) = call.arguments.args.first() {
            return Err(problems.note(argument, "the options of a conversion are given by name"));
        }
        for keyword in &call.arguments.keywords {
            let name = keyword.arg.as_ref().map_or("**", |name| name.as_str());
            let value = match operand(problems, &keyword.value)? {
                Operand::Constant(Constant::Bit(on)) => u8::from(on).to_string(),
                Operand::Constant(Constant::Text(text)) => text,
                Operand::Constant(Constant::Int(number)) => number.to_string(),
                _ => return Err(problems.note(&keyword.value, "an option of a conversion is fixed")),
            };
            convert
                .set(name, &value)
                .map_err(|why| problems.note(keyword, why))?;
        }
        Ok(Some(convert))
    }

    /// A text that Python does not put together itself.
    pub(super) fn text(
        &self,
        problems: &mut Problems<'_>,
        name: &str,
    ) -> Result<(&'e str, &'e Expr), Unread> {
        match self.must(problems, name)? {
            argument @ Expr::StringLiteral(literal) => Ok((literal.value.to_str(), argument)),
            other => {
                let what = expression(other);
                Err(problems.note(other, format!("`{name}` is a text in quotes, and this is {what}")))
            }
        }
    }
}
