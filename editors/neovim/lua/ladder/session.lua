--- The simulation sessions that are open, one a buffer at most.
---
--- A session belongs to the text it was started on. `tick` is the buffer's change count at that moment: once it has
--- moved on, what the server says about places is about another text.
local M = {}

--- @class ladder.Session
--- @field bufnr integer
--- @field client vim.lsp.Client
--- @field tick integer
--- @field id string|nil the server's name for it; nil until the server has answered
--- @field state ladder.State|nil the last one received
--- @field stale boolean the text has moved on since the start
--- @field waiting fun()[] commands that wait for the one under way
--- @field busy boolean a command is under way

--- @class ladder.State
--- @field session string
--- @field uri string
--- @field version integer
--- @field stale boolean
--- @field status 'paused'|'running'|'ended'|'faulted'
--- @field scan integer
--- @field timeMs number
--- @field behind integer
--- @field ahead integer
--- @field next lsp.Range|nil
--- @field hit { message: string, range: lsp.Range|nil }|nil
--- @field tags ladder.Tag[]
--- @field power { range: lsp.Range, on: boolean }[]
--- @field faults { message: string, range: lsp.Range, scan: integer }[]

--- @class ladder.Tag
--- @field name string
--- @field type string
--- @field value any
--- @field role 'input'|'output'|'internal'
--- @field forced boolean

--- @type table<integer, ladder.Session>
local sessions = {}

--- @param bufnr integer
--- @param client vim.lsp.Client
--- @return ladder.Session
function M.open(bufnr, client)
  local session = {
    bufnr = bufnr,
    client = client,
    tick = vim.api.nvim_buf_get_changedtick(bufnr),
    stale = false,
    waiting = {},
    busy = false,
  }
  sessions[bufnr] = session
  return session
end

--- @param bufnr integer
--- @return ladder.Session|nil
function M.of(bufnr)
  return sessions[bufnr]
end

--- The session that the server calls `id`; ids are unique for one server only.
--- @param id string
--- @param client_id integer
--- @return ladder.Session|nil
function M.find(id, client_id)
  for _, session in pairs(sessions) do
    if session.id == id and session.client.id == client_id then
      return session
    end
  end
end

--- @param bufnr integer
function M.close(bufnr)
  sessions[bufnr] = nil
end

--- The tag of that name, whatever its case.
--- @param state ladder.State|nil
--- @param name string
--- @return ladder.Tag|nil
function M.tag(state, name)
  local wanted = vim.fn.tolower(name)
  for _, tag in ipairs(state and state.tags or {}) do
    if vim.fn.tolower(tag.name) == wanted then
      return tag
    end
  end
end

return M
