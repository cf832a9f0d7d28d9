//! Programs for systems that have blocks of one's own and jumps, and neither functions that see the tags of the program, nor loops of
//! networks, nor instructions on arrays.

use crate::functions::with_functions_as_blocks;
use crate::{
    Unwritable, WriteError, Writing, with_arrays_as_elements, with_loops_as_jumps, with_other_files,
};
use ladder_analysis::Analysis;

/// Writes a program, with what it uses of other files, in which all of these are said by blocks, jumps and elements.
///
/// # Errors
///
/// Those of `write`; or something of another file cannot stand in one text with the program.
pub fn with_blocks_alone(
    analysis: &Analysis,
    write: impl Fn(&Analysis, &Unwritable) -> Result<Writing, WriteError>,
) -> Result<Writing, WriteError> {
    with_other_files(analysis, |analysis, unwritable| {
        with_arrays_as_elements(analysis, &["[UNPACK]", "[FILL]"], |analysis| {
            with_loops_as_jumps(
                analysis,
                |_, _| true,
                |analysis| with_functions_as_blocks(analysis, |analysis| write(analysis, unwritable)),
            )
        })
    })
}
