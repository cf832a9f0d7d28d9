// Where a line of the drawing ends. A line end is white space everywhere else, so a regular expression cannot tell.

#include "tree_sitter/parser.h"

enum { LINE_END, UNCLOSED, NEVER };

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
    // No rule asks for NEVER, so it is valid only while the parser recovers: there a token without text is endless.
    bool recovers = valid[NEVER];
    if (!valid[LINE_END] && !valid[UNCLOSED]) {
        return false;
    }
    lexer->mark_end(lexer);
    while (lexer->lookahead == ' ' || lexer->lookahead == '\t') {
        lexer->advance(lexer, true);
    }
    bool at_end = lexer->eof(lexer);
    if (!at_end && lexer->lookahead != '\n' && lexer->lookahead != '\r') {
        return false;
    }
    if (valid[UNCLOSED] && !recovers) {
        lexer->result_symbol = UNCLOSED;
        return true;
    }
    lexer->result_symbol = LINE_END;
    if (at_end) {
        return !recovers;
    }
    bool is_return = lexer->lookahead == '\r';
    lexer->advance(lexer, false);
    if (is_return && lexer->lookahead == '\n') {
        lexer->advance(lexer, false);
    }
    lexer->mark_end(lexer);
    return true;
}
