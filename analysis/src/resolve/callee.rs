//! Operands that name a network: labels to jump to, functions to call.

use super::Resolver;
use crate::program::Argument;
use crate::rules::{bad_operand, duplicate_function, unknown_function, unknown_label};
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::Shape;
use ladder_syntax::Name;

impl Resolver<'_, '_> {
    pub(super) fn label(&mut self, node: &Node) -> Option<Argument> {
        let NodeKind::Name(name) = &node.kind else {
            self.report(bad_operand::wrong(
                self.at(node.range),
                "a label's name is expected here",
            ));
            return None;
        };
        let key = Name::new(name);
        match self.context.jump_target(self.network, &key) {
            Some(target) => Some(Argument::Label(self.network_number(target))),
            None if self.is_in_function_shape() => Some(Argument::OuterLabel(key)),
            None => {
                let diagnostic =
                    unknown_label::unknown(self.context, self.network, name, self.at(node.range));
                self.report(diagnostic);
                None
            }
        }
    }

    /// Whether this is the body of a `<$B>`, which may jump to labels around the place where the block is.
    fn is_in_function_shape(&self) -> bool {
        let block = self.scope.block.map(|block| &self.context.user_blocks[block]);
        block.is_some_and(|block| block.shape == Shape::Function)
    }

    pub(super) fn function(&mut self, node: &Node) -> Option<Argument> {
        let NodeKind::Name(name) = &node.kind else {
            self.report(bad_operand::wrong(
                self.at(node.range),
                "a function's name is expected here",
            ));
            return None;
        };
        if let Some(found) = self.several_functions(name, node) {
            self.report(found);
            return None;
        }
        match self.context.callee(&Name::new(name)) {
            Some(callee) => Some(Argument::Function(self.function_number(&callee))),
            None => {
                let diagnostic = unknown_function::unknown(self.context, name, self.at(node.range));
                self.report(diagnostic);
                None
            }
        }
    }

    /// Says so if a function that the file does not have is one of several other files.
    fn several_functions(&self, name: &str, node: &Node) -> Option<crate::findings::diagnostic::Diagnostic> {
        if self.context.function(&Name::new(name)).is_some() {
            return None;
        }
        duplicate_function::of_several_files(self.context, name, self.at(node.range))
    }
}
