//! The canonical layout of ladder text.
