-- The keys of the diagram that draw: each with what is asked, what is typed, and the program that comes of it.

local LINE = '+--[ ]( start )--[/]( stop )--( )( run )--+'
local BRANCH = { '+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+', '|  /--[ ]( run )--/  |' }

--- The program without what the layout adds: all wires have one length.
local function undrawn(lines)
  return vim.tbl_map(function(line)
    return (line:gsub('%-%-+', '--'):gsub('  +', '  '):gsub('%s+$', ''))
  end, lines)
end

--- Keys, where the cursor is (the text there, or a column with a row below it), what is typed for each question, and the program
--- before and after.
local cases = {
  { '\\c', 'start', { 'door' }, { LINE }, { '+--[ ]( start )--[ ]( door )--[/]( stop )--( )( run )--+' } },
  { '\\C', 'start', { '' }, { LINE }, { '+--[ ]( start )--[/]( contact_1 )--[/]( stop )--( )( run )--+' } },
  { '\\c', '──┤   ├', { 'door' }, { LINE }, { '+--[ ]( door )--[ ]( start )--[/]( stop )--( )( run )--+' } },
  { '\\q', 'start', { 'lamp' }, { LINE }, {
    '+--[ ]( start )--[/]( stop )--\\--( )( run )--\\--+',
    '|  /--( )( lamp )--/  |',
  } },
  { '\\q', 'start', { 'lamp' }, { '+--[ ]( start )--[TON]( t, 5s )--+' }, { '+--[ ]( start )--[TON]( t, 5s )--( )( lamp )--+' } },
  { '\\f', 'start', { 'ton', 'warm, 5s' }, { LINE }, { '+--[ ]( start )--[TON]( warm, 5s )--[/]( stop )--( )( run )--+' } },
  { '\\i', 'start', { 'BST XIC a NXB XIO b BND' }, { LINE }, {
    '+--[ ]( start )--\\--[ ]( a )--\\--[/]( stop )--( )( run )--+',
    '|  /--[/]( b )--/  |',
  } },
  { '\\b', 'start', { 'run' }, { LINE }, BRANCH },
  { '\\B', 'start', { 'run' }, { LINE }, {
    '+--\\--[ ]( run )--\\--[/]( stop )--( )( run )--+',
    '|  /--[ ]( start )--/  |',
  } },
  { '\\\\', 'start', {}, { LINE }, { LINE }, after = { '\\/', 'stop', { 'run' }, {
    '+--\\--[ ]( start )--[/]( stop )--\\--( )( run )--+',
    '|  /--[ ]( run )--/  |',
  } } },
  { '\\\r', 'start', { 'go' }, { LINE }, { '+--[ ]( go )--[/]( stop )--( )( run )--+' } },
  { '\\/', 'start', {}, { LINE }, { '+--[/]( start )--[/]( stop )--( )( run )--+' } },
  { '\\e', 'stop', {}, { LINE }, { '+--[ ]( start )--[P]( stop )--( )( run )--+' } },
  { '\\s', 'run', {}, { LINE }, { '+--[ ]( start )--[/]( stop )--(S)( run )--+' } },
  { '\\r', 'run', {}, { LINE }, { '+--[ ]( start )--[/]( stop )--(R)( run )--+' } },
  { '\\d', 'stop', {}, { LINE }, { '+--[ ]( start )--( )( run )--+' } },
  { 'V\\d', 'start', {}, BRANCH, { '+--[ ]( run )--+' } },
  { '\\ml', 'start', {}, { LINE }, { '+--[/]( stop )--[ ]( start )--( )( run )--+' } },
  { '<M-Left>', 'stop', {}, { LINE }, { '+--[/]( stop )--[ ]( start )--( )( run )--+' } },
  { '<M-Right>', '┬──┤ / ├', {}, BRANCH, {
    '+--\\--[ ]( start )--[/]( stop )--\\--( )( run )--+',
    '|  /--[ ]( run )--/  |',
  } },
  { '\\n', 'start', { 'XIC a OTE b' }, { LINE }, { LINE, '', '+--[ ]( a )--( )( b )--+' } },
  { '\\N', 'start', { 'XIC a OTE b' }, { LINE }, { '+--[ ]( a )--( )( b )--+', '', LINE } },
  { '\\#', 'start', { 'why' }, { LINE }, { '# why #', LINE } },
  { '\\k', 'stop', {}, { LINE }, { '+--[ ]( start )--( )( split_1 )--+', '', '+--[ ]( split_1 )--[/]( stop )--( )( run )--+' } },
  { '\\j', 'start', {}, { LINE, '', '+--[ ]( a )--( )( b )--+' }, {
    '+--\\--[ ]( start )--[/]( stop )--( )( run )--\\--+',
    '|  /--[ ]( a )--( )( b )--/  |',
  } },
  { '\\y', 'start', {}, { LINE }, { LINE, '', LINE } },
  { '\\D', 'start', {}, { LINE, '', '+--[ ]( a )--( )( b )--+' }, { '+--[ ]( a )--( )( b )--+' } },
  { '\\mJ', 'start', {}, { LINE, '', '+--[ ]( a )--( )( b )--+' }, { '+--[ ]( a )--( )( b )--+', '', LINE } },
  { '<M-S-Up>', ' a ', {}, { LINE, '', '+--[ ]( a )--( )( b )--+' }, { '+--[ ]( a )--( )( b )--+', '', LINE } },
  { '<Esc>\\x', 'start', {}, { LINE }, { LINE }, after = { '\\p', 'stop', {}, { '+--[/]( stop )--[ ]( start )--( )( run )--+' } } },
  { '\\Y', 'start', {}, { LINE }, { LINE }, after = { '\\p', 'stop', {}, { '+--[ ]( start )--[/]( stop )--[ ]( start )--( )( run )--+' } } },
  { '\\a', 'start', {}, BRANCH, undrawn(BRANCH), after = { '\\d', nil, {}, { '+--[/]( stop )--( )( run )--+' } } },
  { '\\<F2>', 'start', { 'go' }, { LINE }, { '+--[ ]( go )--[/]( stop )--( )( run )--+' } },
}

return function(t, messages)
  --- The diagram that is shown next to a program with some text.
  local function shown(bufnr, lines)
    local window = vim.iter(vim.api.nvim_list_wins()):find(function(window)
      return vim.bo[vim.api.nvim_win_get_buf(window)].filetype == 'ladder_diagram'
    end)
    local drawing = vim.api.nvim_win_get_buf(window)
    -- What is sought in the diagram is not to be found in that of the text before.
    for _, text in ipairs({ {}, lines }) do
      vim.api.nvim_buf_set_lines(bufnr, 0, -1, false, text)
      vim.api.nvim_exec_autocmds('TextChanged', { buffer = bufnr })
      t.eventually('another diagram', function()
        local is_empty = vim.api.nvim_buf_get_lines(drawing, 0, 1, false)[1]:find('no network')
        return (is_empty ~= nil) == (#text == 0)
      end)
    end
    return window
  end

  --- Puts the cursor of the diagram on a text, as soon as that is drawn.
  local function go(window, text)
    vim.api.nvim_set_current_win(window)
    local drawing = vim.api.nvim_win_get_buf(window)
    t.eventually(text, function()
      for row, line in ipairs(vim.api.nvim_buf_get_lines(drawing, 0, -1, false)) do
        local at = line:find(text, 1, true)
        if at then
          vim.api.nvim_win_set_cursor(window, { row, at - 1 + #text:match('^ *') })
          return true
        end
      end
    end)
  end

  local function press(keys)
    vim.api.nvim_feedkeys(vim.keycode(keys), 'x', false)
  end

  --- Answers the questions with these texts, one after the other.
  local function answering(answers)
    local rest = vim.list_extend({}, answers)
    vim.ui.input = function(_, answer)
      answer(table.remove(rest, 1))
    end
    return rest
  end

  local function expect(bufnr, what, wanted)
    local found
    local ok = vim.wait(5000, function()
      found = undrawn(vim.api.nvim_buf_get_lines(bufnr, 0, -1, false))
      return vim.deep_equal(found, wanted)
    end, 5)
    if not ok then
      t.equal('the program after ' .. what, wanted, vim.list_extend(found, messages))
    end
  end

  --- Draws a case: where the cursor is, the keys, and the answers; then waits for the program.
  local function stroke(bufnr, window, what, keys, at, answers, after)
    if at then
      go(window, at)
    end
    local rest = answering(answers)
    press(keys)
    expect(bufnr, what, after)
    t.equal('what was not asked by ' .. what, {}, rest)
  end

  --- Opens a program with its diagram, and runs something with what is told as messages.
  local function drawing(run)
    local bufnr = t.open('motor.clad')
    vim.cmd('Ladder diagram')
    local ask, echo, told = vim.ui.input, vim.api.nvim_echo, {}
    vim.api.nvim_echo = function(chunks)
      table.insert(told, chunks[1][1])
    end
    t.clear(messages)
    local passed, why = pcall(run, bufnr, told)
    vim.ui.input, vim.api.nvim_echo = ask, echo
    assert(passed, why)
    vim.cmd('silent! bwipeout!')
  end

  t.step('each key of the diagram that draws is one change of the program', function()
    drawing(function(bufnr, told)
      for number, case in ipairs(cases) do
        local keys, at, answers, before, after = unpack(case)
        local what = ('%s on %s (case %d)'):format(keys, at, number)
        local window = shown(bufnr, before)
        t.clear(told)
        stroke(bufnr, window, what, keys, at, answers, after)
        if case.after then
          t.eventually('what is told of ' .. what, function()
            return #told > 0 or vim.fn.mode() == '\22'
          end)
          stroke(bufnr, window, what .. ', and then', unpack(case.after, 1, 4))
        end
        t.equal('the messages of ' .. what, {}, messages)
      end
    end)
  end)

  t.step('what cannot be drawn in the diagram says why', function()
    drawing(function(bufnr)
      for _, case in ipairs({
        { '\\c', 'stop', 2, 'ladder: there is nothing under the cursor to draw at: go to a wire or a block' },
        { '\\d', '├──', 0, 'ladder: there is no contact, coil or block under the cursor' },
        { '\\s', 'start', 0, 'ladder: select one contact or coil that there is such a kind of' },
        { '\\j', 'start', 0, 'ladder: no network of its program, function or block is below it' },
        { '\\mK', 'start', 0, 'ladder: no network of its program, function or block is above it' },
        { '\\ml', 'run', 0, 'ladder: the rung or the branch ends there' },
        { '\\k', '──┤   ├', 0, 'ladder: the network cannot be split here: its lines are joined on both sides, or nothing is before it' },
      }) do
        local keys, at, lines_down, why = unpack(case)
        local window = shown(bufnr, { LINE })
        go(window, at)
        if lines_down > 0 then
          vim.bo[vim.api.nvim_win_get_buf(window)].modifiable = true
          vim.fn.append('$', { '' })
          vim.bo[vim.api.nvim_win_get_buf(window)].modifiable = false
          vim.api.nvim_win_set_cursor(window, { 3, 0 })
        end
        t.clear(messages)
        press(keys)
        t.eventually('the reason of ' .. keys, function()
          return messages[1]
        end)
        t.equal('the reason of ' .. keys, { why }, messages)
        t.equal('the program after ' .. keys, { LINE }, vim.api.nvim_buf_get_lines(bufnr, 0, -1, false))
      end
    end)
  end)

  t.step('each change by a key of the diagram is undone by itself', function()
    drawing(function(bufnr)
      local window = shown(bufnr, { LINE })
      local one = '+--[ ]( start )--[ ]( a )--[/]( stop )--( )( run )--+'
      stroke(bufnr, window, 'the first', '\\c', 'start', { 'a' }, { one })
      local two = '+--[ ]( start )--[ ]( a )--[ ]( b )--[/]( stop )--( )( run )--+'
      -- The cursor is on what is new.
      t.eventually('the cursor on the contact', function()
        local block = vim.api.nvim_get_current_line():sub(1, vim.api.nvim_win_get_cursor(window)[2])
        return vim.fn.strdisplaywidth(block) > 10
      end)
      stroke(bufnr, window, 'the second', '\\c', nil, { 'b' }, { two })
      stroke(bufnr, window, 'undo', '\\u', nil, {}, { one })
      stroke(bufnr, window, 'undo', '\\u', nil, {}, { LINE })
      stroke(bufnr, window, 'redo', '\\<C-r>', nil, {}, { one })
    end)
  end)

  t.step('a name that is drawn is declared where declarations are', function()
    drawing(function(bufnr, told)
      local declared = { 'VAR_INPUT', '  start, stop : BOOL;', 'END_VAR', '', LINE }
      for answer, section in pairs({ door = 'VAR_INPUT', ['door : VAR BOOL'] = 'VAR', ['door : BOOL'] = 'VAR_INPUT' }) do
        local window = shown(bufnr, declared)
        go(window, 'start')
        t.clear(told)
        answering({ answer })
        press('\\c')
        t.eventually('what is told', function()
          return told[1]
        end)
        t.equal('what is told', 'Open contact door added; door declared as BOOL in ' .. section, told[1])
      end
    end)
  end)

  t.step('the question for a tag completes it, and marks what is new', function()
    drawing(function(bufnr)
      local window = shown(bufnr, { 'VAR  level : INT;  END_VAR', LINE })
      go(window, 'start')
      local asked
      vim.ui.input = function(question, answer)
        asked = question
        answer(nil)
      end
      press('\\c')
      t.eventually('the question', function()
        return asked
      end)
      local complete = require('ladder.diagram.operands').complete
      t.equal('what begins so', { 'start', 'stop' }, complete('st'))
      t.equal('of a number nothing', {}, complete('lev'))
      t.equal('the last word', { 'a, run' }, complete('a, ru'))
      t.equal('what is marked', {}, asked.highlight('start'))
      t.equal('what is marked', '0 4 LadderNewTag', table.concat(asked.highlight('door : VAR BOOL')[1], ' '))
      t.equal('what is marked', '0 1 LadderNewTag', table.concat(asked.highlight('t, T#5s')[1], ' '))
      t.equal('what is marked of a duration', 1, #asked.highlight('t, T#5s'))
      asked = nil
    end)
  end)

  t.step('what is drawn while the program runs is run', function()
    drawing(function(bufnr)
      local ladder = require('ladder')
      shown(bufnr, { LINE })
      vim.cmd('wincmd t')
      vim.cmd('Ladder start')
      vim.cmd('Ladder set start 1')
      vim.cmd('Ladder step')
      assert(ladder.wait(bufnr), 'no answer')
      t.equal('the coil', 'run=1', t.values(bufnr, { 'run' }))
      local window = vim.iter(vim.api.nvim_list_wins()):find(function(window)
        return vim.bo[vim.api.nvim_win_get_buf(window)].filetype == 'ladder_diagram'
      end)
      stroke(bufnr, window, 'a contact', '\\c', 'start', { 'door' }, { '+--[ ]( start )--[ ]( door )--[/]( stop )--( )( run )--+' })
      vim.api.nvim_set_current_win(vim.fn.bufwinid(bufnr))
      vim.cmd('Ladder step')
      t.eventually('the coil to drop', function()
        return t.values(bufnr, { 'run', 'start' }) == 'run=0  start=1'
      end)
      vim.cmd('Ladder stop')
    end)
  end)
end
