//! CASE.

use super::super::scope::Type;
use super::super::tree::{Arm, Expression as Tree, ExpressionKind, Statement};
use super::condition::Power;
use super::place::is_computed;
use super::value::Value;
use super::{Lowered, Lowering};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Block, Declaration, Expression, Operator, Path};
use ladder_instructions::Op;

/// A list of labels is drawn with no more branches.
const MOST_LABELS: usize = 4;

impl Lowering<'_, '_> {
    pub(super) fn case(&mut self, selector: &Tree, arms: &[Arm], otherwise: &[Statement]) -> Lowered<()> {
        let value = self.value(selector)?;
        let value = if matches!(value.ty, Type::Enumeration(_)) {
            value
        } else {
            self.atom(value)?
        };
        // Only one arm runs, after all comparisons: what it does to the selector changes nothing.
        let is_kept = value.bare().path().is_none_or(|path| !is_computed(path));
        // All labels are read before the first network: a label that is not constant leaves the whole unread.
        let value = if is_kept {
            self.hold(value)
        } else {
            self.kept(value)?
        };
        let mut conditions = Vec::new();
        for arm in arms {
            conditions.push(self.labels(&value, arm)?);
        }
        self.header("CASE", &selector.span, "OF");
        if !self.chain.is_empty() {
            self.flush();
        }
        let end = self.new_label("endcase");
        let mut jumps = false;
        for (number, (arm, power)) in arms.iter().zip(conditions).enumerate() {
            self.take_comments(arm.span.start);
            let shown = self.shown(&arm.span);
            self.comments.extend(shown);
            let is_last = number + 1 == arms.len() && otherwise.is_empty();
            jumps |= self.branch(power, &arm.body, is_last, "arm", &end);
        }
        self.otherwise(otherwise);
        if jumps {
            self.label(&end);
        }
        Ok(())
    }

    /// A value that nothing changes while an arm runs: a tag of the reader's own is held until the end.
    fn hold(&mut self, value: Value) -> Value {
        if let Some(path) = value.bare().path() {
            self.used.retain(|(_, name)| *name != path.root);
        }
        value
    }

    /// The value in a tag of its own, which is held.
    pub(super) fn kept(&mut self, value: Value) -> Lowered<Value> {
        let ty = value.ty.text().ok_or("a value of such a type is not kept here")?;
        let name = match value.scalar() {
            Some(scalar) => self.held(if value.is_free { Scalar::Lint } else { scalar }),
            None => {
                self.temporaries += 1;
                let name = self.names.fresh(&format!("st{}", self.temporaries));
                self.body.tags.push(Declaration::new(name.clone(), ty));
                name
            }
        };
        let path = Path::tag(name);
        let mnemonic = if value.is_atom() { "MOV" } else { "CALC" };
        self.instruction(mnemonic, vec![(&path).into(), value.bare().clone().into()])?;
        Ok(Value {
            expression: path.into(),
            is_free: false,
            ..value
        })
    }

    /// Whether a value is one of the labels of an arm.
    fn labels(&mut self, value: &Value, arm: &Arm) -> Lowered<Power> {
        let mut any = Vec::new();
        for (first, last) in &arm.labels {
            let first = self.label_value(value, first)?;
            let pair = match last {
                None => {
                    let operands = [value.bare().clone(), first];
                    (Block::of(Op::Eq, operands.clone())?, Block::of(Op::Ne, operands)?)
                }
                Some(last) => {
                    let last = self.label_value(value, last)?;
                    let within = Block::of(Op::Le, [first, value.bare().clone(), last])?;
                    // It has no opposite of its own; a jump takes `[NOT]`.
                    any.push(Power::All(vec![Power::Contact(Box::new((
                        within.clone(),
                        within,
                    )))]));
                    continue;
                }
            };
            any.push(Power::Contact(Box::new(pair)));
        }
        if any.len() > MOST_LABELS
            && any.iter().all(|one| matches!(one, Power::Contact(_)))
            && value.is_integer()
        {
            return self.long_list(value, arm);
        }
        match any.pop() {
            Some(one) if any.is_empty() => Ok(one),
            Some(one) => {
                any.push(one);
                // Comparisons in parallel are clearer than their opposites in series.
                Ok(Power::All(vec![Power::Any(any)]))
            }
            None => Err("an arm without labels".to_owned()),
        }
    }

    /// Many labels as one formula.
    fn long_list(&mut self, value: &Value, arm: &Arm) -> Lowered<Power> {
        let mut formula: Option<Expression> = None;
        for (first, _) in &arm.labels {
            let one = self.label_value(value, first)?;
            let one = value.bare().clone().with(Operator::Equal, one);
            formula = Some(match formula {
                Some(before) => before.with(Operator::Or, one),
                None => one,
            });
        }
        let path = Path::tag(self.held(Scalar::Bool));
        let formula = formula.ok_or("an arm without labels")?;
        self.instruction("CALC", vec![(&path).into(), formula.into()])?;
        Ok(Power::Contact(Box::new((
            Block::contact(&path),
            Block::negated_contact(&path),
        ))))
    }

    fn label_value(&mut self, value: &Value, label: &Tree) -> Lowered<Expression> {
        if let (Type::Enumeration(all), ExpressionKind::Place(place)) = (&value.ty, &label.kind)
            && place.steps.is_empty()
            && let Some(own) = all
                .values
                .iter()
                .find(|own| own.eq_ignore_ascii_case(&place.root))
        {
            return Ok(Path::tag(all.name.clone()).member(own.clone()).into());
        }
        let one = self.value(label)?;
        let is_constant = match &label.kind {
            ExpressionKind::Place(place) if !matches!(one.ty, Type::Enumeration(_)) => self
                .around
                .scope
                .known(&place.root)
                .is_none_or(|known| known.is_constant),
            _ => one.is_atom(),
        };
        if !is_constant {
            return Err("a label of a CASE is not constant".to_owned());
        }
        Ok(one.bare().clone())
    }
}
