-- The plugin's parts that need no server, on the cases that every editor's plugin must pass alike.
return function(t)
  local labels = require('ladder.labels')
  local value = require('ladder.value')
  local comment = require('ladder.comment')

  local function read(name)
    return vim.json.decode(table.concat(vim.fn.readfile(vim.env.LADDER_ROOT .. '/editors/shared/' .. name), '\n'))
  end

  for _, case in ipairs(read('comments.json')) do
    t.step('comments: ' .. case.name, function()
      local lines, refused = comment.toggle(case.before)
      t.equal('the refused line', case.refused, refused)
      t.equal('the lines', case.after, lines)
      if lines then
        t.equal('the lines, toggled again', case.again, (comment.toggle(lines)))
      end
    end)
  end

  t.step('no program is taken from the folder that is open', function()
    local program = require('ladder.program')
    local function find(path, windows, here, there)
      return program.find('ladder', {
        path = path,
        windows = windows,
        here = here,
        is_program = function(file)
          return not there or file == there
        end,
      })
    end
    t.equal('the first that is there', '/b/ladder', find('/a:/b:/c', false, '/plant', '/b/ladder'))
    for _, path in ipairs({ '', '.', ':', 'bin', './bin', '/plant', '/plant/bin/', '/other/../plant/bin' }) do
      t.equal(path, nil, find(path, false, '/plant', nil))
    end
    t.equal('a folder of a similar name', '/plant-2/ladder', find('.:/plant-2', false, '/plant', nil))
    t.equal('the folder of everything', '/bin/ladder', find('/bin', false, '/', nil))
    t.equal('Windows', 'D:\\tools/ladder.exe', find('C:\\Plant;D:\\tools\\', true, 'c:\\plant', nil))
    for _, path in ipairs({ '', '.', ';', 'bin', 'C:bin', 'c:/PLANT/bin', 'C:\\plant' }) do
      t.equal(path, nil, find(path, true, 'C:\\plant', nil))
    end
  end)

  local cases = read('values.json')

  t.step('times read as they are written in a program', function()
    for _, case in ipairs(cases.durations) do
      t.equal(case[1] .. ' ms', case[2], value.duration(case[1]))
    end
  end)

  t.step('values read by their type', function()
    for _, case in ipairs(cases.shown) do
      t.equal(('%s %s'):format(case[1], tostring(case[2])), case[3], value.show({ type = case[1], value = case[2] }))
    end
  end)

  t.step('what is typed is sent as its type wants it, what is not understood as it is', function()
    for _, case in ipairs(cases.typed) do
      t.equal(('%s %s'):format(case[1], case[2]), case[3], value.parse(case[1], case[2]))
    end
  end)

  for _, case in ipairs(read('labels.json')) do
    t.step('labels: ' .. case.name, function()
      local given = vim.tbl_map(function(label)
        return { row = label[1], column = label[2], text = label[3], room = label[4] }
      end, case.labels)
      t.equal(
        'the places',
        case.placed,
        labels.place(given, function(row)
          return case.lines[row + 1]
        end)
      )
    end)
  end
end
