//! Names of files that every operating system takes.

use std::collections::HashSet;

/// The longest stem: with folder and ending it stays within what systems have room for.
const LONGEST: usize = 100;

/// What Windows takes for a device, whatever follows the first dot.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];

/// The name of a file of a project, or one near it: no device, not too long, and like none that was given out before, whatever
/// the case of its letters.
pub(crate) fn file_name(name: &str, taken: &mut HashSet<String>) -> String {
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let mut stem: String = stem.chars().take(LONGEST).collect();
    if is_device(&stem) {
        stem.push('_');
    }
    let mut number = 1;
    loop {
        let name = match number {
            1 => format!("{stem}.{ending}"),
            number => format!("{stem}_{number}.{ending}"),
        };
        if taken.insert(name.to_lowercase()) {
            return name;
        }
        number += 1;
    }
}

fn is_device(stem: &str) -> bool {
    let first = stem.split('.').next().unwrap_or_default().to_ascii_lowercase();
    let port = first.strip_prefix("com").or_else(|| first.strip_prefix("lpt"));
    DEVICES.contains(&first.as_str())
        || port.is_some_and(|number| number.len() == 1 && number.bytes().all(|c| c.is_ascii_digit()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_system_takes_it() {
        let mut taken = HashSet::new();
        let long = "x".repeat(300);
        let names = [
            "Main.clad",
            "main.clad",
            "CON.clad",
            "lpt1.clad",
            "Console.clad",
            "COM.clad",
        ];
        let names = names.map(|name| file_name(name, &mut taken));
        assert_eq!(
            names,
            [
                "Main.clad",
                "main_2.clad",
                "CON_.clad",
                "lpt1_.clad",
                "Console.clad",
                "COM.clad"
            ]
        );
        assert_eq!(file_name(&format!("{long}.clad"), &mut taken).len(), LONGEST + 5);
        assert_eq!(file_name(&format!("{long}y.clad"), &mut taken).len(), LONGEST + 7);
    }
}
