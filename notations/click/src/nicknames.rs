//! The nickname file: what Click's address picker exports as comma-separated values.
//!
//! ```text
//! Address,Data Type,Nickname,Initial Value,Retentive,Address Comment
//! DS1,INT,"TankTemp",100,Yes,"in degrees"
//! ```
//!
//! Columns are known by their names, and those that are not known here (Modbus addresses) are passed over.

use super::address::{Address, Span, Which};
use super::bank::{Bank, Kind};
use super::csv::{self, Record};
use super::model::{Constant, Nickname, Program};
use super::uses::{What, uses};
use ladder_analysis::Severity;
use ladder_notation::{Companion, Finding, LineColumn, ReadError, Report, Source};
use std::collections::{HashMap, HashSet};

const COLUMNS: [&str; 6] = [
    "Address",
    "Data Type",
    "Nickname",
    "Initial Value",
    "Retentive",
    "Address Comment",
];

/// What a nickname file says, and what there is to say about it. Places are those of the program.
#[derive(Debug, Default)]
pub(super) struct Nicknames {
    pub(super) all: Vec<Nickname>,
    pub(super) report: Report,
    pub(super) findings: Vec<Finding>,
}

/// Whether a file next to a program is its nickname file: `nicknames.csv`, `motor.nicknames.csv`, `motor_nicknames.csv`.
pub(super) fn is_file_of(program: &str, file: &str) -> bool {
    let Some(stem) = file.get(..file.len().saturating_sub(4)) else {
        return false;
    };
    let is_own = || {
        ["nicknames", "_nicknames", ".nicknames"].iter().any(|end| {
            let own = stem.strip_suffix(end);
            own.is_some_and(|own| own.is_empty() || own.eq_ignore_ascii_case(program))
        })
    };
    file[stem.len()..].eq_ignore_ascii_case(".csv") && is_own()
}

/// What the nickname files next to a program say.
///
/// # Errors
///
/// If one of them is not a nickname file.
pub(super) fn next_to(source: &Source<'_>) -> Result<Nicknames, ReadError> {
    let mut out = Nicknames::default();
    for companion in source
        .companions
        .iter()
        .filter(|one| is_file_of(&source.name, &one.name))
    {
        read(&companion.name, &companion.bytes, &mut out)?;
    }
    out.twice();
    Ok(out)
}

fn read(file: &str, bytes: &[u8], out: &mut Nicknames) -> Result<(), ReadError> {
    let failure = |error: ReadError| {
        let between = if error.place.is_some() { ":" } else { ": " };
        ReadError::whole(format!("{file}{between}{error}"))
    };
    let mut records = csv::records(bytes, 0).map_err(failure)?.into_iter();
    let header = records.next().unwrap_or_else(|| Record {
        place: LineColumn::START,
        fields: Vec::new(),
    });
    let column = |name: &str| {
        header
            .fields
            .iter()
            .position(|field| field.text.trim().eq_ignore_ascii_case(name))
    };
    let [address, _, nickname, initial, retentive, comment] = COLUMNS.map(column);
    let (Some(address), Some(nickname)) = (address, nickname) else {
        let message =
            "a nickname file begins with the names of its columns, among them `Address` and `Nickname`";
        return Err(failure(ReadError::at(LineColumn::START, message)));
    };
    for record in records {
        let text = |column: Option<usize>| {
            let field = column.and_then(|column| record.fields.get(column));
            field.map_or("", |field| field.text.trim())
        };
        let mut refuse = |element: &str, why: String| {
            let why = format!("{file}:{}: {why}", record.place);
            out.report.refused(LineColumn::START, element, why);
        };
        let name = text(Some(address));
        let Some(address) = Address::parse(name).filter(|address| address.bank.has(address.number)) else {
            if !name.is_empty() {
                refuse(name, "there is no such address here".to_owned());
            }
            continue;
        };
        let initial = text(initial);
        let value = value(initial, address.bank.kind());
        if value.is_none() && !initial.is_empty() {
            refuse(name, format!("`{initial}` is not a value of it"));
        }
        out.all.push(Nickname {
            address,
            name: text(Some(nickname)).to_owned(),
            comment: text(comment).to_owned(),
            initial: value.filter(|value| !is_default(value)),
            retentive: match text(retentive).to_ascii_lowercase().as_str() {
                "yes" => Some(true),
                "no" => Some(false),
                _ => None,
            },
        });
    }
    Ok(())
}

/// A value as the file writes it.
fn value(text: &str, kind: Kind) -> Option<Constant> {
    match kind {
        Kind::Bit => match text {
            "0" => Some(Constant::Bit(false)),
            "1" => Some(Constant::Bit(true)),
            _ => None,
        },
        Kind::Int => text
            .parse::<i16>()
            .ok()
            .map(|number| Constant::Int(number.into())),
        Kind::Int2 => text
            .parse::<i32>()
            .ok()
            .map(|number| Constant::Int(number.into())),
        Kind::Hex => {
            let digits = text.strip_suffix(['h', 'H']).unwrap_or(text);
            u16::from_str_radix(digits, 16)
                .ok()
                .map(|number| Constant::Hex(number.into()))
        }
        Kind::Float => text
            .parse()
            .ok()
            .filter(|number: &f64| number.is_finite())
            .map(Constant::Float),
        Kind::Text => {
            let mut letters = text.chars();
            let letter = letters.next().filter(char::is_ascii)?;
            letters
                .next()
                .is_none()
                .then(|| Constant::Text(letter.to_string()))
        }
    }
}

/// Whether an address holds the value anyway.
fn is_default(value: &Constant) -> bool {
    matches!(value, Constant::Bit(false) | Constant::Int(0) | Constant::Hex(0))
        || *value == Constant::Float(0.0)
}

impl Nicknames {
    /// Says how many addresses the program does not use: nothing declares them.
    pub(super) fn unused(&mut self, program: &Program) {
        let mut used: HashSet<Address> = HashSet::new();
        let mut named: HashSet<&str> = HashSet::new();
        let mut spans: HashSet<Span> = HashSet::new();
        let mut pointed: HashSet<Bank> = HashSet::new();
        for one in uses(program) {
            match one.what {
                What::One(tag) | What::From(tag, _) => match &tag.which {
                    Which::Number(_) => used.extend(tag.address()),
                    Which::Nickname(name) => _ = named.insert(name),
                },
                What::Many(span) => _ = spans.insert(span),
                What::Somewhere(pointer) => _ = pointed.insert(pointer.bank),
            }
        }
        let is_used = |nickname: &&Nickname| {
            let address = nickname.address;
            used.contains(&address)
                || named.contains(nickname.name.as_str())
                || pointed.contains(&address.bank)
                || spans.iter().any(|span| span.holds(address))
        };
        let unused = program.nicknames.len() - program.nicknames.iter().filter(is_used).count();
        if unused > 0 {
            let why = format!("the program does not use {unused} of the addresses, and they are left out");
            self.report.approximated(LineColumn::START, "nicknames", why);
        }
    }

    /// Names that stand for two addresses.
    fn twice(&mut self) {
        let mut first: HashMap<String, Address> = HashMap::new();
        for nickname in self.all.iter().filter(|nickname| !nickname.name.is_empty()) {
            let there = *first
                .entry(nickname.name.to_lowercase())
                .or_insert(nickname.address);
            if there != nickname.address {
                self.findings.push(Finding {
                    place: LineColumn::START,
                    severity: Severity::Warning,
                    check: "click-nickname",
                    message: format!(
                        "the nickname `{}` stands for {there} and for {}: give one of them another name",
                        nickname.name, nickname.address
                    ),
                });
            }
        }
    }
}

/// The file that belongs next to a program with nicknames.
pub(super) fn companion(nicknames: &[Nickname]) -> Option<Companion> {
    (!nicknames.is_empty()).then(|| Companion {
        name: "nicknames.csv".to_owned(),
        bytes: write(nicknames).into(),
    })
}

/// A nickname file, sorted by address.
fn write(nicknames: &[Nickname]) -> String {
    let mut out = format!("{}\n", COLUMNS.join(","));
    let mut sorted: Vec<&Nickname> = nicknames.iter().collect();
    sorted.sort_by_key(|nickname| nickname.address);
    for Nickname {
        address,
        name,
        comment,
        initial,
        retentive,
    } in sorted
    {
        let row = address.bank.row();
        let ty = match row.kind {
            Kind::Bit => "BIT",
            Kind::Int => "INT",
            Kind::Int2 => "INT2",
            Kind::Hex => "HEX",
            Kind::Float => "FLOAT",
            Kind::Text => "TEXT",
        };
        let initial = match initial {
            None if row.kind == Kind::Text => String::new(),
            None => "0".to_owned(),
            Some(Constant::Bit(bit)) => u8::from(*bit).to_string(),
            Some(Constant::Int(number)) => number.to_string(),
            Some(Constant::Hex(number)) => format!("{number:04X}"),
            Some(Constant::Float(number)) => number.to_string(),
            Some(Constant::Text(text)) => csv::field(text),
        };
        let retentive = if retentive.unwrap_or(row.retentive) {
            "Yes"
        } else {
            "No"
        };
        let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        out.push_str(&format!(
            "{address},{ty},{},{initial},{retentive},{}\n",
            quoted(name),
            quoted(comment)
        ));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    #[track_caller]
    fn check(text: &str, expected: Expect) {
        let mut source = Source::alone("main", b"");
        source.companions.push(Companion {
            name: "nicknames.csv".to_owned(),
            bytes: text.to_owned().into(),
        });
        expected.assert_eq(&match next_to(&source) {
            Err(error) => format!("{error}\n"),
            Ok(read) => {
                let mut out = write(&read.all);
                read.report
                    .remarks()
                    .for_each(|entry| out.push_str(&format!("{}: {:?}\n", entry.element, entry.outcome)));
                read.findings
                    .iter()
                    .for_each(|found| out.push_str(&format!("{}\n", found.message)));
                out
            }
        });
    }

    #[test]
    fn nickname_files() {
        check(
            "Address,Data Type,Modbus Address,Function Code,Nickname,Initial Value,Retentive,Address Comment\r\n\
             DS1,INT,400001,FC=03,TankTemp,100,Yes,\"in \"\"degrees\"\", C\"\r\nX001,BIT,100001,FC=02,\"Start\",0,No,\"\"\r\n\
             DH2,HEX,,,Mask,00FFh,No,\r\nTXT1,TEXT,,,State,r,Yes,\r\nDF1,FLOAT,,,tanktemp,0.5,Yes,\r\nXD0u,HEX,,,Upper,0,No,\r\nDD1,INT2,,,Big,x,,\r\n",
            expect![[r#"
                Address,Data Type,Nickname,Initial Value,Retentive,Address Comment
                X001,BIT,"Start",0,No,""
                DS1,INT,"TankTemp",100,Yes,"in ""degrees"", C"
                DD1,INT2,"Big",0,Yes,""
                DH2,HEX,"Mask",00FF,No,""
                DF1,FLOAT,"tanktemp",0.5,Yes,""
                XD0u,HEX,"Upper",0,No,""
                TXT1,TEXT,"State",r,Yes,""
                DD1: Refused("nicknames.csv:8:1: `x` is not a value of it")
                the nickname `tanktemp` stands for DS1 and for DF1: give one of them another name
            "#]],
        );
        check(
            "Nickname\nA\n",
            expect![[r#"
                nicknames.csv:1:1: a nickname file begins with the names of its columns, among them `Address` and `Nickname`
            "#]],
        );
        check(
            "Address,Nickname\nDS1,\"A\nB\"\n\nDS2,B\nDS9999,C\n",
            expect![[r#"
                Address,Data Type,Nickname,Initial Value,Retentive,Address Comment
                DS1,INT,"A
                B",0,Yes,""
                DS2,INT,"B",0,Yes,""
                DS9999: Refused("nicknames.csv:6:1: there is no such address here")
            "#]],
        );
    }

    #[test]
    fn names_of_nickname_files() {
        for (file, is_one) in [
            ("nicknames.csv", true),
            ("motor.nicknames.csv", true),
            ("Motor_nicknames.CSV", true),
            ("pump_nicknames.csv", false),
            ("motor.csv", false),
            ("ünicknames.csv", false),
            ("é", false),
            ("", false),
        ] {
            assert_eq!(is_file_of("motor", file), is_one, "{file}");
        }
    }
}
