//! PLCopen XML, read and run.

mod corpus;
mod elements;
mod harness;
mod projects;
mod traces;
