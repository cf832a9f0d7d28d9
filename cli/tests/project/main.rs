//! What needs the program `ladder`: the book's sessions and pictures, the examples, git, and generated programs.

mod book_pictures;
#[cfg(unix)]
mod book_sessions;
mod editor_menus;
mod examples;
mod formatting;
mod generated;
#[cfg(unix)]
mod git;
#[cfg(unix)]
mod git_setup;
#[cfg(unix)]
mod gitlab_recipe;
mod options;
#[cfg(unix)]
mod review_script;
mod traces;
