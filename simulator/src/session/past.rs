//! What a point held after each of the kept scans.

use super::Session;
use super::delta::{Way, move_cells, move_texts};
use crate::memory::Memory;
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
        let now = self.history.banks();
        let mut memory = Memory {
            bits: now.bits.clone(),
            words: now.words.clone(),
            texts: now.texts.clone(),
            ..Memory::default()
        };
        let note = |memory: &Memory, past: &mut Vec<Vec<Value>>| {
            for (point, values) in points.iter().zip(past) {
                values.push(point.read(memory));
            }
        };
        note(&memory, &mut past);
        let mut left = known - 1;
        self.history.back_from_here(|ran, given| {
            if left == 0 {
                return false;
            }
            left -= 1;
            for mut bytes in [ran, given] {
                if bytes.is_empty() {
                    continue;
                }
                move_cells(&mut bytes, &mut memory.bits);
                move_cells(&mut bytes, &mut memory.words);
                move_texts(&mut bytes, &mut memory.texts, Way::Back);
            }
            note(&memory, &mut past);
            true
        });
        for values in &mut past {
            values.reverse();
        }
        past
    }
}
