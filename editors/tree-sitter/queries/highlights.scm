; Colours. One file for all editors: no node is matched twice, for which match wins differs between them, and no predicate is
; needed. The names are those that each editor knows, or knows the beginning of.

(comment) @comment

; The drawing

[(wire) (rail)] @punctuation.delimiter
[(rail_connector) (down_connector) (up_connector)] @punctuation.special

; Blocks

(mnemonic) @function.builtin
(block_name) @function
(label) @label
(parameter) @variable.parameter

["(" ")" "[" "]"] @punctuation.bracket
(head ["<" ">"] @punctuation.bracket)
(block_definition ["<" ">"] @punctuation.bracket)
["," ":" ";" "."] @punctuation.delimiter

; Expressions

(identifier) @variable
(member) @variable.member
[(system) (address)] @variable.builtin
(function) @function.builtin
(constant) @constant.builtin
(boolean) @constant.builtin.boolean
[(number) (duration) (date)] @constant.numeric
(string) @string
(escape) @string.escape

(binary_expression ["=" "<>" "<" "<=" ">" ">=" "+" "-" "*" "/" "^"] @operator)
(binary_expression ["OR" "XOR" "AND" "SHL" "SHR" "MOD"] @keyword.operator)
(unary_expression "-" @operator)
(unary_expression "NOT" @keyword.operator)
[":=" "=>" ".."] @operator

; Declarations

[
  "VAR" "VAR_INPUT" "VAR_OUTPUT" "VAR_IN_OUT" "VAR_GLOBAL" "VAR_EXTERNAL" "END_VAR"
  "RETAIN" "CONSTANT" "NON_RETAIN" "AT" "ARRAY" "OF"
  "TYPE" "END_TYPE" "STRUCT" "END_STRUCT"
  "FUNCTION_BLOCK" "END_FUNCTION_BLOCK"
] @keyword
(builtin_type) @type.builtin
(type_name) @type
