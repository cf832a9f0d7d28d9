//! Blocks of every row of the instruction table, with operands of the right types.

use super::dice::Dice;
use super::expression::expression;
use super::operand::{INTEGERS, integer, place, range, read, read_exactly};
use super::scope::{Scope, Type};
use super::value::{SCALARS, literal};
use ladder_analysis::values::types::{DEFAULT_STRING, Scalar, converts};
use ladder_instructions::{
    Accepts, Direction, Group, Instruction, Op, Operand, Presence, Profile, TABLE, TypeClass,
};

const STRING: Scalar = Scalar::String(DEFAULT_STRING);

/// A block of any row but those of program flow, which need their targets.
pub(super) fn any(dice: &mut Dice, scope: &mut Scope) -> String {
    loop {
        // Contacts and coils are most of a program.
        let row = if dice.one_in(2) {
            let op = dice.of(&[
                Op::Contact,
                Op::NegatedContact,
                Op::Coil,
                Op::SetCoil,
                Op::ResetCoil,
            ]);
            ladder_instructions::by_op(op)
        } else {
            dice.of(&TABLE.iter().collect::<Vec<_>>())
        };
        let refers = row
            .operands
            .iter()
            .any(|operand| matches!(operand.accepts, Accepts::Label | Accepts::Function));
        let is_loop = matches!(row.op, Op::For | Op::Next | Op::End | Op::Ret);
        if !refers && !is_loop {
            return block(dice, scope, row);
        }
    }
}

/// A contact or a coil, for programs that the reference evaluates.
pub(super) fn boolean(dice: &mut Dice, scope: &mut Scope) -> String {
    let heads = ["[ ]", "[ ]", "[/]", "( )", "(/)", "(S)", "(R)", "[NOT]"];
    match dice.of(&heads) {
        "[NOT]" => "[NOT]".to_owned(),
        head => format!("{head}( {} )", place(dice, scope, Scalar::Bool)),
    }
}

/// A block of a row.
pub(super) fn block(dice: &mut Dice, scope: &mut Scope, row: &'static Instruction) -> String {
    let spellings: Vec<&str> = row.spellings().collect();
    let spelling = if dice.one_in(5) {
        dice.of(&spellings)
    } else {
        row.mnemonic
    };
    let (open, close) = row.shape.brackets();
    let head = match (spelling, dice.below(6)) {
        (" ", 0) => format!("{open}{close}"),
        (spelling, 1) => format!("{open}{}{close}", spelling.to_lowercase()),
        (spelling, _) => format!("{open}{spelling}{close}"),
    };
    let operands = operands(dice, scope, row);
    if operands.is_empty() {
        return head;
    }
    match dice.below(6) {
        0 => format!("{head}({})", operands.join(",")),
        1 => format!("{head} (  {} )", operands.join("  ,")),
        _ => format!("{head}( {} )", operands.join(", ")),
    }
}

fn operands(dice: &mut Dice, scope: &mut Scope, row: &'static Instruction) -> Vec<String> {
    match row.op {
        Op::Bmov => return block_move(dice, scope),
        Op::Pack => return packed(dice, scope, false),
        Op::Unpack => return packed(dice, scope, true),
        Op::Search => return search(dice, scope),
        Op::Fill | Op::Shift => {
            let element = dice.of(&SCALARS);
            let length = dice.between(1, 5);
            return vec![
                range(dice, scope, element, length, true),
                read(dice, scope, element),
            ];
        }
        Op::Typ => {
            let to = dice.of(&SCALARS);
            let sources: Vec<Scalar> = SCALARS.into_iter().filter(|&from| converts(from, to)).collect();
            let from = dice.of(&sources);
            return vec![place(dice, scope, to), read_exactly(dice, scope, from)];
        }
        Op::Wrap => {
            let mut integer = || {
                dice.of(&[
                    Scalar::Sint,
                    Scalar::Uint,
                    Scalar::Dint,
                    Scalar::Word,
                    Scalar::Lint,
                ])
            };
            let (to, from) = (integer(), integer());
            return vec![place(dice, scope, to), read_exactly(dice, scope, from)];
        }
        Op::Persist => {
            let ty = dice.of(&SCALARS);
            return vec![scope.scalar(dice, ty, true)];
        }
        Op::Fmt => return format_text(dice, scope),
        Op::Res => return vec![timer_or_counter(dice, scope)],
        _ if row.group == Group::Condition && row.operands.iter().any(|o| o.accepts == Accepts::Compared) => {
            return compared(dice, scope, row);
        }
        Op::Add | Op::Sub | Op::Mul | Op::Div if dice.one_in(4) => return times(dice, scope, row.op),
        _ => {}
    }
    by_row(dice, scope, row)
}

/// The operands as the row has them: by place, repeated ones some times, named ones now and then.
fn by_row(dice: &mut Dice, scope: &mut Scope, row: &'static Instruction) -> Vec<String> {
    let mut works_in = None;
    let mut list = Vec::new();
    let extra = if row.repeats() { dice.below(3) } else { 0 };
    let count = match row.limit() {
        Some(most) if dice.one_in(2) => row.required().max(most.min(row.required() + 1)),
        _ => row.required(),
    };
    let pairs = row
        .operands
        .iter()
        .any(|o| matches!(o.presence, Presence::Repeated { group: 2, .. }));
    let count = count + extra * if pairs { 2 } else { 1 };
    for index in 0..count {
        let Some(operand) = row.positional(index) else {
            break;
        };
        list.push(operand_text(dice, scope, row, operand, &mut works_in));
    }
    for operand in row.operands.iter().filter(|o| o.presence == Presence::Named) {
        if operand.profiles.contain(Profile::Iec) && dice.one_in(3) {
            let text = operand_text(dice, scope, row, operand, &mut works_in);
            let arrow = if operand.direction == Direction::Out {
                "=>"
            } else {
                ":="
            };
            list.push(format!("{} {arrow} {text}", operand.name));
        }
    }
    list
}

fn operand_text(
    dice: &mut Dice,
    scope: &mut Scope,
    row: &Instruction,
    operand: &Operand,
    works_in: &mut Option<Scalar>,
) -> String {
    let reads = operand.direction == Direction::In;
    match operand.accepts {
        Accepts::Bool if reads => read(dice, scope, Scalar::Bool),
        Accepts::BoolOrRange | Accepts::BoolRangeOrState if dice.one_in(6) && !scope.is_boolean => {
            let length = dice.between(1, 4);
            range(dice, scope, Scalar::Bool, length, !reads)
        }
        Accepts::BoolOrRange if reads => read(dice, scope, Scalar::Bool),
        Accepts::Bool | Accepts::BoolOrRange | Accepts::BoolRangeOrState => place(dice, scope, Scalar::Bool),
        Accepts::State(state) => scope.state(dice, state),
        Accepts::Result(class) => {
            let mut types: Vec<Scalar> = SCALARS.into_iter().filter(|&ty| is_in(ty, class)).collect();
            if matches!(row.op, Op::Mul | Op::Div) {
                types.retain(|&ty| ty != Scalar::Time);
            }
            let ty = dice.of(&types);
            *works_in = Some(ty);
            place(dice, scope, ty)
        }
        Accepts::Value => read(dice, scope, works_in.expect("the result comes first")),
        Accepts::Expression => {
            let ty = works_in.expect("the result comes first");
            expression(dice, scope, ty, 3)
        }
        Accepts::Integer => {
            let small = !matches!(row.op, Op::Usnd);
            integer(dice, scope, small)
        }
        Accepts::String => read(dice, scope, STRING),
        Accepts::Number => {
            let ty = dice.of(&[Scalar::Real, Scalar::Lreal, Scalar::Int, Scalar::Udint]);
            read_exactly(dice, scope, ty)
        }
        Accepts::Duration => match dice.below(4) {
            0 => dice.between(0, 60).to_string(),
            1 => read_exactly(dice, scope, Scalar::Int),
            2 => dice.of(&["10ms", "T#30ms", "20ms", "0s", "T#50ms"]).to_owned(),
            _ => read(dice, scope, Scalar::Time),
        },
        Accepts::Count => match dice.below(2) {
            0 => dice.between(-1, 4).to_string(),
            _ => read(dice, scope, Scalar::Dint),
        },
        Accepts::Time
        | Accepts::Compared
        | Accepts::Convertible
        | Accepts::Wrapped
        | Accepts::TimerOrCounter
        | Accepts::Range
        | Accepts::RangeOrValue
        | Accepts::Label
        | Accepts::Function
        | Accepts::SearchOperator
        | Accepts::Tag => unreachable!("{} has a function of its own", row.signature()),
    }
}

fn is_in(ty: Scalar, class: TypeClass) -> bool {
    match class {
        TypeClass::Number => ty.is_number(),
        TypeClass::NumberOrTime => ty.is_number() || ty == Scalar::Time,
        TypeClass::Real => ty.is_real(),
        TypeClass::BitsOrInteger => ty.is_bits() || ty.is_integer(),
        TypeClass::BoolBitsOrInteger => ty == Scalar::Bool || ty.is_bits() || ty.is_integer(),
        TypeClass::Integer => ty.is_integer(),
        TypeClass::String => ty.is_string(),
        TypeClass::Any => true,
    }
}

/// Operands of a comparison: of one type, or integers of any types.
fn compared(dice: &mut Dice, scope: &mut Scope, row: &Instruction) -> Vec<String> {
    let only_equal = matches!(row.op, Op::Eq | Op::Ne);
    let types: Vec<Scalar> = SCALARS
        .into_iter()
        .filter(|&ty| only_equal || ty != Scalar::Bool)
        .collect();
    let ty = dice.of(&types);
    let count = if row.repeats() { 2 + dice.below(2) } else { 2 };
    (0..count)
        .map(|number| match dice.below(3) {
            0 if number > 0 => literal_of_its_own(dice, ty),
            1 if ty.is_integer() => {
                let other = dice.of(&INTEGERS);
                read_exactly(dice, scope, other)
            }
            _ => read_exactly(dice, scope, ty),
        })
        .collect()
}

/// A literal that is not an integer of another type: `SINT#5` next to a DINT would make both LINT, which is fine, but a
/// typed one must fit in every case.
fn literal_of_its_own(dice: &mut Dice, ty: Scalar) -> String {
    if ty.is_integer() || ty.is_bits() {
        return dice.between(0, 100).to_string();
    }
    literal(dice, ty)
}

/// The ways in which TIMEs and dates go into arithmetic.
fn times(dice: &mut Dice, scope: &mut Scope, op: Op) -> Vec<String> {
    let number = |dice: &mut Dice, scope: &mut Scope| {
        let ty = dice.of(&[Scalar::Int, Scalar::Dint, Scalar::Real, Scalar::Usint]);
        read_exactly(dice, scope, ty)
    };
    match (op, dice.below(3)) {
        (Op::Mul | Op::Div, _) => {
            let result = place(dice, scope, Scalar::Time);
            vec![
                result,
                read_exactly(dice, scope, Scalar::Time),
                number(dice, scope),
            ]
        }
        (Op::Add, 0) => vec![
            place(dice, scope, Scalar::Dt),
            read_exactly(dice, scope, Scalar::Dt),
            read_exactly(dice, scope, Scalar::Time),
        ],
        (Op::Sub, 0) => {
            let ty = dice.of(&[Scalar::Dt, Scalar::Tod]);
            vec![
                place(dice, scope, Scalar::Time),
                read_exactly(dice, scope, ty),
                read_exactly(dice, scope, ty),
            ]
        }
        _ => vec![
            place(dice, scope, Scalar::Time),
            read(dice, scope, Scalar::Time),
            read(dice, scope, Scalar::Time),
        ],
    }
}

fn block_move(dice: &mut Dice, scope: &mut Scope) -> Vec<String> {
    let element = dice.of(&SCALARS);
    let length = dice.between(1, 4);
    let to = range(dice, scope, element, length, true);
    let from = range(dice, scope, element, length, false);
    // An index alone starts there; one of the two says how many.
    let start = |range: &str| range.split_once("..").map(|(start, _)| format!("{start}]"));
    match dice.below(3) {
        0 => vec![start(&to).unwrap_or(to), from],
        1 => vec![to, start(&from).unwrap_or(from)],
        _ => vec![to, from],
    }
}

/// PACK, or UNPACK with its operands the other way round.
fn packed(dice: &mut Dice, scope: &mut Scope, apart: bool) -> Vec<String> {
    let (whole, part, count) = dice.of(&[
        (Scalar::Byte, Scalar::Bool, 8),
        (Scalar::Word, Scalar::Bool, 16),
        (Scalar::Word, Scalar::Byte, 2),
        (Scalar::Dword, Scalar::Word, 2),
        (Scalar::Lword, Scalar::Byte, 8),
        (Scalar::Dint, STRING, 0),
    ]);
    let (one, many) = if part == STRING {
        let text = if apart {
            place(dice, scope, STRING)
        } else {
            read(dice, scope, STRING)
        };
        let number = if apart {
            read_exactly(dice, scope, whole)
        } else {
            place(dice, scope, whole)
        };
        (number, text)
    } else {
        let one = if apart {
            read_exactly(dice, scope, whole)
        } else {
            place(dice, scope, whole)
        };
        (one, range(dice, scope, part, count, apart))
    };
    if apart { vec![many, one] } else { vec![one, many] }
}

fn search(dice: &mut Dice, scope: &mut Scope) -> Vec<String> {
    let element = dice.of(&[
        Scalar::Int,
        Scalar::Dint,
        Scalar::Byte,
        Scalar::Time,
        Scalar::Lreal,
        STRING,
    ]);
    let index = dice.of(&[Scalar::Int, Scalar::Dint, Scalar::Lint]);
    let (name, first, last) = scope.array(dice, element, 2, false);
    let mut list = vec![
        place(dice, scope, index),
        dice.of(&["EQ", "ne", "GT", "GE", "Lt", "LE"]).to_owned(),
        read_exactly(dice, scope, element),
        format!("{name}[{}..{last}]", first + dice.between(0, 1)),
    ];
    // With a negative bound -1 could be an index.
    if first >= 0 && dice.one_in(2) {
        list.push(format!("NEXT := {}", read(dice, scope, Scalar::Bool)));
    }
    if dice.one_in(2) {
        list.push(format!("FOUND => {}", place(dice, scope, Scalar::Bool)));
    }
    list
}

fn format_text(dice: &mut Dice, scope: &mut Scope) -> Vec<String> {
    let count = dice.below(3);
    let places = " %d".repeat(count);
    let mut list = vec![format!("'value{places}$N'")];
    for _ in 0..count {
        list.push(integer(dice, scope, false));
    }
    list
}

fn timer_or_counter(dice: &mut Dice, scope: &mut Scope) -> String {
    let there: Vec<String> = scope
        .tags
        .iter()
        .filter(|tag| matches!(tag.ty, Type::State(state) if state.is_timer() || state.is_counter()))
        .map(|tag| tag.name.clone())
        .collect();
    if there.is_empty() {
        return scope.state(dice, ladder_instructions::StateType::Ton);
    }
    there[dice.below(there.len())].clone()
}
