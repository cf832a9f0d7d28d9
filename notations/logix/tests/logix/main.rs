//! Programs of Logix and RSLogix 500: what they become, and how that runs.

mod add_on;
mod back;
mod broken;
mod cases;
mod exports;
mod files;
mod instructions;
mod loops;
mod one_file;
mod opened;
mod operands;
mod oracle;
mod projects;
mod run;
mod texts;
mod unread;
mod written;
