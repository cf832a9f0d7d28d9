//! The example of every instruction runs.

use crate::support::simulation;

#[test]
fn every_example_runs() {
    for row in ladder_instructions::TABLE {
        let mut simulation = simulation(row.example);
        let points: Vec<_> = simulation.points().to_vec();
        for scan in 0..8 {
            for point in &points {
                let inputs = point.role == ladder_analysis::program::Role::Input;
                if inputs && point.ty == ladder_analysis::values::types::Scalar::Bool {
                    let value = ladder_analysis::values::value::Value::Bool(scan % 3 == 1);
                    simulation.set(point, value).unwrap();
                }
            }
            simulation.scan();
        }
        assert!(
            simulation.take_faults().iter().all(|fault| !fault.stops),
            "{}",
            row.block()
        );
    }
}
