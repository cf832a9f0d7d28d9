--- What is shown of a session: power, values and faults in its buffer, its status above the windows, and messages.
local faults = require('ladder.faults')
local keys = require('ladder.keys')
local power = require('ladder.power')
local sessions = require('ladder.session')
local status = require('ladder.status')
local values = require('ladder.values')
local winbar = require('ladder.winbar')

local M = {}

local function notify(message)
  vim.notify('ladder: ' .. message, vim.log.levels.INFO)
end

--- Called after each change of a buffer's session, by what shows it elsewhere (the tag panel).
--- @type fun(bufnr: integer)[]
local listeners = {}

--- @param listener fun(bufnr: integer)
function M.on_change(listener)
  table.insert(listeners, listener)
end

--- Tells of a session that is not as it was, or is over.
--- @param bufnr integer
function M.changed(bufnr)
  vim.b[bufnr].ladder_status = status.text(sessions.of(bufnr))
  winbar.show(bufnr, sessions.of(bufnr))
  vim.cmd.redrawstatus({ bang = true })
  for _, listener in ipairs(listeners) do
    listener(bufnr)
  end
end

--- Says what a change of the program could not keep.
local function tell_of_change(before, state)
  local change = state.change
  if not change or (before and before.change and before.change.number == change.number) then
    return
  end
  for _, lost in ipairs(change.lost or {}) do
    notify(lost.message .. '.')
  end
end

--- Shows how things are; of the drawing what the state tells.
--- @param session ladder.Session
--- @param state ladder.State
function M.show(session, state)
  local last = session.state
  session.state = state
  -- The server is a moment behind the buffer; until it has taken up what was typed its places are of the text before. What
  -- it says first of the new text is all that there is to show.
  if not state.delta and state.version >= session.tick then
    session.stale = false
    sessions.reset(session)
    power.clear(session.bufnr)
  end
  sessions.take(session, state)
  tell_of_change(last, state)
  -- The same hit comes with an answer and with a notification, and with one that comes late once more.
  if state.hit and state.hit.number > session.hits then
    session.hits = state.hit.number
    notify(state.hit.message .. '.')
  end
  if not session.stale then
    local encoding = session.client.offset_encoding
    power.paint(session.bufnr, state.power, encoding)
    power.mark_next(session.bufnr, state.next, encoding)
    values.show(session)
    faults.show(session.bufnr, state.faults, encoding)
  end
  M.changed(session.bufnr)
end

--- Takes everything off the buffer.
--- @param bufnr integer
function M.clear(bufnr)
  power.clear(bufnr)
  values.clear(bufnr)
  faults.clear(bufnr)
  keys.unmap(bufnr)
  M.changed(bufnr)
end

return M
