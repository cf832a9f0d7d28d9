; What can be folded.

[
  (network)
  (var_section)
  (type_section)
  (structure)
  (block_definition)
  (comment)
] @fold
