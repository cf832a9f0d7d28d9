// Where a line of the drawing ends. A line end is white space everywhere else, so a regular expression cannot tell.

#include "tree_sitter/parser.h"

enum { LINE_END, NEVER };

void *tree_sitter_clad_external_scanner_create(void) { return NULL; }
void tree_sitter_clad_external_scanner_destroy(void *state) { (void)state; }

// There is nothing to remember from one token to the next.
unsigned tree_sitter_clad_external_scanner_serialize(void *state, char *buffer) {
    (void)state;
    (void)buffer;
    return 0;
}
void tree_sitter_clad_external_scanner_deserialize(void *state, const char *buffer, unsigned length) {
    (void)state;
    (void)buffer;
    (void)length;
}

bool tree_sitter_clad_external_scanner_scan(void *state, TSLexer *lexer, const bool *valid) {
    (void)state;
    if (!valid[LINE_END]) {
        return false;
    }
    while (lexer->lookahead == ' ' || lexer->lookahead == '\t') {
        lexer->advance(lexer, true);
    }
    lexer->result_symbol = LINE_END;
    if (lexer->eof(lexer)) {
        // No rule asks for NEVER, so it is valid only while the parser recovers: there a token without text is endless.
        return !valid[NEVER];
    }
    if (lexer->lookahead == '\r') {
        lexer->advance(lexer, false);
        if (lexer->lookahead == '\n') {
            lexer->advance(lexer, false);
        }
        return true;
    }
    if (lexer->lookahead == '\n') {
        lexer->advance(lexer, false);
        return true;
    }
    return false;
}
