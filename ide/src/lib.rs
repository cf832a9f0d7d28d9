//! What an editor asks of ladder text: one file for each feature.
//!
//! Plain types in and out, byte offsets, no protocol: the language server turns them into its messages. All of it reads
//! the [`Context`](ladder_analysis::context::Context) of a file: its names, networks and blocks. Only what fixes findings
//! asks for an [`Analysis`](ladder_analysis::Analysis), which takes longer to make.

mod body;
mod call_hierarchy;
mod comments;
mod completion;
mod declarations;
mod definition;
mod described;
mod drawing;
mod exclusive;
#[cfg(test)]
mod features_of_names;
#[cfg(test)]
mod fixture;
mod folding;
mod highlight;
mod hover;
mod inlay;
mod jumps;
mod lens;
mod links;
mod locate;
pub mod markdown;
mod neighbour;
mod on_type;
mod outline;
mod palette;
mod path;
mod redraw;
mod refactor;
mod references;
mod rename;
mod rule_page;
mod scenario;
mod selection;
mod semantic_tokens;
mod signature;
mod symbol;
mod target;
mod toggle_comment;
mod typing;
mod wanted;
mod workspace_symbols;

pub use call_hierarchy::{Caller, CallerKind, Calls, callers_at, incoming_calls, outgoing_calls};
pub use completion::{
    Completion, CompletionKind, Completions, Snippet, Topic, card, completions, documentation,
};
pub use declarations::{DeclaredRow, Row, declarations};
pub use definition::{declaration, definition, implementation, type_definition};
pub use drawing::beside::Side;
pub use exclusive::{Exclusive, exclusive_outputs, place_of_new as place_of_new_property};
pub use folding::{Fold, folds};
pub use highlight::{Highlight, highlights};
pub use hover::{Hover, hover, used_in_other_files};
pub use inlay::{Inlay, inlays};
pub use ladder_instructions::Profile;
pub use lens::{Lens, LensKind, lenses};
pub use links::{Link, LinkTarget, links};
pub use neighbour::{Alone, ScenarioFile, Which, Workspace, gathered};
pub use on_type::{TRIGGERS, on_type};
pub use outline::{OutlineKind, Outlined, outline};
pub use palette::{PaletteRow, palette};
pub use redraw::{
    Asked, Change, Declared, Given, Neighbours, Offer, Offered, Redraw, Redrawn, change, offer, points_of,
    redraw,
};
pub use refactor::{Action, ActionKind, fix_all, quick_fixes, refactorings};
pub use references::{Reference, references, scenario_references};
pub use rename::{
    Renamable, RenameRefused, Renamed, prepare_rename, prepare_scenario_rename, rename, rename_in_scenario,
};
pub use rule_page::rule_page;
pub use scenario::{
    ScenarioPart, Scenarios, SceneAttribute, scenario_completions, scenario_definition, scenario_highlights,
    scenario_hover, scenario_layout, scenario_on_type, scenario_outline, scene_completions, scene_hover,
};
pub use selection::selections;
pub use semantic_tokens::{Modifiers, Token, TokenKind, semantic_tokens, semantic_tokens_of};
pub use signature::{Parameter, Signature, SignatureHelp, signature_help};
pub use symbol::Usage;
pub use target::Target;
pub use toggle_comment::toggle_comment;
pub use workspace_symbols::{Named, workspace_symbols};
