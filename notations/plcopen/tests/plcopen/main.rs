//! PLCopen XML, read and run.

mod corpus;
mod traces;
