//! What a point held after each of the kept scans.

use super::Session;
use crate::tags::Point;
use ladder_analysis::value::Value;

impl Session {
    /// What points held after each of the last scans, the oldest first: for each point up to `scans` values, of which
    /// the last is from the scan that the simulation stands behind. What was given since is not in it. Only kept
    /// scans are known, so there may be fewer, equally many for all points.
    pub fn past(&self, points: &[Point], scans: usize) -> Vec<Vec<Value>> {
        let mut past: Vec<Vec<Value>> = vec![Vec::new(); points.len()];
        let known = self.history.known().min(scans);
        if known == 0 {
            return past;
        }
        let mut rewind = self.history.rewind(&self.simulation);
        for _ in 0..known {
            rewind.undo_given();
            for (point, values) in points.iter().zip(&mut past) {
                values.push(rewind.value(point));
            }
            if !rewind.undo_scan() {
                break;
            }
        }
        for values in &mut past {
            values.reverse();
        }
        past
    }
}
