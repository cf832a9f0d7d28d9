//! Names, types, the program model and the diagnostics of ladder text.
