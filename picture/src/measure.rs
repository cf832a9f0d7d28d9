//! How wide texts are.

/// The columns that a text takes.
pub(super) fn columns(text: &str) -> u32 {
    #[cfg(test)]
    tests::MEASURED.with(|measured| measured.set(measured.get() + 1));
    ladder_format::display_width(text)
}

#[cfg(test)]
mod tests {
    use super::super::{Options, scene};
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
        let scene = scene(&analysis.context, &Options::default());
        assert!(scene.shapes.len() > operands);
        MEASURED.with(Cell::get)
    }

    #[test]
    fn the_work_grows_with_the_operands_and_no_faster() {
        assert!(measured(100) <= 1000, "{}", measured(100));
        assert!(measured(900) <= 9000, "{}", measured(900));
    }
}
