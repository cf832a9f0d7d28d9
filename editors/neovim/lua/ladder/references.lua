--- `:Ladder references`: every tag of a program, and where it is read, written, set and reset. <CR> goes there.
require('ladder.highlight')

local side_buffer = require('ladder.side_buffer')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_references')

--- @param answer table as docs/protocol.md of the project describes it
--- @return string[] lines, table[] places by line: the range that it is about
function M.lines(answer)
  local lines, places = {}, {}
  for _, tag in ipairs(answer.tags) do
    local name = tag.block and (tag.block .. '.' .. tag.name) or tag.name
    local words = { tag.kind }
    if tag.address and tag.address ~= tag.name then
      table.insert(words, tag.address)
    end
    if #tag.places == 0 then
      table.insert(words, 'used nowhere')
    end
    local comment = tag.comment and ('  # %s #'):format(tag.comment) or ''
    table.insert(lines, ('%s : %s, %s%s'):format(name, tag.type, table.concat(words, ', '), comment))
    table.insert(places, tag.range)
    for _, place in ipairs(tag.places) do
      local line = place.range.start.line + 1
      table.insert(lines, ('    %-14s  line %d, network %d'):format(place.does, line, place.network))
      table.insert(places, place.range)
    end
  end
  return lines, places
end

--- Goes to a range of the program.
local function go(source, range, encoding)
  local window = vim.fn.bufwinid(source)
  if window < 0 then
    vim.cmd.sbuffer(source)
    window = vim.api.nvim_get_current_win()
  end
  vim.api.nvim_set_current_win(window)
  local line = vim.api.nvim_buf_get_lines(source, range.start.line, range.start.line + 1, false)[1] or ''
  vim.cmd("normal! m'")
  vim.api.nvim_win_set_cursor(window, {
    range.start.line + 1,
    vim.str_byteindex(line, encoding, range.start.character, false),
  })
end

--- Shows the cross-reference of a program in a split.
--- @param source integer
function M.open(source)
  local client = require('ladder.server').of(source)
  if not client then
    error('the language server is not attached to this buffer.', 0)
  end
  local asked = { command = 'ladder.crossReference', arguments = { { uri = vim.uri_from_bufnr(source) } } }
  client:request('workspace/executeCommand', asked, function(failed, answer)
    if failed then
      return vim.notify('ladder: ' .. failed.message, vim.log.levels.ERROR)
    end
    local lines, places = M.lines(answer)
    local shown = #lines > 0 and lines or { 'The program has no tags.' }
    local bufnr = side_buffer.with_lines('references', source, shown)
    for index, line in ipairs(lines) do
      local tag = line:match('^%S+')
      local from, to = line:find('^    %S+ ?%a* ?%a*')
      local mark = tag and { 0, #tag, 'LadderTagName' } or { from - 1 + 4, to, 'LadderTagType' }
      vim.api.nvim_buf_set_extmark(bufnr, namespace, index - 1, mark[1], { end_col = mark[2], hl_group = mark[3] })
    end
    local actions = {
      ['<CR>'] = function()
        local range = places[vim.api.nvim_win_get_cursor(0)[1]]
        if range then
          go(source, range, client.offset_encoding)
        end
      end,
      q = function()
        vim.api.nvim_win_close(0, true)
      end,
    }
    side_buffer.on_double_click(actions, actions['<CR>'])
    side_buffer.map(bufnr, actions)
    vim.api.nvim_open_win(bufnr, true, { split = 'below', height = math.min(math.max(#lines, 3), 16), style = 'minimal' })
    vim.wo[0][0].cursorline = true
    vim.wo[0][0].wrap = false
  end, source)
end

return M
