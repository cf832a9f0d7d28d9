-- The grammar against all programs of the project, and its queries. Started by tests/grammar/run.
local root = vim.env.LADDER_ROOT
local grammar = root .. '/editors/tree-sitter'
package.path = root .. '/tests/editors/neovim/?.lua;' .. package.path
local t = require('harness')

local function read(path)
  local file = assert(io.open(path, 'rb'))
  local text = file:read('*a')
  file:close()
  return text
end

--- The files below a folder whose names match, sorted.
local function files(folder, pattern)
  local found = vim.fs.find(function(name)
    return name:match(pattern) ~= nil
  end, { path = root .. '/' .. folder, limit = math.huge, type = 'file' })
  table.sort(found)
  assert(#found > 0, folder .. ' holds no ' .. pattern)
  return found
end

local function tree(text)
  return vim.treesitter.get_string_parser(text, 'clad'):parse(true)[1]:root()
end

--- The tree without the names of fields, as `tree-sitter test` compares it.
local function shape(text)
  return (text:gsub('[%w_]+: ', ''):gsub('%s+', ' '):gsub(' %)', ')'):gsub('^ ', ''):gsub(' $', ''))
end

--- What the grammar cannot read, one line each.
local function unread(place, text, problems)
  local top = tree(text)
  if not top:has_error() then
    return
  end
  local function visit(node)
    if node:type() == 'ERROR' or node:missing() then
      local row = node:start()
      local what = node:missing() and 'MISSING ' .. node:type() or 'ERROR'
      table.insert(problems, ('%s: line %d: %s'):format(place, row + 1, what))
    elseif node:has_error() then
      for child in node:iter_children() do
        visit(child)
      end
    end
  end
  visit(top)
end

local function holds_nothing(problems)
  assert(#problems == 0, table.concat(problems, '\n'))
end

--- The programs of the project without an error.
local function healthy()
  local folders = { 'examples', 'tests/corpus', 'tests/instructions', 'tests/editors', 'library' }
  local all = {}
  for _, folder in ipairs(folders) do
    if vim.uv.fs_stat(root .. '/' .. folder) then
      vim.list_extend(all, files(folder, '%.clad$'))
    end
  end
  local command = { vim.env.LADDER_BIN, 'check', '--format', 'json', unpack(all) }
  local checked = vim.system(command, { text = true }):wait()
  assert(checked.code <= 1, checked.stderr)
  local sick = {}
  for _, finding in ipairs(vim.json.decode(checked.stdout)) do
    if finding.severity == 'error' then
      sick[finding.file] = true
    end
  end
  return vim.tbl_filter(function(file)
    return not sick[file]
  end, all), #all
end

--- The programs on the pages of the book that are right, as { place, text }.
local function of_the_book()
  local found = {}
  for _, page in ipairs(files('docs/src', '%.md$')) do
    local lines, first
    for number, line in ipairs(vim.split(read(page), '\n', { plain = true })) do
      if lines and line:match('^%s*```%s*$') then
        table.insert(found, { ('%s:%d'):format(page, first), table.concat(lines, '\n') .. '\n' })
        lines = nil
      elseif lines then
        table.insert(lines, line)
      elseif line:match('^%s*```clad') and not line:find('wrong', 1, true) then
        lines, first = {}, number
      end
    end
  end
  return found
end

--- The queries in files, by the editor they are for: '' for all.
local function queries()
  local found = {}
  for _, path in ipairs(files('editors/tree-sitter/queries', '%.scm$')) do
    found[path:sub(#grammar + #'/queries/' + 1)] = read(path)
  end
  return found
end

t.step('programs without errors give no ERROR node', function()
  local programs, all = healthy()
  assert(#programs > 60 and #programs < all, ('%d of %d programs are healthy'):format(#programs, all))
  local problems = {}
  for _, path in ipairs(programs) do
    unread(path, read(path), problems)
  end
  holds_nothing(problems)
end)

t.step('the programs of the book give no ERROR node', function()
  local programs = of_the_book()
  assert(#programs > 200, ('%d programs'):format(#programs))
  local problems = {}
  for _, program in ipairs(programs) do
    unread(program[1], program[2], problems)
  end
  holds_nothing(problems)
end)

t.step('lines end in every way, and the last need not', function()
  local text = table.concat(vim.fn.readfile(root .. '/examples/tank.clad'), '\n')
  for _, line_end in ipairs({ '\r\n', '\r' }) do
    t.equal('the tree with other line ends', tree(text):sexpr(), tree((text:gsub('\n', line_end))):sexpr())
  end
  t.equal('the tree after a byte order mark', tree(text):sexpr(), tree('\239\187\191' .. text):sexpr())
  t.equal('the tree with a line end more', tree(text):sexpr(), tree(text .. '\n'):sexpr())
end)

t.step('an error is found', function()
  local problems = {}
  unread('planted', '+--[TON]( a, , b )--( )( y )--+\n', problems)
  t.equal('what is found', 1, #problems)
end)

t.step('what is wrong or half typed takes nothing from its neighbours', function()
  local right = '+--[ ]( a )--( )( y )--+\n'
  local typed = { '[ ]( a', '[TON', '[TON]( t, ', '[ ](', '(' }
  vim.list_extend(typed, { '[ ]( a --( )( y )--+', '[ --( )( y )--+', '[EQ]( a, )--( )( y )--+', 'word--( )( y )--+' })
  for _, wrong in ipairs(typed) do
    local sound = {}
    for child in tree(right .. '+--' .. wrong .. '\n' .. right):iter_children() do
      if child:type() == 'network' and not child:has_error() then
        sound[child:start()] = child:end_()
      end
    end
    t.equal('the networks next to ' .. wrong, { 1, 3 }, { sound[0], sound[2] })
  end
end)

t.step('the trees of test/corpus are as they are written there', function()
  local problems, count = {}, 0
  for _, path in ipairs(files('editors/tree-sitter/test/corpus', '%.txt$')) do
    for name, text, wanted in read(path):gmatch('===\n([^\n]+)\n=+\n\n(.-)\n%-%-%-\n\n([^=]+)') do
      count = count + 1
      local found = shape(tree(text):sexpr())
      if found ~= shape(wanted) then
        table.insert(problems, ('%s: %s\nfound %s'):format(path, name, found))
      end
    end
  end
  assert(count >= 20, ('%d tests'):format(count))
  holds_nothing(problems)
end)

t.step('colours are as test/highlight says', function()
  local query = vim.treesitter.query.parse('clad', queries()['highlights.scm'])
  local problems, count = {}, 0
  for _, path in ipairs(files('editors/tree-sitter/test/highlight', '%.clad$')) do
    local text = read(path)
    local names = {}
    for id, node in query:iter_captures(tree(text), text) do
      local row, column, end_row, end_column = node:range()
      for at = column, (row == end_row and end_column or column + 1) - 1 do
        -- What is inside comes later.
        names[row .. ':' .. at] = query.captures[id]
      end
    end
    local row
    for number, line in ipairs(vim.split(text, '\n')) do
      local before, carets, name = line:match('^(#%s*)(%^+) ([%w.]+) #$')
      if line:match('^# <%-') then
        before, carets, name = '', '^', line:match('^# <%- ([%w.]+) #$')
      end
      if not before then
        row = number - 1
      else
        for at = #before, #before + #carets - 1 do
          count = count + 1
          if names[row .. ':' .. at] ~= name then
            table.insert(problems, ('%s:%d: column %d is %s'):format(path, number, at, tostring(names[row .. ':' .. at])))
          end
        end
      end
    end
  end
  assert(count > 100, ('%d characters'):format(count))
  holds_nothing(problems)
end)

-- Which of two matches wins differs between editors.
t.step('every token has exactly one colour', function()
  local query = vim.treesitter.query.parse('clad', queries()['highlights.scm'])
  local problems = {}
  local texts = vim.tbl_map(read, files('examples', '%.clad$'))
  for _, path in ipairs(files('editors/tree-sitter/test/corpus', '%.txt$')) do
    for text in read(path):gmatch('===\n\n(.-)\n%-%-%-\n') do
      table.insert(texts, text)
    end
  end
  for _, text in ipairs(texts) do
    local top = tree(text)
    local matches = {}
    for _, node in query:iter_captures(top, text) do
      matches[node:id()] = (matches[node:id()] or 0) + 1
    end
    local function visit(node, above)
      local found = matches[node:id()] or 0
      local row, column = node:start()
      if found > 1 or (node:child_count() == 0 and found + above == 0) then
        table.insert(problems, ('%d:%d %s has %d'):format(row + 1, column, vim.treesitter.get_node_text(node, text), found))
      end
      for child in node:iter_children() do
        visit(child, above + found)
      end
    end
    visit(top, 0)
  end
  holds_nothing(problems)
end)

t.step('queries fit the grammar and use no predicate that an editor does not know', function()
  local count = 0
  for name, text in pairs(queries()) do
    count = count + 1
    local used = {}
    for pattern, predicates in pairs(vim.treesitter.query.parse('clad', text).info.patterns) do
      for _, predicate in ipairs(predicates) do
        table.insert(used, pattern .. ': ' .. table.concat(predicate, ' '))
      end
    end
    -- Helix, Neovim and Zed know it; Emacs reads the colours only.
    local known = name == 'injections.scm' and { '1: set! injection.language comment' } or {}
    t.equal('the predicates in ' .. name, known, used)
  end
  t.equal('the number of files of queries', 11, count)
end)

t.step('each editor knows the names of what is captured', function()
  local known = {
    ['folds.scm'] = { 'fold' },
    ['injections.scm'] = { 'injection.content' },
    ['helix/indents.scm'] = { 'indent', 'outdent' },
    ['helix/textobjects.scm'] = {
      'class.around', 'class.inside', 'comment.around', 'comment.inside', 'entry.around', 'entry.inside',
      'function.around', 'function.inside', 'parameter.around', 'parameter.inside',
    },
    ['neovim/indents.scm'] = { 'indent.begin', 'indent.branch', 'indent.end' },
    ['neovim/textobjects.scm'] = {
      'block.inner', 'block.outer', 'class.inner', 'class.outer', 'comment.inner', 'comment.outer',
      'function.inner', 'function.outer', 'parameter.inner', 'parameter.outer', 'statement.outer',
    },
    ['zed/brackets.scm'] = { 'close', 'open' },
    ['zed/indents.scm'] = { 'end', 'indent' },
    ['zed/outline.scm'] = { 'context', 'item', 'name' },
    ['zed/textobjects.scm'] = { 'class.around', 'class.inside', 'comment.around', 'function.around', 'function.inside' },
  }
  for name, text in pairs(queries()) do
    if known[name] then
      local captures = vim.list_slice(vim.treesitter.query.parse('clad', text).captures)
      table.sort(captures)
      t.equal('the captures of ' .. name, known[name], captures)
    end
  end
end)

local PROGRAM = [[
TYPE
    Motor : STRUCT
        on : BOOL;
    END_STRUCT;
END_TYPE
VAR
    m : Motor;
END_VAR

FUNCTION_BLOCK [$Both]
VAR_INPUT a, b : BOOL; END_VAR
+--[ ]( a )--[ ]( b )--( )( ENO )--+
END_FUNCTION_BLOCK

# Seal-in #
+--\--[ ]( a )--\--[TON]( t, 5s )--( )( y )--+
|  |
|  /--[ ]( y )--/
+--( )( z )--+
]]

--- What each capture of a query takes of the program: its first and last line, or its text if that is one line.
local function taken(name, ...)
  local query = vim.treesitter.query.parse('clad', queries()[name])
  local found = {}
  for _, match in query:iter_matches(tree(PROGRAM), PROGRAM) do
    for id, nodes in pairs(match) do
      if vim.list_contains({ ... }, query.captures[id]) then
        local row, column = nodes[1]:start()
        local end_row, end_column = nodes[#nodes]:end_()
        local lines = vim.split(PROGRAM, '\n')
        end_row = end_column == 0 and end_row - 1 or end_row
        local text = row == end_row and lines[row + 1]:sub(column + 1, end_column > 0 and end_column or -1)
        text = ('%s %s'):format(query.captures[id], text or ('%d to %d'):format(row + 1, end_row + 1))
        table.insert(found, { row * 1000 + column, text })
      end
    end
  end
  table.sort(found, function(one, other)
    return one[1] < other[1]
  end)
  return table.concat(vim.tbl_map(function(one)
    return one[2]
  end, found), '\n')
end

t.step('what is selected is what people call so', function()
  for editor, around in pairs({ helix = 'around', zed = 'around', neovim = 'outer' }) do
    local wanted = ('function.%s +--[ ]( a )--[ ]( b )--( )( ENO )--+\nfunction.%s 16 to 18\nfunction.%s +--( )( z )--+'):gsub('%%s', around)
    t.equal('functions in ' .. editor, wanted, taken(editor .. '/textobjects.scm', 'function.' .. around))
    wanted = ('class.%s 1 to 5\nclass.%s 6 to 8\nclass.%s 10 to 13\nclass.%s VAR_INPUT a, b : BOOL; END_VAR'):gsub('%%s', around)
    t.equal('classes in ' .. editor, wanted, taken(editor .. '/textobjects.scm', 'class.' .. around))
  end
  local operands = ('a b ENO a t 5s y y z'):gsub('%S+', 'parameter.%%s %0'):gsub(' p', '\np')
  t.equal('operands in Helix', operands:gsub('%%s', 'inside'), taken('helix/textobjects.scm', 'parameter.inside'))
  t.equal('operands in Neovim', operands:gsub('%%s', 'inner'), taken('neovim/textobjects.scm', 'parameter.inner'))
end)

t.step('declarations are indented, and end where they began', function()
  local sections = 'indent 1 to 5\nindent 2 to 4\nindent 6 to 8\nindent VAR_INPUT a, b : BOOL; END_VAR'
  local ends = 'outdent END_STRUCT\noutdent END_TYPE\noutdent END_VAR\noutdent END_VAR'
  t.equal('in Helix', sections, taken('helix/indents.scm', 'indent'))
  t.equal('the ends in Helix', ends, taken('helix/indents.scm', 'outdent'))
  t.equal('in Neovim', sections:gsub('indent', 'indent.begin'), taken('neovim/indents.scm', 'indent.begin'))
  t.equal('the ends in Neovim', ends:gsub('outdent', 'indent.branch'), taken('neovim/indents.scm', 'indent.branch'))
  t.equal('the ends in Zed', ends:gsub('outdent', 'end'), taken('zed/indents.scm', 'end'))
end)

t.step('the outline of Zed', function()
  t.equal('the names', 'name Motor\nname on\nname VAR\nname m\nname $Both\nname VAR_INPUT\nname a\nname b', taken('zed/outline.scm', 'name'))
end)

t.step('Neovim without the server: colours and folds', function()
  vim.cmd.enew()
  vim.api.nvim_buf_set_lines(0, 0, -1, false, vim.split(PROGRAM, '\n', { trimempty = true }))
  vim.treesitter.start(0, 'clad')
  vim.wo.foldmethod, vim.wo.foldexpr = 'expr', 'v:lua.vim.treesitter.foldexpr()'
  -- Neovim parses for the folds when it has time.
  t.eventually('how deep each line is folded', function()
    local levels = {}
    for line = 1, vim.fn.line('$') do
      table.insert(levels, vim.fn.foldlevel(line))
    end
    return table.concat(levels) == '1222111101111001110'
  end)
  local names = vim.tbl_map(function(capture)
    return capture.capture
  end, vim.treesitter.get_captures_at_pos(0, 15, 20))
  t.equal('the colour of TON', { 'function.builtin' }, names)
end)

t.run()
