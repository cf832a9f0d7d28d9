" Scenarios of ladder programs.
if exists('b:current_syntax')
  finish
endif

" What a row is about is first; after an arrow is what is expected.
syntax match laddertestTag /^\s*[^ \t#"'=]\+/
syntax match laddertestArrow /=>/
syntax match laddertestHeading /^\s*\%(program\|step\|interval\|tolerance\)\>/
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
highlight default link laddertestComment Comment

let b:current_syntax = 'laddertest'
