" Scenarios of ladder programs.
if exists('b:current_syntax')
  finish
endif

" What a row is about is first; after an arrow is what is expected.
syntax match laddertestTag /^\s*[^ \t#"'=]\+/
syntax match laddertestArrow /=>/
syntax match laddertestHeading /^\s*\%(program\|plant\|connect\|step\|interval\|tolerance\)\>/
" How long the steps below are; expected of a tag of that name is something with an arrow.
syntax match laddertestHeading /^\s*time\>\%(\s*=>\)\@!/
syntax match laddertestScenario /^\s*scenario\>/
syntax match laddertestName /"[^"]*"/
syntax match laddertestText /'\%(\$.\|[^'$]\)*'/
syntax match laddertestLow /\%(^\s*\S\+.*\)\@<=\<_\+\>/
syntax match laddertestHigh /\%([ \t_.]\)\@<=-\+\ze\%([ \t_.]\|$\)/
syntax match laddertestNumber /\%(\s\)\@<=-\?\d[0-9A-Za-z_.:#-]*/
syntax match laddertestNumber /\%(\s\)\@<=\a\+#[0-9A-Za-z_.:-]\+/
syntax match laddertestTolerance /\%(±\|+-\)\s*\S\+/
" Properties and assumptions; a row of a tag that is called so has an arrow, or levels and nothing else.
syntax match laddertestProperty /^\s*\%(assume\|always\|never\|when\|after\|within\|possible\|no\%(\s\+faults\)\@=\)\>\%(\s*=>\|[-_. \t]*$\)\@!.*$/ contains=laddertestForm,laddertestPast,laddertestOperator,laddertestSpan,laddertestText,laddertestComment
syntax match laddertestProperty /^\s*property\s\+".*$/ contains=laddertestForm,laddertestName,laddertestPast,laddertestOperator,laddertestSpan,laddertestText,laddertestComment
syntax match laddertestForm /\<\%(property\|assume\|always\|never\|when\|until\|after\|within\|of\|possible\|no\|faults\|scans\=\)\>/ contained
syntax match laddertestPast /\<\%(rises\|falls\|was\)\ze\s*(/ contained
syntax match laddertestOperator /\c\<\%(not\|and\|or\|xor\|mod\)\>/ contained
syntax match laddertestOperator /[-+*\/=<>&:]/ contained
syntax match laddertestSpan /\%([[:alnum:]_.]\)\@1<!\%(\d\|\a\+#\)[0-9A-Za-z_.#]*/ contained
" A # right after a letter or digit belongs to a literal.
syntax match laddertestComment /\%([[:alnum:]]\)\@1<!#.*$/

highlight default link laddertestTag Identifier
highlight default link laddertestArrow Operator
highlight default link laddertestHeading Keyword
highlight default link laddertestScenario Keyword
highlight default link laddertestName Title
highlight default link laddertestText String
highlight default link laddertestLow NonText
highlight default link laddertestHigh Special
highlight default link laddertestNumber Number
highlight default link laddertestTolerance Constant
highlight default link laddertestProperty Identifier
highlight default link laddertestForm Keyword
highlight default link laddertestPast Function
highlight default link laddertestOperator Operator
highlight default link laddertestSpan Number
highlight default link laddertestComment Comment

let b:current_syntax = 'laddertest'
