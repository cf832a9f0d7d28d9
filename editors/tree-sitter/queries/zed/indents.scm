; Declarations are indented, the drawing is not.

(var_section "END_VAR" @end) @indent
(type_section "END_TYPE" @end) @indent
(structure "END_STRUCT" @end) @indent
