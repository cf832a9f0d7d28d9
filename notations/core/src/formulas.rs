//! Programs whose formulas call functions (`[CALC]( y, a + MIN(b, c * 2) )`), for systems whose formulas have others: what they call
//! becomes an instruction of its own, in front of the formula, and tags hold the parts.

use crate::edited::{Edited, Edits, own_networks, write_edited};
use crate::{WriteError, Writing};
use ladder_analysis::Analysis;
use ladder_analysis::context::Body;
use ladder_analysis::program::{Argument, Block, BlockKind, Expr, ExprKind};
use ladder_instructions::Op;
use ladder_syntax::TextRange;

/// The comment on a tag for a part.
const PART: &str = "a part of a formula";

/// The functions. No other system has them in its formulas.
const FUNCTIONS: [Op; 5] = [Op::Min, Op::Max, Op::Limit, Op::Sel, Op::Mux];

/// Writes a program in whose formulas none of `MIN`, `MAX`, `LIMIT`, `SEL` and `MUX` is called.
///
/// # Errors
///
/// Those of `write`.
pub fn with_calls_as_instructions(
    analysis: &Analysis,
    write: impl Fn(&Analysis) -> Result<Writing, WriteError>,
) -> Result<Writing, WriteError> {
    write_edited(analysis, by_instructions(analysis), &write)
}

fn by_instructions(analysis: &Analysis) -> Option<Edited> {
    let text = analysis.context.parse.to_string();
    let mut parts = Parts {
        lower: text.to_lowercase(),
        text: &text,
        number: 0,
        body: Body::Main,
        edits: Edits::default(),
    };
    for (network, body) in own_networks(analysis)? {
        parts.body = body;
        for block in &network.blocks {
            if let Some(instead) = parts.of(block) {
                parts.edits.instead.push((block.location.range, instead));
            }
        }
    }
    if parts.edits.is_empty() {
        return None;
    }
    parts.edits.program(&analysis.context)
}

/// The mnemonic of an instruction, its result, and its other operands.
type Instruction = (String, String, String);

/// The parts of formulas.
struct Parts<'t> {
    text: &'t str,
    lower: String,
    number: usize,
    /// What the network is in.
    body: Body,
    edits: Edits,
}

impl Parts<'_> {
    /// What stands in the place of a formula that calls one of the functions.
    fn of(&mut self, block: &Block) -> Option<String> {
        let BlockKind::Instruction(row) = block.kind else {
            return None;
        };
        let [to, from] = &block.arguments[..] else {
            return None;
        };
        let (Op::Calc, Argument::Value(formula)) = (row.op, &from.argument) else {
            return None;
        };
        if !calls(formula) {
            return None;
        }
        let mut chain = Vec::new();
        let to = self.text[to.range].trim().to_owned();
        let value = self.text_of(formula, &mut chain);
        // The value of the last call is that of the formula.
        match chain.last_mut() {
            Some((_, result, _)) if *result == value && matches!(formula.kind, ExprKind::Call(..)) => {
                result.clone_from(&to);
            }
            _ => chain.push(("CALC".to_owned(), to, value)),
        }
        let chain: Vec<String> = chain
            .iter()
            .map(|(name, result, operands)| format!("[{name}]( {result}, {operands} )"))
            .collect();
        Some(chain.join("--"))
    }

    /// An expression without these calls; the instructions in their place are added to the chain.
    fn text_of(&mut self, formula: &Expr, chain: &mut Vec<Instruction>) -> String {
        let own = &self.text[formula.range];
        if !calls(formula) {
            return own.to_owned();
        }
        if let ExprKind::Call(op, arguments) = &formula.kind
            && FUNCTIONS.contains(op)
        {
            let name = own.split('(').next().unwrap_or_default().trim().to_uppercase();
            let operands: Vec<String> = arguments
                .iter()
                .map(|argument| self.operand(argument, chain))
                .collect();
            return self.part(formula, name, operands.join(", "), chain);
        }
        let inner: Vec<&Expr> = match &formula.kind {
            ExprKind::Call(_, arguments) => arguments.iter().collect(),
            ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => vec![inner],
            ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => vec![left, right],
            _ => Vec::new(),
        };
        let (mut out, mut from) = (String::new(), formula.range.start());
        for inner in inner {
            out.push_str(&self.text[TextRange::new(from, inner.range.start())]);
            out.push_str(&self.text_of(inner, chain));
            from = inner.range.end();
        }
        out + &self.text[TextRange::new(from, formula.range.end())]
    }

    /// An argument of a call as an operand: a tag, a literal, or a part.
    fn operand(&mut self, argument: &Expr, chain: &mut Vec<Instruction>) -> String {
        let mut inner = argument;
        while let ExprKind::Pass(of) = &inner.kind {
            inner = of;
        }
        let text = self.text_of(inner, chain);
        match &inner.kind {
            ExprKind::Constant(_) | ExprKind::Read(_) => text,
            ExprKind::Call(op, _) if FUNCTIONS.contains(op) => text,
            _ => self.part(inner, "CALC".to_owned(), text, chain),
        }
    }

    fn part(&mut self, of: &Expr, name: String, operands: String, chain: &mut Vec<Instruction>) -> String {
        let part = loop {
            self.number += 1;
            let part = format!("part_{}", self.number);
            if !self.lower.contains(&part) {
                break part;
            }
        };
        let ty = of.ty.name();
        self.edits
            .declare(self.body, &format!("{part} : {ty};  # {PART} #"));
        chain.push((name, part.clone(), operands));
        part
    }
}

/// Whether a formula calls one of the functions.
fn calls(formula: &Expr) -> bool {
    match &formula.kind {
        ExprKind::Call(op, arguments) => FUNCTIONS.contains(op) || arguments.iter().any(calls),
        ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => calls(inner),
        ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => calls(left) || calls(right),
        _ => false,
    }
}
