--- The highlight groups. All are defaults: a colour scheme or a user's own `:highlight` goes first.
local contrast = require('ladder.contrast')

local M = {}

--- Colours that can be read, for the grounds that Neovim tells apart; with their numbers on terminals of 256 colours.
local readable = {
  dark = { DiagnosticOk = { 0xb3f6c0, 10 }, DiagnosticWarn = { 0xfce094, 11 }, DiagnosticError = { 0xffc0b9, 9 }, Comment = { 0x9b9ea4, 248 } },
  light = { DiagnosticOk = { 0x005523, 22 }, DiagnosticWarn = { 0x6b5300, 94 }, DiagnosticError = { 0x590008, 88 }, Comment = { 0x4f5258, 240 } },
}

--- The scheme's own colour for "all is well", or for what a person should look at. Schemes that do not name them have those
--- for a dark ground from Neovim, also on a light one, where nobody can read them.
local function colour(name)
  local found = vim.api.nvim_get_hl(0, { name = name, link = false })
  local own, own_cterm = unpack(readable[vim.o.background][name])
  local ground = contrast.ground()
  local is_readable = not found.fg or contrast.between(found.fg, ground) >= contrast.READABLE
  if is_readable or contrast.between(found.fg, ground) >= contrast.between(own, ground) then
    return { fg = found.fg, ctermfg = found.ctermfg or own_cterm, default = true }
  end
  return { fg = own, ctermfg = own_cterm, default = true }
end

--- Each is marked by weight or line besides its colour, so that it is seen without colours too; a link could not add that:
--- what has power is bold, a contact that lets it through is underlined, one that does not is neither; of what is in italics it is not known.
local function attributes()
  local good = colour('DiagnosticOk')
  -- Comments are quiet.
  local quiet = colour('Comment')
  local value = vim.api.nvim_get_hl(0, { name = 'Identifier', link = false })
  local with = function(base, more)
    -- The syntax makes coils bold, which means power here.
    return vim.tbl_extend('force', base, { nocombine = true }, more)
  end
  return {
    LadderPowerOn = with(good, { bold = true }),
    LadderPowerOff = with(quiet, {}),
    LadderPowerUnknown = with(quiet, { italic = true }),
    LadderClosedOn = with(good, { bold = true, underline = true }),
    LadderClosed = with(good, { underline = true }),
    LadderBlocks = with(colour('DiagnosticWarn'), {}),
    LadderStops = with(colour('DiagnosticWarn'), { reverse = true }),
    LadderForced = with(colour('DiagnosticWarn'), { bold = true }),
    LadderBreakpoint = colour('DiagnosticError'),
    LadderValue = { fg = value.fg, ctermfg = value.ctermfg or 14, default = true },
    -- It must be seen on any scheme, and over any of the colours above.
    LadderNext = { reverse = true, default = true },
  }
end

local links = {
  LadderValueOn = 'LadderPowerOn',
  LadderTagName = 'Identifier',
  LadderTagType = 'Type',
  LadderBlockName = 'Function',
  LadderNewTag = 'LadderForced',
  LadderHere = 'MatchParen',
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
