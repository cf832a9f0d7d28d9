//! FOR, WHILE and REPEAT.

use super::super::scope::Type;
use super::super::tree::{Expression as Tree, For, Statement};
use super::super::uses::Uses;
use super::condition::Power;
use super::value::Value;
use super::{Lowered, Lowering};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Block, Expression, Literal, Operand, Operator, Path};
use ladder_instructions::Op;

/// The labels of a loop, and whether anything jumps to them.
#[derive(Debug)]
pub(super) struct Loop {
    pub(super) next: String,
    pub(super) end: String,
    pub(super) uses_next: bool,
    pub(super) uses_end: bool,
    /// It is a `<FOR>`, not jumps.
    is_counted: bool,
}

/// `<FOR>` nests no deeper (LANGUAGE §5.5).
const DEEPEST_FOR: usize = 8;

/// What a counting loop counts with.
struct Counting {
    path: Path,
    ty: Scalar,
    from: Value,
    to: Value,
    by: Value,
}

impl Lowering<'_, '_> {
    fn new_loop(&mut self, end: &'static str, is_counted: bool) {
        let next = self.new_label("next");
        let end = self.new_label(end);
        self.loops.push(Loop {
            next,
            end,
            uses_next: false,
            uses_end: false,
            is_counted,
        });
    }

    /// The statements of a loop.
    fn turn(&mut self, body: &[Statement]) {
        self.inner(body);
        if let Some(own) = self.loops.last().filter(|own| own.uses_next) {
            let label = own.next.clone();
            self.label(&label);
        }
    }

    fn end_loop(&mut self) {
        if let Some(own) = self.loops.pop().filter(|own| own.uses_end) {
            self.label(&own.end);
        }
    }

    pub(super) fn counting(&mut self, statement: &Statement, counting: &For) -> Lowered<()> {
        let (path, ty) = self.target(&counting.variable)?;
        let scalar = ty.scalar().filter(|ty| ty.is_integer());
        let ty = scalar.ok_or_else(|| format!("`{path}` does not count: it is not a whole number"))?;
        let by = match &counting.by {
            Some(by) => self.value(by)?,
            None => Value::number(1, Literal::from(1)),
        };
        let from = self.value(&counting.from)?;
        let to = self.value(&counting.to)?;
        let counts = Counting {
            path,
            ty,
            from,
            to,
            by,
        };
        let head = statement.span.start..counting.by.as_ref().unwrap_or(&counting.to).span.end;
        if let Some(shown) = self.shown(&head) {
            self.comments.push(format!("{shown} DO"));
        }
        self.comments_after(head.end, "DO");
        let within = Uses::of(&counting.body, self.around.scope);
        let is_steady = counts.path.whole().is_some() && !within.is_assigned(&counting.variable.root);
        match self.turns(&counts).filter(|_| is_steady) {
            Some((turns, from, by)) => self.counted(&counts, turns, from, by, counting),
            None => self.with_jumps(counts, counting),
        }
    }

    /// How many turns a loop has, if that is known: with its start and its step.
    fn turns(&self, counts: &Counting) -> Option<(i64, i64, i64)> {
        let constant = |value: &Value| {
            let (first, last) = value.range;
            (first == last && value.is_free && !value.is_real()).then_some(first)
        };
        let (from, to, by) = (
            constant(&counts.from)?,
            constant(&counts.to)?,
            constant(&counts.by)?,
        );
        let depth = self.loops.iter().filter(|own| own.is_counted).count();
        if by == 0 || depth >= DEEPEST_FOR {
            return None;
        }
        let turns = (to - from) / by + 1;
        let is_within = |number: i128| super::value::is_within((number, number), counts.ty);
        let is_plain = (to - from) * by.signum() >= 0 && turns < 1_000_000_000;
        let is_held = is_within(from) && is_within(from + turns * by) && is_within(turns);
        (is_plain && is_held).then_some((turns as i64, from as i64, by as i64))
    }

    /// `<FOR>` .. `<NEXT>`: the number of turns is known.
    fn counted(&mut self, counts: &Counting, turns: i64, from: i64, by: i64, counting: &For) -> Lowered<()> {
        let path = &counts.path;
        let is_plain = (from, by) == (1, 1);
        let number = if is_plain {
            path.clone()
        } else {
            Path::tag(self.held(counts.ty))
        };
        let turn = Operand::Taken("I".to_owned(), (&number).into());
        let first = Block::of(Op::For, [Operand::from(Expression::from(turns)), turn])?;
        let first = self.element(first);
        self.network(vec![first]);
        self.new_loop("endfor", true);
        if !is_plain {
            // from + (turn - 1) * by, with what is constant in one number.
            let turn = Expression::from(&number);
            let counted = match by.abs() {
                1 => turn,
                by => turn.with(Operator::Times, Expression::from(by)),
            };
            let rest = from - by;
            let value = match (by > 0, rest) {
                (false, rest) => Expression::from(rest).with(Operator::Minus, counted),
                (true, 0) => counted,
                (true, 1..) => counted.with(Operator::Plus, Expression::from(rest)),
                (true, _) => counted.with(Operator::Minus, Expression::from(-rest)),
            };
            self.instruction("CALC", vec![path.into(), value.into()])?;
            self.flush();
        }
        self.turn(&counting.body);
        let next = self.element(Block::of(Op::Next, Operand::NONE)?);
        self.network(vec![next]);
        if self.around.dialect.steps_past_the_end() && self.uses.outlives_loops(&counting.variable.root) {
            self.advance(path, by)?;
            self.flush();
        }
        self.end_loop();
        Ok(())
    }

    fn advance(&mut self, path: &Path, by: i64) -> Lowered<()> {
        let sum = match by {
            by if by < 0 => Expression::from(path).with(Operator::Minus, Expression::from(-by)),
            by => Expression::from(path).with(Operator::Plus, Expression::from(by)),
        };
        self.instruction("CALC", vec![path.into(), sum.into()])
    }

    /// A value that the loop does not change.
    fn steady(&mut self, value: Value, ty: Scalar) -> Lowered<Value> {
        if value.is_free && value.is_atom() {
            return Ok(value);
        }
        let value = self.fit(value, ty)?;
        self.kept(value)
    }

    /// The number of turns is not known: the loop is made of jumps.
    fn with_jumps(&mut self, counts: Counting, counting: &For) -> Lowered<()> {
        let Counting {
            path,
            ty,
            from,
            to,
            by,
        } = counts;
        self.assign(&path, &Type::Scalar(ty), from)?;
        let to = self.steady(to, ty)?;
        let by = self.steady(by, ty)?;
        self.flush();
        self.new_loop("endfor", false);
        let again = self.new_label("loop");
        self.label(&again);
        let end = self.loops.last_mut().map(|own| {
            own.uses_end = true;
            own.end.clone()
        });
        let end = end.unwrap_or_default();
        let past = |op| Block::of(op, [Expression::from(&path), to.expression.clone()]);
        let (low, high) = by.range;
        let is_constant = by.is_free;
        if is_constant {
            let op = if low < 0 { Op::Lt } else { Op::Gt };
            let parts = vec![self.element(past(op)?), self.jump(&end)];
            self.network(parts);
        } else {
            // Its sign decides which way the loop goes.
            let zero = Expression::from(0);
            for (sign, op) in [(Op::Ge, Op::Gt), (Op::Lt, Op::Lt)] {
                let sign = Block::of(sign, [by.expression.clone(), zero.clone()])?;
                let parts = vec![self.element(sign), self.element(past(op)?), self.jump(&end)];
                self.network(parts);
            }
        }
        self.turn(&counting.body);
        if is_constant {
            self.advance(&path, high as i64)?;
        } else {
            let sum = Expression::from(&path).with(Operator::Plus, by.expression);
            self.instruction("CALC", vec![(&path).into(), sum.into()])?;
        }
        self.flush();
        let back = self.jump(&again);
        self.network(vec![back]);
        self.end_loop();
        Ok(())
    }

    pub(super) fn while_loop(&mut self, condition: &Tree, body: &[Statement]) -> Lowered<()> {
        let again = self.new_label("loop");
        self.label(&again);
        let power = self.condition(condition)?;
        self.header("WHILE", &condition.span, "DO");
        self.new_loop("endwhile", false);
        if !matches!(power, Power::Always(true)) {
            let end = self.loops.last_mut().map(|own| {
                own.uses_end = true;
                own.end.clone()
            });
            let mut parts = self.opposite(power);
            parts.push(self.jump(&end.unwrap_or_default()));
            self.network(parts);
        }
        self.turn(body);
        let back = self.jump(&again);
        self.network(vec![back]);
        self.end_loop();
        Ok(())
    }

    pub(super) fn repeat(&mut self, body: &[Statement], condition: &Tree) -> Lowered<()> {
        let state = self.state();
        // The condition is read before anything of the loop is made.
        self.condition(condition)?;
        self.restore(state);
        let again = self.new_label("loop");
        self.label(&again);
        self.comments.push("REPEAT".to_owned());
        self.new_loop("endrepeat", false);
        self.turn(body);
        let power = self.condition(condition)?;
        if let Some(shown) = self.shown(&condition.span) {
            self.comments.push(format!("UNTIL {shown}"));
        }
        // A fault in the condition ends the loop: there is no power then.
        let parts = vec![self.circuit(&power.negated()), self.jump(&again)];
        self.network(parts);
        self.end_loop();
        Ok(())
    }
}
