//! What must stand above a network: the blocks that its operands come from, and tags for power that is an operand.

use super::blocks::{Class, is_enable, is_enable_out, operand_pins, power_output, power_pins, result_output};
use super::body::Body;
use super::draw::Target;
use crate::expression::{Form, Typed};
use crate::graph::{Edge, End, Kind, Modifier};
use crate::model::{Type, UnitKind};
use crate::standard::{self, Gate};
use ladder_format::program::{Block, Path};
use ladder_instructions::Op;
use std::collections::HashSet;

/// The outputs that were seen, and whether their blocks may stand in the network itself.
pub(super) type Seen = HashSet<(End, bool)>;

impl Body<'_> {
    /// Writes what must stand above the network of an element.
    pub(super) fn prepare(&mut self, node: usize) {
        let mut seen = Seen::new();
        self.prepare_node(node, true, &mut seen);
    }

    fn prepare_node(&mut self, node: usize, inline: bool, seen: &mut Seen) {
        match &self.graph.nodes[node].kind {
            Kind::Block { .. } => {
                if let Some(class) = self.class(node).filter(|class| class.acts()) {
                    self.prepare_block(node, class, seen);
                } else {
                    self.prepare_condition(node, inline, seen);
                }
            }
            Kind::Variable(text, _) => {
                if self.is_written_by_power(node, text) {
                    self.prepare_pin(node, 0, inline, seen);
                } else if let Err(why) = self.direct(node, 0, seen) {
                    self.refuse(node, why);
                }
            }
            _ => {
                for pin in 0..self.graph.nodes[node].inputs.len() {
                    self.prepare_pin(node, pin, inline, seen);
                }
            }
        }
    }

    /// Whether a variable is written as a coil writes.
    pub(super) fn is_written_by_power(&mut self, node: usize, text: &str) -> bool {
        let from = self.graph.nodes[node]
            .inputs
            .first()
            .map_or(&[][..], |pin| &pin.from);
        let Some(first) = from.first().copied() else {
            return true;
        };
        if self.tags.guards.contains_key(&node) {
            return false;
        }
        self.is_power(first).unwrap_or_else(|| {
            let ty = self.operand(text).ok().and_then(|operand| operand.ty);
            matches!(ty, Some(Type::Named(name)) if name.eq_ignore_ascii_case("BOOL"))
        })
    }

    /// A gate or a comparison.
    fn prepare_condition(&mut self, node: usize, inline: bool, seen: &mut Seen) {
        let is_and = self.class(node) == Some(Class::Gate(Gate::And));
        let is_compare = matches!(self.class(node), Some(Class::Compare(_)));
        for pin in 0..self.graph.nodes[node].inputs.len() {
            if is_compare && !is_enable(&self.graph.nodes[node].inputs[pin].name) {
                if let Err(why) = self.direct(node, pin, seen) {
                    self.refuse(node, why);
                }
            } else {
                // What is second in a series has only the power of the first: a block there would run otherwise.
                self.prepare_pin(node, pin, inline && !(is_and && pin > 0), seen);
                self.prepare_inversion(node, pin, inline && !(is_and && pin > 0), seen);
            }
        }
        let output = power_output(self, node).unwrap_or(0);
        let end = End { node, output };
        let is_negated = self.graph.nodes[node]
            .outputs
            .get(output)
            .is_some_and(|it| it.negated);
        if is_negated && !inline && !self.tags.results.contains_key(&end) {
            let tag = self.helper("inverted", "BOOL", "what leaves a gate");
            self.flush();
            self.network(&[Target::End(end, tag)]);
        }
    }

    /// Within a series only what comes to a pin is inverted, and not what is before it: so it needs a tag.
    fn prepare_inversion(&mut self, node: usize, pin: usize, inline: bool, seen: &mut Seen) {
        let is_not = self.class(node) == Some(Class::Gate(Gate::Not));
        let is_modified = self.graph.nodes[node].inputs[pin].modifier != Modifier::default();
        let is_kept = inline || self.tags.operands.contains_key(&(node, pin));
        let is_once = is_not != is_modified;
        if is_kept || !(is_not || is_modified) || (is_once && self.invertible(node, pin).is_some()) {
            return;
        }
        if let Err(why) = self.direct(node, pin, seen) {
            self.refuse(node, why);
        }
    }

    /// The one contact or value that comes to a pin, if it can be inverted by itself.
    pub(super) fn invertible(&self, node: usize, pin: usize) -> Option<End> {
        let pin = self.graph.nodes[node].inputs.get(pin)?;
        let ([end], true) = (&pin.from[..], pin.modifier.edge == Edge::None) else {
            return None;
        };
        let source = &self.graph.nodes[end.node];
        let is_invertible = match &source.kind {
            Kind::Value(text, _) => self
                .operand(text)
                .is_ok_and(|operand| !matches!(operand.form(), Form::Formula | Form::Milliseconds)),
            Kind::Contact(_, modifier) if modifier.edge == Edge::None => {
                let before = source.inputs.first().map_or(&[][..], |pin| &pin.from);
                matches!(before, [end] if self.graph.nodes[end.node].kind == Kind::LeftRail)
            }
            _ => false,
        };
        (is_invertible && !self.is_refused(end.node) && !self.tags.results.contains_key(end)).then_some(*end)
    }

    fn prepare_pin(&mut self, node: usize, pin: usize, inline: bool, seen: &mut Seen) {
        for end in self.graph.nodes[node].inputs[pin].from.clone() {
            if !self.graph.feedback.contains(&(node, end)) {
                self.prepare_end(end, inline, seen);
            }
        }
    }

    fn prepare_end(&mut self, end: End, inline: bool, seen: &mut Seen) {
        if !seen.insert((end, inline)) {
            return;
        }
        let node = end.node;
        match &self.graph.nodes[node].kind {
            Kind::Value(text, _) => {
                if let Ok(operand) = self.operand(text)
                    && operand.form() == Form::Formula
                    && let Err(why) = self.computed(end)
                {
                    self.refuse(node, why);
                }
            }
            Kind::Block { .. } => {
                let Some(class) = self.class(node) else { return };
                if !class.acts() {
                    self.decide(node);
                    if self.tags.results.contains_key(&end) {
                        return;
                    }
                    return self.prepare_condition(node, inline, seen);
                }
                if self.state.executed[node] {
                    return;
                }
                self.prepare_block(node, class, seen);
                let stands_in_wire =
                    inline && class != Class::Text && power_output(self, node) == Some(end.output);
                if !stands_in_wire && !self.state.executed[node] {
                    self.execute(node);
                }
            }
            _ => self.prepare_node(node, inline, seen),
        }
    }

    /// A block is written in a network of its own.
    pub(super) fn execute(&mut self, node: usize) {
        self.flush();
        if !self.state.executed[node] {
            self.take_turns(node);
        }
        // It may have stood in the network that is written now.
        if !self.state.executed[node] && !self.network(&[Target::Root(node)]) {
            self.in_pieces(Target::Root(node));
            self.state.executed[node] = true;
        }
        self.statements(node);
    }

    /// The operands of a block, its instance and the tags of its results.
    fn prepare_block(&mut self, node: usize, class: Class, seen: &mut Seen) {
        if self.is_refused(node) {
            return;
        }
        if let Err(why) = self.try_prepare_block(node, class, seen) {
            self.refuse(node, why);
        }
        for pin in power_pins(self, node) {
            self.prepare_pin(node, pin, true, seen);
        }
    }

    fn try_prepare_block(&mut self, node: usize, class: Class, seen: &mut Seen) -> Result<(), String> {
        if class == Class::Unknown {
            self.note_unread(node);
        }
        for pin in operand_pins(self, node) {
            let is_wired = !self.graph.nodes[node].inputs[pin].from.is_empty();
            if is_wired && !self.tags.operands.contains_key(&(node, pin)) {
                match self.direct(node, pin, seen) {
                    // Its text has the value as the source does.
                    Err(_) if class == Class::Unknown => {}
                    done => drop(done?),
                }
            }
        }
        self.enabled(node, seen);
        self.results_of(node, class)
    }

    /// The tags that hold the results of a function.
    fn results_of(&mut self, node: usize, class: Class) -> Result<(), String> {
        let is_function = matches!(
            class,
            Class::Value(_)
                | Class::Convert
                | Class::Logic(_)
                | Class::Unknown
                | Class::Unit(UnitKind::Function)
        );
        if !is_function {
            return Ok(());
        }
        let Some(first) = result_output(&self.graph.nodes[node]) else {
            return Ok(());
        };
        for output in 0..self.graph.nodes[node].outputs.len() {
            let end = End { node, output };
            let is_power = power_output(self, node) == Some(output);
            if is_power || self.tags.results.contains_key(&end) {
                continue;
            }
            let uses = self.facts.uses.get(&end).cloned().unwrap_or_default();
            if (output != first || class == Class::Unknown) && uses.is_empty() {
                continue;
            }
            let is_negated = self.graph.nodes[node].outputs[output].negated;
            let is_only = |user: usize| {
                self.graph.nodes[user]
                    .inputs
                    .first()
                    .is_some_and(|pin| pin.from.len() == 1)
            };
            let variables: Vec<(usize, Path, Option<Type>)> = uses
                .iter()
                .filter_map(|user| match &self.graph.nodes[*user].kind {
                    Kind::Variable(text, false) if is_only(*user) && !is_negated => {
                        let operand = self.operand(text).ok()?;
                        Some((*user, operand.value.path()?.clone(), operand.ty))
                    }
                    _ => None,
                })
                .collect();
            let (late, variables): (Vec<_>, Vec<_>) = variables
                .into_iter()
                .partition(|(user, tag, _)| self.is_written_later(node, *user, tag));
            let taken = late.first().or(variables.first());
            let taken = taken.and_then(|(.., ty)| ty.clone());
            let is_enabled = self.graph.nodes[node]
                .inputs
                .iter()
                .any(|pin| is_enable(&pin.name));
            if let (true, Some(output)) = (is_enabled, power_output(self, node)) {
                let end = End { node, output };
                self.tags
                    .guards
                    .extend(late.into_iter().map(|(user, ..)| (user, end)));
            }
            let tag = if let ([(user, tag, _)], true) = (&variables[..], uses.len() == 1) {
                self.state.merged[*user] = true;
                tag.clone()
            } else {
                let ty = self.out_type(end).or(taken).or_else(|| self.type_taken(end));
                let ty = ty.or_else(|| self.type_asked_of_unknown(end));
                let ty = ty.ok_or("the type of its result is not known")?;
                let ty = self.type_text(&ty)?;
                let Kind::Block { name, .. } = &self.graph.nodes[node].kind else {
                    return Ok(());
                };
                let comment = format!("the result of {name}");
                let tag = match self.tags.holders.get(&end) {
                    Some(tag) => tag.clone(),
                    None => self.helper(&name.to_lowercase(), &ty, &comment),
                };
                self.begin_with_nothing(node, end, &tag)?;
                // Without power at EN nothing is written.
                if is_enabled {
                    for (user, variable, _) in variables {
                        self.state.merged[user] = true;
                        let block = Block::of(Op::Mov, [&variable, &tag])?;
                        self.tags.moves.entry(node).or_default().push(block);
                    }
                }
                tag
            };
            self.tags.results.insert(end, tag);
        }
        Ok(())
    }

    /// The operand at a pin: the variable or value that is wired to it, or a tag with what comes there.
    fn direct(&mut self, node: usize, pin: usize, seen: &mut Seen) -> Result<Typed, String> {
        let operand = self.find_direct(node, pin, seen)?;
        self.tags.operands.insert((node, pin), operand.clone());
        for end in &self.graph.nodes[node].inputs[pin].from {
            // What feeds back has its turn after that.
            if !self.graph.feedback.contains(&(node, *end)) {
                self.state.seen[end.node] = true;
            }
        }
        Ok(operand)
    }

    fn find_direct(&mut self, node: usize, pin: usize, seen: &mut Seen) -> Result<Typed, String> {
        let (from, modifier) = {
            let pin = &self.graph.nodes[node].inputs[pin];
            (pin.from.clone(), pin.modifier)
        };
        if let ([end], true) = (&from[..], modifier == Modifier::default()) {
            let source = &self.graph.nodes[end.node];
            match &source.kind {
                Kind::Value(text, negated) => {
                    let operand = self.operand(text)?;
                    match (operand.form(), negated) {
                        (Form::Literal(_) | Form::Path(_), false) => return Ok(operand),
                        (Form::Formula, false) if self.takes_formula(node, &operand) => {
                            return Ok(operand);
                        }
                        (Form::Formula, false) => return self.computed(*end),
                        (Form::Milliseconds, false)
                            if matches!(self.class(node), Some(Class::Value("MOV") | Class::Convert)) =>
                        {
                            return Ok(operand);
                        }
                        (Form::Milliseconds, _) => {
                            return Err("a TIME as a number has no counterpart in such an operand".to_owned());
                        }
                        _ => {}
                    }
                }
                Kind::Contact(text, contact) if *contact == Modifier::default() => {
                    let before = source.inputs.first().map_or(&[][..], |pin| &pin.from);
                    let is_at_rail =
                        matches!(before, [end] if self.graph.nodes[end.node].kind == Kind::LeftRail);
                    let operand = self.operand(text)?;
                    if is_at_rail && matches!(operand.form(), Form::Path(_)) {
                        return Ok(operand);
                    }
                }
                Kind::Block { .. } if self.class(end.node).is_some_and(Class::acts) => {
                    if !self.graph.feedback.contains(&(node, *end)) {
                        self.prepare_end(*end, false, seen);
                    }
                    let is_negated = source
                        .outputs
                        .get(end.output)
                        .is_some_and(|output| output.negated);
                    if !is_negated {
                        return Ok(Typed::of(self.reference(*end)?, None));
                    }
                }
                _ => {}
            }
        }
        let is_power = match from.first() {
            Some(end) => self.is_power(*end) != Some(false),
            None => true,
        };
        if !is_power {
            return Err("several values are wired to one pin, or one is inverted".to_owned());
        }
        let like = match &self.graph.nodes[node].kind {
            Kind::Block { name, instance, .. } => {
                let name = instance.as_deref().unwrap_or(name).to_owned();
                format!("{name}_{}", self.graph.nodes[node].inputs[pin].name)
            }
            _ => "power".to_owned(),
        };
        self.prepare_power(node, pin, seen);
        let tag = self.helper(&like, "BOOL", "what comes to a pin");
        self.put_power(Target::Pin(node, pin, tag.clone()));
        Ok(Typed::of(tag, Some(Type::Named("BOOL".to_owned()))))
    }

    /// What must stand above the power at a pin.
    pub(super) fn prepare_power(&mut self, node: usize, pin: usize, seen: &mut Seen) {
        self.take_turns(node);
        self.prepare_pin(node, pin, true, seen);
    }

    /// A network that puts power into a tag.
    pub(super) fn put_power(&mut self, target: Target) {
        self.flush();
        if !self.network(std::slice::from_ref(&target)) {
            self.in_pieces(target);
        }
    }

    /// Whether an expression is all that a block computes, in the type of the one variable that takes it.
    fn takes_formula(&self, node: usize, formula: &Typed) -> bool {
        let Some(output) = result_output(&self.graph.nodes[node]) else {
            return false;
        };
        let taken = self
            .facts
            .uses
            .get(&End { node, output })
            .map_or(&[][..], Vec::as_slice);
        let (Some(Class::Value("MOV")), &[user]) = (self.class(node), taken) else {
            return false;
        };
        let Kind::Variable(text, false) = &self.graph.nodes[user].kind else {
            return false;
        };
        let ty = self.operand(text).ok().and_then(|taken| taken.ty);
        let real = |ty: &Option<Type>| match ty.as_ref().map(|ty| self.shared.real(ty)) {
            Some(Type::Named(name)) => standard::elementary(name),
            _ => None,
        };
        real(&ty).is_some() && real(&ty) == real(&formula.ty)
    }

    /// A tag with the value of an expression.
    fn computed(&mut self, end: End) -> Result<Typed, String> {
        let Kind::Value(text, _) = &self.graph.nodes[end.node].kind else {
            return Err("it is no value".to_owned());
        };
        let ty = self.operand(text)?.ty;
        let ty = ty.ok_or_else(|| format!("the type of `{text}` is not known"))?;
        let written = self.type_text(&ty)?;
        let tag = self.helper("value", &written, "the value of an expression");
        self.flush();
        self.tags.results.insert(end, tag.clone());
        self.network(&[Target::Value(end, tag.clone())]);
        Ok(Typed::of(tag, Some(ty)))
    }

    /// The tag that holds what leaves an output of a block that is above.
    pub(super) fn reference(&self, end: End) -> Result<Path, String> {
        let node = &self.graph.nodes[end.node];
        let output = node
            .outputs
            .get(end.output)
            .map_or("", |output| output.name.as_str());
        let held = self.tags.results.get(&end);
        if let Some(tag) = held.or_else(|| self.tags.holders.get(&end)) {
            return Ok(tag.clone());
        }
        let Kind::Block { name, .. } = &node.kind else {
            return Err("what feeds it has no result".to_owned());
        };
        if matches!(self.class(end.node), Some(Class::Standard(_))) && is_enable_out(output) {
            return Ok(Path::system("ON"));
        }
        match (self.class(end.node), self.tags.instances.get(&end.node).cloned()) {
            (Some(Class::Standard(standard::StandardBlock::Stateful(mnemonic, ..))), Some(instance)) => {
                let output = if output.is_empty() {
                    standard::power_output(standard::StandardBlock::Stateful(mnemonic, "", &[])).to_owned()
                } else {
                    output.to_ascii_uppercase()
                };
                if !standard::OUTPUTS.contains(&output.as_str()) {
                    return Err(format!("`{name}` has no output `{output}`"));
                }
                Ok(instance.member(output))
            }
            (Some(Class::Unit(UnitKind::FunctionBlock)), Some(instance)) => {
                let block = self.shared.blocks.get(&name.to_lowercase());
                let known = block.and_then(|block| block.scope.get(output));
                let known = known.ok_or_else(|| format!("`{name}` has no output `{output}`"))?;
                Ok(instance.member(&known.path.root))
            }
            _ => Err(format!("nothing holds what `{name}` has at `{output}`")),
        }
    }
}
