//! Programs that nobody wrote: what is made at random is written in Python, in ladder text, and in Python again, and stays
//! the same; what is broken at random is refused or read, and never brings anything down.

use super::Click;
use super::address::{Span, Tag};
use super::bank::Bank;
use super::conversion::Convert;
use super::dsl;
use super::model::{
    Action, Bits, Coil, Comparison, Condition, Constant, Contact, ContactKind, CopyOptions, Counter,
    CounterKind, Drum, Formula, Function, Instruction, Math, MathKind, Operand, Operator, Pointer, Program,
    Relation, Routine, Rung, Search, Shift, Steps, Timer, TimerKind, Unit,
};
use ladder_notation::{Converted, LineColumn, Notation, Report, Source, convert};
use proptest::prelude::*;
use proptest::sample::select;

const NAMES: &[&str] = &[
    "Start", "Level", "DS", "T1", "Ton", "Word", "größe", "_low", "A1", "Main", "start",
];

/// An address of one of some banks, by number or by nickname.
fn tag(banks: &'static [Bank]) -> impl Strategy<Value = Tag> {
    (select(banks), 1u16..16, prop::option::of(select(NAMES))).prop_map(|(bank, number, name)| match name {
        Some(name) => Tag::nickname(bank, name),
        None => Tag::number(bank, number),
    })
}

fn span(banks: &'static [Bank], most: u16) -> impl Strategy<Value = Span> {
    (select(banks), 1u16..8, 0..most).prop_map(|(bank, first, more)| Span {
        bank,
        first,
        last: first + more,
    })
}

const BITS: &[Bank] = &[Bank::X, Bank::Y, Bank::C, Bank::T, Bank::Ct, Bank::Sc];
const COILS: &[Bank] = &[Bank::Y, Bank::C];
const NUMBERS: &[Bank] = &[Bank::Ds, Bank::Dd, Bank::Df, Bank::Ctd, Bank::Td, Bank::Sd];
const WRITTEN: &[Bank] = &[Bank::Ds, Bank::Dd, Bank::Df];

fn contact() -> impl Strategy<Value = Condition> {
    let one = tag(BITS).prop_map(Bits::One);
    let many = span(&[Bank::X, Bank::Y, Bank::C], 4).prop_map(Bits::Many);
    let kinds = select(
        &[
            ContactKind::Open,
            ContactKind::Closed,
            ContactKind::Rising,
            ContactKind::Falling,
        ][..],
    );
    (kinds, prop_oneof![3 => one, 1 => many]).prop_map(|(kind, bits)| {
        let kind = match (kind, &bits) {
            (ContactKind::Rising, Bits::Many(_)) => ContactKind::Open,
            (ContactKind::Falling, Bits::Many(_)) => ContactKind::Closed,
            (kind, _) => kind,
        };
        let place = LineColumn::START;
        Condition::Contact(Contact { place, kind, bits })
    })
}

fn relation() -> impl Strategy<Value = Relation> {
    (0usize..6).prop_map(|row| Relation::ALL[row].0)
}

fn comparison() -> impl Strategy<Value = Condition> {
    let numbers = (tag(NUMBERS), any::<i16>()).prop_map(|(tag, number)| (tag, Constant::Int(number.into())));
    let words =
        (tag(&[Bank::Dh]), any::<u16>()).prop_map(|(tag, number)| (tag, Constant::Hex(number.into())));
    let texts = tag(&[Bank::Txt]).prop_map(|tag| (tag, Constant::Text("$".to_owned())));
    (prop_oneof![3 => numbers, 1 => words, 1 => texts], relation()).prop_map(|((tag, value), relation)| {
        let relation = if tag.bank == Bank::Txt {
            Relation::Ne
        } else {
            relation
        };
        Condition::Compare(Comparison {
            place: LineColumn::START,
            left: Operand::Tag(tag),
            relation,
            right: Operand::Constant(value),
        })
    })
}

fn condition() -> impl Strategy<Value = Condition> {
    let leaf = prop_oneof![4 => contact(), 1 => comparison()];
    leaf.prop_recursive(3, 12, 4, |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 1..4).prop_map(Condition::All),
            prop::collection::vec(inner, 1..4).prop_map(Condition::Any),
        ]
    })
}

fn pin() -> impl Strategy<Value = Option<Condition>> {
    prop::option::of(prop_oneof![contact(), condition()])
}

fn formula() -> impl Strategy<Value = Formula> {
    let leaf = prop_oneof![
        tag(&[Bank::Ds]).prop_map(|tag| Formula::Value(Operand::Tag(tag))),
        tag(&[Bank::Df, Bank::Dd]).prop_map(|tag| Formula::Value(Operand::Tag(tag))),
        (0i64..99).prop_map(|number| Formula::Value(Operand::Constant(Constant::Int(number)))),
        span(&[Bank::Ds], 4).prop_map(Formula::Sum),
        Just(Formula::Pi),
    ];
    let operators = &[
        Operator::Add,
        Operator::Subtract,
        Operator::Multiply,
        Operator::Divide,
        Operator::Modulo,
    ];
    leaf.prop_recursive(3, 8, 2, move |inner| {
        prop_oneof![
            (inner.clone(), select(&operators[..]), inner.clone()).prop_map(|(left, operator, right)| {
                Formula::Binary(Box::new(left), operator, Box::new(right))
            }),
            inner.prop_map(|inside| Formula::Call(Function::Sqrt, vec![inside])),
        ]
    })
}

fn words() -> impl Strategy<Value = Formula> {
    let leaf = prop_oneof![
        tag(&[Bank::Dh]).prop_map(|tag| Formula::Value(Operand::Tag(tag))),
        (0u32..0x1_0000).prop_map(|number| Formula::Value(Operand::Constant(Constant::Hex(number)))),
    ];
    let operators = &[
        Operator::And,
        Operator::Or,
        Operator::Xor,
        Operator::Add,
        Operator::Subtract,
    ];
    leaf.prop_recursive(3, 8, 2, move |inner| {
        prop_oneof![
            (inner.clone(), select(&operators[..]), inner.clone()).prop_map(|(left, operator, right)| {
                Formula::Binary(Box::new(left), operator, Box::new(right))
            }),
            inner.prop_map(|inside| Formula::Not(Box::new(inside))),
        ]
    })
}

fn setpoint() -> impl Strategy<Value = Operand> {
    let number = (0i64..32_768).prop_map(|number| Operand::Constant(Constant::Int(number)));
    prop_oneof![number, tag(&[Bank::Ds]).prop_map(Operand::Tag)]
}

fn timer() -> impl Strategy<Value = Instruction> {
    let kinds = &[
        TimerKind::On,
        TimerKind::Off,
        TimerKind::RetentiveOn,
        TimerKind::RetentiveOff,
    ];
    (select(&kinds[..]), setpoint(), 0usize..5, pin()).prop_map(|(kind, setpoint, unit, reset)| {
        Instruction::Timer(Timer {
            kind,
            tag: Tag::number(Bank::T, 1),
            setpoint,
            unit: Unit::ALL[unit].0,
            reset: reset.filter(|_| kind.is_retentive()),
        })
    })
}

fn counter() -> impl Strategy<Value = Instruction> {
    let kinds = &[CounterKind::Up, CounterKind::Down, CounterKind::UpDown];
    (select(&kinds[..]), setpoint(), pin(), pin()).prop_map(|(kind, setpoint, down, reset)| {
        Instruction::Counter(Counter {
            kind,
            tag: Tag::number(Bank::Ct, 1),
            setpoint,
            count_down: down.filter(|_| kind == CounterKind::UpDown),
            reset,
        })
    })
}

fn copies() -> impl Strategy<Value = Instruction> {
    let options = CopyOptions::default;
    let pointer = (tag(&[Bank::Ds]), -9i32..9).prop_map(|(by, offset)| {
        Operand::Pointer(Pointer {
            bank: Bank::Ds,
            by,
            offset,
        })
    });
    let source = prop_oneof![
        tag(NUMBERS).prop_map(Operand::Tag),
        any::<i16>().prop_map(|number| Operand::Constant(Constant::Int(number.into()))),
        (-1.0e6..1.0e6).prop_map(|number| Operand::Constant(Constant::Float(number))),
        (0u32..0x1_0000).prop_map(|number| Operand::Constant(Constant::Hex(number))),
        pointer,
    ];
    let copy = move |(source, target)| Instruction::Copy {
        source,
        target: Operand::Tag(target),
        options: options(),
    };
    prop_oneof![
        (source.clone(), tag(WRITTEN)).prop_map(copy),
        (tag(BITS).prop_map(Operand::Tag), tag(COILS)).prop_map(copy),
        ("[ -~]{1,4}", 1u16..9).prop_map(move |(text, number)| {
            copy((
                Operand::Constant(Constant::Text(text)),
                Tag::number(Bank::Txt, number),
            ))
        }),
        (select(&[Bank::Td, Bank::Ctd][..]), 1u16..9).prop_map(move |(bank, number)| copy((
            Operand::Constant(Constant::Int(0)),
            Tag::number(bank, number)
        ))),
        (span(&[Bank::Ds], 5), 1u16..99).prop_map(move |(source, target)| Instruction::BlockCopy {
            source,
            target: Tag::number(Bank::Ds, target),
            options: options(),
        }),
        (
            select(&[Bank::Dd, Bank::Df, Bank::Td][..]),
            span(&[Bank::Ds], 5),
            1u16..99
        )
            .prop_map(move |(bank, source, target)| Instruction::BlockCopy {
                source,
                target: Tag::number(bank, target),
                options: options(),
            }),
        (span(&[Bank::T, Bank::Ct], 9), tag(&[Bank::Dh])).prop_map(move |(source, target)| {
            Instruction::Pack {
                source,
                target,
                options: options(),
            }
        }),
        span(&[Bank::Td, Bank::Ctd], 9).prop_map(move |target| Instruction::Fill {
            source: Operand::Constant(Constant::Int(7)),
            target,
            options: options(),
        }),
        (source, span(WRITTEN, 5)).prop_map(move |(source, target)| Instruction::Fill {
            source,
            target,
            options: options(),
        }),
        (span(&[Bank::C], 16), tag(&[Bank::Dh, Bank::Ds])).prop_map(move |(source, target)| {
            Instruction::Pack {
                source,
                target,
                options: options(),
            }
        }),
        (span(&[Bank::Txt], 6), tag(&[Bank::Ds])).prop_map(move |(source, target)| Instruction::Pack {
            source,
            target,
            options: options(),
        }),
        (tag(&[Bank::Dd]), span(&[Bank::C], 16)).prop_map(move |(source, target)| Instruction::Unpack {
            source,
            target,
            options: options(),
        }),
    ]
}

/// Copies between numbers and characters.
fn conversions() -> impl Strategy<Value = Instruction> {
    let text = || tag(&[Bank::Txt]).prop_map(Operand::Tag);
    let number = || tag(&[Bank::Ds, Bank::Dd]).prop_map(Operand::Tag);
    let from_text = (text(), number(), select(&[Convert::Value, Convert::Ascii][..]));
    let to_code = (number(), text(), Just(Convert::Binary));
    let first = (1u16..99).prop_map(|number| Operand::Tag(Tag::number(Bank::Txt, number)));
    let form =
        (any::<bool>(), prop::option::of(0u8..0x80)).prop_map(|(suppress_zero, termination)| Convert::Text {
            suppress_zero,
            exponential: false,
            termination,
        });
    prop_oneof![from_text, to_code, (number(), first, form)].prop_map(|(source, target, convert)| {
        let options = CopyOptions {
            convert: Some(convert),
            ..CopyOptions::default()
        };
        Instruction::Copy {
            source,
            target,
            options,
        }
    })
}

fn drum() -> impl Strategy<Value = Instruction> {
    let times =
        (prop::collection::vec(setpoint(), 1..5), 0usize..5).prop_map(|(presets, unit)| Steps::Times {
            presets,
            unit: Unit::ALL[unit].0,
            accumulator: Tag::number(Bank::Td, 9),
        });
    let events = prop::collection::vec(contact(), 1..5).prop_map(Steps::Events);
    let outputs = prop::collection::vec(tag(COILS), 1..5);
    let pins = (condition(), prop::option::of((contact(), setpoint())), pin());
    (prop_oneof![times, events], outputs, any::<u16>(), pins).prop_map(
        |(steps, outputs, bits, (reset, jump, jog))| {
            let lit = bits & ((1 << outputs.len()) - 1);
            let (jump, jump_step) = jump.unzip();
            Instruction::Drum(Box::new(Drum {
                pattern: vec![lit; steps.len()],
                steps,
                outputs,
                current_step: Tag::number(Bank::Ds, 12),
                completion_flag: Tag::number(Bank::C, 12),
                reset: Some(reset),
                jump,
                jump_step,
                jog,
            }))
        },
    )
}

fn instruction() -> impl Strategy<Value = Instruction> {
    let bits = prop_oneof![
        tag(COILS).prop_map(Bits::One),
        span(COILS, 4).prop_map(Bits::Many)
    ];
    let coil = bits.prop_map(|bits| Coil {
        bits,
        immediate: false,
    });
    let math = |kind| {
        move |(formula, target)| {
            Instruction::Math(Math {
                kind,
                formula,
                target: Operand::Tag(target),
            })
        }
    };
    let value = tag(&[Bank::Ds]).prop_map(Operand::Tag);
    prop_oneof![
        coil.clone().prop_map(Instruction::Out),
        coil.clone().prop_map(Instruction::Set),
        coil.prop_map(Instruction::Reset),
        timer(),
        counter(),
        copies(),
        conversions(),
        drum(),
        (formula(), tag(WRITTEN)).prop_map(math(MathKind::Decimal)),
        (words(), tag(&[Bank::Dh])).prop_map(math(MathKind::Hex)),
        (
            relation(),
            value,
            span(&[Bank::Ds, Bank::Dd], 9),
            tag(&[Bank::C]),
            any::<bool>()
        )
            .prop_map(|(relation, value, among, flag, continuous)| {
                Instruction::Search(Search {
                    relation,
                    value,
                    among,
                    result: Tag::number(Bank::Ds, 9),
                    flag,
                    continuous,
                })
            }),
        (span(&[Bank::C], 9), pin(), pin(), any::<bool>()).prop_map(|(mut bits, clock, reset, down)| {
            if down && clock.is_some() {
                (bits.first, bits.last) = (bits.last, bits.first);
            }
            Instruction::Shift(Shift { bits, clock, reset })
        }),
        Just(Instruction::Call("step".to_owned())),
        Just(Instruction::End),
        Just(Instruction::Nop),
    ]
}

fn action() -> impl Strategy<Value = Action> {
    let comment = prop::option::of(select(&["told", "two words", "a # in it"][..]));
    (instruction(), any::<bool>(), comment).prop_map(|(what, oneshot, comment)| {
        let has = !matches!(
            what,
            Instruction::Timer(_)
                | Instruction::Counter(_)
                | Instruction::Shift(_)
                | Instruction::Drum(_)
                | Instruction::Call(_)
                | Instruction::End
                | Instruction::Nop
        );
        // A comment is after a block.
        let says = what != Instruction::Nop;
        Action {
            place: LineColumn::START,
            condition: Condition::ALWAYS,
            what,
            oneshot: oneshot && has,
            comment: comment.filter(|_| says).map(str::to_owned),
        }
    })
}

fn rung() -> impl Strategy<Value = Rung> {
    let comments = prop::collection::vec(select(&["above", "ladder: profile iec", "a `b` # c"][..]), 0..3);
    let condition = prop_oneof![1 => Just(Condition::ALWAYS), 4 => condition()];
    (comments, condition, prop::collection::vec(action(), 1..4)).prop_map(
        |(comments, condition, mut actions)| {
            // Nothing next to something is not an instruction of its own, and a register's pins follow its rung at once.
            if actions.len() > 1 {
                actions.retain(|action| action.what != Instruction::Nop);
            }
            if let Some(at) = actions
                .iter()
                .position(|action| matches!(action.what, Instruction::Shift(_)))
            {
                actions = vec![actions.swap_remove(at)];
            }
            if actions.is_empty() {
                actions.push(Action {
                    place: LineColumn::START,
                    condition: Condition::ALWAYS,
                    what: Instruction::Nop,
                    oneshot: false,
                    comment: None,
                });
            }
            Rung {
                place: LineColumn::START,
                comments: comments.into_iter().map(str::to_owned).collect(),
                condition,
                actions,
            }
        },
    )
}

fn program() -> impl Strategy<Value = Program> {
    let rungs = || prop::collection::vec(rung(), 1..5);
    (rungs(), rungs()).prop_map(|(main, sub)| {
        let routine = |name: &str, rungs| Routine {
            name: name.to_owned(),
            rungs,
            ..Routine::default()
        };
        let mut program = Program {
            nicknames: Vec::new(),
            main: routine("main", main),
            subroutines: vec![routine("step", sub)],
            seen_first: Vec::new(),
        };
        // Each timer and counter has one block, and only the main program ends.
        let mut number = 0;
        for action in program.main.rungs.iter_mut().flat_map(|rung| &mut rung.actions) {
            alone(&mut action.what, &mut number);
        }
        for action in program.subroutines[0]
            .rungs
            .iter_mut()
            .flat_map(|rung| &mut rung.actions)
        {
            alone(&mut action.what, &mut number);
            if action.what == Instruction::End {
                action.what = Instruction::Return;
            }
        }
        program
    })
}

fn alone(what: &mut Instruction, number: &mut u16) {
    let tag = match what {
        Instruction::Timer(timer) => &mut timer.tag,
        Instruction::Counter(counter) => &mut counter.tag,
        _ => return,
    };
    *number += 1;
    *tag = Tag::number(tag.bank, *number);
}

fn converted(python: &str) -> Converted {
    let source = Source::alone("test", python.as_bytes());
    let options = ladder_format::Options::default();
    convert(&Click, &source, &options).unwrap_or_else(|error| panic!("{error}\n{python}"))
}

fn written_back(ladder: &str) -> String {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(ladder).into(), "test.clad");
    let writing = Click
        .write(&analysis)
        .unwrap_or_else(|error| panic!("{error}\n{ladder}"));
    let remarks: Vec<_> = writing.report.remarks().collect();
    assert!(remarks.is_empty(), "{remarks:#?}\n{ladder}");
    String::from_utf8(writing.bytes).expect("it is text")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, max_shrink_iters: 4_000, ..ProptestConfig::default() })]

    #[test]
    fn python_is_read_as_it_was_written(program in program()) {
        let python = dsl::write(&program, &mut Report::default());
        let read = dsl::read(&python).unwrap_or_else(|error| panic!("{error}\n{python}"));
        prop_assert_eq!(dsl::write(&read, &mut Report::default()), python);
    }

    #[test]
    fn ladder_text_and_python_say_the_same(program in program()) {
        let python = dsl::write(&program, &mut Report::default());
        let ladder = converted(&python).written.text;
        let again = written_back(&ladder);
        prop_assert_eq!(&converted(&again).written.text, &ladder, "{}", again);
        prop_assert_eq!(written_back(&ladder), again);
    }

    #[test]
    fn broken_python_is_refused_or_read(changes in prop::collection::vec((any::<prop::sample::Index>(), 0u8..4, any::<u8>()), 1..12)) {
        let mut bytes = include_bytes!("../tests/click/bottling.py").to_vec();
        for (at, kind, byte) in changes {
            let at = at.index(bytes.len());
            match kind {
                0 => bytes[at] = byte,
                1 => _ = bytes.remove(at),
                2 => bytes.insert(at, b"()[].,:=\"'#\n\\-0"[usize::from(byte) % 15]),
                _ => {
                    let end = (at + usize::from(byte)).min(bytes.len());
                    let part = bytes[at..end].to_vec();
                    bytes.splice(at..at, part);
                }
            }
        }
        Click.recognises(&bytes);
        let source = Source::alone("test", &bytes);
        if let Ok(converted) = convert(&Click, &source, &ladder_format::Options::default()) {
            let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&converted.written.text).into(), "test.clad");
            let _ = Click.write(&analysis);
        }
    }
}
