//! The files whose tags the rows of a scenario can name, besides those of its program.

use crate::neighbour::Workspace;
use ladder_analysis::context::{Callee, Context};
use ladder_analysis::written::facts::NodeKind;
use ladder_instructions::Op;
use ladder_syntax::Name;
use std::sync::Arc;

/// This many files are searched: analysis of one takes time.
const MOST: usize = 64;

/// The files that a program reaches through its calls and blocks, the nearest first.
pub(super) fn used_files(program: &Context, workspace: &dyn Workspace) -> Vec<Arc<Context>> {
    let mut names = imports(program);
    let mut files: Vec<Arc<Context>> = Vec::new();
    let mut at = 0;
    while at < names.len().min(MOST) {
        if let Some(file) = workspace.file(&names[at]) {
            for name in imports(&file) {
                if !names.contains(&name) && !program.is_called(&name) {
                    names.push(name);
                }
            }
            files.push(file);
        }
        at += 1;
    }
    files
}

/// The files whose functions and blocks a file names.
fn imports(file: &Context) -> Vec<Arc<str>> {
    let mut names: Vec<Arc<str>> = Vec::new();
    let mut enter = |name: &Arc<str>| {
        if !names.contains(name) {
            names.push(Arc::clone(name));
        }
    };
    file.user_blocks
        .iter()
        .filter_map(|it| it.file())
        .for_each(&mut enter);
    for network in &file.networks {
        for block in network.blocks().filter(|it| it.op() == Some(Op::Call)) {
            if let Some(operand) = block.facts.operands.first()
                && let NodeKind::Name(name) = &operand.value.kind
                && let Some(Callee::Other(import)) = file.callee(&Name::new(name))
            {
                enter(&import.file);
            }
        }
    }
    names
}
