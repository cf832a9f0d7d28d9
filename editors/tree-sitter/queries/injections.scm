; Addresses, TODO and the like in comments, where the editor has the grammar `comment`.

((comment) @injection.content
  (#set! injection.language "comment"))
