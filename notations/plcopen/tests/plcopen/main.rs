//! PLCopen XML, read and run.

mod broken;
mod corpus;
mod elements;
mod harness;
mod projects;
mod traces;
mod written;
