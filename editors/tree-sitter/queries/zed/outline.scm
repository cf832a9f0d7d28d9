; The outline: blocks of one's own, sections with what they declare, labels and functions.

(block_definition
  "FUNCTION_BLOCK" @context
  (block_name) @name) @item
(var_section kind: _ @name) @item
(declaration name: (identifier) @name) @item
(type_declaration name: (type_name) @name) @item
(network (rung (function_block (head) @context (operand_list (label) @name)))) @item
