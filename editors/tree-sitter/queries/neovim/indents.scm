; Declarations are indented, the drawing is not.

[(var_section) (type_section) (structure)] @indent.begin
["END_VAR" "END_TYPE" "END_STRUCT"] @indent.branch @indent.end
