//! Calls with `EN` and `ENO`: what is called runs only if `EN` holds, and `ENO` says whether it did.
//!
//! As the compilers do that the generators of such calls write for: a function that does not run returns what its type begins with,
//! and its other outputs stay; a block that does not run takes its inputs all the same.

use super::super::dialect::Dialect;
use super::super::scope::{ParameterRole, Shape, Type};
use super::super::tree::{Call, Direction, Expression as Tree, ExpressionKind, Place};
use super::condition::Power;
use super::restarted::zero;
use super::value::{Value, wide};
use super::{Lowered, Lowering};
use ladder_analysis::values::types::Scalar;
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Head, Literal, Operand, Path};
use ladder_instructions::Op;
use std::rc::Rc;

/// A call, apart from its `EN` and `ENO`.
pub(super) struct Enabled {
    pub(super) call: Call,
    condition: Option<Tree>,
    done: Option<Place>,
}

impl Lowering<'_, '_> {
    /// What a call is apart from its `EN` and `ENO`. None: it has neither.
    pub(super) fn enabled(&self, call: &Call) -> Lowered<Option<Enabled>> {
        let is = |name: Option<&String>, own: &str| name.is_some_and(|name| name.eq_ignore_ascii_case(own));
        let has = call
            .arguments
            .iter()
            .any(|one| is(one.name.as_ref(), "EN") || is(one.name.as_ref(), "ENO"));
        if !has || self.declares_en(call) {
            return Ok(None);
        }
        if self.around.dialect != Dialect::Iec {
            return Err("a call with EN or ENO is not read: use IF".to_owned());
        }
        let mut enabled = Enabled {
            call: call.clone(),
            condition: None,
            done: None,
        };
        let mut arguments = std::mem::take(&mut enabled.call.arguments);
        for one in std::mem::take(&mut arguments) {
            match (is(one.name.as_ref(), "EN"), is(one.name.as_ref(), "ENO")) {
                (true, _) if one.direction == Direction::In => enabled.condition = one.value,
                (_, true) => {
                    enabled.done = match one.value.map(|value| value.kind) {
                        None => None,
                        Some(ExpressionKind::Place(place)) if one.direction == Direction::Out => Some(place),
                        Some(_) => return Err("ENO goes into a tag, and not negated".to_owned()),
                    };
                }
                _ => arguments.push(one),
            }
        }
        enabled.call.arguments = arguments;
        Ok(Some(enabled))
    }

    /// Whether what is called declares an input of this name for itself.
    fn declares_en(&self, call: &Call) -> bool {
        let scope = self.around.scope;
        let shape = match scope.known(&call.callee.root).map(|known| &known.ty) {
            Some(Type::Block(shape)) => Some(shape),
            _ => scope.function_named(&call.callee.root),
        };
        let is_en = |name: &str| name.eq_ignore_ascii_case("EN") || name.eq_ignore_ascii_case("ENO");
        shape.is_some_and(|shape| shape.parameters.iter().any(|one| is_en(&one.name)))
    }

    /// The value of a function with `EN`. It goes into a place that the call does not name, or into a tag of the reader's own.
    pub(super) fn enabled_function(
        &mut self,
        enabled: &Enabled,
        to: Option<(&Path, Scalar)>,
    ) -> Lowered<Value> {
        let power = self.power_of(enabled)?;
        let value = self.function(&enabled.call)?;
        let ty = match value.scalar() {
            Some(ty) if value.is_free && ty.is_integer() => wide(value.range),
            ty => ty.ok_or("a function that returns more than one value is not read")?,
        };
        let to = match to {
            Some((path, own)) if own == ty => path.clone(),
            _ => self.temporary(ty),
        };
        self.assign(&to, &Type::Scalar(ty), value)?;
        let begin = match power {
            Power::Always(true) => Vec::new(),
            _ => vec![Block::of(Op::Mov, [Operand::from(&to), zero(ty).into()])?],
        };
        self.under_power(enabled, power, begin)?;
        Ok(Value::path(to, ty))
    }

    /// A function with `EN` whose result nobody takes.
    pub(super) fn enabled_alone(&mut self, enabled: &Enabled, shape: &Rc<Shape>) -> Lowered<()> {
        let power = self.power_of(enabled)?;
        let operands = self.operands(&shape.parameters, &enabled.call)?;
        self.act(Block::user(shape.name.clone(), operands)?);
        self.under_power(enabled, power, Vec::new())
    }

    /// A block with `EN`: its inputs are members that are written, its outputs are taken after it.
    pub(super) fn enabled_block(&mut self, enabled: &Enabled, shape: &Rc<Shape>, path: &Path) -> Lowered<()> {
        let mut own = enabled.call.clone();
        let (mut inputs, mut outputs) = (Vec::new(), Vec::new());
        let mut places = shape.parameters.iter();
        let mut in_outs = Vec::new();
        for one in std::mem::take(&mut own.arguments) {
            let parameter = match &one.name {
                Some(name) => shape
                    .parameters
                    .iter()
                    .find(|own| own.name.eq_ignore_ascii_case(name)),
                None => places.next(),
            };
            let parameter = parameter.ok_or_else(|| format!("`{path}` does not have such an operand"))?;
            let Some(value) = &one.value else { continue };
            let member = path.clone().member(parameter.spelled.clone());
            match parameter.role {
                ParameterRole::Input => inputs.push((member, parameter.ty.clone(), value.clone())),
                ParameterRole::Output => {
                    let ExpressionKind::Place(place) = &value.kind else {
                        return Err("an output goes into a tag".to_owned());
                    };
                    outputs.push((member, parameter.ty.clone(), place.clone(), one.direction));
                }
                ParameterRole::InOut => in_outs.push(one),
            }
        }
        own.arguments = in_outs;
        for (member, ty, value) in inputs {
            let value = self.argument(&value, &ty)?;
            self.assign(&member, &ty, value)?;
        }
        let power = self.power_of(enabled)?;
        let mut operands = vec![path.into()];
        operands.extend(self.operands(&shape.parameters, &own)?);
        self.once_more(path, "duplicate-instance");
        self.act(Block::user(shape.name.clone(), operands)?);
        self.under_power(enabled, power, Vec::new())?;
        for (member, ty, place, direction) in outputs {
            let (to, to_ty) = self.target(&place)?;
            self.taken(Value::of(member, ty), &to, &to_ty, direction)?;
        }
        Ok(())
    }

    /// What a call has power from. What was computed before it is a network of its own.
    fn power_of(&mut self, enabled: &Enabled) -> Lowered<Power> {
        let power = match &enabled.condition {
            Some(tree) => self.condition(tree)?,
            None => Power::Always(true),
        };
        self.flush();
        Ok(power)
    }

    /// What a call does, where it has power, after what happens without that. A block of the user runs without power, too: a jump goes
    /// past it.
    fn under_power(&mut self, enabled: &Enabled, power: Power, mut first: Vec<Block>) -> Lowered<()> {
        let act = std::mem::take(&mut self.chain);
        let is_jumped = !matches!(power, Power::Always(true)) && act.iter().any(is_of_user);
        let mut last = None;
        if let Some(place) = &enabled.done {
            let (done, ty) = self.target(place)?;
            if ty != Type::BOOL {
                return Err(format!("`{done}` is not a BOOL"));
            }
            if !is_jumped && done.whole().is_some() && self.uses.is_assigned_once(&place.root) {
                last = Some(Block::coil(&done));
            } else {
                let set = |value: Literal| Block::of(Op::Mov, [Operand::from(&done), value.into()]);
                first.push(set(zero(Scalar::Bool))?);
                last = Some(set(true.into())?);
            }
        }
        let mut parts: Vec<Circuit<Element>> = first.into_iter().map(|block| self.element(block)).collect();
        let mut end = None;
        if is_jumped {
            let label = self.new_label("endcall");
            self.network(parts);
            parts = self.opposite(power);
            parts.push(self.jump(&label));
            self.network(parts);
            parts = Vec::new();
            end = Some(label);
        } else if !matches!(power, Power::Always(true)) {
            parts.push(self.circuit(&power));
        }
        parts.extend(act.into_iter().map(Circuit::Element));
        parts.extend(last.map(|block| self.element(block)));
        self.network(parts);
        if let Some(end) = end {
            self.label(&end);
        }
        Ok(())
    }
}

fn is_of_user(element: &Element) -> bool {
    element
        .as_block()
        .is_some_and(|block| matches!(block.head(), Head::User(..)))
}
