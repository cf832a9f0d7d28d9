//! One element as a block.

use super::Importer;
use super::head::plain_duration;
use crate::element::{self, Form};
use crate::field::{self, Coil, Slot};
use crate::fork::made::Made;
use crate::fork::outside::Outside;
use crate::fork::{self, Given, Read, What};
use crate::model::{Leaf, Version};
use crate::tags::MOST_STAGES;
use crate::text;
use ladder_format::program::{Block, Expression, Operand, Path};
use ladder_instructions::Op;
use ladder_notation::{Turn, Unread};

/// The relay that the fork sets when the result of a calculation does not fit.
const OVERFLOW: &str = "ROverflowFlagV";

/// Why an element of the fork is not a block here.
const NOT_READ: &str = "it is not read";

/// A block and what there is to say about it.
pub(super) struct Translation {
    pub(super) block: Block,
    /// Why it is not quite the same.
    pub(super) remark: Option<String>,
}

impl Translation {
    const fn with(block: Block, remark: Option<String>) -> Translation {
        Translation { block, remark }
    }
}

impl From<Block> for Translation {
    fn from(block: Block) -> Translation {
        Translation::with(block, None)
    }
}

impl<'f> Importer<'f> {
    /// Whether export makes the same line of a block.
    pub(super) fn comes_back(&self, leaf: &Leaf, block: &Block) -> bool {
        if self.jumps.block(leaf).is_some() {
            let label = leaf.text.split(' ').nth(1);
            let own = block.only().and_then(Expression::path).and_then(Path::whole);
            return label.is_none_or(|label| !field::is_literal(label) && own == Some(label));
        }
        if block.user_name().is_some_and(|name| name.starts_with("RES")) {
            return true;
        }
        // RES of a variable is a MOV here.
        let variable = leaf.text.strip_prefix("RES ");
        let is_reset = variable.is_some_and(|name| self.tags.any_state(name).is_none());
        let plain = element::plain(&leaf.text, self.file.dialect());
        !is_reset && plain.as_deref() == Some(leaf.text.as_str())
    }

    pub(super) fn translated(&mut self, leaf: &'f Leaf) -> Result<Translation, String> {
        if let Some(block) = self.jumps.block(leaf) {
            return block.clone().map(Translation::from);
        }
        let fields = field::fields(&leaf.text);
        let dialect = self.file.dialect();
        if let Some(read) = fork::read(&leaf.text, dialect) {
            let mut translation = self.forks(&read?)?;
            translation.remark = translation.remark.or_else(|| register(&fields));
            return Ok(translation);
        }
        let row = element::row_of(&leaf.text).ok_or("there is no such instruction here")?;
        if element::plain(&leaf.text, dialect).is_none() && row.form != Form::Comment {
            return Err("its fields are not numbers, or are those of the fork".to_owned());
        }
        let name = fields.first().copied().unwrap_or_default();
        Ok(match row.form {
            Form::Contact => {
                let tag = self.tags.bit(name);
                let block = if fields[1] == "0" {
                    Block::contact(tag)
                } else {
                    Block::negated_contact(tag)
                };
                let overflow =
                    "LDmicro's fork makes it high when a sum or difference does not fit; here nothing does";
                let is_overflow = name == OVERFLOW && dialect.version == Version::V02;
                Translation::with(block, is_overflow.then(|| overflow.to_owned()))
            }
            Form::Constant(on) => Block::contact(Path::system(if on { "ON" } else { "OFF" })).into(),
            Form::Coil => {
                let op = match Coil::of(&fields) {
                    Coil::Plain => Op::Coil,
                    Coil::Negated => Op::NegatedCoil,
                    Coil::Set => Op::SetCoil,
                    Coil::Reset => Op::ResetCoil,
                };
                Block::of(op, [self.tags.bit(name)])?.into()
            }
            Form::Timer(op) => {
                let tag = self.state(op, name)?;
                let delay = element::preset(&fields, dialect).ok_or("its delay is not a number")?;
                Block::of(op, [tag.into(), duration(delay)?])?.into()
            }
            Form::Counter(op) => {
                let tag = self.state(op, name)?;
                let most = field::literal(fields[1]).unwrap_or(0);
                Block::of(op, [Expression::from(tag), most.into()])?.into()
            }
            Form::Reset => match self.tags.any_state(name) {
                Some(tag) => Block::of(Op::Res, [tag])?.into(),
                None if self.tags.is_pulses(name) => match fork::outside(&leaf.text) {
                    Some(read) => self.forks(&read?)?,
                    None => return Err("no block here ends pulses".to_owned()),
                },
                None => {
                    let mut remark = None;
                    let value = self.operand(self.tags.reset(name), &mut remark)?;
                    let block = Block::of(Op::Mov, [self.tags.variable(name).into(), value])?;
                    Translation::with(block, remark)
                }
            },
            Form::Adc => {
                let channel = self
                    .channels
                    .get(name)
                    .ok_or("there are no more analog inputs here")?;
                let operands = [self.tags.variable(name).into(), Expression::from(*channel)];
                Block::of(Op::Adc, operands)?.into()
            }
            Form::Shift => {
                let stages: u32 = fields[1].parse().unwrap_or(0);
                let register = self.tags.registers.get(name);
                match register {
                    Some((tag, _)) if stages > 0 && stages <= MOST_STAGES => {
                        let register = Path::tag(tag);
                        let all = register.clone().range(0, i64::from(stages) - 1);
                        Block::of(Op::Shift, [all, register.index([0])])?.into()
                    }
                    _ => return Err(format!("a shift register has 1 to {MOST_STAGES} stages")),
                }
            }
            Form::Values(op, slots) => {
                let mut translation = self.values(op, &fields, slots)?;
                translation.remark = translation.remark.or(register(&fields));
                translation
            }
            Form::Table | Form::Curve => self.listed_values(row.form, &fields)?,
            Form::Text => self.text(&fields)?,
            Form::Comment => return Err("a comment is alone in its rung".to_owned()),
            Form::Placeholder => return Err("the rung is empty: delete it, or add instructions".to_owned()),
        })
    }

    /// The tag of a timer or counter.
    fn state(&self, op: Op, name: &str) -> Result<Path, String> {
        let other = || format!("`{name}` is a timer and a counter at once");
        self.tags.state(name, op).ok_or_else(other)
    }

    fn operand(&self, text: &str, remark: &mut Option<String>) -> Result<Expression, String> {
        if !field::is_literal(text) {
            return Ok(self.tags.variable(text).into());
        }
        let value = field::literal(text).ok_or("its literal is not a number")?;
        let wrapped = field::wrapped(value);
        if wrapped != value {
            *remark = Some(format!("{text} is {wrapped} in 16 bits"));
        }
        Ok(wrapped.into())
    }

    fn values(&self, op: Op, fields: &[&str], slots: &[Slot]) -> Result<Translation, String> {
        let mut remark = None;
        let mut operands = Vec::new();
        for (field, slot) in fields.iter().zip(slots) {
            operands.push(match slot {
                Slot::Place if field::is_literal(field) => {
                    return Err(format!("{field} is a number and cannot be written"));
                }
                Slot::Place => self.tags.variable(field).into(),
                Slot::Value => self.operand(field, &mut remark)?,
                Slot::Number => field::literal(field).unwrap_or(0).into(),
            });
        }
        Ok(Translation::with(Block::of(op, operands)?, remark))
    }

    /// An element of the fork.
    fn forks(&mut self, read: &Read<'_>) -> Result<Translation, String> {
        if let (What::Outside(outside), [Given::Fields(fields)]) = (read.what, &read.given[..]) {
            return Ok(self.outside(outside, fields));
        }
        let mut remark = read.remark.map(str::to_owned);
        let mut operands: Vec<Operand> = Vec::with_capacity(read.given.len());
        for given in &read.given {
            operands.push(match given {
                Given::Place(name) => self.tags.variable(name).into(),
                Given::Value(field) => self.operand(field, &mut remark)?.into(),
                Given::Scans(scans) => (*scans).into(),
                Given::Relay(name) => self.tags.bit(name).into(),
                Given::Bit(name, bit) => self.tags.variable(name).bit((*bit).into()).into(),
                Given::Pulses(name) => {
                    let number = self.tags.pulses.get(*name);
                    let number = number.ok_or("there are no more pulse outputs here")?;
                    Operand::Given("CH".to_owned(), i64::from(*number).into())
                }
                Given::Fields(_) => return Err(NOT_READ.to_owned()),
            });
        }
        let mut what = read.what;
        if let (What::Made(Made::Segments(segments)), [_, Given::Place(character)]) =
            (&mut what, &read.given[..])
            && self.tags.any_state(character).is_some()
        {
            segments.fixed = true;
            let why = "where the number is no character, LDmicro makes it 32; here it stays";
            remark.get_or_insert_with(|| why.to_owned());
        }
        // A count of a timer is a number only where it is read.
        let is_read = |index: usize| index > 0 && matches!(what, What::Made(Made::Segments(_)));
        let counts = |(index, given): (usize, &Given<'_>)| match given {
            Given::Bit(name, _) => self.tags.any_state(name).is_some(),
            Given::Place(name) if !is_read(index) => {
                matches!(what, What::Made(_)) && self.tags.any_state(name).is_some()
            }
            _ => false,
        };
        if read.given.iter().enumerate().any(counts) {
            return Err("what it changes is a timer or counter of another kind".to_owned());
        }
        let block = match what {
            What::Instruction(op) => Block::of(op, operands)?,
            What::Made(made) => {
                self.made.insert(made);
                made.block(operands)?
            }
            What::Outside(_) => return Err(NOT_READ.to_owned()),
        };
        Ok(Translation::with(block, remark))
    }

    /// An element that is not read.
    fn outside(&mut self, outside: Outside, fields: &str) -> Translation {
        let remark = outside.remark();
        let writes = outside.writes_its_fields().then(|| {
            let mut tags: Vec<String> = fields.split(' ').flat_map(|name| self.tags.named(name)).collect();
            tags.sort_unstable();
            tags.dedup();
            tags
        });
        let part = Unread {
            name: &outside.name(),
            about: &format!("{}: {remark}", outside.word),
            text: fields,
            writes: writes.as_deref(),
            power: outside.power(),
            turn: Turn::Here,
        };
        let block = self.unread.block(part, |name| Made::named(name).is_some());
        Translation::with(block, Some(remark))
    }

    fn listed_values(&self, form: Form, fields: &[&str]) -> Result<Translation, String> {
        let mut remark = None;
        let to = self.tags.variable(fields[0]).into();
        let index = self.operand(fields[1], &mut remark)?;
        let (op, each) = match form {
            Form::Table => (Op::Lut, 1),
            _ => (Op::Pwl, 2),
        };
        let values = element::numbers(element::values(fields, form)).unwrap_or_default();
        if fields[2].parse() != Ok(values.len() / each) || !values.len().is_multiple_of(each) {
            return Err("the number of its values is not the one that it gives".to_owned());
        }
        if values.is_empty() {
            return Err("it has no entries".to_owned());
        }
        let values = values
            .iter()
            .map(|value| Expression::from(field::wrapped(*value)));
        let block = Block::of(op, [to, index].into_iter().chain(values))?;
        Ok(Translation::with(block, remark))
    }

    fn text(&self, fields: &[&str]) -> Result<Translation, String> {
        let version = self.file.version;
        let text = text::read(fields).ok_or("its text is not what LDmicro writes")?;
        let mut operands = vec![Expression::literal(text::literal(&text))?];
        match (fields[0], text::numbers(&text)) {
            ("(none)", 0) => {}
            ("(none)", _) => return Err("its text wants a number, and it has no variable".to_owned()),
            (_, 0) => return Err("it has a variable, and its text has no place for it".to_owned()),
            (name, 1) => operands.push(self.tags.variable(name).into()),
            (_, _) => return Err("LDmicro sends one number in a text".to_owned()),
        }
        let once = "here it is also sent once at the start; the fork waits until power comes";
        Ok(Translation::with(
            Block::of(Op::Fmt, operands)?,
            (version == Version::V02).then(|| once.to_owned()),
        ))
    }
}

/// What there is to say of a register of the controller such as `#PORTA` among an element's fields.
fn register(fields: &[&str]) -> Option<String> {
    let name = fields.iter().find(|field| field.starts_with('#'))?;
    Some(format!(
        "{name} is a register of the controller; here it is a tag"
    ))
}

/// A delay in microseconds.
fn duration(microseconds: u64) -> Result<Expression, String> {
    Ok(Expression::literal(format!(
        "T#{}",
        plain_duration(microseconds)
    ))?)
}
