//! What a network and a block do, as numbers that are equal where they do the same: by the names of tags, whatever their
//! places in the text and in memory.

use super::renamed::Renamed;
use ladder_analysis::program::{
    Argument, Block, BlockKind, Chosen, Expr, ExprKind, Location, Network, Place, Program, RangeRef, TagId,
};
use ladder_instructions::{Coil, Group, Op, Power};
use ladder_syntax::Name;
use std::hash::{DefaultHasher, Hash, Hasher};

/// The numbers of one program.
pub(super) struct Signatures<'p> {
    program: &'p Program,
    tags: Vec<u64>,
}

impl<'p> Signatures<'p> {
    pub(super) fn of(program: &'p Program, renamed: &Renamed) -> Signatures<'p> {
        let tags = program.tags.iter().map(|tag| {
            let mut hasher = DefaultHasher::new();
            Name::new(renamed.former_name(tag)).hash(&mut hasher);
            tag.ty.hash(&mut hasher);
            tag.block
                .map(|block| Name::new(&program.blocks[block].name))
                .hash(&mut hasher);
            hasher.finish()
        });
        Signatures {
            tags: tags.collect(),
            program,
        }
    }

    /// What a network does.
    pub(super) fn network(&self, network: &Network) -> u64 {
        let mut hasher = DefaultHasher::new();
        network.steps.hash(&mut hasher);
        for block in &network.blocks {
            self.hash_block(block, &mut hasher);
        }
        hasher.finish()
    }

    /// What a block does.
    pub(super) fn block(&self, block: &Block) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.hash_block(block, &mut hasher);
        hasher.finish()
    }

    /// What a block does, without operands that may change while it goes on with what it remembers. None if it
    /// remembers nothing that would then make sense.
    pub(super) fn kind(&self, block: &Block) -> Option<u64> {
        let mut hasher = DefaultHasher::new();
        self.program.profile(block.location).hash(&mut hasher);
        match block.kind {
            BlockKind::User(user) => Name::new(&self.program.blocks[user].name).hash(&mut hasher),
            BlockKind::Instruction(row) => {
                let remembers_power = matches!(row.power, Power::EnEdge(_))
                    || matches!(row.coil, Some(Coil::OnEdge(_)))
                    || row.op == Op::Shift;
                row.op.hash(&mut hasher);
                if row.group == Group::State {
                    // It goes with its tag, whatever its preset is.
                    let state = block.arguments.first().map(|bound| &bound.argument);
                    if let Some(state) = state {
                        self.hash_argument(state, block.location, &mut hasher);
                    }
                } else if !remembers_power {
                    return None;
                }
            }
        }
        Some(hasher.finish())
    }

    fn hash_block(&self, block: &Block, hasher: &mut DefaultHasher) {
        self.program.profile(block.location).hash(hasher);
        match block.kind {
            BlockKind::Instruction(row) => row.op.hash(hasher),
            BlockKind::User(user) => Name::new(&self.program.blocks[user].name).hash(hasher),
        }
        block.works_in.hash(hasher);
        for bound in &block.arguments {
            bound.operand.map(|operand| operand.name).hash(hasher);
            bound.parameter.hash(hasher);
            self.hash_argument(&bound.argument, block.location, hasher);
        }
    }

    fn tag(&self, tag: TagId) -> u64 {
        self.tags.get(tag.0 as usize).copied().unwrap_or_default()
    }

    fn hash_argument(&self, argument: &Argument, at: Location, hasher: &mut DefaultHasher) {
        std::mem::discriminant(argument).hash(hasher);
        match argument {
            Argument::Value(expr) => self.hash_expr(expr, hasher),
            Argument::Place(place, ty) => {
                self.hash_place(place, hasher);
                ty.hash(hasher);
            }
            Argument::State(tag) => self.tag(*tag).hash(hasher),
            Argument::ChosenState(chosen) => self.hash_chosen(chosen, hasher),
            Argument::Range(range) => self.hash_range(range, hasher),
            Argument::Label(to) => {
                let here = || {
                    let networks = self.program.networks.iter();
                    let mut all = networks.map(|network| network.location);
                    all.position(|it| it.file == at.file && it.range.contains_range(at.range))
                };
                let network = to.or_else(here);
                for (label, _) in (self.program.labels.iter()).filter(|(_, it)| Some(*it) == network) {
                    label.hash(hasher);
                }
            }
            Argument::OuterLabel(name) => name.hash(hasher),
            Argument::Function(function) => {
                Name::new(&self.program.functions[*function].name).hash(hasher);
            }
            Argument::Operator(op) => op.hash(hasher),
            Argument::Parts(parts) => {
                for part in parts {
                    self.hash_argument(part, at, hasher);
                }
            }
        }
    }

    fn hash_chosen(&self, chosen: &Chosen, hasher: &mut DefaultHasher) {
        (self.tag(chosen.first), chosen.count).hash(hasher);
        self.hash_expr(&chosen.number, hasher);
    }

    fn hash_place(&self, place: &Place, hasher: &mut DefaultHasher) {
        std::mem::discriminant(place).hash(hasher);
        match place {
            Place::Tag(tag) => self.tag(*tag).hash(hasher),
            Place::Element(tag, index) => {
                self.tag(*tag).hash(hasher);
                self.hash_expr(index, hasher);
            }
            Place::Member(tag, member) => (self.tag(*tag), member).hash(hasher),
            Place::Chosen(chosen) => self.hash_chosen(chosen, hasher),
            Place::ChosenMember(chosen, member) => {
                self.hash_chosen(chosen, hasher);
                member.hash(hasher);
            }
            Place::Bit(word, ty, bit) => {
                self.hash_place(word, hasher);
                (ty, bit).hash(hasher);
            }
            Place::As(inner, stored, ty) => {
                self.hash_place(inner, hasher);
                (stored, ty).hash(hasher);
            }
            Place::System(system) => system.name().hash(hasher),
        }
    }

    fn hash_range(&self, range: &RangeRef, hasher: &mut DefaultHasher) {
        (self.tag(range.tag), range.element).hash(hasher);
        self.hash_expr(&range.first, hasher);
        if let Some(last) = &range.last {
            self.hash_expr(last, hasher);
        }
        if let Some(row) = &range.row {
            row.bounds.hash(hasher);
            self.hash_expr(&row.index, hasher);
        }
    }

    fn hash_expr(&self, expr: &Expr, hasher: &mut DefaultHasher) {
        expr.ty.hash(hasher);
        std::mem::discriminant(&expr.kind).hash(hasher);
        match &expr.kind {
            // A real has no hash of its own.
            ExprKind::Constant(value) => format!("{value:?}").hash(hasher),
            ExprKind::Read(place) => self.hash_place(place, hasher),
            ExprKind::Pass(inner) => self.hash_expr(inner, hasher),
            ExprKind::Unary(operator, inner) => {
                operator.hash(hasher);
                self.hash_expr(inner, hasher);
            }
            ExprKind::Binary(operator, left, right) => {
                operator.hash(hasher);
                self.hash_expr(left, hasher);
                self.hash_expr(right, hasher);
            }
            ExprKind::Compare(op, left, right) => {
                op.hash(hasher);
                self.hash_expr(left, hasher);
                self.hash_expr(right, hasher);
            }
            ExprKind::Call(op, arguments) => {
                op.hash(hasher);
                for argument in arguments {
                    self.hash_expr(argument, hasher);
                }
            }
            ExprKind::Sum(range) => self.hash_range(range, hasher),
            ExprKind::Offset(subscripts) => {
                for subscript in subscripts {
                    (subscript.first, subscript.last).hash(hasher);
                    self.hash_expr(&subscript.index, hasher);
                }
            }
        }
    }
}
