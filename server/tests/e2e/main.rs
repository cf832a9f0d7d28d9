//! Sessions between a small client and the whole server, framework included, over a pipe in the process.

mod click;
mod client;
mod companions;
mod completion;
mod configuration;
mod diagnostics;
mod features;
mod follow;
mod history;
mod hostile;
mod house;
mod lenses;
mod lifecycle;
mod navigate;
mod notations;
mod plant;
mod protocol_page;
mod pull;
mod rename;
mod semantic_tokens;
mod several_files;
mod shown;
mod simulate;
mod sync;
mod untrusted;
mod workspace;
