-- A person's first hour in Neovim, step by step: open, see an error, ask, align, simulate.
package.path = vim.env.LADDER_ROOT .. '/tests/editors/neovim/?.lua;' .. package.path
local t = require('harness')

require('units')(t)
require('readable')(t)
require('typed')(t)
require('drawn')(t)
require('long')(t)
require('debugging')(t)
require('missing')(t)
require('scenario_files')(t)

local messages = {}
vim.notify = function(message)
  table.insert(messages, message)
end

require('language')(t)
require('scenarios')(t, messages)
require('proofs')(t, messages)
require('conversion')(t, messages)
require('revisions')(t, messages)
require('simulating')(t, messages)
require('changing')(t, messages)
require('online')(t, messages)
require('keys')(t, messages)
require('power')(t, messages)
require('views')(t)
require('strokes')(t, messages)
require('arrays')(t)
require('click')(t, messages)
require('structured_text')(t)

t.run()
