//! The program model: what a checked program does, without its text.
//!
//! The simulator compiles it, importers and exporters go by way of it, and rules about power read it. Names are
//! resolved, operands typed and brought to the type that the instruction works in, and each network's elements
//! are in their order of evaluation (LANGUAGE §6).

pub use crate::names::system_tag::{Clock, SystemTag};
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use ladder_instructions::{Instruction, Op, Operand, Profile, Semantics, Shape, Timing};
use ladder_syntax::{Name, TextRange};
use std::ops::Range;

/// A place in the text of one of the program's files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Location {
    /// Index into [`Program::files`].
    pub file: u32,
    /// Bytes from the start of the file.
    pub range: TextRange,
}

/// A tag's index in [`Program::tags`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TagId(pub u32);

/// A program that can run.
#[derive(Debug, Clone, Default)]
pub struct Program {
    /// Names of the files it is made of, the program's own first.
    pub files: Vec<String>,
    /// The time from one scan to the next that it is made for, in nanoseconds, where its own file says so.
    pub cycle: Option<i64>,
    /// Of each file whose arithmetic and timing its blocks have.
    pub profiles: Vec<Profile>,
    /// The tags, in the order of their declaration or first use. What several names at one direct address mean is one tag.
    pub tags: Vec<Tag>,
    /// The names that tags at direct addresses have besides their own.
    pub other_names: Vec<OtherName>,
    /// The first address on whose names the files do not agree: such a program must not run.
    pub disagreement: Option<Disagreement>,
    /// All networks: those of the program's file first, from top to bottom.
    pub networks: Vec<Network>,
    /// The networks of the main program: all before the first `<FUN>`.
    pub main: Range<usize>,
    /// The functions that the program can reach.
    pub functions: Vec<Function>,
    /// The tags that are the states of user-defined blocks.
    pub instances: Vec<Instance>,
    /// The user-defined blocks that the program can reach.
    pub blocks: Vec<UserBlock>,
    /// Every label with the network that holds it, in the order of the networks.
    pub labels: Vec<(Name, usize)>,
}

impl Program {
    /// Whose arithmetic and timing the blocks of a place's file have.
    pub fn profile(&self, place: Location) -> Profile {
        let profile = self.profiles.get(place.file as usize).copied();
        profile.unwrap_or_default()
    }

    /// What they do otherwise.
    pub fn semantics(&self, place: Location) -> &'static Semantics {
        self.profile(place).semantics()
    }

    /// The names that tags have besides their own: those that are seen everywhere, or in the body of a block.
    pub fn other_names_in(&self, block: Option<usize>) -> impl Iterator<Item = (&str, &Tag)> {
        let names = self.other_names.iter().filter(move |name| name.block == block);
        names.map(|name| (name.name.as_str(), &self.tags[name.tag.0 as usize]))
    }

    /// The type of a member of a tag.
    pub fn member_type(&self, tag: &Tag, member: Member) -> Scalar {
        member.ty(self.semantics(tag.location))
    }
}

/// A function (`<FUN>`).
#[derive(Debug, Clone)]
pub struct Function {
    /// As written.
    pub name: String,
    /// Its networks; the first holds the `<FUN>`.
    pub networks: Range<usize>,
}

/// A tag that is the state of a user-defined block.
#[derive(Debug, Clone)]
pub struct Instance {
    /// The tag.
    pub tag: TagId,
    /// The block: index into [`Program::blocks`].
    pub block: usize,
    /// The tags of the block's body, each with the one that holds it for this state.
    pub tags: Vec<(TagId, TagId)>,
}

/// A user-defined block (LANGUAGE §5.7).
#[derive(Debug, Clone)]
pub struct UserBlock {
    /// As written, with the `$`.
    pub name: String,
    /// The shape that its header shows.
    pub shape: Shape,
    /// Its parameters in the order of their declaration: tags of its body.
    pub parameters: Vec<(TagId, ParameterKind)>,
    /// Of each parameter that is a structure or an array, and not passed as one tag, its parts in the body: the elementary values
    /// of one that is copied, the columns of one that is passed by reference. In their order goes what is given.
    pub parts: Vec<Vec<Place>>,
    /// The tags `EN` and `ENO` of its body.
    pub en: TagId,
    /// See `en`.
    pub eno: TagId,
    /// The networks of its body.
    pub networks: Range<usize>,
}

/// How a parameter of a user-defined block is passed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ParameterKind {
    /// Copied in before the body runs.
    Input,
    /// Copied out after it.
    Output,
    /// The caller's tag itself.
    InOut,
}

/// What a tag is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// Fed from outside.
    Input,
    /// Shown to the outside.
    Output,
    /// Neither.
    Internal,
}

/// A tag: a variable of the program.
#[derive(Debug, Clone)]
pub struct Tag {
    /// As declared, or as first written. A tag of another file has that file's stem before it (`library.count`),
    /// unless it is a VAR_GLOBAL tag or a direct address.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Input, output or neither.
    pub role: Role,
    /// Keeps its value over a warm restart.
    pub retain: bool,
    /// Never written by the program.
    pub constant: bool,
    /// It is no tag of its file alone: VAR_GLOBAL, a direct address, or not declared.
    pub shared: bool,
    /// Its value at a cold start, one for each element; empty for zero, FALSE, the empty text.
    pub initial: Vec<Value>,
    /// Where it is one of the elementary parts of a declared tag: how elements are named and counted.
    pub column: Option<std::sync::Arc<ColumnOf>>,
    /// The direct address that it is declared at, or that it is.
    pub address: Option<String>,
    /// The user-defined block whose body it belongs to (index into [`Program::blocks`]).
    pub block: Option<usize>,
    /// Where it is declared, or first used.
    pub location: Location,
}

/// How the elements of a tag are named that is an elementary part of a declared one.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnOf {
    /// First and last index of each array around the part, the outermost first. In the tag's name each has its place: `[]`.
    pub dimensions: Box<[(i64, i64)]>,
    /// How many elements the longest array around the part has. An array of arrays is one array, as `a[1][2]` is `a[1, 2]`.
    pub longest_array: u64,
    /// How many bytes of the tag's name are that of the tag as it is declared, and the type of that.
    pub declared: (usize, Type),
    /// How many bytes are the name of the tag of the program that it is in: for a tag in the state of a block that of the instance.
    pub root: usize,
}

impl Tag {
    /// The name of an element, by its index in the tag.
    pub fn element_name(&self, index: i64) -> String {
        match &self.column {
            Some(column) => element_name(&self.name, &column.dimensions, index),
            None => format!("{}[{index}]", self.name),
        }
    }
}

/// The name of an element of a column: each `[]` in the name of that is the place of an index.
pub fn element_name(column: &str, dimensions: &[(i64, i64)], index: i64) -> String {
    let mut indices = Vec::with_capacity(dimensions.len());
    if let &[_] = dimensions {
        indices.push(index);
    } else {
        let mut rest = index;
        for (first, last) in dimensions.iter().rev() {
            let count = last - first + 1;
            indices.push(first + rest.rem_euclid(count));
            rest = rest.div_euclid(count);
        }
        indices.reverse();
    }
    let mut parts = column.split("[]");
    let mut name = parts.next().unwrap_or_default().to_owned();
    // Two pairs of brackets in a row are one: `g[1, 2]`.
    let mut is_after_index = false;
    for (part, index) in parts.zip(indices) {
        if is_after_index {
            name.pop();
            name.push_str(&format!(", {index}]"));
        } else {
            name.push_str(&format!("[{index}]"));
        }
        name.push_str(part);
        is_after_index = part.is_empty();
    }
    name
}

/// Another name of a tag at a direct address.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct OtherName {
    /// As declared, with the file's stem before it where the name of a tag of that file has it.
    pub name: String,
    /// The tag.
    pub tag: TagId,
    /// The user-defined block whose body declares it.
    pub block: Option<usize>,
}

/// What is said of a direct address in one place, and otherwise in another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Disagreement {
    /// What is wrong and what to do.
    pub message: String,
    /// Where it is said otherwise.
    pub location: Location,
}

/// A network, ready to run.
#[derive(Debug, Clone)]
pub struct Network {
    /// From its first rung to its last.
    pub location: Location,
    /// Its elements in the order of evaluation. A step's index is the number of the power that it gives.
    pub steps: Vec<Step>,
    /// The blocks on its rungs.
    pub blocks: Vec<Block>,
    /// What can be shown as live or dead, with the step whose power it carries.
    pub elements: Vec<Element>,
}

/// One step of a network's evaluation. Each gives one power, numbered by its index; it uses only powers of
/// steps before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Step {
    /// A segment begins: at the left rail with the rail's power, elsewhere with none.
    Start {
        /// Whether it begins with the line's `+`.
        rail: bool,
    },
    /// A block is evaluated; gives its ENO.
    Block {
        /// Index into [`Network::blocks`].
        block: usize,
        /// The step whose power is EN.
        en: usize,
    },
    /// A pair of connectors; gives the OR of both wires that enter it.
    Join {
        /// The power that comes along the upper line.
        upper: usize,
        /// The power that comes along the lower line.
        lower: usize,
    },
}

/// A part of the drawing that carries power.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Element {
    /// What it is.
    pub kind: ElementKind,
    /// Where it is drawn, in the network's file.
    pub range: TextRange,
    /// Index of the step whose power it shows: for a block the power that leaves it.
    pub step: usize,
}

/// What an [`Element`] is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ElementKind {
    /// Dashes, or a comment that joins.
    Wire,
    /// `+`
    Rail,
    /// `\` or `/`
    Connector,
    /// A block.
    Block,
}

/// What a block on a rung is.
#[derive(Debug, Clone, Copy)]
pub enum BlockKind {
    /// A row of the instruction table.
    Instruction(&'static Instruction),
    /// A user-defined block: index into [`Program::blocks`].
    User(usize),
}

/// A block on a rung, with its operands.
#[derive(Debug, Clone)]
pub struct Block {
    /// What it is.
    pub kind: BlockKind,
    /// Where it is.
    pub location: Location,
    /// Its operands: those by place in their order, then named ones. For a user-defined block in the order of
    /// its parameters.
    pub arguments: Vec<Bound>,
    /// The type that it works in: the result's (`[ADD]` on INT), or the one that a comparison is made in
    /// (LINT for integers of different types, which compare by value). None where no type is chosen.
    pub works_in: Option<Scalar>,
}

/// An argument with the operand that it is given for.
#[derive(Debug, Clone)]
pub struct Bound {
    /// The row's operand; none in a user-defined block.
    pub operand: Option<&'static Operand>,
    /// For a user-defined block the index of the parameter.
    pub parameter: Option<usize>,
    /// What is given.
    pub argument: Argument,
    /// Where it is.
    pub range: TextRange,
}

impl Bound {
    /// The places that it names, with where they are written.
    pub fn places(&self) -> Vec<(&Place, TextRange)> {
        let mut found = Vec::new();
        match &self.argument {
            Argument::Value(expression) => expression.each_read(&mut |place, at| found.push((place, at))),
            Argument::Place(place, _) => found.push((place, self.range)),
            _ => {}
        }
        found
    }
}

impl Expr {
    /// Every place that it reads, with where it is written.
    fn each_read<'e>(&'e self, give: &mut impl FnMut(&'e Place, TextRange)) {
        match &self.kind {
            ExprKind::Read(place) => give(place, self.range),
            ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => inner.each_read(give),
            ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => {
                left.each_read(give);
                right.each_read(give);
            }
            ExprKind::Call(_, arguments) => arguments.iter().for_each(|argument| argument.each_read(give)),
            ExprKind::Offset(subscripts) => {
                for subscript in subscripts {
                    subscript.index.each_read(give);
                }
            }
            ExprKind::Constant(_) | ExprKind::Sum(_) => {}
        }
    }
}

impl Place {
    /// The tag that it is, or lies in; none for a system tag.
    pub fn root(&self) -> Option<TagId> {
        match self {
            Place::Tag(tag) | Place::Element(tag, _) | Place::Member(tag, _) => Some(*tag),
            Place::Chosen(chosen) | Place::ChosenMember(chosen, _) => Some(chosen.first),
            Place::Bit(inner, ..) | Place::As(inner, ..) => inner.root(),
            Place::System(_) => None,
        }
    }
}

impl Argument {
    /// The tag that it lies in, if it is a place, a range or a state.
    pub fn root(&self) -> Option<TagId> {
        match self {
            Argument::Place(place, _) => place.root(),
            Argument::Range(range) => Some(range.tag),
            Argument::State(tag) => Some(*tag),
            Argument::ChosenState(chosen) => Some(chosen.first),
            _ => None,
        }
    }
}

/// What is given for an operand.
#[derive(Debug, Clone)]
pub enum Argument {
    /// A value that is read, already in the type that the operand asks for.
    Value(Expr),
    /// A place that is written (or read and written), and its type.
    Place(Place, Scalar),
    /// A whole structure or array: each of its elementary parts as a place or a range, in the order of their declaration.
    Parts(Vec<Argument>),
    /// The state of a timer, counter or bistable.
    State(TagId),
    /// The same, where a computed index says which tag it is.
    ChosenState(Box<Chosen>),
    /// A range of an array, or (with `last` absent) the elements from an index on.
    Range(RangeRef),
    /// The network that a jump to this label from this block goes to; none for the label in `<LBL>` itself.
    Label(Option<usize>),
    /// In the body of a `<$B>`: a label that the body does not have, as names are compared. It is looked up where
    /// the block is, see [`Program::labels`].
    OuterLabel(Name),
    /// A function: index into [`Program::functions`]; in `<FUN>` its own.
    Function(usize),
    /// SEARCH's operator: one of `Eq Ne Gt Ge Lt Le`.
    Operator(Op),
}

/// Where a value is.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
    /// An elementary tag.
    Tag(TagId),
    /// One element of an array.
    Element(TagId, Box<Expr>),
    /// A member of a timer, counter or bistable.
    Member(TagId, Member),
    /// An elementary tag of several: an input or output of a block that a computed index chooses.
    Chosen(Box<Chosen>),
    /// A member of a timer, counter or bistable that a computed index chooses.
    ChosenMember(Box<Chosen>, Member),
    /// One bit of an integer or bit string, from 0.
    Bit(Box<Place>, Scalar, u8),
    /// A tag at a direct address which this place knows in another type than the tag has: the bits of the first type,
    /// read and written as the second. Both are integers or bit strings of one width.
    As(Box<Place>, Scalar, Scalar),
    /// A system tag.
    System(SystemTag),
}

/// One of several tags of one kind at equal distances: each element of an array of timers, counters or blocks is a tag.
#[derive(Debug, Clone, PartialEq)]
pub struct Chosen {
    /// The first of them.
    pub first: TagId,
    /// How many tags of the program are from one to the next.
    pub step: u32,
    /// How many they are.
    pub count: u32,
    /// Which one it is, counted from 0. It checks the indices that it is computed from.
    pub number: Expr,
}

/// A range of an array.
#[derive(Debug, Clone, PartialEq)]
pub struct RangeRef {
    /// The array.
    pub tag: TagId,
    /// Type of its elements.
    pub element: Scalar,
    /// Index of the first element meant.
    pub first: Box<Expr>,
    /// Index of the last; absent where an index alone says where the range starts.
    pub last: Option<Box<Expr>>,
}

/// A typed expression.
#[derive(Debug, Clone, PartialEq)]
pub struct Expr {
    /// The type of its value.
    pub ty: Scalar,
    /// What it is.
    pub kind: ExprKind,
    /// Where it is.
    pub range: TextRange,
}

/// The forms of an expression.
#[derive(Debug, Clone, PartialEq)]
pub enum ExprKind {
    /// A literal, in the expression's type.
    Constant(Value),
    /// A value that is read.
    Read(Place),
    /// A value that passes to the expression's type without `[TYP]`.
    Pass(Box<Expr>),
    /// `-a`, `NOT a`, in the expression's type.
    Unary(UnaryOperator, Box<Expr>),
    /// Arithmetic, logic and shifts, in the expression's type. The right side of a shift is any integer.
    Binary(BinaryOperator, Box<Expr>, Box<Expr>),
    /// A comparison: gives BOOL. Both sides have one type, or are integers of two types.
    Compare(Op, Box<Expr>, Box<Expr>),
    /// A function by name, in the expression's type.
    Call(Op, Vec<Expr>),
    /// `SUM(a[1..9])`
    Sum(RangeRef),
    /// Where an element of an array of several dimensions is, counted from 0 row by row.
    Offset(Vec<Subscript>),
}

/// One index of several.
#[derive(Debug, Clone, PartialEq)]
pub struct Subscript {
    /// Any integer.
    pub index: Expr,
    /// The first index of the dimension.
    pub first: i64,
    /// The last one.
    pub last: i64,
    /// How many elements are from one index to the next.
    pub stride: i64,
}

/// Unary operators of expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum UnaryOperator {
    /// `-`
    Minus,
    /// `NOT`: logical on BOOL, bitwise else.
    Not,
}

/// Binary operators of expressions that give the type they work in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BinaryOperator {
    /// `OR`
    Or,
    /// `XOR`
    Xor,
    /// `AND`
    And,
    /// `SHL`
    Shl,
    /// `SHR`
    Shr,
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
    /// `MOD`
    Mod,
    /// `^`
    Power,
}

impl BinaryOperator {
    /// The instruction that does the same.
    pub const fn op(self) -> Op {
        match self {
            BinaryOperator::Or => Op::Or,
            BinaryOperator::Xor => Op::Xor,
            BinaryOperator::And => Op::And,
            BinaryOperator::Shl => Op::Shl,
            BinaryOperator::Shr => Op::Shr,
            BinaryOperator::Add => Op::Add,
            BinaryOperator::Sub => Op::Sub,
            BinaryOperator::Mul => Op::Mul,
            BinaryOperator::Div => Op::Div,
            BinaryOperator::Mod => Op::Mod,
            BinaryOperator::Power => Op::Exp,
        }
    }
}

/// A member of a timer, counter or bistable (LANGUAGE §4, Members).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Member {
    In,
    Pt,
    Q,
    Et,
    Cu,
    Cd,
    R,
    Ld,
    Pv,
    Cv,
    Qu,
    Qd,
    Q1,
    /// The counter changed in this evaluation.
    Changed,
    /// The timer is timing: `EN AND NOT DN`.
    Timing,
}

impl Member {
    /// As programs write it.
    pub const fn name(self) -> &'static str {
        match self {
            Member::In => "IN",
            Member::Pt => "PT",
            Member::Q => "Q",
            Member::Et => "ET",
            Member::Cu => "CU",
            Member::Cd => "CD",
            Member::R => "R",
            Member::Ld => "LD",
            Member::Pv => "PV",
            Member::Cv => "CV",
            Member::Qu => "QU",
            Member::Qd => "QD",
            Member::Q1 => "Q1",
            Member::Changed => "CC",
            Member::Timing => "TT",
        }
    }

    /// The member's type where blocks have these differences: what a timer counts is TIME, or scans and steps.
    pub const fn ty(self, semantics: &Semantics) -> Scalar {
        match (self, semantics.timing) {
            (Member::Pt | Member::Et, Timing::Clock) => Scalar::Time,
            (Member::Pt | Member::Et, Timing::Units) => Scalar::Int,
            (Member::Pt | Member::Et | Member::Pv | Member::Cv, _) => Scalar::integer_of(semantics),
            _ => Scalar::Bool,
        }
    }
}
