; For nvim-treesitter-textobjects. A network is what functions are elsewhere, a block of one's own or a section what classes
; are, a rung or a declaration a statement.

(network) @function.outer @function.inner

(block_definition [(var_section) (type_section) (network) (rail_line)]+ @class.inner) @class.outer
(var_section (declaration)+ @class.inner) @class.outer
(type_section (type_declaration)+ @class.inner) @class.outer

[(rung) (declaration) (type_declaration)] @statement.outer

[(logical_block) (coil_block) (function_block)] @block.outer
(operand_list) @block.inner

(operand_list [(expression) (named_operand)] @parameter.inner @parameter.outer)

(comment) @comment.outer @comment.inner
