//! What was exercised, in the form of LCOV: rungs are lines, a contact that is closed or open is a branch.

use super::coverage::{Covered, CoveredFile};
use ladder_simulator::coverage::CoverageItemKind;
use ladder_workspace::shown;
use std::collections::BTreeMap;

pub(super) fn text(covered: &Covered) -> String {
    covered
        .files
        .iter()
        .map(|(name, file)| record(name, file))
        .collect()
}

fn record(name: &str, file: &CoveredFile) -> String {
    let mut out = format!("TN:\nSF:{}\n", shown::line(name));
    let mut lines: BTreeMap<u32, u64> = BTreeMap::new();
    for network in file.networks.values() {
        for &line in &network.lines {
            *lines.entry(line).or_default() += network.scans;
        }
    }
    let contacts = file
        .parts
        .values()
        .filter(|part| part.kind != CoverageItemKind::Coil);
    let (mut branches, mut taken) = (0, 0);
    // Contacts are numbered on their line.
    let mut numbers: BTreeMap<u32, u32> = BTreeMap::new();
    for part in contacts {
        let number = numbers.entry(part.place.line).or_default();
        // Where it was tried, a third says whether a scenario shows that it matters.
        let ways = [Some(part.on), Some(part.off), part.matters];
        for (branch, seen) in ways.into_iter().flatten().enumerate() {
            let count = match (part.on || part.off, seen) {
                (false, _) => "-",
                (true, false) => "0",
                (true, true) => "1",
            };
            out.push_str(&format!("BRDA:{},{number},{branch},{count}\n", part.place.line));
            branches += 1;
            taken += usize::from(seen);
        }
        *number += 1;
    }
    out.push_str(&format!("BRF:{branches}\nBRH:{taken}\n"));
    for (line, scans) in &lines {
        out.push_str(&format!("DA:{line},{scans}\n"));
    }
    let hit = lines.values().filter(|scans| **scans > 0).count();
    out.push_str(&format!("LF:{}\nLH:{hit}\nend_of_record\n", lines.len()));
    out
}
