//! How LDmicro draws an element: two lines, and how many cells they take.

use super::super::element::{self, Form};
use super::super::field::{self, Coil};
use super::super::fork;
use super::super::model::File;
use super::{CELL, TOO_LONG};
use ladder_instructions::Op;

/// What is drawn of an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Symbol {
    /// Above the wire: a name, or the upper half of a box.
    pub(super) above: String,
    /// In the wire.
    pub(super) body: String,
    /// How many cells it has, next to each other.
    pub(super) cells: usize,
}

impl Symbol {
    fn new(above: impl Into<String>, body: impl Into<String>) -> Symbol {
        Symbol {
            above: above.into(),
            body: body.into(),
            cells: 1,
        }
    }

    fn too_long(cells: usize) -> Symbol {
        let symbol = Symbol::new("", TOO_LONG);
        Symbol { cells, ..symbol }
    }
}

/// The longest name in a box.
const IN_BOX: usize = CELL - 9;

/// The symbol of an element, by its line.
pub(super) fn symbol(text: &str) -> Symbol {
    let Some(row) = element::row_of(text) else {
        return fitting(Symbol::new("", format!("{{{text}}}")));
    };
    let fields = field::fields(text);
    let field = |index: usize| fields.get(index).copied().unwrap_or_default();
    let name = field(0);
    let symbol = match row.form {
        Form::Contact => Symbol::new(name, if field(1) == "0" { "] [" } else { "]/[" }),
        Form::Coil => Symbol::new(
            name,
            match Coil::of(&fields) {
                Coil::Plain => "( )",
                Coil::Negated => "(/)",
                Coil::Set => "(S)",
                Coil::Reset => "(R)",
            },
        ),
        Form::Constant(on) => Symbol::new("", if on { "+------+" } else { "+      +" }),
        Form::Timer(_) => Symbol::new(name, format!("[{} {}]", row.word, delay(field(1)))),
        Form::Counter(Op::Ctc) => Symbol::new(name, format!("{{CTC 0:{}}}", field(1))),
        Form::Counter(_) => Symbol::new(name, format!("[{} >={}]", row.word, field(1))),
        Form::Reset => Symbol::new(name, "{RES}"),
        Form::Adc => Symbol::new(name, "{READ ADC}"),
        Form::Shift => shift(name, field(1)),
        Form::Table => looked_up(name, "LUT", field(1)),
        Form::Curve => looked_up(name, "PWL", field(1)),
        Form::Text => return string(name, &fields),
        Form::Values(op, _) => match op {
            Op::OneShotRising => Symbol::new("      _ ", "[OSR_/ ]"),
            Op::OneShotFalling => Symbol::new("    _   ", "[OSF \\_]"),
            Op::Mcr => Symbol::new("", "{MASTER RLY}"),
            Op::Mov => moved(name, field(1)),
            Op::Add => return math("ADD", '+', &fields),
            Op::Sub => return math("SUB", '-', &fields),
            Op::Mul => return math("MUL", '*', &fields),
            Op::Div => return math("DIV", '/', &fields),
            Op::Eq => compared(name, "==", field(1)),
            Op::Ne => compared(name, "/=", field(1)),
            Op::Gt => compared(name, ">", field(1)),
            Op::Ge => compared(name, ">=", field(1)),
            Op::Lt => compared(name, "<", field(1)),
            Op::Le => compared(name, "<=", field(1)),
            Op::Usnd => Symbol::new(name, "{UART SEND}"),
            Op::Urcv => Symbol::new(name, "{UART RECV}"),
            Op::Pwm => Symbol::new(name, format!("{{PWM {}}}", frequency(field(1)))),
            _ => Symbol::new(name, format!("{{{}}}", row.word)),
        },
        Form::Comment | Form::Placeholder => Symbol::new("", ""),
    };
    fitting(symbol)
}

fn fitting(symbol: Symbol) -> Symbol {
    if symbol.body.chars().count() < CELL {
        return symbol;
    }
    Symbol::too_long(symbol.cells)
}

/// Microseconds, as they are shown.
fn delay(field: &str) -> String {
    let microseconds: u64 = field.parse().unwrap_or(0);
    match microseconds {
        us if us >= 1_000_000 => format!("{:.3} s", us as f64 / 1e6),
        us if us >= 100_000 => format!("{:.1} ms", us as f64 / 1e3),
        us => format!("{:.2} ms", us as f64 / 1e3),
    }
}

/// Hertz, as they are shown.
fn frequency(field: &str) -> String {
    let hertz: u64 = field.parse().unwrap_or(0);
    match hertz {
        hz if hz >= 100_000 => format!("{:.0} kHz", hz as f64 / 1e3),
        hz if hz >= 10_000 => format!("{:.1} kHz", hz as f64 / 1e3),
        hz if hz >= 1_000 => format!("{:.2} kHz", hz as f64 / 1e3),
        hz => format!("{hz} Hz"),
    }
}

/// Two lines as long as each other: the shorter one is filled up before its last character.
fn boxed(above: String, body: String, open: char, close: &str, length: usize) -> Symbol {
    let line = |text: String, close: &str| {
        let blanks = length.saturating_sub(1 + text.chars().count() + close.chars().count());
        format!("{open}{text}{:blanks$}{close}", "")
    };
    let last = &close[close.len() - 1..];
    Symbol::new(line(above, last), line(body, close))
}

fn length(text: &str) -> usize {
    text.chars().count()
}

fn compared(left: &str, operator: &str, right: &str) -> Symbol {
    let longest = (3 + operator.len() + length(left)).max(3 + length(right));
    boxed(
        format!("{left} {operator}"),
        format!(" {right}"),
        '[',
        "]",
        longest,
    )
}

fn moved(to: &str, from: &str) -> Symbol {
    if length(to) > IN_BOX || length(from) > IN_BOX {
        return Symbol::too_long(1);
    }
    boxed(format!("{to}  :="), format!(" {from}"), '{', "MOV}", 14)
}

fn looked_up(to: &str, table: &str, index: &str) -> Symbol {
    if length(to) > IN_BOX || length(index) > IN_BOX - 1 {
        return Symbol::too_long(1);
    }
    boxed(format!(" {to} :="), format!("  {table}[{index}]"), '{', "}", 14)
}

fn shift(name: &str, stages: &str) -> Symbol {
    let last = stages.parse::<u32>().unwrap_or(1).max(1) - 1;
    let body = format!(" {name}0..{last}");
    if length(&body) > 12 {
        return Symbol::too_long(1);
    }
    boxed("SHIFT REG".to_owned(), body, '{', "}", 14)
}

fn math(word: &str, sign: char, fields: &[&str]) -> Symbol {
    let field = |index: usize| fields.get(index).copied().unwrap_or_default();
    let above = format!("{word}  {}  :=", field(0));
    let body = format!(" {} {sign} {}", field(1), field(2));
    let longest = 2 + length(&above).max(length(&body));
    if longest >= 2 * CELL {
        return Symbol::too_long(2);
    }
    let symbol = boxed(above, body, '{', "}", longest);
    Symbol { cells: 2, ..symbol }
}

fn string(variable: &str, fields: &[&str]) -> Symbol {
    let codes = fields.get(2..).unwrap_or_default();
    let text: String = codes
        .iter()
        .map(|code| match code.parse::<u8>() {
            Ok(code) if code >= 32 => char::from(code),
            _ => 'X',
        })
        .collect();
    if length(&text) + 4 >= 2 * CELL {
        return Symbol::too_long(2);
    }
    let name = if variable == "(none)" { "" } else { variable };
    let symbol = Symbol::new(name, format!("{{\"{text}\"}}"));
    Symbol { cells: 2, ..symbol }
}

/// What the symbol of an element does not say, if there is something.
pub(super) fn loss(text: &str) -> Option<String> {
    let dialect = File::default().dialect();
    let row = element::row_of(text).filter(|_| fork::read(text, dialect).is_none());
    let Some(row) = row else {
        return Some("LDmicro 2.2 has no such element".to_owned());
    };
    let fields = field::fields(text);
    if row.form != Form::Comment && symbol(text).body == TOO_LONG {
        return Some("it is too long for the drawing".to_owned());
    }
    let shown = |text: &str, units: &[(&str, f64)]| {
        let (number, unit) = text.split_once(' ')?;
        let (_, factor) = units.iter().find(|(name, _)| *name == unit)?;
        Some((number.parse::<f64>().ok()? * factor).round() as u64)
    };
    match row.form {
        Form::Table | Form::Curve => Some("the drawing does not hold its table".to_owned()),
        Form::Timer(_) if fields.get(2).is_some_and(|adjust| *adjust != "-1") => {
            Some("the drawing does not hold how many cycles are added to its delay".to_owned())
        }
        Form::Timer(_) => {
            let text = delay(fields[1]);
            let kept = shown(&text, &[("s", 1e6), ("ms", 1e3)]);
            (kept != fields[1].parse().ok()).then(|| format!("its delay is rounded to {text}"))
        }
        Form::Values(Op::Pwm, _) => {
            let text = frequency(fields[1]);
            let kept = shown(&text, &[("Hz", 1.0), ("kHz", 1e3)]);
            (kept != fields[1].parse().ok()).then(|| format!("its frequency is rounded to {text}"))
        }
        _ => None,
    }
}
