//! The programs ladder and ldfmt.
