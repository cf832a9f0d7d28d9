//! Networks in a row, with jumps, loops, calls and switched rails among them.

use super::dice::Dice;
use super::drawing::Network;
use super::operand::{integer, place};
use super::scope::Scope;
use super::user_block::Definition;
use super::{block, wiring};
use ladder_analysis::values::types::Scalar;

/// What the networks of a region may use.
#[derive(Debug, Clone, Copy)]
pub(super) struct Region<'p> {
    /// Functions that can be called.
    pub(super) functions: &'p [String],
    /// User-defined blocks.
    pub(super) blocks: &'p [Definition],
    /// `<END>` may be here.
    pub(super) may_end: bool,
    /// Contacts and coils only.
    pub(super) is_boolean: bool,
}

impl Region<'_> {
    /// Some networks. `first` is in the first of them, before all else.
    pub(super) fn networks(
        self,
        dice: &mut Dice,
        scope: &mut Scope,
        first: &[String],
        count: usize,
    ) -> Vec<Network> {
        let mut all = Vec::new();
        if !first.is_empty() {
            all.push(self.network(dice, scope, first));
        }
        let mut label = 0;
        while all.len() < count {
            if self.is_boolean || dice.one_in(2) {
                all.push(self.network(dice, scope, &[]));
                continue;
            }
            match dice.below(9) {
                0 => self.forward(dice, scope, &mut all, &mut label),
                1 => self.back(dice, scope, &mut all, &mut label),
                2 => self.repeat(dice, scope, &mut all),
                3 => self.switched(dice, scope, &mut all),
                4 if !self.functions.is_empty() => {
                    let call = format!("<CALL>( {} )", self.functions[dice.below(self.functions.len())]);
                    all.push(self.network(dice, scope, &[call]));
                }
                5 if dice.one_in(4) => all.push(self.network(dice, scope, &["<RET>".to_owned()])),
                6 if self.may_end && dice.one_in(12) => {
                    all.push(self.network(dice, scope, &["<END>".to_owned()]));
                }
                _ => all.push(self.network(dice, scope, &[])),
            }
        }
        all
    }

    fn network(self, dice: &mut Dice, scope: &mut Scope, given: &[String]) -> Network {
        wiring::network(dice, given, &mut |dice| self.block(dice, scope))
    }

    fn block(self, dice: &mut Dice, scope: &mut Scope) -> String {
        if self.is_boolean {
            return block::boolean(dice, scope);
        }
        if !self.blocks.is_empty() && dice.one_in(8) {
            let definition = &self.blocks[dice.below(self.blocks.len())];
            return definition.call(dice, scope);
        }
        block::any(dice, scope)
    }

    /// A jump over some networks.
    fn forward(self, dice: &mut Dice, scope: &mut Scope, all: &mut Vec<Network>, label: &mut usize) {
        *label += 1;
        let name = format!("label_{label}");
        all.push(self.network(dice, scope, &[format!("<JMP>( {name} )")]));
        for _ in 0..dice.below(3) {
            all.push(self.network(dice, scope, &[]));
        }
        all.push(self.network(dice, scope, &[format!("<LBL>( {name} )")]));
    }

    /// A jump back, at most three times in a scan.
    fn back(self, dice: &mut Dice, scope: &mut Scope, all: &mut Vec<Network>, label: &mut usize) {
        *label += 1;
        let name = format!("label_{label}");
        let turns = scope.scalar(dice, Scalar::Dint, true);
        let rung = |blocks: &[String]| {
            let mut rung = vec![super::Item::Rail];
            rung.extend(blocks.iter().cloned().map(super::Item::Block));
            rung.push(super::Item::Rail);
            vec![rung]
        };
        all.push(rung(&[format!("[MOV]( {turns}, 0 )")]));
        all.push(self.network(dice, scope, &[format!("<LBL>( {name} )")]));
        all.push(rung(&[
            format!("[LT]( {turns}, {} )", dice.between(1, 3)),
            format!("[ADD]( {turns}, {turns}, 1 )"),
            format!("<JMP>( {name} )"),
        ]));
    }

    /// A loop.
    fn repeat(self, dice: &mut Dice, scope: &mut Scope, all: &mut Vec<Network>) {
        let count = integer(dice, scope, true);
        let count = if count.parse::<i64>().is_ok() {
            count
        } else {
            scope.scalar(dice, Scalar::Sint, false)
        };
        all.push(self.network(dice, scope, &[format!("<FOR>( {count} )")]));
        for _ in 0..dice.below(3) {
            if dice.one_in(6) {
                self.inner_loop(dice, scope, all);
            }
            all.push(self.network(dice, scope, &[]));
        }
        all.push(self.network(dice, scope, &["<NEXT>".to_owned()]));
    }

    /// A loop in a loop.
    fn inner_loop(self, dice: &mut Dice, scope: &mut Scope, all: &mut Vec<Network>) {
        let turns = dice.between(0, 3);
        all.push(self.network(dice, scope, &[format!("<FOR>( {turns} )")]));
        all.push(self.network(dice, scope, &[]));
        all.push(self.network(dice, scope, &["<NEXT>".to_owned()]));
    }

    /// Rails that are switched off and on.
    fn switched(self, dice: &mut Dice, scope: &mut Scope, all: &mut Vec<Network>) {
        let switch = place(dice, scope, Scalar::Bool);
        all.push(self.network(dice, scope, &[format!("[ ]( {switch} )"), "<MCR>".to_owned()]));
        for _ in 0..=dice.below(2) {
            all.push(self.network(dice, scope, &[]));
        }
        if dice.one_in(2) {
            all.push(self.network(dice, scope, &["<MCR>".to_owned()]));
        }
    }
}
