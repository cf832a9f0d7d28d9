//! Programs of Logix and RSLogix 500: what they become, and how that runs.

mod cases;
mod files;
mod run;
