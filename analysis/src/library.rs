//! The blocks of the library (LANGUAGE §5.7), as files that every other file sees. They are read when a file first names a
//! block that its workspace does not define.

use crate::exporting::exports;
use crate::other_files::exports::Exports;
use crate::other_files::others::{Exported, Others};
pub use ladder_library::{SOURCES, Source, Use};
use ladder_syntax::parse;
use std::sync::{Arc, OnceLock};

/// What the names of the library's files begin with. No file of a workspace has such a name: two slashes stand next to each
/// other in no path that was taken apart.
const PLACE: &str = "library://";

impl Exported {
    /// Of all files of a workspace, which sees the library too. Where several files offer one name the first of them stands
    /// for all.
    pub fn new(files: Vec<Arc<Exports>>) -> Exported {
        Exported::with(files, Some(offered))
    }
}

impl Others {
    /// As a file sees them that is alone: the library.
    pub fn alone() -> Others {
        static NOTHING_ELSE: OnceLock<Arc<Exported>> = OnceLock::new();
        let exported = NOTHING_ELSE.get_or_init(|| Arc::new(Exported::new(Vec::new())));
        exported.others_of("")
    }
}

/// The name of a block's file.
fn file_of(source: &Source) -> String {
    format!("{PLACE}{}.clad", source.name.trim_start_matches('$'))
}

/// What the library offers.
pub(crate) fn offered() -> &'static Arc<Exported> {
    static OFFERED: OnceLock<Arc<Exported>> = OnceLock::new();
    OFFERED.get_or_init(|| {
        let files = SOURCES
            .iter()
            .map(|source| Arc::new(exports(&Arc::new(parse(source.text)), &file_of(source))));
        Arc::new(Exported::with(files.collect(), None))
    })
}

/// The block whose file has a name, if it is one of the library's.
pub fn source(file: &str) -> Option<&'static Source> {
    let name = file.strip_prefix(PLACE)?.strip_suffix(".clad")?;
    SOURCES.iter().find(|source| source.name[1..] == *name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze::{Analysis, AnalyzeOptions, analyze};
    use crate::link::library_analysis;

    /// The library must not be asked for.
    fn unread() -> &'static Arc<Exported> {
        panic!("the library is read");
    }

    fn analyze_unread(text: &str) -> Analysis {
        let others = Arc::new(Exported::with(Vec::new(), Some(unread))).others_of("");
        analyze(
            &Arc::new(parse(text)),
            AnalyzeOptions::new("program").among(&others),
        )
    }

    const OWN: &str =
        "FUNCTION_BLOCK [$Toggle]\nEND_FUNCTION_BLOCK\n+--[$toggle]( )--[TON]( t, 5s )--( )( y )--+\n";

    #[test]
    fn a_program_without_a_block_of_it_reads_nothing_of_it() {
        assert!(!analyze_unread(OWN).has_errors());
    }

    #[test]
    #[should_panic(expected = "the library is read")]
    fn a_program_with_a_block_of_it_reads_it() {
        analyze_unread(&OWN.replace("[$toggle]", "[$Blink]"));
    }

    #[test]
    fn its_blocks_are_read_where_they_are_used() {
        for source in SOURCES {
            let own = library_analysis(&file_of(source)).expect("it is one of them");
            assert!(!own.has_errors(), "{}", source.name);
            // What one block defines another one sees.
            let user = format!(
                "FUNCTION_BLOCK [$User]\n+--[{}]( )--+\nEND_FUNCTION_BLOCK\n",
                source.name
            );
            let others = offered().others_of("library://User.clad");
            let options = AnalyzeOptions::new("library://User.clad").among(&others);
            let user = analyze(&Arc::new(parse(&user)), options);
            let used = user
                .context
                .user_blocks
                .iter()
                .find(|block| block.name == source.name);
            let file = used.and_then(|block| block.file()).expect("it is known");
            assert_eq!(**file, *file_of(source));
        }
        let alone = analyze(&Arc::new(parse("+--[$blink]( )--( )( y )--+\n")), "program");
        assert_eq!(
            &**alone.context.user_blocks[0].file().expect("it is not its own"),
            "library://Blink.clad"
        );
    }
}
