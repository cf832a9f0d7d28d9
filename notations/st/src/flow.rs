//! The order of networks: jumps forward as conditions around what they pass over, loops, the end of a scan.

use crate::arguments::{by_place, named, place};
use crate::checks::Checks;
use crate::network::is;
use crate::power::Power;
use crate::project::{Result, Service, UnitKind};
use crate::term::Term;
use crate::unit::Unit;
use ladder_analysis::program::{Argument, Block, Network};
use ladder_analysis::values::types::Scalar;
use ladder_instructions::{Op, Shape};
use std::collections::BTreeMap;
use std::ops::Range;

/// The jumps and loops of a unit.
#[derive(Debug, Default)]
pub(crate) struct Flow {
    /// By the network that is jumped to: the variable that says so, and the networks that jump.
    jumps: BTreeMap<usize, (String, Vec<usize>)>,
    /// By the network with the FOR: the network with its NEXT, and the variable with the number of turns.
    loops: BTreeMap<usize, (usize, String)>,
    now: usize,
}

impl Flow {
    /// The loops around a network, the outermost first: the networks of FOR and NEXT.
    fn loops_around(&self, network: usize) -> impl Iterator<Item = (usize, usize)> {
        let around = self.loops.iter().map(|(first, (last, _))| (*first, *last));
        around.filter(move |(first, last)| *first < network && network <= *last)
    }

    /// The innermost of them.
    fn loop_around(&self, network: usize) -> Option<(usize, usize)> {
        self.loops_around(network).last()
    }

    /// The variables of the jumps that leave the loop which ends with a network, and the one around that.
    fn leaving(&self, last: usize) -> Vec<String> {
        let Some((first, outer)) = (self.loops.iter())
            .find(|(_, (at, _))| *at == last)
            .and_then(|(first, _)| Some((*first, self.loop_around(*first)?.1)))
        else {
            return Vec::new();
        };
        let jumps = self.jumps.iter().filter(|(target, (_, sources))| {
            **target > outer && sources.iter().any(|source| (first + 1..=last).contains(source))
        });
        jumps.map(|(_, (flag, _))| flag.clone()).collect()
    }
}

impl Unit<'_, '_> {
    /// All networks of the unit. `comment` are the lines above one.
    pub(crate) fn networks(&mut self, comment: &mut dyn FnMut(usize) -> Vec<String>) -> Result<()> {
        let program = self.project.source.program;
        let networks = self.project.networks(self.kind);
        let mut flow = self.flow(networks.clone())?;
        let has_mcr = |network: &Network| network.blocks.iter().any(|block| is(block, Op::Mcr));
        if program.networks[networks.clone()].iter().any(has_mcr) {
            let rail = self.numbered("rail", "BOOL");
            self.line(format!("{rail} := TRUE;"));
            self.rungs.rail = Some(rail);
        }
        let mut guards: Vec<String> = Vec::new();
        for index in networks.clone() {
            flow.now = index;
            let network = &program.networks[index];
            self.here = network.location;
            let passing = |(target, (_, sources)): (&usize, &(String, Vec<usize>))| {
                *target > index && sources.iter().any(|source| *source < index)
            };
            let wanted: Vec<String> = (flow.jumps.iter())
                .filter(|jump| passing(*jump))
                .map(|(_, (flag, _))| flag.clone())
                .collect();
            let begins = Self::beginning(&flow, index);
            let is_loop = flow.loops.contains_key(&index);
            if guards != wanted || !begins.is_empty() || is_loop {
                self.unguard(&mut guards);
            }
            let lines = comment(index);
            for line in &lines {
                match line.as_str() {
                    "" if self.out.lines.is_empty()
                        || self.out.lines.last().is_some_and(String::is_empty) => {}
                    "" => self.out.lines.push(String::new()),
                    line => self.line(line),
                }
            }
            for line in &begins {
                self.line(line);
            }
            self.guard(&mut guards, &wanted);
            self.flow = flow;
            let opened = self.network(network)?;
            flow = std::mem::take(&mut self.flow);
            (0..opened).for_each(|_| self.close("END_IF;"));
            if network.blocks.iter().any(|block| is(block, Op::Jmp)) {
                self.unguard(&mut guards);
            }
            let closes = flow.loops.values().any(|(last, _)| *last == index);
            if closes {
                self.unguard(&mut guards);
                self.close("END_WHILE;");
                for flag in flow.leaving(index) {
                    self.open(format!("IF {flag} THEN"));
                    self.line("EXIT;");
                    self.close("END_IF;");
                }
            }
            if let Some((_, turns)) = flow.loops.get(&index).cloned() {
                self.unguard(&mut guards);
                self.turns(network, &turns)?;
            }
        }
        self.unguard(&mut guards);
        Ok(())
    }

    fn unguard(&mut self, guards: &mut Vec<String>) {
        if !guards.is_empty() {
            self.close("END_IF;");
            guards.clear();
        }
    }

    fn guard(&mut self, guards: &mut Vec<String>, wanted: &[String]) {
        if guards.is_empty() && !wanted.is_empty() {
            let terms: Vec<String> = wanted.iter().map(|flag| format!("NOT {flag}")).collect();
            self.open(format!("IF {} THEN", terms.join(" AND ")));
            guards.extend(wanted.iter().cloned());
        }
    }

    /// What is set before a network.
    fn beginning(flow: &Flow, index: usize) -> Vec<String> {
        let mut begins = Vec::new();
        for (target, (flag, sources)) in &flow.jumps {
            let Some(first) = sources.iter().min() else {
                continue;
            };
            // What leaves a loop is FALSE before that, whose body may not be run.
            let mut left = flow.loops_around(*first).filter(|(_, last)| target > last);
            let at = left.next().map_or(*first, |(outermost, _)| outermost);
            if at == index {
                begins.push(format!("{flag} := FALSE;"));
            }
        }
        for (at, (_, turns)) in &flow.loops {
            // A loop at the end of another is not reached if that makes no turn.
            if *at == index || flow.loop_around(*at).is_some_and(|(first, _)| first == index) {
                begins.push(format!("{turns} := 0;"));
            }
        }
        begins
    }

    fn flow(&mut self, networks: Range<usize>) -> Result<Flow> {
        let program = self.project.source.program;
        let mut flow = Flow::default();
        for (first, last) in program.loops(networks.clone()) {
            let turns = self.numbered("turns", "DINT");
            flow.loops.insert(first, (last, turns));
        }
        for index in networks {
            for block in program.networks[index]
                .blocks
                .iter()
                .filter(|block| is(block, Op::Jmp))
            {
                self.here = block.location;
                let target = match by_place(block).first() {
                    Some(Argument::Label(Some(target))) => *target,
                    _ => return self.stop("a jump out of the block where it stands: write it next to that"),
                };
                if target <= index {
                    return self.stop("a jump back, which Structured Text has no word for: use a loop");
                }
                let enters = |(first, last): (usize, usize)| index <= first || index > last;
                if flow.loop_around(target).is_some_and(enters) {
                    return self.stop("a jump into a loop, which Structured Text has no word for");
                }
                let label = match block.arguments.first() {
                    Some(bound) if block.location.file == 0 => self
                        .project
                        .source
                        .text
                        .get(Range::<usize>::from(bound.range))
                        .unwrap_or("there")
                        .to_owned(),
                    _ => "there".into(),
                };
                let jump = flow.jumps.entry(target).or_insert_with(|| {
                    let name = format!("to_{}", crate::names::identifier(&label));
                    (self.instance(&name, "BOOL"), Vec::new())
                });
                jump.1.push(index);
            }
        }
        Ok(flow)
    }

    /// `<JMP>`: the rest of its network is passed over.
    pub(crate) fn jump(&mut self, block: &Block, en: usize, step: usize) -> Result<bool> {
        let power = self.entering(en, en);
        self.rungs.powers[step] = Power::Dead;
        let (flag, lines, leaves) = self.jump_lines(block)?;
        let is_start = format!("{flag} := FALSE;");
        match power.term() {
            Some(_) if matches!(power, Power::Dead) => return Ok(false),
            Some(term)
                if lines.len() == 1 && self.out.lines.last().is_some_and(|line| line.trim() == is_start) =>
            {
                self.out.lines.pop();
                self.line(format!("{flag} := {};", term.text));
            }
            _ => self.when(&power, &lines),
        }
        Ok(self.behind_jump(Some((flag, leaves))))
    }

    /// What a jump does: its variable, the statements, and whether they leave the loop.
    pub(crate) fn jump_lines(&mut self, block: &Block) -> Result<(String, Vec<String>, bool)> {
        self.here = block.location;
        let found = match by_place(block).first() {
            Some(Argument::Label(Some(target))) => self
                .flow
                .jumps
                .get(target)
                .map(|(flag, _)| (*target, flag.clone())),
            _ => None,
        };
        let Some((target, flag)) = found else {
            return self.stop("a jump to nowhere");
        };
        let now = self.flow.now;
        let mut lines = vec![format!("{flag} := TRUE;")];
        if let Some((_, turns)) = self.flow.loops.get(&now) {
            lines.push(format!("{turns} := 0;"));
        }
        let leaves = self.flow.loop_around(now).is_some_and(|(_, last)| target > last);
        if leaves {
            lines.push("EXIT;".into());
        }
        Ok((flag, lines, leaves))
    }

    /// Begins what a jump passes over, in its own network.
    pub(crate) fn behind_jump(&mut self, jump: Option<(String, bool)>) -> bool {
        match jump {
            Some((flag, false)) => {
                self.open(format!("IF NOT {flag} THEN"));
                true
            }
            _ => false,
        }
    }

    /// `<RET>` and `<END>`
    pub(crate) fn leave(&mut self, op: Op, en: usize, step: usize) -> Result<()> {
        let power = self.entering(en, en);
        self.rungs.powers[step] = Power::Dead;
        let mut lines = Vec::new();
        if let UnitKind::Block(index) = self.kind
            && self.project.source.program.blocks[index].shape == Shape::Function
            && op == Op::Ret
        {
            return self.stop("a block that returns where it stands: write that next to it");
        }
        if op == Op::End {
            let ended = self.service(Service::Ended);
            lines.push(format!("{ended} := TRUE;"));
        }
        lines.push("RETURN;".into());
        self.when(&power, &lines);
        Ok(())
    }

    /// `<FOR>`: how many turns the loop after its network makes.
    pub(crate) fn begins_loop(&mut self, block: &Block, en: usize, step: usize) -> Result<()> {
        let Some((_, turns)) = self.flow.loops.get(&self.flow.now).cloned() else {
            return self.stop("a FOR without a NEXT");
        };
        let mut checks = Checks::new();
        let Some(Argument::Value(count)) = by_place(block).first() else {
            return self.stop("a FOR without a number of turns");
        };
        let term = self.settled(count, &mut checks)?;
        let term = match count.ty {
            Scalar::Dint => term,
            ty if ty.width() < 32 && !ty.is_bits() => crate::expression::pass(term, ty, Scalar::Dint),
            // Nobody waits for so many.
            Scalar::Lint => {
                let least = Term::call("LIMIT", &[&Term::whole("0"), &term, &Term::whole("2147483647")]);
                match term.text.parse::<i32>() {
                    Ok(_) => term,
                    Err(_) => Term::call("LINT_TO_DINT", &[&least]),
                }
            }
            ty => {
                let most = Term::call("MIN", &[&term, &Term::whole("2147483647")]);
                Term::call(&crate::place::conversion(ty, Scalar::Dint), &[&most])
            }
        };
        if checks.is_empty() {
            let power = self.entering(en, step);
            self.rungs.powers[step] = power.clone();
            self.when(&power, &[format!("{turns} := {};", term.text)]);
            return Ok(());
        }
        let power = self.entering(en, en);
        if matches!(power, Power::Dead) {
            return Ok(());
        }
        let done = self.done(step);
        self.guarded(
            power.term().as_ref(),
            checks,
            &[format!("{turns} := {};", term.text)],
            done.as_deref(),
        );
        self.is_done(step, done);
        Ok(())
    }

    /// The head of a loop.
    fn turns(&mut self, network: &Network, turns: &str) -> Result<()> {
        // A FOR with one turn is not run by compilers that are built on matiec.
        let turn = self.numbered("turn", "DINT");
        self.line(format!("{turn} := 0;"));
        self.open(format!("WHILE {turn} < {turns} DO"));
        self.line(format!("{turn} := {turn} + 1;"));
        let Some(block) = network.blocks.iter().find(|block| is(block, Op::For)) else {
            return Ok(());
        };
        self.here = block.location;
        if let Some((to, ty)) = place(named(block, "I")) {
            self.free_temporaries();
            let mut checks = Checks::new();
            let target = self.place(to, &mut checks)?;
            let value = crate::expression::pass(Term::variable(&turn), Scalar::Dint, ty);
            self.guarded(None, checks, &target.assign(&value), None);
        }
        Ok(())
    }
}
