//! A run of lines without a blank one: its networks, or only text.

use crate::block;
use crate::element::{self, Labels};
use crate::frame;
use crate::label::labels;
use crate::marks::Marks;
use crate::network::{self, Network};
use crate::operand::Operands;
use crate::sheet::{Sheet, WIDEST, is_wire};
use crate::sides::Sides;
use crate::symbol::{self, Symbol, SymbolKind};
use crate::text::{self, Phrase};
use crate::wires;
use ladder_format::program::{self, Block};
use ladder_syntax::parse;

/// What was made of the lines.
#[derive(Debug, Default)]
pub(crate) struct Part {
    pub(crate) symbols: Vec<Element>,
    pub(crate) networks: Vec<Drawn>,
    /// What is written in lines without a rung.
    pub(crate) texts: Vec<Phrase>,
}

/// A contact, coil or box.
#[derive(Debug)]
pub(crate) struct Element {
    pub(crate) line: usize,
    pub(crate) column: usize,
    /// How much it tells of itself that it is drawn, and no ladder text.
    pub(crate) form: Form,
    /// As it is drawn, with what is written about it.
    pub(crate) shown: String,
    /// As a block of ladder text, or why it is none.
    pub(crate) written: Result<program::Part, String>,
}

/// In which form an element is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// As ladder text has it too.
    Own,
    /// With brackets and no name: it may be either.
    Nameless,
    /// With bars and no name. `|/|` may be a slip in ladder text.
    Bare,
    /// With its name inside its brackets.
    Inside,
    /// With its name above it or between bars, with inverse brackets, or as a box.
    Drawn,
}

/// A network, with the lines that belong to it.
#[derive(Debug)]
pub(crate) struct Drawn {
    pub(crate) network: Network,
    /// The last line that belongs to it.
    pub(crate) end: usize,
    /// What is written next to it.
    pub(crate) texts: Vec<Phrase>,
    /// Why its wires cannot be followed.
    pub(crate) problems: Vec<network::Problem>,
}

/// Reads lines.
pub(crate) fn read(sheet: &Sheet, operands: &mut Operands) -> Part {
    let mut marks = Marks::new(sheet.len());
    let frames = frame::find(sheet, &mut marks);
    let mut sides: Vec<Sides> = frames
        .iter()
        .map(|frame| Sides::of(sheet, &mut marks, frame))
        .collect();
    let mut symbols = symbol::find(sheet, &mut marks);
    let power: Vec<Option<(usize, usize)>> = sides
        .iter()
        .zip(symbols.len()..)
        .map(|(sides, symbol)| sides.power.map(|line| (line, symbol)))
        .collect();
    for (number, frame) in frames.iter().enumerate() {
        symbols.push(Symbol {
            line: sides[number].power.unwrap_or(frame.top),
            from: frame.left,
            to: frame.right + 1,
            kind: SymbolKind::Frame(number),
        });
    }
    let mut wires = wires::find(sheet, &marks, &power);
    let is_drawn = wires
        .runs
        .iter()
        .any(|run| run.things.iter().any(|thing| !thing.is_joint()));
    let mut phrases: Vec<Vec<Phrase>> = (0..sheet.len())
        .map(|line| text::phrases(sheet, &marks, line))
        .collect();
    if !is_drawn {
        let whole = |line: usize| Phrase {
            line,
            from: 0,
            to: sheet.width(line),
            text: sheet.text(line, 0, sheet.width(line)),
        };
        return Part {
            texts: (0..sheet.len()).map(whole).collect(),
            ..Part::default()
        };
    }
    let labels = labels(&symbols, &frames, &mut phrases, &marks);
    for (frame, sides) in frames.iter().zip(&mut sides) {
        sides.take_contacts(frame, &mut wires, |symbol| {
            let SymbolKind::Contact(inside) = &symbols[symbol].kind else {
                return None;
            };
            let name = match (inside.trim(), &labels[symbol].0) {
                ("", Some(name)) => name.text.as_str(),
                (name, None) => name,
                _ => return None,
            };
            name.starts_with(|c: char| c.is_alphabetic() || c == '%')
                .then(|| name.to_owned())
        });
    }
    let acts = |symbol: usize| match &symbols[symbol].kind {
        SymbolKind::Contact(inside) => block::row(inside.split(' ').next().unwrap_or("")).is_some_and(acts),
        SymbolKind::Coil(_) | SymbolKind::Flow(_) | SymbolKind::Frame(_) => true,
        SymbolKind::Own => {
            sheet.at(symbols[symbol].line, symbols[symbol].from) != '[' || {
                let text = sheet.text(symbols[symbol].line, symbols[symbol].from + 1, symbols[symbol].to);
                block::row(text.split(']').next().unwrap_or("")).is_some_and(acts)
            }
        }
    };
    let (networks, mut problems) = network::networks(&wires, &acts);
    problems.extend(sheet.cut().map(|line| {
        (
            (line, WIDEST - 1),
            format!("a line is read up to column {WIDEST}"),
        )
    }));
    for phrase in phrases.iter().flatten() {
        let touches = |run: &wires::Run| {
            let before = phrase.to == run.from && is_wire(sheet.at(run.line, run.from));
            let after = run.to == phrase.from && is_wire(sheet.at(run.line, phrase.from.saturating_sub(1)));
            run.is_rung() && (before || after)
        };
        if wires.next_to(phrase.line, phrase.from).any(touches) {
            let why = format!(
                "`{}` is in the wire: a name belongs above its contact, or inside it",
                phrase.text
            );
            problems.push(((phrase.line, phrase.from), why));
        }
    }
    let elements = symbols.iter().zip(&labels).map(|(symbol, label)| {
        let label = Labels {
            above: label.0.as_ref().map(|phrase| phrase.text.as_str()),
            below: label.1.as_ref().map(|phrase| phrase.text.as_str()),
        };
        let drawn = sheet.text(symbol.line, symbol.from, symbol.to);
        let block = match &symbol.kind {
            SymbolKind::Contact(inside) => Some(element::contact(inside, label, operands)),
            SymbolKind::Coil(inside) => Some(element::coil(inside, label, operands)),
            SymbolKind::Flow(inside) => Some(element::flow(inside, operands)),
            SymbolKind::Own => None,
            SymbolKind::Frame(number) => {
                Some(sides[*number].written(&frames[*number], label.above, operands))
            }
        };
        Element {
            line: symbol.line,
            column: symbol.from,
            form: form(
                &symbol.kind,
                label
                    .above
                    .is_some_and(|above| above.contains(char::is_alphanumeric)),
                sheet.at(symbol.line, symbol.from),
            ),
            shown: match label.above {
                Some(above) => format!("{} {above}", drawn.trim()),
                None => drawn.trim().to_owned(),
            },
            written: match block {
                Some(block) => block.map(program::Part::Block),
                None => own(drawn),
            },
        }
    });
    let elements = elements.collect();
    Part {
        symbols: elements,
        networks: shared(networks, phrases, problems, sheet.len()),
        texts: Vec::new(),
    }
}

/// A block that is drawn as ladder text has it. One that the table does not have, or spells otherwise, stays as it is.
fn own(text: String) -> Result<program::Part, String> {
    let letters = |text: &str| text.split_whitespace().collect::<String>();
    match Block::read(&text) {
        Ok(block) if letters(&block.to_string()) == letters(&text) => Ok(program::Part::Block(block)),
        _ if parse(&format!("+--{text}--+")).errors().is_empty() => Ok(program::Part::Text(text)),
        _ => Err("what is between its brackets is not known".to_owned()),
    }
}

fn form(kind: &SymbolKind, has_name_above: bool, first: char) -> Form {
    let has_bracket = matches!(first, '[' | '(');
    match kind {
        SymbolKind::Own | SymbolKind::Flow(_) => Form::Own,
        SymbolKind::Frame(_) => Form::Drawn,
        // Ladder text has no `] [`.
        _ if has_name_above || first == ']' => Form::Drawn,
        // A block without operands: `[OSR]`.
        SymbolKind::Contact(inside) if block::row(inside).is_some_and(|row| row.required() == 0) => Form::Own,
        SymbolKind::Contact(inside) | SymbolKind::Coil(inside) => {
            let letters: String = inside.chars().filter(|c| c.is_alphanumeric()).collect();
            let says = letters.len() > 1 || (!letters.is_empty() && !"PNSRLUM".contains(&letters));
            match (says, has_bracket) {
                (true, true) => Form::Inside,
                (true, false) => Form::Drawn,
                (false, true) => Form::Nameless,
                (false, false) => Form::Bare,
            }
        }
    }
}

fn acts(row: &'static ladder_instructions::Instruction) -> bool {
    row.role == ladder_instructions::Role::Acting
}

/// Assigns to each network the lines up to its last rung, and what is written and wrong there; the last one has the rest.
fn shared(
    networks: Vec<Network>,
    phrases: Vec<Vec<Phrase>>,
    problems: Vec<network::Problem>,
    lines: usize,
) -> Vec<Drawn> {
    let mut phrases = phrases.into_iter().flatten().peekable();
    let mut problems = problems;
    problems.sort_unstable();
    let mut problems = problems.into_iter().peekable();
    let networks: Vec<Network> = networks.into_iter().filter(has_symbol).collect();
    let count = networks.len();
    let mut drawn = Vec::new();
    for (number, network) in networks.into_iter().enumerate() {
        let is_last = number + 1 == count;
        let last_rung = network.lines.last().copied().unwrap_or(0);
        let end = if is_last {
            lines.saturating_sub(1)
        } else {
            last_rung
        };
        drawn.push(Drawn {
            network,
            end,
            texts: std::iter::from_fn(|| phrases.next_if(|phrase| phrase.line <= end)).collect(),
            problems: std::iter::from_fn(|| problems.next_if(|((line, _), _)| *line <= end)).collect(),
        });
    }
    drawn
}

fn has_symbol(network: &Network) -> bool {
    network.symbols().next().is_some()
}
