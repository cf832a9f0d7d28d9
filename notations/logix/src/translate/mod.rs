//! Instructions as elements of a rung.

mod aoi;
mod bits;
mod data;
mod files;
mod flow;
mod loops;
mod states;

use crate::blocks::Blocks;
use crate::mnemonic::{Op, Role, instruction, is_known};
use crate::model::{Family, Project};
use crate::operand::{Expr, Path, Step};
use crate::scope::{Place, Tags};
use crate::types::Elem;
use crate::unit::operand;
use crate::values::{Value, literal};
use crate::words;
pub(crate) use flow::Routines;
use ladder_drawings::neutral::Instruction;
use ladder_format::Circuit;
use ladder_format::program::{self, Block, Element, Expression, Operand, Sign};
use ladder_instructions::Op as Own;
use ladder_notation::UnreadParts;
pub(crate) use states::tagged;
use std::collections::{HashMap, HashSet};

/// What an instruction became: the elements, and what there is to say about them.
pub(crate) struct Translated {
    pub(crate) circuit: Circuit<Element>,
    /// Why it is not quite the same.
    pub(crate) note: Option<String>,
}

/// Translates instructions, one after the other.
pub(crate) struct Translator<'p> {
    pub(crate) project: &'p Project,
    pub(crate) tags: Tags,
    pub(crate) blocks: Blocks,
    /// What is not read.
    pub(crate) unread: UnreadParts,
    pub(crate) routines: Routines,
    /// The names of the blocks that Add-On Instructions become.
    pub(crate) aoi_names: Vec<String>,
    /// The labels of the unit that is being translated.
    pub(crate) labels: HashMap<String, String>,
    /// The name of that routine.
    pub(crate) routine: String,
    /// Networks that go on with the rung that is being translated, after it.
    pub(crate) after: Vec<Circuit<Element>>,
    /// What is computed on the rung before the instruction that is being translated.
    before: Vec<Circuit<Element>>,
    scope: usize,
    origin: Option<u32>,
    note: Option<String>,
    /// What is reported at the first instruction of its sort alone.
    told: HashSet<&'static str>,
}

type Result<T> = std::result::Result<T, String>;

impl<'p> Translator<'p> {
    pub(crate) fn new(project: &'p Project, tags: Tags, routines: Routines) -> Translator<'p> {
        Translator {
            project,
            tags,
            blocks: Blocks::default(),
            unread: UnreadParts::default(),
            routines,
            aoi_names: aoi::names(project),
            labels: HashMap::new(),
            routine: String::new(),
            after: Vec::new(),
            before: Vec::new(),
            scope: 0,
            origin: None,
            note: None,
            told: HashSet::new(),
        }
    }

    /// What an instruction becomes.
    ///
    /// # Errors
    ///
    /// If it has no counterpart here: why.
    pub(crate) fn translate(
        &mut self,
        scope: usize,
        it: &Instruction<'_>,
        origin: Option<u32>,
    ) -> Result<Translated> {
        self.scope = scope;
        self.origin = origin;
        self.note = None;
        self.before.clear();
        let after = self.after.len();
        let mut circuit = self.instruction(it)?;
        if !self.before.is_empty() {
            if self.after.len() > after {
                self.after.truncate(after);
                return Err("the length of a text in a loop has no counterpart here".to_owned());
            }
            let before = std::mem::take(&mut self.before).into_iter();
            circuit = Circuit::Series(before.chain([circuit]).collect());
        }
        Ok(Translated {
            circuit,
            note: self.note.take(),
        })
    }

    /// The scope of the instruction that was translated last.
    pub(crate) const fn scope(&self) -> usize {
        self.scope
    }

    /// Whether it is an instruction that has a counterpart, with another number of operands.
    pub(crate) fn is_broken(it: &Instruction<'_>) -> bool {
        is_known(it.name) && instruction(it.name, it.operands.len()).is_none()
    }

    fn instruction(&mut self, it: &Instruction<'_>) -> Result<Circuit<Element>> {
        let operands = &it.operands[..];
        if let Some(aoi) = self.aoi(it.name) {
            return self.aoi_call(aoi, operands);
        }
        let Some(op) = instruction(it.name, operands.len()) else {
            return Err(match self.protected(it.name) {
                Some(_) => "its source is protected".to_owned(),
                None if is_known(it.name) => {
                    format!("{} does not have {} operands", it.name, operands.len())
                }
                None => "it has no counterpart here".to_owned(),
            });
        };
        match op {
            Op::Contact(own) => self.contact(own, operands[0]),
            Op::Coil(own) => self.coil(own, operands[0]),
            Op::Ons => self.one_shot(operands[0]),
            Op::Osr if operands.len() == 1 => self.one_shot(operands[0]),
            Op::Osr => self.one_shot_rising(operands[0], operands[1]),
            Op::Osf => self.state_block("OSF", operands),
            Op::Timer(name) => self.timer(name, operands),
            Op::Counter(name) => self.state_block(name, &operands[..1]),
            Op::Tagged(name) => self.tagged(name, operands[0]),
            Op::Scl if operands.len() == 1 => self.tagged("SCL", operands[0]),
            Op::Res => self.reset(operands[0]),
            Op::Compare(own) => self.compare(own, operands),
            Op::Lim => self.limits(operands),
            Op::Meq => self.masked_equal(operands),
            Op::Cmp => self.compare_formula(operands[0]),
            Op::Binary(operator) => self.binary(operator, operands),
            Op::Unary(sign) => {
                let inner = Box::new(self.expr(operands[0])?);
                self.compute(operands[1], &Expr::Unary(sign, inner))
            }
            Op::Function(name) => {
                let inner = self.expr(operands[0])?;
                self.compute(operands[1], &Expr::Call(name.to_owned(), vec![inner]))
            }
            Op::Atan2 => self.angle(operands),
            Op::ToText => self.spelled(operands, false),
            Op::FromText => self.spelled(operands, true),
            Op::Trunc => self.truncate(operands),
            Op::Cpt => {
                let formula = self.expr(operands[1])?;
                self.compute(operands[0], &formula)
            }
            Op::Mov => self.move_value(operands[0], operands[1]),
            Op::Mvm => self.masked_move(operands),
            Op::Btd => self.distribute(operands),
            Op::Clr => self.clear(operands[0]),
            Op::Cop => self.copy(operands),
            Op::Fll => self.fill(operands),
            Op::Shift(name) => self.on_file(name, operands[0], &operands[1..3], "IB"),
            Op::Load(name) => self.load(name, operands),
            Op::Unload(name) => self.on_file(name, operands[0], &operands[1..3], "PI"),
            Op::Sqi => self.on_file("SQI", operands[0], &operands[1..4], "VVI"),
            Op::Sqo => self.on_file("SQO", operands[0], &operands[1..4], "VPI"),
            Op::Sql => self.on_file("SQL", operands[0], &operands[1..3], "VI"),
            Op::Fal => self.file_arithmetic(operands),
            Op::Fsc => self.file_search(operands),
            Op::Statistic(name) => self.on_file(name, operands[0], &operands[2..4], "PI"),
            Op::Srt => self.on_file("SRT", operands[0], &operands[2..3], "I"),
            Op::Size => self.size(operands),
            Op::Swpb => self.swap(operands),
            Op::ToBcd => self.digits(operands, words::to_bcd),
            Op::FromBcd => self.digits(operands, words::from_bcd),
            Op::For => self.repeat(operands),
            Op::Brk => self.leave_loop(),
            Op::Label(own) => self.label(own, operands[0]),
            Op::Jsr => self.call(operands),
            Op::Sbr => Ok(Circuit::Series(Vec::new())),
            Op::Ret => self.ret(operands),
            Op::Mcr => self.op(Own::Mcr, Operand::NONE),
            Op::Afi => Ok(self.block(Block::contact(program::Path::system("OFF")))),
            Op::Nop => Ok(Circuit::Element(Element::comment("NOP", self.origin))),
            Op::Tnd => Ok(self.block(Block::ret())),
            Op::Scl => self.scale(operands),
            Op::Scp => self.scale_with_parameters(operands),
            Op::Pid => self.pid(operands),
            Op::Strings(own) => self.strings(own, operands),
        }
    }

    fn block(&self, block: Block) -> Circuit<Element> {
        Circuit::Element(Element::of(block, self.origin))
    }

    fn op<O: Into<Operand>>(
        &self,
        op: Own,
        operands: impl IntoIterator<Item = O>,
    ) -> Result<Circuit<Element>> {
        Ok(self.block(Block::of(op, operands)?))
    }

    /// An instruction that makes one value of another: `[MOV]( to, value )`
    fn put(&self, op: Own, to: &program::Path, value: impl Into<Expression>) -> Result<Circuit<Element>> {
        self.op(op, [to.into(), value.into()])
    }

    /// A block that the program brings along, by its name.
    fn user<O: Into<Operand>>(
        &self,
        name: &str,
        operands: impl IntoIterator<Item = O>,
    ) -> Result<Circuit<Element>> {
        Ok(self.block(Block::user(name, operands)?))
    }

    /// Notes why what comes of an instruction is not quite the same.
    fn note(&mut self, why: &str) {
        self.note.get_or_insert_with(|| why.to_owned());
    }

    /// The same of the first instruction of its sort, for it holds of all.
    fn note_first(&mut self, why: &'static str) {
        if self.told.insert(why) {
            self.note(why);
        }
    }

    /// An operand that is read: of a text its length is computed before.
    fn expr(&mut self, text: &str) -> Result<Expr> {
        let mut expr = operand(self.project.family, text)?;
        if text.contains(".LEN") {
            self.measure(&mut expr)?;
        }
        Ok(expr)
    }

    /// The first operands, as those that are read.
    fn exprs<const N: usize>(&mut self, texts: &[&str]) -> Result<[Expr; N]> {
        let all = texts.iter().take(N).map(|text| self.expr(text));
        let all: Vec<Expr> = all.collect::<Result<_>>()?;
        all.try_into().map_err(|_| "operands are missing".to_owned())
    }

    /// Of values of which some are reals, those that have more digits than a real become reals before: "the controller
    /// converts the integer value to a REAL value before the instruction executes", rounded to 24 bits (1756-RM006K, p. 543).
    fn as_reals(&mut self, values: &mut [Expr]) -> Result<()> {
        let mut elems = Vec::new();
        for value in values.iter() {
            elems.push(match value {
                Expr::Path(path) => self.tags.place(self.scope, path, Role::Value)?.elem(),
                Expr::Real(_) => Some(Elem::Real),
                _ => None,
            });
        }
        let is = |elem: Elem| elems.contains(&Some(elem));
        let real = match (is(Elem::Lreal), is(Elem::Real)) {
            (true, _) => Elem::Lreal,
            (false, true) => Elem::Real,
            (false, false) => return Ok(()),
        };
        for (value, elem) in values.iter_mut().zip(elems) {
            let is_exact = |elem: Elem| elem.is_real() || elem.widens_to(real);
            if elem.is_some_and(|elem| elem.is_integer() && !is_exact(elem)) {
                let helper = self.helper("real", real, "an integer that is compared with a real");
                let (own, _) = self.value(value, real)?;
                let block = self.put(Own::Typ, &helper, own)?;
                self.before.push(block);
                *value = Expr::Path(Path::tag(helper.root));
            }
            if let (Elem::Real, Expr::Int(int)) = (real, &*value) {
                *value = Expr::Real(f64::from(*int as f32));
            }
        }
        Ok(())
    }

    /// Puts tags in the place of the lengths of texts.
    fn measure(&mut self, expr: &mut Expr) -> Result<()> {
        match expr {
            Expr::Path(path) => {
                let mut text = path.clone();
                if text.steps.pop() == Some(Step::Member("LEN".to_owned()))
                    && let Ok(place) = self.tags.place(self.scope, &text, Role::Text)
                    && matches!(place.elem(), Some(Elem::String(_)))
                {
                    let helper = self.helper("length", Elem::Dint, "the length of a text");
                    let block = self.put(Own::Len, &helper, place.path)?;
                    self.before.push(block);
                    *path = Path::tag(helper.root);
                }
                Ok(())
            }
            Expr::Unary(_, inner) => self.measure(inner),
            Expr::Call(_, all) => all.iter_mut().try_for_each(|inner| self.measure(inner)),
            Expr::Binary(_, left, right) => {
                self.measure(left)?;
                self.measure(right)
            }
            Expr::Int(_) | Expr::Real(_) | Expr::Text(_) | Expr::Unset => Ok(()),
        }
    }

    fn place(&mut self, text: &str, role: Role) -> Result<Place> {
        match operand(self.project.family, text)? {
            Expr::Path(path) => self.tags.place(self.scope, &path, role),
            _ => Err(format!("`{text}` is no tag")),
        }
    }

    /// A place that is written: the outputs of an instance are not, from outside.
    fn target(&mut self, text: &str, role: Role) -> Result<Place> {
        let place = self.place(text, role)?;
        if place.is_output {
            return Err(format!(
                "`{}` cannot be written from outside of its instruction",
                place.path
            ));
        }
        if place.is_system() {
            return Err(format!("`{text}` belongs to the controller"));
        }
        Ok(place)
    }

    /// A tag that an instruction needs for a value on its way.
    fn helper(&mut self, like: &str, elem: Elem, what: &str) -> program::Path {
        self.tags
            .helper(self.scope, like, elem, &format!("helper: {what}"))
    }

    /// A contact on what a formula computes, by way of a tag.
    fn computed(
        &mut self,
        contact: Own,
        formula: Expression,
        like: &str,
        what: &str,
    ) -> Result<Circuit<Element>> {
        let helper = self.helper(like, Elem::Bool, what);
        let blocks = vec![
            self.put(Own::Calc, &helper, formula)?,
            self.op(contact, [helper])?,
        ];
        Ok(Circuit::Series(blocks))
    }

    /// A value as an operand where a type is asked for, and its own type if it is a tag.
    fn value(&mut self, expr: &Expr, wanted: Elem) -> Result<(Expression, Option<Elem>)> {
        let constant = match expr {
            Expr::Int(int) => Some(Value::Int(*int)),
            Expr::Real(real) => Some(Value::Real(*real)),
            Expr::Text(text) => Some(Value::Text(text.clone())),
            Expr::Unary(Sign::Minus, inner) => match **inner {
                Expr::Int(int) => Some(Value::Int(int.wrapping_neg())),
                Expr::Real(real) => Some(Value::Real(-real)),
                _ => None,
            },
            Expr::Path(path) => {
                let place = self.tags.place(self.scope, path, Role::Value)?;
                let elem = place.elem();
                return Ok((place.path.into(), elem));
            }
            _ => None,
        };
        let value = match constant {
            Some(constant) => Expression::literal(literal(&constant, wanted))?,
            None => self.tags.formula(self.scope, expr)?,
        };
        Ok((value, None))
    }

    /// Whether programs of the family count in other units, and so on.
    fn is_slc(&self) -> bool {
        self.project.family == Family::Slc
    }
}
