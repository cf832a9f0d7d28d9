//! The program's text with its power: every live wire drawn as `=`.

use crate::simulation::Simulation;
use ladder_analysis::program::ElementKind;

/// The text of the program's own file with its power after the last scan. Wires that carry power are drawn with
/// `=`; everything else stays as it is, column by column. `text` must be the text that was compiled.
pub fn diagram(text: &str, simulation: &Simulation) -> String {
    diagram_of(0, text, simulation)
}

/// As [`diagram`], for another file of the program: an index into [`Program::files`].
///
/// [`Program::files`]: ladder_analysis::program::Program::files
pub fn diagram_of(file: u32, text: &str, simulation: &Simulation) -> String {
    let mut bytes = text.as_bytes().to_vec();
    let live = simulation
        .power()
        .filter(|(kind, location, on)| *on && *kind == ElementKind::Wire && location.file == file);
    for (_, location, _) in live {
        let range = usize::from(location.range.start())..usize::from(location.range.end());
        // A comment that joins two wires is a wire too, but keeps its text.
        if let Some(wire) = bytes
            .get_mut(range)
            .filter(|wire| wire.iter().all(|&byte| byte == b'-'))
        {
            wire.fill(b'=');
        }
    }
    // Only ASCII was replaced by ASCII.
    String::from_utf8(bytes).unwrap_or_else(|_| text.to_owned())
}
