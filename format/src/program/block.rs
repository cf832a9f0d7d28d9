//! Blocks of a sketch: an instruction of the table or a user's block, with its operands.

use super::expression::List;
use super::{Expression, Literal, Path};
use ladder_instructions::{Direction, Instruction, Op, Shape, by_op, lookup};
use ladder_syntax::is_block_name;
use std::fmt::{self, Display, Formatter};

/// A block on a rung. What the table of instructions does not allow cannot be made.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Block {
    head: Head,
    operands: Vec<Operand>,
}

/// What a block is.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Head {
    /// An instruction of the table.
    Instruction(Op),
    /// A block of one's own, by its name without `$`, in the brackets that its definition has.
    User(Shape, String),
}

/// One operand of a block.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Operand {
    /// By its place.
    Value(Expression),
    /// `R := reset`
    Given(String, Expression),
    /// `FOUND => hit`
    Taken(String, Expression),
}

/// Why something cannot be part of a program: a sentence without a point.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Invalid(pub(super) String);

impl Invalid {
    pub(super) fn new(why: &str) -> Invalid {
        Invalid(why.to_owned())
    }
}

impl Display for Invalid {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Invalid {}

impl From<Invalid> for String {
    fn from(invalid: Invalid) -> String {
        invalid.0
    }
}

impl Block {
    /// An instruction with its operands.
    ///
    /// # Errors
    ///
    /// If the instruction does not take such operands, or one of them cannot be written.
    pub fn of<O: Into<Operand>>(op: Op, operands: impl IntoIterator<Item = O>) -> Result<Block, Invalid> {
        let operands: Vec<Operand> = operands.into_iter().map(Into::into).collect();
        let row = by_op(op);
        let by_place = operands
            .iter()
            .filter(|operand| matches!(operand, Operand::Value(_)));
        let count = by_place.count();
        if !row.takes(count) {
            let block = row.block();
            return Err(Invalid(format!("{block} does not take {count} operands")));
        }
        for operand in &operands {
            let (name, out) = match operand {
                Operand::Value(_) => continue,
                Operand::Given(name, _) => (name, false),
                Operand::Taken(name, _) => (name, true),
            };
            let known = row.named(name);
            if known.is_none_or(|known| (known.direction == Direction::Out) != out) {
                return Err(Invalid(format!("{} has no operand `{name}`", row.block())));
            }
        }
        Block::checked(Head::Instruction(op), operands)
    }

    /// The instruction that is spelled so in brackets of a shape, as [`Block::of`] has it.
    ///
    /// # Errors
    ///
    /// As [`Block::of`], and if there is none.
    pub fn spelled<O: Into<Operand>>(
        shape: Shape,
        mnemonic: &str,
        operands: impl IntoIterator<Item = O>,
    ) -> Result<Block, Invalid> {
        let operands: Vec<Operand> = operands.into_iter().map(Into::into).collect();
        let count = operands
            .iter()
            .filter(|operand| matches!(operand, Operand::Value(_)))
            .count();
        let rows = lookup(shape, mnemonic);
        let fitting = |row: &&Instruction| row.takes(count);
        match rows.clone().find(fitting).or_else(|| rows.clone().next()) {
            Some(row) => Block::of(row.op, operands),
            None => Err(Invalid(format!("there is no instruction `{mnemonic}`"))),
        }
    }

    /// A block of one's own in `[ ]`, by its name without `$`. The first operand is its state, if it has one.
    ///
    /// # Errors
    ///
    /// If the name or an operand cannot be written.
    pub fn user<O: Into<Operand>>(
        name: impl Into<String>,
        operands: impl IntoIterator<Item = O>,
    ) -> Result<Block, Invalid> {
        Block::user_in(Shape::Logical, name, operands)
    }

    /// The same in other brackets: `($Flash)( lamp )`
    ///
    /// # Errors
    ///
    /// As [`Block::user`].
    pub fn user_in<O: Into<Operand>>(
        shape: Shape,
        name: impl Into<String>,
        operands: impl IntoIterator<Item = O>,
    ) -> Result<Block, Invalid> {
        let name = name.into();
        if !is_block_name(&name) {
            return Err(Invalid(format!(
                "`{name}` is not a name that a block can have here"
            )));
        }
        let operands = operands.into_iter().map(Into::into).collect();
        Block::checked(Head::User(shape, name), operands)
    }

    fn checked(head: Head, operands: Vec<Operand>) -> Result<Block, Invalid> {
        operands.iter().try_for_each(|operand| operand.value().check())?;
        Ok(Block { head, operands })
    }

    /// An instruction whose only operand is a tag, by a name that is one.
    const fn on(op: Op, operands: Vec<Operand>) -> Block {
        let head = Head::Instruction(op);
        Block { head, operands }
    }

    /// `[ ]( tag )`
    pub fn contact(tag: impl Into<Expression>) -> Block {
        Block::on(Op::Contact, vec![Operand::Value(tag.into())])
    }

    /// `[/]( tag )`
    pub fn negated_contact(tag: impl Into<Expression>) -> Block {
        Block::on(Op::NegatedContact, vec![Operand::Value(tag.into())])
    }

    /// `( )( tag )`
    pub fn coil(tag: impl Into<Expression>) -> Block {
        Block::on(Op::Coil, vec![Operand::Value(tag.into())])
    }

    /// `<LBL>( name )`
    pub fn label(name: &str) -> Block {
        Block::on(Op::Lbl, vec![Path::tag(name).into()])
    }

    /// `<JMP>( name )`
    pub fn jump(name: &str) -> Block {
        Block::on(Op::Jmp, vec![Path::tag(name).into()])
    }

    /// `<FUN>( name )`
    pub fn function(name: &str) -> Block {
        Block::on(Op::Fun, vec![Path::tag(name).into()])
    }

    /// `<CALL>( name )`
    pub fn call(name: &str) -> Block {
        Block::on(Op::Call, vec![Path::tag(name).into()])
    }

    /// `<RET>`
    pub const fn ret() -> Block {
        Block::on(Op::Ret, Vec::new())
    }

    /// `[NOT]`
    pub const fn inverter() -> Block {
        Block::on(Op::Inverter, Vec::new())
    }

    /// `[OSR]`
    pub const fn one_shot() -> Block {
        Block::on(Op::OneShotRising, Vec::new())
    }

    /// An unread part (LANGUAGE §5.9) by a name that is one, without `$`, and what the other system writes for it.
    pub fn unread(name: &str, text: Option<String>) -> Block {
        let text = text.map(|text| Operand::from(Literal::text(&text)));
        Block {
            head: Head::User(Shape::Logical, name.to_owned()),
            operands: text.into_iter().collect(),
        }
    }

    /// What it is.
    pub const fn head(&self) -> &Head {
        &self.head
    }

    /// The instruction, if it is one.
    pub const fn op(&self) -> Option<Op> {
        match self.head {
            Head::Instruction(op) => Some(op),
            Head::User(..) => None,
        }
    }

    /// The name of the user's block, without `$`, if it is one.
    pub fn user_name(&self) -> Option<&str> {
        match &self.head {
            Head::User(_, name) => Some(name),
            Head::Instruction(_) => None,
        }
    }

    /// Its operands in their order.
    pub fn operands(&self) -> &[Operand] {
        &self.operands
    }

    /// The value of its only operand.
    pub fn only(&self) -> Option<&Expression> {
        match &self.operands[..] {
            [Operand::Value(value)] => Some(value),
            _ => None,
        }
    }

    /// The tag of a user's block or an instruction with a state.
    pub fn state(&self) -> Option<&Path> {
        let has_state = match self.head {
            Head::Instruction(op) => by_op(op).state().is_some(),
            Head::User(..) => true,
        };
        match self.operands.first() {
            Some(Operand::Value(Expression::Path(path))) if has_state => Some(path),
            _ => None,
        }
    }

    /// Calls something with each path among its operands. Labels and functions are names, not paths.
    pub fn paths<'b>(&'b self, mut found: impl FnMut(&'b Path)) {
        if !self.names_a_place() {
            self.operands
                .iter()
                .for_each(|operand| operand.value().paths(&mut found));
        }
    }

    /// Changes each path among its operands. They must be valid as before.
    pub fn change_paths(&mut self, mut with: impl FnMut(&mut Path)) {
        if !self.names_a_place() {
            for operand in &mut self.operands {
                operand.value_mut().change_paths(&mut with);
            }
        }
    }

    /// Whether its operand names a place of the program.
    const fn names_a_place(&self) -> bool {
        matches!(self.op(), Some(Op::Lbl | Op::Jmp | Op::Fun | Op::Call))
    }
}

impl Operand {
    /// Of a block that has none.
    pub const NONE: [Operand; 0] = [];

    /// What it holds.
    pub const fn value(&self) -> &Expression {
        let (Operand::Value(value) | Operand::Given(_, value) | Operand::Taken(_, value)) = self;
        value
    }

    const fn value_mut(&mut self) -> &mut Expression {
        let (Operand::Value(value) | Operand::Given(_, value) | Operand::Taken(_, value)) = self;
        value
    }
}

impl<E: Into<Expression>> From<E> for Operand {
    fn from(value: E) -> Operand {
        Operand::Value(value.into())
    }
}

impl Display for Operand {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Operand::Value(value) => value.fmt(f),
            Operand::Given(name, value) => write!(f, "{name} := {value}"),
            Operand::Taken(name, value) => write!(f, "{name} => {value}"),
        }
    }
}

impl Display for Block {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (shape, sign, name) = match &self.head {
            Head::Instruction(op) => {
                let row = by_op(*op);
                (row.shape, "", row.mnemonic)
            }
            Head::User(shape, name) => (*shape, "$", name.as_str()),
        };
        let (open, close) = shape.brackets();
        write!(f, "{open}{sign}{name}{close}")?;
        if self.operands.is_empty() {
            return Ok(());
        }
        write!(f, "( {} )", List(&self.operands))
    }
}
