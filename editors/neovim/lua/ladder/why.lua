--- Why a tag holds what it holds: the reasons as a list to walk through, each with its place in the program, where the
--- blocks that stop power are marked.
require('ladder.highlight')

local sessions = require('ladder.session')
local simulation = require('ladder.simulation')
local view = require('ladder.view')

local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_why')

--- The scan whose reasons are marked, by buffer.
--- @type table<integer, integer>
local marked = {}

--- @class ladder.ReasonRow
--- @field text string
--- @field depth integer
--- @field range lsp.Range|nil
--- @field uri string|nil
--- @field stops boolean|nil

--- @param reason table as docs/protocol.md of the project describes it
--- @param depth integer
--- @param rows ladder.ReasonRow[]
local function add(reason, depth, rows)
  local write = reason.write or reason.now
  -- The sentence goes on with what is beneath.
  local text = write and reason.text:match('^(.-): ') or reason.text
  table.insert(rows, { text = text, depth = depth, range = write and write.range, uri = write and write.uri })
  for _, written in ipairs({ reason.write, reason.now }) do
    local verb = written == reason.now and reason.now and 'keeps it off' or 'wrote it'
    table.insert(rows, {
      text = ('%s %s in line %d'):format(written.block, verb, written.range.start.line + 1),
      depth = depth + 1,
      range = written.range,
      uri = written.uri,
    })
    for index, way in ipairs(written.ways or {}) do
      if not written.power and #written.ways > 1 then
        table.insert(rows, { text = index == 1 and 'blocked by' or 'or else by', depth = depth + 1 })
      end
      for _, block in ipairs(way) do
        table.insert(rows, {
          text = (block.stops and 'x ' or '= ') .. block.text,
          depth = depth + 1,
          range = block.range,
          uri = block.uri,
          stops = block.stops,
        })
        for _, because in ipairs(block.because or {}) do
          add(because, depth + 2, rows)
        end
      end
    end
    for _, because in ipairs(written.because or {}) do
      add(because, depth + 2, rows)
    end
  end
end

--- The rows of a tree of reasons.
--- @param reason table
--- @return ladder.ReasonRow[]
function M.rows(reason)
  local rows = {}
  add(reason, 0, rows)
  return rows
end

--- Marks the blocks that stop power, in the program itself.
--- @param session ladder.Session
--- @param rows ladder.ReasonRow[]
local function mark(session, rows)
  vim.api.nvim_buf_clear_namespace(session.bufnr, namespace, 0, -1)
  marked[session.bufnr] = session.state and session.state.scan
  local encoding = session.client.offset_encoding
  for _, row in ipairs(session.stale and {} or rows) do
    if row.stops and row.range and not row.uri then
      local from, to = row.range.start, row.range['end']
      local line = vim.api.nvim_buf_get_lines(session.bufnr, from.line, from.line + 1, false)[1] or ''
      vim.api.nvim_buf_set_extmark(
        session.bufnr,
        namespace,
        from.line,
        vim.str_byteindex(line, encoding, from.character, false),
        {
          end_row = to.line,
          end_col = to.line == from.line and vim.str_byteindex(line, encoding, to.character, false) or 0,
          hl_group = 'LadderStops',
          priority = 145,
          strict = false,
        }
      )
    end
  end
end

-- What stopped power in one scan may let it through in the next.
view.on_change(function(bufnr)
  local session = sessions.of(bufnr)
  if marked[bufnr] and not (session and not session.stale and session.state.scan == marked[bufnr]) then
    marked[bufnr] = nil
    if vim.api.nvim_buf_is_valid(bufnr) then
      vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
    end
  end
end)

--- Shows why a tag holds what it holds, in the quickfix list.
--- @param bufnr integer
--- @param tag string
function M.ask(bufnr, tag)
  simulation.ask(bufnr, 'why', { tag = tag }, function(why)
    local session = sessions.of(bufnr)
    local rows = M.rows(why.reason)
    mark(session, rows)
    local items = vim.tbl_map(function(row)
      local text = (' '):rep(row.depth * 2) .. row.text
      if not row.range then
        return { text = text }
      end
      local there = row.uri and vim.uri_to_bufnr(row.uri) or bufnr
      vim.fn.bufload(there)
      local line = vim.api.nvim_buf_get_lines(there, row.range.start.line, row.range.start.line + 1, false)[1] or ''
      return {
        bufnr = there,
        lnum = row.range.start.line + 1,
        col = vim.str_byteindex(line, session.client.offset_encoding, row.range.start.character, false) + 1,
        text = text,
      }
    end, rows)
    vim.fn.setqflist({}, ' ', {
      title = ('Why %s'):format(rows[1].text),
      items = items,
      -- The places are in the text already.
      quickfixtextfunc = function(list)
        local shown = vim.fn.getqflist({ id = list.id, items = 1 }).items
        return vim.list_slice(
          vim.tbl_map(function(item)
            return item.text
          end, shown),
          list.start_idx,
          list.end_idx
        )
      end,
    })
    local window = vim.api.nvim_get_current_win()
    vim.cmd(('botright copen %d'):format(math.min(math.max(#rows, 3), 12)))
    vim.wo.wrap = false
    vim.api.nvim_set_current_win(window)
  end)
end

return M
