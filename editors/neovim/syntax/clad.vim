" Ladder text without its language server. The server's semantic tokens, where it sends them, go on top of this.
if exists('b:current_syntax')
  finish
endif

syntax case ignore

" A comment ends at the very next #, which may be lines below.
syntax region cladComment start=/#/ end=/#/ contains=cladTodo,cladDirective keepend
syntax keyword cladTodo TODO FIXME XXX contained
syntax match cladDirective /\<ladder:\s*\%(allow-file\|allow\|fmt\s\+\%(on\|off\)\|profile\)\>/ contained

" The rails, wires and connectors.
syntax match cladWire /-\+/
syntax match cladRail /[+|]/
syntax match cladConnector /[\\/]/

" A block: its first part says what it is, the parentheses after it what it works on.
syntax match cladBlock /\[[^][#()]*\]/ nextgroup=cladOperands skipwhite
syntax match cladContact /\[\s*[PN\/]\?\s*\]/ nextgroup=cladOperands skipwhite
syntax match cladFlow /<\$\?\w*>/ nextgroup=cladOperands skipwhite
syntax match cladCoil /(\s*\%([A-Z/]*\|\$\w*\)\s*)\ze\s*(/ nextgroup=cladOperands skipwhite
syntax region cladOperands matchgroup=cladBracket start=/(/ end=/)/ oneline contained
      \ contains=cladNested,cladString,cladLiteral,cladNumber,cladConstant,cladNamed,cladOperator,cladTag,cladInnerComment
syntax region cladNested start=/(/ end=/)/ oneline contained transparent
      \ contains=cladNested,cladString,cladLiteral,cladNumber,cladConstant,cladNamed,cladOperator,cladTag,cladInnerComment

" Every # that no literal has taken.
syntax region cladInnerComment start=/#/ end=/#/ contained contains=cladTodo
syntax match cladTag /\%([[:alpha:]_%]\|[^\d0-\d127]\)\%([[:alnum:]_.]\|[^\d0-\d127]\)*/ contained
syntax match cladNamed /\<\w\+\ze\s*\%(:=\|=>\)/ contained
syntax match cladNumber /\<\d[0-9_]*\%(\.\d[0-9_]*\)\?\%(e[+-]\?\d\+\)\?\>/ contained
syntax match cladNumber /\<\d[0-9_.]*\%([dhm]\|ms\|us\|ns\|s\)[0-9dhmsun_.]*\>/ contained
syntax match cladLiteral /\.\@1<!\<\%(\d[0-9_]*\|T\|L\?TIME\|D\|DATE\|TOD\|TIME_OF_DAY\|DT\|DATE_AND_TIME\|BOOL\|BYTE\|[DL]\?WORD\|U\?[SDL]\?INT\|L\?REAL\|STRING\)#-\?\%(\%(2\|8\|16\)#\)\?[0-9A-Za-z_.:-]\+/ contained
syntax match cladOperator /:=\|=>\|<>\|<=\|>=\|\.\.\|[-+*\/^=<>]/ contained
syntax keyword cladOperator AND OR XOR NOT MOD SHL SHR contained
syntax keyword cladConstant TRUE FALSE PI contained
syntax region cladString start=/'/ skip=/\$'/ end=/'/ oneline contained

" Declarations and definitions of blocks.
syntax keyword cladSection FUNCTION_BLOCK END_FUNCTION_BLOCK
syntax region cladDeclarations matchgroup=cladSection
      \ start=/\<VAR\%(_INPUT\|_OUTPUT\|_IN_OUT\|_GLOBAL\|_EXTERNAL\)\?\>\%(\s\+\%(RETAIN\|CONSTANT\)\>\)\?/
      \ end=/\<END_VAR\>/
      \ contains=cladInnerComment,cladType,cladString,cladLiteral,cladNumber,cladConstant,cladAt,cladTypeName
syntax region cladDeclarations matchgroup=cladSection start=/^\s*TYPE\>/ end=/\<END_TYPE\>/
      \ contains=cladInnerComment,cladType,cladString,cladLiteral,cladNumber,cladConstant,cladAt,cladStructure,cladTypeName
syntax keyword cladAt AT ARRAY OF contained
syntax keyword cladStructure STRUCT END_STRUCT contained
" A type of one's own, after the colon and after OF. A keyword goes first.
syntax match cladTypeName /\%(:\s*\|\<OF\s\+\)\@<=\$\?[[:alpha:]_]\w*/ contained
syntax keyword cladType BOOL BYTE WORD DWORD LWORD SINT INT DINT LINT USINT UINT UDINT ULINT contained
syntax keyword cladType REAL LREAL TIME DATE TOD DT STRING TON TOF TP RTO RTOF CTU CTD CTUD CTC SR RS contained

highlight default link cladComment Comment
highlight default link cladInnerComment Comment
highlight default link cladTodo Todo
highlight default link cladDirective PreProc
" What a word is, here and from the server's tokens. Other links go first: those of a colour scheme, and your own.
highlight default link LadderInput Identifier
highlight default link LadderOutput String
highlight default link LadderTag @variable
highlight default link LadderContact Special
highlight default link LadderCoil Removed
highlight default link LadderBlock Statement
highlight default link @lsp.type.variable.clad LadderTag
highlight default link @lsp.type.function.clad LadderBlock
highlight default link @lsp.typemod.variable.input.clad LadderInput
highlight default link @lsp.typemod.parameter.input.clad LadderInput
highlight default link @lsp.typemod.variable.output.clad LadderOutput
highlight default link @lsp.typemod.parameter.output.clad LadderOutput
highlight default link @lsp.typemod.function.contact.clad LadderContact
highlight default link @lsp.typemod.function.coil.clad LadderCoil

highlight default link cladWire Normal
highlight default link cladRail Delimiter
highlight default link cladConnector Special
highlight default link cladContact LadderContact
highlight default link cladCoil LadderCoil
highlight default link cladBlock LadderBlock
highlight default link cladFlow Keyword
highlight default link cladBracket Delimiter
highlight default link cladTag LadderTag
highlight default link cladNamed Label
highlight default link cladNumber Number
highlight default link cladLiteral Number
highlight default link cladOperator Operator
highlight default link cladConstant Constant
highlight default link cladString String
highlight default link cladSection Keyword
highlight default link cladAt Keyword
highlight default link cladType Type
highlight default link cladTypeName Type
highlight default link cladStructure Keyword

" Where a line begins as a rung does, no comment is open: colours are worked out from there, whatever is above. A comment
" with such a line in it is coloured by the server's tokens.
syntax sync clear
syntax sync match cladSyncRung grouphere NONE /^[+|\\/\[<]/
syntax sync minlines=20 maxlines=400

let b:current_syntax = 'clad'
