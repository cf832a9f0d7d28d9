//! How wide texts are.

/// The columns that a text takes.
pub(super) fn columns(text: &str) -> u32 {
    #[cfg(test)]
    tests::MEASURED.with(|measured| measured.set(measured.get() + 1));
    ladder_format::display_width(text)
}

/// No text in a drawing takes more columns: one of a megabyte would make all lines of its network as wide.
const MOST_COLUMNS: u32 = 1000;

/// A text as it is drawn: all of it, but for one that is too long.
pub(super) fn shortened(text: String) -> String {
    // A character takes a column at the most for each of its bytes.
    if text.len() <= MOST_COLUMNS as usize || columns(&text) <= MOST_COLUMNS {
        return text;
    }
    let mut taken = 0;
    let fits = |letter: &char| {
        taken += columns(letter.encode_utf8(&mut [0; 4]));
        taken < MOST_COLUMNS
    };
    text.chars().take_while(fits).chain(['…']).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{Options, picture};
    use ladder_analysis::analyze;
    use ladder_syntax::parse;
    use std::cell::Cell;
    use std::sync::Arc;

    thread_local! {
        /// How many texts have been measured.
        pub(super) static MEASURED: Cell<usize> = const { Cell::new(0) };
    }

    /// How many texts are measured to draw a block with this many operands.
    fn measured(operands: usize) -> usize {
        let text = format!("+--[ADD]( y{} )--+\n", ", a".repeat(operands));
        let analysis = analyze(&Arc::new(parse(&text)), "program");
        MEASURED.with(|measured| measured.set(0));
        let picture = picture(&analysis.context, &Options::default());
        assert!(picture.shapes.len() > operands);
        MEASURED.with(Cell::get)
    }

    #[test]
    fn a_text_that_is_too_long_is_cut() {
        let long = "ö".repeat(1000);
        assert_eq!(super::shortened(long.clone()), long);
        assert_eq!(super::shortened(long + "x"), format!("{}…", "ö".repeat(999)));
    }

    #[test]
    fn the_work_grows_with_the_operands_and_no_faster() {
        assert!(measured(100) <= 1000, "{}", measured(100));
        assert!(measured(900) <= 9000, "{}", measured(900));
    }
}
