--- The highlight groups. All are defaults: a colour scheme or a user's own `:highlight` goes first.
local M = {}

--- The scheme's own colour for "all is well", and the one for what a person should look at.
local function colour(name, cterm)
  local found = vim.api.nvim_get_hl(0, { name = name, link = false })
  return { fg = found.fg, ctermfg = found.ctermfg or cterm, default = true }
end

--- Each is marked by weight or line besides its colour, so that it is seen without colours too; a link could not add that:
--- what has power is bold, a contact that lets it through is underlined, one that does not is neither.
local function attributes()
  local good = colour('DiagnosticOk', 10)
  -- Comments are quiet and must be readable, in any scheme. Without a colour the syntax colours would be: then it is
  -- a grey that can be read.
  local quiet = colour('Comment', vim.o.background == 'dark' and 248 or 240)
  local with = function(base, more)
    -- The syntax makes coils bold, which means power here.
    return vim.tbl_extend('force', base, { nocombine = true }, more)
  end
  return {
    LadderPowerOn = with(good, { bold = true }),
    LadderPowerOff = with(quiet, {}),
    LadderClosedOn = with(good, { bold = true, underline = true }),
    LadderClosed = with(good, { underline = true }),
    LadderBlocks = with(colour('DiagnosticWarn', 11), {}),
    LadderStops = with(colour('DiagnosticWarn', 11), { reverse = true }),
    LadderForced = with(colour('DiagnosticWarn', 11), { bold = true }),
    LadderValue = colour('Identifier', 14),
    -- It must be seen on any scheme, and over any of the colours above.
    LadderNext = { reverse = true, default = true },
  }
end

local links = {
  LadderValueOn = 'LadderPowerOn',
  LadderBreakpoint = 'DiagnosticError',
  LadderTagName = 'Identifier',
  LadderTagType = 'Type',
  LadderBlockName = 'Function',
  LadderLow = 'LadderPowerOff',
  LadderAxis = 'LadderPowerOff',
  LadderCursorA = 'CurSearch',
  LadderCursorB = 'Visual',
  LadderCursorAValue = 'LadderValue',
  LadderCursorBValue = 'LadderValue',
}

--- What was defined here, to tell it from what a scheme or a user has defined since.
local defined = {}

local function look(name)
  local group = vim.api.nvim_get_hl(0, { name = name })
  -- Neovim forgets that it was one when the background changes.
  group.default = nil
  return group
end

--- @param name string
--- @param group table
local function define(name, group)
  local now = look(name)
  -- A default does not replace one of its own that is made for another background.
  local is_ours = defined[name] and vim.deep_equal(now, defined[name])
  vim.api.nvim_set_hl(0, name, vim.tbl_extend('force', group, { default = not is_ours }))
  if is_ours or not defined[name] then
    defined[name] = look(name)
  end
end

function M.define()
  for name, group in pairs(attributes()) do
    define(name, group)
  end
  for name, target in pairs(links) do
    vim.api.nvim_set_hl(0, name, { link = target, default = true })
  end
end

M.define()
local group = vim.api.nvim_create_augroup('ladder_highlight', {})
vim.api.nvim_create_autocmd('ColorScheme', { group = group, callback = M.define })
vim.api.nvim_create_autocmd('OptionSet', { group = group, pattern = 'background', callback = M.define })

return M
