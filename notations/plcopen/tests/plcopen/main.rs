//! PLCopen XML, read and run.

mod broken;
mod corpus;
mod elements;
mod harness;
mod projects;
mod ten;
mod traces;
mod written;
