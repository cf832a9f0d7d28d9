//! What runs a program in a controller: an organization block that calls the program's block in every cycle, and the data
//! block of that call. Both have names of their own, so that nothing of a project is replaced where they are imported: next
//! to `Main` a controller runs any further organization block of the cycle.

use super::Project;
use super::operand::address;
use crate::model::{Body, Kind, Net, Network, Part, RAIL, Role, Type, Unit, Wire};
use ladder_analysis::names::scope::TagFacts;
use ladder_syntax::Name;

/// The data block and the organization block for the block of a program. Inputs and outputs with addresses are connected to
/// these, all others are left open: they keep their values in the data block, and others may write them there.
pub(super) fn caller(project: &Project<'_>, program: &Unit) -> [Unit; 2] {
    let data = Unit {
        kind: Kind::Data,
        name: format!("{}_DB", program.name),
        returns: Some(Type::Named(program.name.clone())),
        ..Unit::default()
    };
    let mut call = Part::named(format!("\"{}\"", data.name));
    for tag in &project.analysis.context.scopes[0].tags {
        let Some(there) = tag.cold.address.as_deref().map(address) else {
            continue;
        };
        call = match role(program, tag) {
            Some(Role::Input) => call.given(tag.name.to_string(), there),
            Some(Role::Output) => call.taken(tag.name.to_string(), there),
            _ => call,
        };
    }
    let wire = Wire {
        from: RAIL,
        to: None,
        parts: vec![call],
    };
    let network = Network {
        body: Body::Ladder(Net {
            points: 1,
            wires: vec![wire],
        }),
        ..Network::default()
    };
    let main = Unit {
        kind: Kind::Organization,
        name: format!("{}_Main", program.name),
        told: vec![format!("Calls {} in every cycle", program.name)],
        networks: vec![network],
        ..Unit::default()
    };
    [data, main]
}

/// What a tag is of the program's block.
fn role(program: &Unit, tag: &TagFacts) -> Option<Role> {
    let mut variables = program.variables.iter();
    let own = variables.find(|own| Name::new(&own.name) == Name::new(&tag.name))?;
    Some(own.role)
}
