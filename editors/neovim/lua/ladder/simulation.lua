--- Runs sessions: sends the simulator's commands, one at a time and in order, and shows every state that comes back.
local breakpoints = require('ladder.breakpoints')
local keys = require('ladder.keys')
local power = require('ladder.power')
local server = require('ladder.server')
local sessions = require('ladder.session')
local shown = require('ladder.shown')
local view = require('ladder.view')
local winbar = require('ladder.winbar')

local M = {}

local group = vim.api.nvim_create_augroup('ladder_simulation', {})

local function notify(message, level)
  vim.notify('ladder: ' .. message, level or vim.log.levels.INFO)
end

local function tell_error(err)
  notify(err.message, vim.log.levels.ERROR)
end

--- Forgets the session and takes everything it showed off the buffer.
local function close(session)
  local bufnr = session.bufnr
  if sessions.of(bufnr) ~= session then
    return
  end
  sessions.close(bufnr)
  vim.api.nvim_clear_autocmds({ group = group, buffer = bufnr })
  if vim.api.nvim_buf_is_valid(bufnr) then
    view.clear(bufnr)
  end
end

--- An answer tells nothing of the drawing: what a command changes there comes with the next notification.
--- @param session ladder.Session
--- @param state ladder.State
local function answered(session, state)
  session.asked = math.max(session.asked, state.commands)
  view.show(session, state)
end

--- A `ladder/simulationState` from the server.
--- @param state ladder.State
--- @param client_id integer
function M.receive(state, client_id)
  local session = sessions.find(state.session, client_id)
  if session and vim.api.nvim_buf_is_loaded(session.bufnr) then
    -- What failed once would fail with every state; the server must not wait for it.
    local done, message = pcall(view.show, session, state)
    session.seen = math.max(session.seen, state.commands or 0)
    session.client:notify('ladder/simulationShown', { session = session.id })
    if not state.delta then
      -- The windows may show other lines of the new text.
      M.look(session.bufnr)
    end
    if not done then
      error(message, 0)
    end
  end
end

--- Tells the server what the windows show now, if that is something else.
--- @param session ladder.Session
local function look(session)
  if not session.id or not vim.api.nvim_buf_is_loaded(session.bufnr) then
    return
  end
  local now = shown.of(session.bufnr)
  if vim.deep_equal(now, session.shown) then
    return
  end
  session.shown = now
  sessions.forget(session, shown.is_shown(now))
  if not session.stale then
    power.forget(session.bufnr, shown.is_shown(now))
  end
  winbar.show(session.bufnr, session)
  local argument = vim.tbl_extend('force', { session = session.id }, now)
  server.command(session.client, session.bufnr, 'ladder.simulate.show', argument, function(err, state)
    if not err and sessions.of(session.bufnr) == session then
      session.asked = math.max(session.asked, state.commands)
    end
  end)
end

shown.on_change(look)

--- The tags that are listed besides have changed.
--- @param bufnr integer
function M.look(bufnr)
  local session = sessions.of(bufnr)
  if session then
    look(session)
  end
end

--- Sends the commands of one session one after another: the server may work on several at once, and `set` before
--- `step` must mean just that.
local function next_command(session)
  session.busy = false
  local send = table.remove(session.waiting, 1)
  if send then
    send()
  end
end

--- Tells the server that a session is over; what it answers is of no use any more.
local function end_on_server(session, id)
  server.command(session.client, session.bufnr, 'ladder.simulate.stop', { session = id }, function() end)
end

--- @param session ladder.Session
--- @param command string without its prefix
--- @param argument fun(): table made when the command is sent, for then the session has its name
--- @param answer fun(result: any)
--- @param first boolean|nil before those that wait already
local function enqueue(session, command, argument, answer, first)
  table.insert(session.waiting, first and 1 or #session.waiting + 1, function()
    session.busy = true
    local sent = server.command(
      session.client,
      session.bufnr,
      'ladder.simulate.' .. command,
      argument(),
      function(err, result)
        if sessions.of(session.bufnr) ~= session then
          if result and command == 'start' then
            end_on_server(session, result.session)
          end
          return
        end
        if err then
          tell_error(err)
          if not session.id then
            return close(session)
          end
        else
          answer(result)
        end
        next_command(session)
      end
    )
    if not sent then
      notify('the language server has ended; ":checkhealth ladder" may say why.', vim.log.levels.ERROR)
      close(session)
    end
  end)
  if not session.busy then
    next_command(session)
  end
end

--- Watches the buffer as long as it has a session.
local function watch(session)
  local bufnr = session.bufnr
  vim.api.nvim_buf_attach(bufnr, false, {
    on_lines = function(_, _, tick)
      if sessions.of(bufnr) ~= session then
        -- True detaches.
        return true
      end
      -- What is drawn moves with the text until the server tells of the new one.
      session.tick = tick
      session.stale = true
    end,
  })
  vim.api.nvim_create_autocmd('BufUnload', {
    group = group,
    buffer = bufnr,
    callback = function()
      M.stop(bufnr)
    end,
  })
  vim.api.nvim_create_autocmd('LspDetach', {
    group = group,
    buffer = bufnr,
    callback = function(event)
      if event.data.client_id == session.client.id then
        close(session)
      end
    end,
  })
end

--- Shows the first rung where the windows of a buffer are above it.
local function reveal(bufnr, first)
  for _, window in ipairs(first and vim.fn.win_findbuf(bufnr) or {}) do
    local line = math.min(first.start.line + 1, vim.api.nvim_buf_line_count(bufnr))
    if vim.fn.getwininfo(window)[1].botline < line then
      vim.api.nvim_win_set_cursor(window, { line, 0 })
      vim.api.nvim_win_call(window, function()
        vim.cmd.normal({ 'zz', bang = true })
      end)
    end
  end
end

--- Starts a session for the buffer's text as it is now; one that was there is ended.
--- @param bufnr integer
--- @param options table|nil `intervalMs`, `inputs`, `watchdog`
function M.start(bufnr, options)
  local client = server.await(bufnr)
  if not client then
    return notify(
      'no language server is attached to this buffer; ":checkhealth ladder" says why.',
      vim.log.levels.ERROR
    )
  end
  M.stop(bufnr)
  local session = sessions.open(bufnr, client)
  watch(session)
  enqueue(session, 'start', function()
    session.shown = shown.of(bufnr)
    local with = vim.tbl_extend('force', options or {}, { show = session.shown })
    return { uri = vim.uri_from_bufnr(bufnr), options = with }
  end, function(result)
    session.id = result.session
    view.show(session, result.state)
    keys.map(bufnr)
    reveal(bufnr, result.first)
    look(session)
    for _, note in ipairs(result.notes or {}) do
      notify(note, vim.log.levels.WARN)
    end
  end)
  if breakpoints.any(bufnr) and not (options and options.online) then
    M.command(bufnr, 'breakpoints', breakpoints.argument(bufnr))
  end
end

--- Shows what the controller does that ladder.toml names, in the place of a simulation. It is read, and never written.
--- @param bufnr integer
function M.go_online(bufnr)
  M.start(bufnr, { online = true })
end

--- Starts a session as a person does: it runs, unless `g:ladder_start_paused` is set, and its first rung is in sight.
--- @param bufnr integer
function M.begin(bufnr)
  M.start(bufnr)
  local paused = vim.g.ladder_start_paused
  if sessions.of(bufnr) and not (paused and paused ~= 0) then
    M.run(bufnr)
  end
end

--- Shows a session that the server has started for a debugger; one that was there is ended.
--- @param bufnr integer
--- @param client vim.lsp.Client
--- @param started { session: string, state: ladder.State, notes: string[]|nil }
--- @param what table what was shown of the buffer when it was asked for
--- @return ladder.Session
function M.adopt(bufnr, client, started, what)
  M.stop(bufnr)
  local session = sessions.open(bufnr, client)
  watch(session)
  session.id = started.session
  session.shown = what
  session.debugged = true
  view.show(session, started.state)
  look(session)
  for _, note in ipairs(started.notes or {}) do
    notify(note, vim.log.levels.WARN)
  end
  return session
end

--- Tells the simulation of the buffer, if there is one, which breakpoints there are now.
--- @param bufnr integer
function M.send_breakpoints(bufnr)
  local session = sessions.of(bufnr)
  if session and not session.debugged then
    M.command(bufnr, 'breakpoints', breakpoints.argument(bufnr))
  end
end

--- Asks something that changes nothing.
--- @param bufnr integer
--- @param command 'why'|'history'|'tags'
--- @param argument table what the command takes besides the session
--- @param answer fun(result: any)
function M.ask(bufnr, command, argument, answer)
  local session = sessions.of(bufnr)
  if not session then
    return notify('no simulation runs for this buffer; ":Ladder start" starts one.', vim.log.levels.WARN)
  end
  enqueue(session, command, function()
    return vim.tbl_extend('force', { session = session.id }, argument)
  end, answer)
end

--- Returns the tag of that name with its value, nil if there is none. What is to be done with it comes before the commands
--- that were given since, with `first` of `command`.
--- @param bufnr integer
--- @param name string
--- @param answer fun(tag: ladder.Tag|nil)
function M.with_tag(bufnr, name, answer)
  M.ask(bufnr, 'tags', { containing = name }, function(found)
    local wanted = vim.fn.tolower(name)
    answer(vim.iter(found.tags):find(function(tag)
      return vim.fn.tolower(tag.name) == wanted
    end))
  end)
end

--- Tags whose names hold a text, for completion: asked for at once, whatever else is under way.
--- @param bufnr integer
--- @param containing string
--- @return ladder.Tag[]
function M.search(bufnr, containing)
  local session = sessions.of(bufnr)
  if not session or not session.id then
    return {}
  end
  local argument = { session = session.id, containing = containing, count = 200 }
  local params = { command = 'ladder.simulate.tags', arguments = { argument } }
  local answer = session.client:request_sync('workspace/executeCommand', params, 1000, bufnr)
  return answer and answer.result and answer.result.tags or {}
end

--- Sends a command that answers with the new state.
--- @param bufnr integer
--- @param command string one of those that docs/protocol.md lists, without its prefix
--- @param argument table|nil what the command takes besides the session
--- @param first boolean|nil before those that wait already: it is a part of one that was given before them
function M.command(bufnr, command, argument, first)
  local session = sessions.of(bufnr)
  if not session then
    return notify('no simulation runs for this buffer; ":Ladder start" starts one.', vim.log.levels.WARN)
  end
  enqueue(session, command, function()
    return vim.tbl_extend('force', { session = session.id }, argument or {})
  end, function(state)
    answered(session, state)
  end, first)
end

--- Runs, as fast as was said last.
--- @param bufnr integer
--- @param scans integer|nil until it is paused if not given
function M.run(bufnr, scans)
  M.command(bufnr, 'run', { scans = scans })
end

--- How fast runs go from now on, and the one that is under way.
--- @param bufnr integer
--- @param speed number|'max'
function M.speed(bufnr, speed)
  M.command(bufnr, 'speed', speed == 'max' and { realTime = false } or { speed = speed })
end

--- Pauses at once: it does not wait for the commands before it, and drops those that have not been sent.
--- @param bufnr integer
function M.pause(bufnr)
  local session = sessions.of(bufnr)
  if not session or not session.id then
    return M.command(bufnr, 'pause')
  end
  session.waiting = {}
  server.command(session.client, bufnr, 'ladder.simulate.pause', { session = session.id }, function(err, state)
    if err then
      tell_error(err)
    elseif sessions.of(bufnr) == session then
      answered(session, state)
    end
  end)
end

--- Ends the buffer's session, if there is one.
--- @param bufnr integer
function M.stop(bufnr)
  local session = sessions.of(bufnr)
  if not session then
    return
  end
  close(session)
  if session.id then
    end_on_server(session, session.id)
  end
end

--- Waits until every command sent so far is answered, and what it changed is shown; for scripts and tests.
--- @param bufnr integer
--- @param timeout_ms integer|nil
--- @return boolean answered
function M.wait(bufnr, timeout_ms)
  return vim.wait(timeout_ms or 2000, function()
    local session = sessions.of(bufnr)
    local answered_all = session and not session.busy and #session.waiting == 0
    return not session or (answered_all and session.seen >= session.asked)
  end, 5)
end

return M
