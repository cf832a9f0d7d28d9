//! What holds for every row of the table.

use std::collections::HashMap;

use ladder_instructions::{
    Accepts, Coil, Direction, Edge, Group, Instruction, Op, Power, Presence, Role, Shape, StateType, TABLE,
    by_op, lookup,
};

fn row(shape: Shape, spelling: &str, count: usize) -> &'static Instruction {
    lookup(shape, spelling)
        .find(|row| row.takes(count))
        .expect("such a row")
}

#[test]
fn every_op_has_its_row_in_its_place() {
    assert_eq!(TABLE.len(), Op::COUNT);
    for (index, row) in TABLE.iter().enumerate() {
        assert_eq!(row.op as usize, index, "{:?}", row.op);
        assert_eq!(by_op(row.op).op, row.op);
    }
}

#[test]
fn only_not_has_two_rows_in_the_same_brackets() {
    let mut rows: HashMap<(Shape, &str), Vec<Op>> = HashMap::new();
    for row in TABLE {
        for spelling in row.spellings() {
            rows.entry((row.shape, spelling)).or_default().push(row.op);
        }
    }
    let shared: Vec<_> = rows.into_iter().filter(|(_, ops)| ops.len() > 1).collect();
    assert_eq!(shared, [((Shape::Logical, "NOT"), vec![Op::Inverter, Op::Not])]);
}

#[test]
fn operands_stand_in_the_order_that_the_methods_rely_on() {
    let rank = |presence| match presence {
        Presence::Required => 0,
        Presence::Trailing | Presence::Repeated { .. } => 1,
        Presence::Named => 2,
    };
    for row in TABLE {
        let ranks: Vec<_> = row
            .operands
            .iter()
            .map(|operand| rank(operand.presence))
            .collect();
        assert!(ranks.is_sorted(), "{}", row.signature());
        let repeated = row
            .operands
            .iter()
            .filter(|o| matches!(o.presence, Presence::Repeated { .. }))
            .count();
        for operand in row.operands {
            if let Presence::Repeated { group, .. } = operand.presence {
                assert_eq!(usize::from(group), repeated, "{}", row.signature());
            }
        }
    }
}

#[test]
fn operand_names_differ_within_a_row() {
    for row in TABLE {
        let mut names: Vec<_> = row
            .operands
            .iter()
            .map(|operand| operand.name.to_uppercase())
            .collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), row.operands.len(), "{}", row.signature());
    }
}

#[test]
fn a_result_is_written() {
    for row in TABLE {
        for operand in row.operands {
            if matches!(operand.accepts, Accepts::Result(_)) {
                assert_ne!(operand.direction, Direction::In, "{}", row.signature());
            }
        }
    }
}

#[test]
fn conditions_write_nothing() {
    for row in TABLE.iter().filter(|row| row.role == Role::Condition) {
        assert!(
            row.operands.iter().all(|o| o.direction == Direction::In),
            "{}",
            row.signature()
        );
    }
}

#[test]
fn counts_of_operands() {
    let counts = |spelling| -> Vec<usize> {
        let rows: Vec<_> = lookup(Shape::Logical, spelling).collect();
        (0..=9)
            .filter(|count| rows.iter().any(|row| row.takes(*count)))
            .collect()
    };
    assert_eq!(counts(" "), [1]);
    assert_eq!(counts("NE"), [2]);
    assert_eq!(counts("EQ"), [2, 3, 4, 5, 6, 7, 8, 9]);
    assert_eq!(counts("ADD"), [3, 4, 5, 6, 7, 8, 9]);
    assert_eq!(counts("MOD"), [3]);
    assert_eq!(counts("NOT"), [0, 2]);
    assert_eq!(counts("TON"), [2]);
    assert_eq!(counts("PWL"), [6, 8]);
    assert_eq!(counts("SCANTIME"), [0, 1]);
    assert_eq!(counts("FMT"), [1, 2, 3, 4, 5, 6, 7, 8, 9]);
    assert_eq!(row(Shape::Logical, "SCANTIME", 0).limit(), Some(1));
    assert_eq!(row(Shape::Logical, "ADD", 3).limit(), None);
}

#[test]
fn positional_operands_repeat_in_their_group() {
    let names = |spelling, count: usize| -> Vec<&str> {
        let row = row(Shape::Logical, spelling, count);
        (0..count)
            .map_while(|index| row.positional(index))
            .map(|operand| operand.name)
            .collect()
    };
    assert_eq!(names("ADD", 5), ["y", "a", "b", "b", "b"]);
    assert_eq!(names("PWL", 8), ["y", "x", "x0", "y0", "x1", "y1", "x1", "y1"]);
    assert_eq!(names("TON", 2), ["t", "PT"]);
    assert!(row(Shape::Logical, "TON", 2).positional(2).is_none());
    assert!(row(Shape::Logical, "NOT", 0).positional(0).is_none());
}

#[test]
fn named_operands_are_found_without_case() {
    let search = row(Shape::Logical, "SEARCH", 4);
    assert_eq!(
        search.named("found").map(|operand| operand.direction),
        Some(Direction::Out)
    );
    assert!(search.named("y").is_none(), "given by place");
    assert!(search.named("R").is_none());
}

#[test]
fn what_becomes_of_power_agrees_with_the_rest_of_the_row() {
    for row in TABLE {
        let name = row.block();
        let is_coil = row.group == Group::Coil && row.op != Op::Res;
        assert_eq!(row.coil.is_some(), is_coil, "{name} writes bits as a coil");
        assert_eq!(
            row.power == Power::Output,
            row.state().is_some(),
            "{name} has an output"
        );
        assert_eq!(
            row.power == Power::SetTag,
            row.coil == Some(Coil::Sets),
            "{name} gives the tag that it sets"
        );
        let is_condition = !matches!(
            row.power,
            Power::Passes | Power::PassesIfDone | Power::Output | Power::SetTag
        );
        assert_eq!(
            is_condition,
            row.group == Group::Condition,
            "{name} decides about power"
        );
        let says = match row.power {
            Power::Passes | Power::PassesIfDone | Power::Compares => row.eno.starts_with("EN"),
            Power::Level { high } => row.eno == if high { "EN and tag" } else { "EN and not tag" },
            Power::TagEdge(Edge::Rising) => row.eno == "EN and tag rose",
            Power::TagEdge(Edge::Falling) => row.eno == "EN and tag fell",
            Power::Inverts => row.eno == "not EN",
            Power::EnEdge(Edge::Rising) => row.eno == "EN rose",
            Power::EnEdge(Edge::Falling) => row.eno == "EN fell",
            Power::Output => row.state().map(StateType::output) == Some(row.eno),
            Power::SetTag => row.eno == "the tag",
        };
        assert!(says, "ENO of {name}: {}", row.eno);
    }
}
