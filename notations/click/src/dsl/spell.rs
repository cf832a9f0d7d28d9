//! The parts of a program as the DSL writes them.

use super::super::address::Tag;
use super::super::formula::{self, Spelling};
use super::super::model::{
    Action, Bits, Condition, Constant, ContactKind, CopyOptions, CounterKind, Formula, Instruction, MathKind,
    Operand, Steps, TimerKind,
};

/// A condition: `all(x[1], nc(c.Stop))`.
pub(in super::super) fn condition(condition: &Condition) -> String {
    let list = |word: &str, parts: &[Condition]| match parts {
        [] => "True".to_owned(),
        [one] => self::condition(one),
        parts => {
            let parts: Vec<String> = parts.iter().map(self::condition).collect();
            format!("{word}({})", parts.join(", "))
        }
    };
    match condition {
        Condition::All(parts) => list("all", parts),
        Condition::Any(parts) => list("any", parts),
        Condition::Contact(contact) => {
            let bits = bits(&contact.bits);
            match contact.kind {
                ContactKind::Open => bits,
                ContactKind::Closed => format!("nc({bits})"),
                ContactKind::Rising => format!("re({bits})"),
                ContactKind::Falling => format!("fe({bits})"),
            }
        }
        Condition::Compare(comparison) => format!(
            "{} {} {}",
            operand(&comparison.left),
            comparison.relation.sign(),
            operand(&comparison.right)
        ),
    }
}

pub(in super::super) fn bits(bits: &Bits) -> String {
    match bits {
        Bits::One(tag) => tag.dsl(),
        Bits::Many(span) => span.dsl(),
    }
}

pub(in super::super) fn operand(operand: &Operand) -> String {
    match operand {
        Operand::Constant(constant) => self::constant(constant),
        Operand::Tag(tag) => tag.dsl(),
        Operand::Pointer(pointer) => {
            let offset = match pointer.offset {
                0 => String::new(),
                offset => format!("{offset:+}"),
            };
            format!("{}[{}{offset}]", pointer.bank.row().dsl, pointer.by.dsl())
        }
    }
}

pub(in super::super) fn constant(constant: &Constant) -> String {
    match constant {
        Constant::Bit(true) => "True".to_owned(),
        Constant::Bit(false) => "False".to_owned(),
        Constant::Int(number) => number.to_string(),
        Constant::Hex(number) => format!("0x{number:X}"),
        Constant::Float(number) => format!("{number:?}"),
        Constant::Text(text) => quoted(text),
    }
}

/// A text as a Python string.
pub(in super::super) fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => out.push_str(&format!("\\x{:02x}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

pub(in super::super) fn formula(formula: &Formula) -> String {
    let spelling = Spelling {
        operand: &operand,
        sum: &|span| format!("SUM({})", span.dsl()),
        binary: None,
    };
    formula::write(formula, spelling)
}

/// An action as a statement: `ton(t.Warm, setpoint=3, unit=Ts)`. The loop's is without its colon and body.
pub(in super::super) fn action(action: &Action) -> String {
    let mut call = Call::default();
    match &action.what {
        Instruction::Out(coil) => call.word("out").push(bits(&coil.bits)),
        Instruction::Set(coil) => call.word("set").push(bits(&coil.bits)),
        Instruction::Reset(coil) => call.word("reset").push(bits(&coil.bits)),
        Instruction::Timer(timer) => {
            let word = match timer.kind {
                TimerKind::On => "ton",
                TimerKind::Off => "tof",
                TimerKind::RetentiveOn => "rton",
                TimerKind::RetentiveOff => "rtof",
            };
            call.word(word).push(timer.tag.dsl());
            call.named("setpoint", operand(&timer.setpoint));
            call.named("unit", timer.unit.name().to_owned());
            call.pin("reset", timer.reset.as_ref());
        }
        Instruction::Counter(counter) => {
            let word = match counter.kind {
                CounterKind::Up => "ctu",
                CounterKind::Down => "ctd",
                CounterKind::UpDown => "ctud",
            };
            call.word(word).push(counter.tag.dsl());
            call.named("setpoint", operand(&counter.setpoint));
            call.pin("count_down", counter.count_down.as_ref());
            call.pin("reset", counter.reset.as_ref());
        }
        Instruction::Copy {
            source,
            target,
            options,
        } => {
            call.word("copy").push(operand(source));
            call.push(operand(target));
            call.options(options);
        }
        Instruction::BlockCopy {
            source,
            target,
            options,
        } => {
            call.word("copy_block").push(source.dsl());
            call.push(target.dsl());
            call.options(options);
        }
        Instruction::Fill {
            source,
            target,
            options,
        } => {
            call.word("copy_fill").push(operand(source));
            call.push(target.dsl());
            call.options(options);
        }
        Instruction::Pack {
            source,
            target,
            options,
        } => {
            call.word("copy_pack").push(source.dsl());
            call.push(target.dsl());
            call.options(options);
        }
        Instruction::Unpack {
            source,
            target,
            options,
        } => {
            call.word("copy_unpack").push(source.dsl());
            call.push(target.dsl());
            call.options(options);
        }
        Instruction::Shift(shift) => {
            call.word("shift").push(shift.bits.dsl());
            call.pin("clock", shift.clock.as_ref());
            call.pin("reset", shift.reset.as_ref());
        }
        Instruction::Search(search) => {
            let end = |number| Tag::number(search.among.bank, number).dsl();
            call.word("search")
                .push(quoted(&search.relation.mnemonic().to_lowercase()));
            call.push(operand(&search.value));
            call.push(end(search.among.first));
            call.push(end(search.among.last));
            call.push(search.result.dsl());
            call.push(search.flag.dsl());
            if search.continuous {
                call.named("continuous", "True".to_owned());
            }
        }
        Instruction::Drum(drum) => {
            call.word(match drum.steps {
                Steps::Events(_) => "event_drum",
                Steps::Times { .. } => "time_drum",
            });
            for (name, value) in super::drum::arguments(drum) {
                call.named(name, value);
            }
        }
        Instruction::Math(math) => {
            let word = match math.kind {
                MathKind::Decimal => "calc",
                MathKind::Hex => "math_hex",
            };
            call.word(word).push(quoted(&formula(&math.formula)));
            call.push(operand(&math.target));
        }
        Instruction::Call(name) => call.word("call").push(name.clone()),
        Instruction::For(count) => return format!("for _ in range({})", operand(count)),
        Instruction::Next => _ = call.word("next_loop"),
        Instruction::End => _ = call.word("end"),
        Instruction::Return => return "return".to_owned(),
        Instruction::Nop => return "pass".to_owned(),
        Instruction::Kept { text, .. } => return format!("pass  # {text}"),
    }
    if action.oneshot {
        let word = match action.what {
            Instruction::Math(_) => "one_shot",
            _ => "oneshot",
        };
        call.named(word, "True".to_owned());
    }
    call.text()
}

/// A call, argument by argument.
#[derive(Default)]
struct Call {
    word: &'static str,
    arguments: Vec<String>,
}

impl Call {
    fn word(&mut self, word: &'static str) -> &mut Call {
        self.word = word;
        self
    }

    fn push(&mut self, argument: String) {
        self.arguments.push(argument);
    }

    fn named(&mut self, name: &str, value: String) {
        self.arguments.push(format!("{name}={value}"));
    }

    fn pin(&mut self, name: &str, pin: Option<&Condition>) {
        if let Some(condition) = pin {
            self.named(name, format!("lambda: {}", self::condition(condition)));
        }
    }

    fn options(&mut self, options: &CopyOptions) {
        if let Some(convert) = options.convert {
            self.named("convert", convert.dsl());
        }
        if options.allow_whitespace {
            self.named("allow_whitespace", "True".to_owned());
        }
        if !options.named.is_empty() {
            let spelled = |(name, value): &(String, String)| match value.as_str() {
                "True" => name.clone(),
                _ => format!("{name}={value}"),
            };
            let named: Vec<String> = options.named.iter().map(spelled).collect();
            self.named("options", quoted(&named.join(", ")));
        }
    }

    fn text(&self) -> String {
        format!("{}({})", self.word, self.arguments.join(", "))
    }
}
