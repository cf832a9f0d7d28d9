//! PLCopen XML, read and run.

mod boxes;
mod broken;
mod charts;
mod corpus;
mod elements;
mod harness;
mod one_file;
mod oracle;
mod pins;
mod projects;
mod structured_files;
mod ten;
mod traces;
mod unread;
mod written;
