-- The plugin's parts that need no server.
return function(t)
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

  local function rows(tag, window)
    local lines = vim.tbl_map(function(cells)
      return (require('ladder.waves').line(cells))
    end, require('ladder.waves').draw(tag, window))
    return table.concat(lines, '\n')
  end

  t.step('a trace is drawn with characters', function()
    local window = { first = 0, count = 12, newest = 10, here = 10, wide = 1 }
    local bit = { kind = 'bit', columns = { { 1, 0 }, { 3, 1 }, { 6, 0 }, { 7, 1 }, { 8, 2 }, { 9, 0 } } }
    t.equal('a waveform', ' ▁▁╱▔▔╲╱╲▁▁ ', rows(bit, window))
    bit.columns = { { 0, 0 }, { 2, 2 }, { 3, 0 }, { 5, 2 }, { 6, 1 } }
    t.equal('pulses within a column', '▁▁▒▁▁╱▔▔▔▔▔ ', rows(bit, window))
    local number = { kind = 'number', range = { 0, 15 } }
    number.columns = { { 0, 0, 0, 0 }, { 2, 4, 4, 4 }, { 4, 7, 7, 7 }, { 5, 8, 8, 8 }, { 6, 15, 15, 15 } }
    t.equal('a number', '     ▁█████ \n▁▁▅▅███████ ', rows(number, window))
    t.equal('a text', '│i│busy     ', rows({ kind = 'text', columns = { { -1, 'idle' }, { 2, 'busy' } } }, window))
    local ticks = { { at = 4, text = '1 s' }, { at = 8, text = '2 s' }, { at = 40, text = '3 s' } }
    local axis = require('ladder.waves').axis(ticks, window, 2)
    t.equal('the times', '  │1 s      ', (require('ladder.waves').line(axis)))
    local wide = { first = 1, count = 12, newest = 4, here = 3, wide = 3 }
    t.equal('scans with room', '▁▁▁╱▔▔╲▁▁▁▁▁', rows({ kind = 'bit', columns = { { 1, 0 }, { 2, 1 }, { 3, 0 } } }, wide))
    axis = require('ladder.waves').axis({ { at = 2, text = '20 ms' } }, wide, 1)
    t.equal('the times of scans with room', '   │20▾ms   ', (require('ladder.waves').line(axis)))
    local columns = { columns = { { 3, 0 }, { 7, 1 }, { 9, 0 } } }
    local edge = require('ladder.waves').edge
    t.equal('the next change', 7, edge(columns, 3, 1))
    t.equal('the change before', 7, edge(columns, 9, -1))
    t.equal('after the last', nil, edge(columns, 9, 1))
    t.equal('a long name', 'conve…', (require('ladder.waves').line(require('ladder.waves').cells('conveyor', 6))))
  end)
end
