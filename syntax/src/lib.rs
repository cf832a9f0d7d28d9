//! Lexer, parser, lossless tree and wiring of the ladder text language.
