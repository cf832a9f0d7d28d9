; A network is what functions are elsewhere (`maf`, `]f`), a block of one's own or a section what types are (`mat`, `]t`), a
; rung or a declaration an entry (`mae`, `]e`), an operand an argument (`mia`, `]a`).

(network) @function.around @function.inside

(block_definition [(var_section) (type_section) (network) (rail_line)]+ @class.inside) @class.around
(var_section (declaration)+ @class.inside) @class.around
(type_section (type_declaration)+ @class.inside) @class.around

[(rung) (declaration) (type_declaration)] @entry.around @entry.inside

(operand_list ([(expression) (named_operand)] @parameter.inside . ","? @parameter.around) @parameter.around)

(comment) @comment.around @comment.inside
