-- Programs of the book and examples, typed key by key: once by a user who looks at the screen and goes on after what
-- the editor has begun, and once by a user who looks at the book only, and types every character. Both get the
-- program that is in the book.
return function(t)
  local typing = require('typing')
  local guide = vim.env.LADDER_ROOT .. '/docs/src/guide/'

  --- The programs of a page that are right, or the program of a file.
  local function programs(page)
    if vim.endswith(page, '.clad') then
      local lines = vim.fn.readfile(guide .. page)
      lines.line = 1
      return { lines }
    end
    local found, lines = {}, nil
    for number, line in ipairs(vim.fn.readfile(guide .. page)) do
      if lines and line == '```' then
        table.insert(found, lines)
        lines = nil
      elseif lines then
        table.insert(lines, line)
      elseif line:match('^```clad') and not line:find('wrong', 1, true) then
        lines = { line = number }
      end
    end
    return found
  end

  --- What the formatter makes of lines.
  local function aligned(lines)
    local done = vim.system({ vim.env.LADDER_BIN, 'fmt', '-' }, { stdin = table.concat(lines, '\n') .. '\n', text = true }):wait()
    assert(done.code <= 1, done.stderr)
    return vim.split(vim.trim(done.stdout), '\n')
  end

  --- The text next to the cursor.
  local function around(keys)
    local line, column = unpack(keys:lua('return { vim.api.nvim_get_current_line(), vim.api.nvim_win_get_cursor(0)[2] }'))
    return line:sub(1, column), line:sub(column + 1)
  end

  --- How much of a line is there already, whatever the length of its wires and blanks; nil if something else is.
  local function there(left, wanted)
    local at = 0
    for character in left:gsub('[- ]', ''):gmatch('.') do
      at = at + 1
      while wanted:sub(at, at):match('[- ]') do
        at = at + 1
      end
      if wanted:sub(at, at) ~= character then
        return nil
      end
    end
    if left:match('[- ]$') then
      at = at + #wanted:match('^[- ]*', at + 1)
    end
    return at
  end

  --- Types one line.
  --- @param looks boolean whether what the editor has begun is seen, and left as it is
  --- @param notes string[] takes what was in the way
  local function type_line(keys, wanted, looks, notes)
    local left = around(keys)
    local at = looks and there(left, wanted) or 0
    -- A rail or another rung is typed over what was begun.
    if looks and at == 0 and vim.trim(left) ~= '' and wanted ~= '' and not wanted:match('^[#EFV+|]') then
      table.insert(notes, ('"%s" was there before "%s"'):format(left, wanted))
      keys:press('<C-u>')
    end
    while at < #wanted do
      local _, right = around(keys)
      -- The editor has written the rest already.
      if looks and vim.trim(right) ~= '' and vim.trim(right) == vim.trim(wanted:sub(at + 1)) then
        return
      end
      at = at + 1
      -- A letter of several bytes is one key.
      local key = wanted:match('^[%z\1-\127\194-\244][\128-\191]*', at)
      at = at + #key - 1
      keys:press(key == '<' and '<lt>' or key)
      if keys:lua('return vim.fn.pumvisible()') == 1 then
        table.insert(notes, 'a list opened at ' .. wanted:sub(1, at))
      end
    end
    local _, right = around(keys)
    if looks and vim.trim(right) ~= '' and vim.trim(right) ~= '|' then
      table.insert(notes, ('"%s" was left behind "%s"'):format(right, wanted))
    end
  end

  --- Types a program into a new file, and looks at what came of it.
  local function type_program(lines, looks, where)
    local keys, notes = typing.open(t, { '' }), {}
    keys:press('i')
    for number, line in ipairs(lines) do
      type_line(keys, line, looks, notes)
      if number < #lines then
        keys:press('<CR>')
        if looks then
          -- What Enter begins comes a moment later.
          vim.wait(60)
        end
      end
    end
    -- A label or a function may be there only since the last key.
    local red
    vim.wait(1000, function()
      red = #keys:lua('return vim.diagnostic.get(0, { severity = 1 })')
      return red == 0
    end)
    keys:press('<Esc>')
    vim.wait(100)
    local found = keys:lines()
    while found[#found] == '' do
      table.remove(found)
    end
    t.equal(where .. ': the program', table.concat(aligned(lines), '\n'), table.concat(aligned(found), '\n'))
    t.equal(where .. ': what was in the way', {}, notes)
    t.equal(where .. ': errors while it was typed', 0, red)
    keys:close()
  end

  for _, page in ipairs({
    'first-program.md',
    'drawing-rungs.md',
    'for-electricians.md',
    'for-programmers.md',
    'testing.md',
    'simulator.md',
    'formatter.md',
    'checks.md',
    'refactoring.md',
    '../language/blocks.md',
    '../language/drawing.md',
    '../language/execution.md',
    '../language/expressions.md',
    '../language/instructions/flow.md',
    '../language/layout.md',
    '../language/source-text.md',
    '../language/types.md',
    '../../../examples/garage_door.clad',
    '../../../examples/traffic_light.clad',
  }) do
    for how, looks in vim.spairs({ ['who looks at the screen'] = true, ['who looks at the book only'] = false }) do
      t.step(('the programs of %s, typed by a user %s'):format(page, how), function()
        for _, lines in ipairs(programs(page)) do
          type_program(lines, looks, ('%s:%d'):format(page, lines.line))
        end
      end)
    end
  end
end
