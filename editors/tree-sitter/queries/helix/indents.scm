; Declarations are indented, the drawing is not.

[(var_section) (type_section) (structure)] @indent
["END_VAR" "END_TYPE" "END_STRUCT"] @outdent
