; A network is what functions are elsewhere, a block of one's own or a section what classes are.

(network) @function.around @function.inside

(block_definition [(var_section) (type_section) (network) (rail_line)]* @class.inside) @class.around
(var_section (declaration)* @class.inside) @class.around
(type_section (type_declaration)* @class.inside) @class.around

(comment)+ @comment.around
