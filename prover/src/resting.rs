//! What of a program rests on unread parts: what a run of the simulator shows of it may be otherwise on the controller.

use crate::causes::left_open;
use crate::encode::Times;
use crate::model::build_with_points;
use crate::sure::depending;
use ladder_simulator::Simulation;
use std::collections::BTreeMap;

/// The values that depend on what unread parts write, by the names of their tags in lower case, with the sentence that names the part.
pub fn resting_on_unread(simulation: &Simulation) -> BTreeMap<String, String> {
    if simulation.program().unread_parts().next().is_none() {
        return BTreeMap::new();
    }
    let (model, points) = build_with_points(simulation, Times::Exact);
    let depends = depending(&model);
    let resting = points.into_iter().filter_map(|(point, bits)| {
        let bit = bits.into_iter().find(|bit| depends[bit.node()])?;
        let (why, _) = left_open(&model, bit).into_iter().next()?;
        Some((point.name.to_lowercase(), why))
    });
    resting.collect()
}
