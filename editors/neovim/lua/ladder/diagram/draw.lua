--- Keys of the diagram that draw: each is one edit of the program, and one step of its undo. They work on what the cursor is on,
--- or on what is selected in visual mode.
local blocks = require('ladder.diagram.blocks')
local branches = require('ladder.diagram.branches')
local clipboard = require('ladder.diagram.clipboard')
local comments = require('ladder.diagram.comments')
local here = require('ladder.diagram.here')
local networks = require('ladder.diagram.networks')
local palette = require('ladder.diagram.palette')
local pens = require('ladder.diagram.pen')

local M = {}

local CONTACT = { block = '[ ]', title = 'Contact', operands = '' }
local CLOSED_CONTACT = { block = '[/]', title = 'Closed contact', operands = '' }
local COIL = { block = '( )', title = 'Coil', operands = '' }
local BESIDE = { block = '[ ]', title = 'Contact in parallel', operands = '' }

--- The heads that are each other's opposite.
local opposites = { ['[ ]'] = '[/]', ['[/]'] = '[ ]', ['( )'] = '(/)', ['(/)'] = '( )' }

--- The heads that one key goes through.
local kinds = { { '[ ]', '[/]', '[P]', '[N]' }, { '( )', '(/)', '(S)', '(R)', '(P)', '(N)' } }

local function opposite(head)
  return opposites[head]
end

local function next_kind(head)
  for _, heads in ipairs(kinds) do
    for index, own in ipairs(heads) do
      if own == head then
        return heads[index % #heads + 1]
      end
    end
  end
end

--- @param head string
--- @return fun(head: string): string|nil
local function coil(head)
  return function(old)
    return vim.startswith(old, '(') and head or nil
  end
end

--- What a key does with some arguments.
local function with(run, ...)
  local arguments = { ... }
  return function(pen)
    run(pen, unpack(arguments))
  end
end

local function step_of_undo(step)
  return function(pen)
    local window = vim.fn.bufwinid(pen.source)
    vim.api.nvim_buf_call(pen.source, function()
      vim.cmd('silent ' .. step)
    end)
    -- What came back is under the cursor of the program.
    pen:show(window ~= -1 and vim.lsp.util.make_position_params(window, pen:encoding()).position or nil)
  end
end

--- The keys after |<LocalLeader>|, and what each draws.
--- @type { [1]: string, [2]: string, run: fun(pen: ladder.Pen) }[]
M.keys = {
  { 'c', 'Put in a contact', run = with(pens.put, CONTACT) },
  { 'C', 'Put in a closed contact', run = with(pens.put, CLOSED_CONTACT) },
  { 'q', 'Put in a coil', run = with(branches.coil, COIL) },
  { 'f', 'Put in a block of the palette', run = palette.draw },
  { 'i', 'Put in what is typed', run = networks.entry },
  { 'b', 'Draw a contact in parallel', run = with(branches.branch, BESIDE, 'below') },
  { 'B', 'Draw a contact in parallel above', run = with(branches.branch, BESIDE, 'above') },
  { '\\', 'Begin a branch, or close it', run = with(branches.from_to, BESIDE) },
  { '<CR>', 'Write operands', run = blocks.operands },
  { '<F2>', 'Rename the tag', run = blocks.rename },
  {
    '/',
    'Make it its opposite, or close a branch',
    run = function(pen)
      if branches.is_begun(pen) then
        branches.close(pen, BESIDE)
      else
        blocks.head(pen, opposite)
      end
    end,
  },
  { 'E', 'Make it its opposite', run = with(blocks.head, opposite) },
  { 'e', 'Make it the next kind', run = with(blocks.head, next_kind) },
  { 's', 'Make it a set coil', run = with(blocks.head, coil('(S)')) },
  { 'r', 'Make it a reset coil', run = with(blocks.head, coil('(R)')) },
  { 'd', 'Delete it with its wire', run = blocks.delete },
  { 'a', 'Select the next larger group', run = blocks.larger, selects = true },
  { 'mh', 'Move it left', run = with(blocks.move, 'left') },
  { 'ml', 'Move it right', run = with(blocks.move, 'right') },
  { 'mk', 'Move it to the rung above', run = with(blocks.move, 'up') },
  { 'mj', 'Move it to the rung below', run = with(blocks.move, 'down') },
  { 'x', 'Pick it up', run = clipboard.pick_up },
  { 'Y', 'Copy it as text', run = clipboard.copy },
  { 'p', 'Put down what was picked up or copied', run = clipboard.put_down },
  { 'n', 'Write a network below', run = with(networks.write, 'below') },
  { 'N', 'Write a network above', run = with(networks.write, 'above') },
  { '#', 'Write a comment', run = comments.above },
  { 'k', 'Split the network', run = networks.split },
  { 'j', 'Join it with the next one', run = networks.join },
  { 'y', 'Draw the network once more', run = networks.duplicate },
  { 'mK', 'Move the network up', run = networks.move_up },
  { 'mJ', 'Move the network down', run = networks.move_down },
  { 'D', 'Delete the network', run = networks.delete },
  { 'u', 'Take the last change back', run = step_of_undo('undo') },
  { '<C-R>', 'Make it again', run = step_of_undo('redo') },
}

--- Lists the keys.
local function list()
  local leader = vim.g.maplocalleader or '\\'
  local lines = vim.tbl_map(function(key)
    return { ('%-8s%s\n'):format(leader .. key[1], key[2]) }
  end, M.keys)
  vim.api.nvim_echo(lines, false, {})
end

table.insert(M.keys, { '?', 'List these keys', run = list })

--- The keys that need no |<LocalLeader>|, and those that they are.
local aliases = {
  ['<M-Left>'] = 'mh',
  ['<M-Right>'] = 'ml',
  ['<M-Up>'] = 'mk',
  ['<M-Down>'] = 'mj',
  ['<M-S-Up>'] = 'mK',
  ['<M-S-Down>'] = 'mJ',
}

--- Maps the keys in the buffer of a diagram.
--- @param source integer
--- @param diagram ladder.Diagram
--- @param redraw fun() called when the program has become another one
function M.map(source, diagram, redraw)
  local pen = pens.new(source, diagram, redraw)
  local function map(lhs, key)
    vim.keymap.set({ 'n', 'x' }, lhs, function()
      pen:begin()
      key.run(pen)
      if vim.fn.mode():match('^[vV\22]') and not key.selects then
        vim.api.nvim_feedkeys(vim.keycode('<Esc>'), 'nx', false)
      end
    end, { buffer = diagram.bufnr, desc = key[2] })
  end
  local by_letters = {}
  for _, key in ipairs(M.keys) do
    by_letters[key[1]] = key
    map('<LocalLeader>' .. key[1], key)
  end
  for lhs, letters in pairs(aliases) do
    map(lhs, by_letters[letters])
  end
  for lhs, by in pairs({ ['<Tab>'] = 1, ['<S-Tab>'] = -1 }) do
    vim.keymap.set({ 'n', 'x' }, lhs, function()
      here.step(diagram, by)
    end, { buffer = diagram.bufnr, desc = by > 0 and 'Next place' or 'Place before' })
  end
end

return M
