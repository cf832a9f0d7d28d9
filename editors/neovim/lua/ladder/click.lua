--- Programs of other systems, with their diagram next to them. One in Python is opened as such when a person says so.
local server = require('ladder.server')

local M = {}

--- The file type of a Python file that is a Click program.
M.FILETYPE = 'ladderclick'

--- What is among the first lines of a program in XML.
local XML_PROGRAM = { 'www.plcopen.org/xml/tc6', '<SW.Blocks.' }
local FIRST_LINES = 60

--- Whether a buffer holds a program of another system.
--- @param bufnr integer
--- @return boolean
function M.is_foreign(bufnr)
  local filetype = vim.bo[bufnr].filetype
  if filetype ~= 'xml' then
    return filetype == M.FILETYPE or filetype == 'ladderforeign'
  end
  local first = table.concat(vim.api.nvim_buf_get_lines(bufnr, 0, FIRST_LINES, false), '\n')
  return vim.iter(XML_PROGRAM):any(function(mark)
    return first:find(mark, 1, true) ~= nil
  end)
end

--- The diagram of each program, by buffers.
--- @type table<integer, integer>
local drawings = {}

--- The version of the program that each diagram shows, by the diagram's buffer: an answer and a notification may cross.
--- @type table<integer, integer>
local versions = {}

--- The buffer that shows a program's diagram, if there is one.
--- @param bufnr integer
--- @return integer|nil
function M.drawing(bufnr)
  local drawing = drawings[bufnr]
  return drawing and vim.api.nvim_buf_is_loaded(drawing) and drawing or nil
end

--- `:LadderClick`: the Python file of a buffer is a Click program from now on.
--- @param bufnr integer
function M.open(bufnr)
  if vim.bo[bufnr].filetype == 'python' then
    vim.bo[bufnr].filetype = M.FILETYPE
  elseif vim.bo[bufnr].filetype ~= M.FILETYPE then
    vim.notify('ladder: a Click program is a file in Python, and this is none.', vim.log.levels.ERROR)
  end
end

--- @param drawing integer
--- @param previewed { uri: string, version: integer, text: string }
local function show_text(drawing, previewed)
  if (versions[drawing] or -1) > previewed.version then
    return
  end
  versions[drawing] = previewed.version
  local lines = vim.split((previewed.text:gsub('\n$', '')), '\n', { plain = true })
  if not vim.deep_equal(lines, vim.api.nvim_buf_get_lines(drawing, 0, -1, false)) then
    vim.bo[drawing].modifiable = true
    vim.api.nvim_buf_set_lines(drawing, 0, -1, false, lines)
    vim.bo[drawing].modifiable = false
    vim.bo[drawing].modified = false
  end
end

--- A `ladder/preview` from the server.
--- @param previewed { uri: string, version: integer, text: string }
function M.receive(previewed)
  for program in pairs(drawings) do
    local drawing = M.drawing(program)
    if drawing and vim.api.nvim_buf_is_valid(program) and vim.uri_from_bufnr(program) == previewed.uri then
      show_text(drawing, previewed)
    end
  end
end

--- A buffer that is not a file and that nobody edits, next to the current window. The server knows it as any other drawing.
--- @param program integer
--- @param client vim.lsp.Client
--- @param previewed { uri: string, version: integer, text: string }
--- @return integer
local function new_drawing(program, client, previewed)
  local drawing = vim.api.nvim_create_buf(true, true)
  local path = vim.uri_from_bufnr(program):gsub('^%a[%w+.-]*:', '')
  vim.api.nvim_buf_set_name(drawing, 'ladder-click:' .. path .. '.clad')
  vim.bo[drawing].bufhidden = 'hide'
  show_text(drawing, previewed)
  vim.bo[drawing].filetype = 'clad'
  vim.lsp.buf_attach_client(drawing, client.id)
  drawings[program] = drawing
  return drawing
end

--- Shows the diagram of a program next to it. It follows what is typed.
--- @param program integer
--- @param shown fun(drawing: integer)|nil called when it is there
function M.preview(program, shown)
  if not M.is_foreign(program) then
    local message = 'ladder: this is not a program of another system; ":LadderClick" makes one of a Python file.'
    return vim.notify(message, vim.log.levels.ERROR)
  end
  local client = server.await(program)
  if not client then
    return vim.notify('ladder: no language server is attached; ":checkhealth ladder" says why.', vim.log.levels.ERROR)
  end
  local argument = { uri = vim.uri_from_bufnr(program) }
  server.command(client, program, 'ladder.preview', argument, function(err, previewed)
    if err then
      return vim.notify('ladder: ' .. err.message, vim.log.levels.ERROR)
    end
    local drawing = M.drawing(program)
    if drawing then
      show_text(drawing, previewed)
    else
      drawing = new_drawing(program, client, previewed)
    end
    if #vim.fn.win_findbuf(drawing) == 0 then
      vim.api.nvim_open_win(drawing, false, { split = 'right' })
    end
    if shown then
      shown(drawing)
    end
  end)
end

--- Starts a simulation; of a program of another system that of its diagram, which shows the power.
--- @param bufnr integer
function M.start(bufnr)
  local simulation = require('ladder.simulation')
  if not M.is_foreign(bufnr) then
    return simulation.begin(bufnr)
  end
  M.preview(bufnr, simulation.begin)
end

vim.api.nvim_create_autocmd('BufUnload', {
  group = vim.api.nvim_create_augroup('ladder_click', {}),
  callback = function(event)
    -- What is opened again begins with its versions.
    local drawing = drawings[event.buf]
    if drawing then
      versions[drawing] = nil
    end
    versions[event.buf] = nil
  end,
})

return M
