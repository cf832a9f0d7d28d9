//! What an operand asks for: the block it belongs to, which way the value goes, and which tags fit how well.

use crate::typing::{Open, Operand, Typing};
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::type_by_form;
use ladder_analysis::program::{ParameterKind, SystemTag};
use ladder_analysis::values::callable::is_callable;
use ladder_analysis::values::types::{Scalar, Type, are_comparable, passes};
use ladder_analysis::written::user_block::{Parameter, UserBlockFacts};
use ladder_analysis::{in_class, state_member};
use ladder_instructions::{
    Accepts, Direction, Instruction, Semantics, Shape, StateType, States, Truth, TypeClass, lookup,
};
use ladder_syntax::Name;

/// What a block is, as far as its first part shows.
#[derive(Clone, Copy)]
pub(crate) enum Called<'c> {
    Row(&'static Instruction),
    User(&'c UserBlockFacts),
}

/// The blocks that a first part may mean: two for NOT, else at most one.
pub(crate) fn called<'c>(context: &'c Context, shape: Shape, head: &str) -> Vec<Called<'c>> {
    if head.starts_with('$') {
        let key = Name::new(head);
        let own = context
            .user_blocks
            .iter()
            .find(|block| block.key == key && block.shape == shape);
        let found = own.or_else(|| {
            let mut others = context.others.blocks(&key).map(|(_, block)| &block.facts);
            others.find(|block| block.shape == shape)
        });
        return found.map(Called::User).into_iter().collect();
    }
    lookup(shape, head).map(Called::Row).collect()
}

/// What fits into a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Bool,
    /// A BOOL, or a range of them.
    BoolOrRange,
    /// As `BoolOrRange`, or a timer or counter.
    BoolRangeOrState,
    State(StateType),
    TimerOrCounter,
    /// A tag of a type in this class.
    Class(TypeClass),
    /// A value that passes to this type.
    To(Scalar),
    /// A value that can be compared with this type.
    With(Scalar),
    Number,
    Integer,
    /// A TIME, or plain milliseconds.
    Duration,
    /// An array.
    Range,
    /// A whole structure or array of this type.
    Whole(Type),
    Label,
    Function,
    SearchOperator,
    /// Any value.
    Any,
}

/// What an operand asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Wanted {
    pub(crate) kind: Kind,
    pub(crate) reads: bool,
    pub(crate) writes: bool,
    /// Whether a whole expression may be here.
    pub(crate) expression: bool,
    /// A timer's, counter's or bistable's own tag, or a result: what other blocks write is less likely meant.
    pub(crate) by_coil: bool,
}

impl Wanted {
    const fn read(kind: Kind) -> Wanted {
        Wanted {
            kind,
            reads: true,
            writes: false,
            expression: false,
            by_coil: false,
        }
    }
}

/// What the operand around the cursor asks for. None if nothing is known of its block.
pub(crate) fn wanted(typing: &Typing<'_>, operand: &Operand) -> Option<Wanted> {
    if let Some(value) = compared(typing, operand) {
        return Some(value);
    }
    if let Some(inner) = inside(typing, operand) {
        return Some(inner);
    }
    let shape = operand.shape?;
    let called = called(typing.context, shape, &operand.head);
    called.iter().find_map(|called| match called {
        Called::Row(row) => {
            let formal = match &operand.name {
                Some(name) => row.named(name),
                None => row.positional(operand.before.len()),
            }?;
            let mut wanted = of_row(typing, operand, formal.accepts);
            (wanted.reads, wanted.writes) = directions(formal.direction);
            wanted.by_coil = shape == Shape::Coil;
            Some(wanted)
        }
        Called::User(block) => Some(of_parameter(parameter(block, operand)?)),
    })
}

/// A value of an enumeration after `step =` or `step <>` in an expression.
fn compared(typing: &Typing<'_>, operand: &Operand) -> Option<Wanted> {
    let before = typing.text[operand.start..typing.word.start].trim_end();
    let left = before.strip_suffix("<>").or_else(|| before.strip_suffix('='))?;
    if left.ends_with([':', '<', '>']) || operand.open.last() == Some(&Open::Index) {
        return None;
    }
    let ty @ Scalar::Enum(_) = type_of(typing.context, typing.scope, last_path(left.trim_end()))? else {
        return None;
    };
    Some(Wanted {
        expression: true,
        ..Wanted::read(Kind::With(ty))
    })
}

/// The path that a text ends with.
fn last_path(text: &str) -> &str {
    let mut depth = 0usize;
    let begin = text.char_indices().rev().find(|(_, letter)| {
        match letter {
            ']' => depth += 1,
            '[' if depth == 0 => return true,
            '[' => depth -= 1,
            _ if depth > 0 => {}
            letter => return !letter.is_alphanumeric() && !matches!(letter, '_' | '.'),
        }
        false
    });
    begin.map_or(text, |(at, letter)| &text[at + letter.len_utf8()..])
}

/// The parameter of a user-defined block that is being given.
pub(crate) fn parameter<'c>(block: &'c UserBlockFacts, operand: &Operand) -> Option<&'c Parameter> {
    match &operand.name {
        Some(name) => block.parameters.iter().find(|p| p.key == Name::new(name)),
        None => block.parameters.get(operand.before.len()),
    }
}

fn of_parameter(parameter: &Parameter) -> Wanted {
    let kind = match parameter.ty {
        Some(Type::Scalar(Scalar::Bool)) => Kind::Bool,
        Some(Type::Scalar(ty)) => Kind::To(ty),
        Some(Type::State(state)) => Kind::State(state),
        Some(Type::Array { .. }) => Kind::Range,
        Some(ty @ Type::Compound(_)) => Kind::Whole(ty),
        None => Kind::Any,
    };
    Wanted {
        reads: parameter.kind != ParameterKind::Output,
        writes: parameter.kind != ParameterKind::Input,
        ..Wanted::read(kind)
    }
}

const fn directions(direction: Direction) -> (bool, bool) {
    match direction {
        Direction::In => (true, false),
        Direction::Out => (false, true),
        Direction::InOut => (true, true),
    }
}

/// What is asked for inside an index, or among the arguments of a function of an expression.
fn inside(typing: &Typing<'_>, operand: &Operand) -> Option<Wanted> {
    match operand.open.last()? {
        Open::Index => Some(Wanted::read(Kind::Integer)),
        Open::Group => Some(Wanted {
            expression: true,
            ..Wanted::read(result_type(typing, operand).map_or(Kind::Any, Kind::To))
        }),
        Open::Call(name, commas) => {
            let row = function(name);
            let accepts = row.and_then(|row| row.positional(commas + 1)).map(|o| o.accepts);
            let kind = match accepts {
                Some(Accepts::Bool) => Kind::Bool,
                Some(Accepts::Integer) => Kind::Integer,
                Some(Accepts::Number) => Kind::Number,
                Some(Accepts::String) => Kind::Class(TypeClass::String),
                Some(_) => result_type(typing, operand).map_or(Kind::Any, Kind::To),
                None if name.eq_ignore_ascii_case("SUM") => Kind::Range,
                None => Kind::Any,
            };
            Some(Wanted {
                expression: true,
                ..Wanted::read(kind)
            })
        }
    }
}

/// The row of a function that expressions call by name.
pub(crate) fn function(name: &str) -> Option<&'static Instruction> {
    lookup(Shape::Logical, name).find(|row| is_callable(row))
}

fn of_row(typing: &Typing<'_>, operand: &Operand, accepts: Accepts) -> Wanted {
    let kind = match accepts {
        Accepts::Bool => Kind::Bool,
        Accepts::BoolOrRange => Kind::BoolOrRange,
        Accepts::BoolRangeOrState => Kind::BoolRangeOrState,
        Accepts::State(state) => Kind::State(state),
        Accepts::TimerOrCounter => Kind::TimerOrCounter,
        Accepts::Result(class) => Kind::Class(class),
        Accepts::Value | Accepts::Expression => result_type(typing, operand).map_or(Kind::Any, Kind::To),
        Accepts::Compared => {
            let mut others = operand.before.iter().map(|range| &typing.text[range.clone()]);
            let ty = others.find_map(|text| type_of(typing.context, typing.scope, text));
            ty.map_or(Kind::Any, Kind::With)
        }
        Accepts::Convertible | Accepts::Tag | Accepts::RangeOrValue => Kind::Any,
        Accepts::Wrapped => Kind::Class(TypeClass::BitsOrInteger),
        Accepts::Integer => Kind::Integer,
        Accepts::Number => Kind::Number,
        Accepts::String => Kind::Class(TypeClass::String),
        Accepts::Duration => Kind::Duration,
        Accepts::Time => Kind::To(Scalar::Time),
        Accepts::Count => Kind::To(Scalar::Dint),
        Accepts::Range => Kind::Range,
        Accepts::Label => Kind::Label,
        Accepts::Function => Kind::Function,
        Accepts::SearchOperator => Kind::SearchOperator,
    };
    Wanted {
        expression: accepts == Accepts::Expression,
        ..Wanted::read(kind)
    }
}

/// The type of the block's result, its first operand.
fn result_type(typing: &Typing<'_>, operand: &Operand) -> Option<Scalar> {
    let first = operand.before.first()?;
    type_of(typing.context, typing.scope, &typing.text[first.clone()])
}

/// The type of a place that is written out: `count`, `a[3]`, `t.ET`, `%MW1`. None for anything else.
pub(crate) fn type_of(context: &Context, scope: usize, text: &str) -> Option<Scalar> {
    let text = text.trim();
    if let Some((base, member)) = text.rsplit_once('.') {
        if base.eq_ignore_ascii_case("SYS") {
            return Some(SystemTag::from_name(member)?.ty());
        }
        if let Some(Type::State(state)) = whole_type(context, scope, base) {
            return Some(state_member(state, member)?.ty(context.profile.semantics()));
        }
        if type_of(context, scope, base).is_some() {
            return Some(Scalar::Bool);
        }
    }
    whole_type(context, scope, text)?.scalar()
}

/// The type of a tag, or of an array's element.
pub(crate) fn whole_type(context: &Context, scope: usize, text: &str) -> Option<Type> {
    let text = text.trim();
    if text.contains(['[', '.']) {
        return crate::path::type_of(context, scope, text);
    }
    match crate::path::tag_of(context, scope, text) {
        Some(tag) => tag.ty,
        None => type_by_form(text).map(|(scalar, _)| Type::Scalar(scalar)),
    }
}

/// How well a tag of a type fits, in a profile with these differences: 0 as it is, 1 it passes, 2 an element or member
/// of it does. None: not at all.
pub(crate) fn rank(semantics: &Semantics, wanted: &Wanted, ty: Type) -> Option<u8> {
    const COLUMNS: usize = 32;
    match (wanted.kind, ty) {
        (Kind::Whole(whole), _) if whole == ty => return Some(0),
        (Kind::Whole(_), _) => return None,
        (Kind::Any, Type::Compound(_)) => return Some(1),
        (_, Type::Compound(_)) => {
            let columns = ty.column_list();
            let mut parts = columns
                .iter()
                .take(COLUMNS)
                .filter(|column| !matches!(column.ty, Type::Compound(_)));
            return parts
                .any(|column| rank(semantics, wanted, column.ty).is_some())
                .then_some(2);
        }
        _ => {}
    }
    let bits = |ty: Scalar| ty.is_bits() || ty.is_integer();
    match (wanted.kind, ty) {
        (Kind::Bool | Kind::BoolOrRange | Kind::BoolRangeOrState, _) => match ty {
            Type::Scalar(Scalar::Bool) => Some(0),
            Type::Scalar(ty) if semantics.truth == Truth::NotZero && ty.is_number() => Some(1),
            Type::Array {
                element: Scalar::Bool,
                ..
            } => Some(1),
            Type::State(state) if wanted.kind == Kind::BoolRangeOrState => {
                (state.is_timer() || state.is_counter()).then_some(1)
            }
            // `t.Q` and `word.3`
            Type::State(_) if !wanted.writes => Some(2),
            Type::Scalar(ty) if bits(ty) => Some(3),
            Type::Array { element, .. } if bits(element) => Some(3),
            _ => None,
        },
        (Kind::State(wanted), Type::State(state)) if state == wanted => Some(0),
        (Kind::State(wanted), Type::State(state)) => {
            (semantics.states == States::Shared && state.is_of_one_sort_with(wanted)).then_some(1)
        }
        (Kind::TimerOrCounter, Type::State(state)) => (state.is_timer() || state.is_counter()).then_some(0),
        (Kind::State(_) | Kind::TimerOrCounter, _) => None,
        (Kind::Range, Type::Array { .. }) => Some(0),
        (Kind::Range, _) => None,
        (Kind::Label | Kind::Function | Kind::SearchOperator | Kind::Whole(_), _)
        | (_, Type::Compound(_)) => None,
        (Kind::Any, Type::Scalar(_)) => Some(0),
        (Kind::Any, Type::Array { .. } | Type::State(_)) => Some(1),
        (_, Type::Scalar(ty)) => scalar_rank(wanted, ty),
        (_, Type::Array { element, .. }) => scalar_rank(wanted, element).map(|_| 2),
        (_, Type::State(state)) => {
            let members = ["ET", "PT", "CV", "PV", "Q"];
            let fits = |word: &&str| {
                state_member(state, word)
                    .is_some_and(|member| scalar_rank(wanted, member.ty(semantics)).is_some())
            };
            (!wanted.writes && members.iter().any(fits)).then_some(2)
        }
    }
}

/// As `rank`, of one value.
pub(crate) fn scalar_rank(wanted: &Wanted, ty: Scalar) -> Option<u8> {
    let exact = |fits: bool| fits.then_some(0);
    match wanted.kind {
        Kind::Bool | Kind::BoolOrRange | Kind::BoolRangeOrState => exact(ty == Scalar::Bool),
        Kind::Class(class) => exact(in_class(ty, class)),
        Kind::To(to) if ty == to => Some(0),
        Kind::To(to) if wanted.writes => passes(to, ty).then_some(1),
        Kind::To(to) => passes(ty, to).then_some(1),
        Kind::With(other) if ty == other => Some(0),
        Kind::With(other) => are_comparable(ty, other).then_some(1),
        Kind::Number => exact(ty.is_number()),
        Kind::Integer => exact(ty.is_integer()),
        Kind::Duration => match ty {
            Scalar::Time => Some(0),
            _ => ty.is_integer().then_some(1),
        },
        Kind::Any => Some(0),
        _ => None,
    }
}
