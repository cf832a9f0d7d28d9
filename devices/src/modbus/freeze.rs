//! Places for tags that have none yet. What has one keeps it: an edit of the program must not move what screens know.

use super::bind::{Entry, Map, width_in};
use super::place::{Place, Table};
use ladder_analysis::program::Role;
use ladder_simulator::Simulation;

/// A map with places for the inputs and outputs of a program that have none, in the order of the program, each after the last place
/// of its table. Inputs get places that clients may write if they are allowed to, outputs such that they only read.
pub fn freeze(map: &Map, simulation: &Simulation) -> Map {
    let mut next = Table::ALL.map(|table| {
        let own = map.entries.iter().filter(|entry| entry.place.table == table);
        own.map(|entry| usize::from(entry.place.number) + entry.width)
            .max()
            .unwrap_or(0)
    });
    let mut frozen = map.clone();
    for point in simulation.points() {
        let is_there = map.entries.iter().any(|entry| entry.point == *point);
        let tables = match point.role {
            Role::Input => [Table::Coil, Table::Holding],
            Role::Output => [Table::Discrete, Table::Input],
            Role::Internal => continue,
        };
        let fits = tables
            .into_iter()
            .find_map(|table| Some((table, width_in(table, point.ty)?)));
        let Some((table, width)) = fits.filter(|_| !is_there && !point.read_only) else {
            continue;
        };
        let at = &mut next[table as usize];
        let last = u16::try_from(*at + width - 1).ok();
        if let (Some(_), Ok(number)) = (last, u16::try_from(*at)) {
            frozen.entries.push(Entry {
                place: Place { table, number },
                point: point.clone(),
                width,
                at: 0..0,
                may_be_written: false,
            });
            *at += width;
        }
    }
    frozen.entries.sort_by_key(|entry| entry.place);
    frozen
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modbus::{Named, Places};
    use crate::tests::simulation;
    use expect_test::expect;

    fn frozen(text: &str, named: &[(&str, &str)]) -> Vec<String> {
        let simulation = simulation(text, 10_000_000);
        let places = Places {
            named: Named::list(named),
            ..Places::default()
        };
        let map = Map::new(&places, &simulation).unwrap();
        let frozen = freeze(&map, &simulation);
        let is_there = |place: &Place| map.tags().any(|(other, ..)| other == *place);
        let added = frozen.tags().filter(|(place, ..)| !is_there(place));
        added
            .map(|(place, point, _)| format!("{place} {}", point.name))
            .collect()
    }

    const MIXER: &str = "VAR_INPUT\n    go AT %IX0.0 : BOOL;\n    stop : BOOL;\n    wanted : REAL;\n    name : STRING;\nEND_VAR\nVAR_OUTPUT\n    run, alarm : BOOL;\n    level : INT;\n    total : DINT;\nEND_VAR\n\
        VAR\n    n : INT;\nEND_VAR\n+--[ ]( go )--[/]( stop )--( )( run )--( )( alarm )--+\n+--[MOV]( level, n )--[TRUNC]( total, wanted )--+\n";

    #[test]
    fn what_has_no_place_gets_the_next_one() {
        expect![[r#"
            coil 0 stop
            discrete 1 run
            discrete 2 alarm
            input 0 level
            input 1 total
            holding 0 wanted"#]]
        .assert_eq(&frozen(MIXER, &[]).join("\n"));
    }

    #[test]
    fn what_has_one_keeps_it() {
        let named = [
            ("holding 100", "wanted"),
            ("discrete 7", "alarm"),
            ("input 0", "total"),
        ];
        expect![[r#"
            coil 0 stop
            discrete 8 run
            input 2 level"#]]
        .assert_eq(&frozen(MIXER, &named).join("\n"));
    }
}
