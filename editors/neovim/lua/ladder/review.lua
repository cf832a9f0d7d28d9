--- `:Ladder review`: signs next to the rungs that are not as the last commit has them, and whether each does the same.
local M = {}

local namespace = vim.api.nvim_create_namespace('ladder_review')
--- So long after the last edit, in milliseconds.
local AFTER_EDIT = 400

--- Each sign with its group, those first that a line with several has.
local signs = {
  { 'other', '≠', 'DiagnosticSignWarn' },
  { 'unknown', '?', 'DiagnosticSignInfo' },
  { 'new', '+', 'Added' },
  { 'gone', '-', 'Removed' },
  { 'same', '=', 'DiagnosticSignOk' },
  { 'drawn', '~', 'Comment' },
}

--- @class ladder.Review
--- @field group integer of its autocommands
--- @field base? string the text of the last commit
--- @field lines table<integer, string[]> what happened at a line, from 0
--- @field asked integer counts what was asked for: only the newest answer is shown

--- @type table<integer, ladder.Review>
local reviews = {}

--- What a sign says of a change; of comments there is none.
local function mark_of(change)
  if change.kind ~= 'network' or change.change == 'commented' then
    return nil
  end
  if change.change == 'edited' then
    return (change.meaning == 'same' or change.meaning == 'other') and change.meaning or 'unknown'
  end
  return (change.change == 'new' or change.change == 'gone') and change.change or 'drawn'
end

local function show(bufnr, review, changes)
  vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
  review.lines = {}
  local last = vim.api.nvim_buf_line_count(bufnr) - 1
  for _, change in ipairs(changes) do
    local mark = mark_of(change)
    if mark then
      local line = math.min(change.line, last)
      review.lines[line] = review.lines[line] or {}
      table.insert(review.lines[line], change.reason and ('%s: %s'):format(change.title, change.reason) or change.title)
      for rank, sign in ipairs(signs) do
        if sign[1] == mark then
          local options = { sign_text = sign[2], sign_hl_group = sign[3], priority = 20 - rank }
          vim.api.nvim_buf_set_extmark(bufnr, namespace, line, 0, options)
        end
      end
    end
  end
end

local function compare(bufnr, review)
  local client = require('ladder.server').of(bufnr)
  if not client or not review.base then
    return
  end
  review.asked = review.asked + 1
  local turn = review.asked
  local asked = { command = 'ladder.compare', arguments = { { uri = vim.uri_from_bufnr(bufnr), base = review.base } } }
  client:request('workspace/executeCommand', asked, function(failed, answer)
    if reviews[bufnr] ~= review or review.asked ~= turn then
      return
    end
    -- The text has moved on: it is asked for again.
    if failed and failed.code ~= vim.lsp.protocol.ErrorCodes.ContentModified then
      vim.notify('ladder: ' .. failed.message, vim.log.levels.ERROR)
    elseif answer then
      show(bufnr, review, answer.changes)
    end
  end, bufnr)
end

--- Asks git for the text of the last commit, and compares.
local function read_base(bufnr, review)
  local file = vim.api.nvim_buf_get_name(bufnr)
  local command = { 'git', '-C', vim.fs.dirname(file), 'cat-file', 'blob', 'HEAD:./' .. vim.fs.basename(file) }
  -- Nothing is fetched for it, and nothing that the repository names is run.
  local options = { env = { GIT_NO_LAZY_FETCH = '1', GIT_TERMINAL_PROMPT = '0' } }
  local started = pcall(vim.system, command, options, function(done)
    vim.schedule(function()
      if reviews[bufnr] ~= review then
        return
      end
      if done.code ~= 0 then
        M.stop(bufnr)
        return vim.notify('ladder: the last commit does not have this file.', vim.log.levels.ERROR)
      end
      review.base = done.stdout
      compare(bufnr, review)
    end)
  end)
  if not started then
    M.stop(bufnr)
    error('git cannot be started.', 0)
  end
end

--- @param bufnr integer
function M.stop(bufnr)
  local review = reviews[bufnr]
  reviews[bufnr] = nil
  if review then
    vim.api.nvim_del_augroup_by_id(review.group)
  end
  if vim.api.nvim_buf_is_valid(bufnr) then
    vim.api.nvim_buf_clear_namespace(bufnr, namespace, 0, -1)
  end
end

--- Shows the signs of a buffer, which follow its text, or takes them away.
--- @param bufnr integer
function M.toggle(bufnr)
  if reviews[bufnr] then
    return M.stop(bufnr)
  end
  if vim.api.nvim_buf_get_name(bufnr) == '' then
    error('the buffer has no file yet.', 0)
  end
  if not require('ladder.server').of(bufnr) then
    error('the language server is not attached to this buffer.', 0)
  end
  local group = vim.api.nvim_create_augroup('ladder_review_' .. bufnr, {})
  local review = { group = group, lines = {}, asked = 0 }
  reviews[bufnr] = review
  local timer = assert(vim.uv.new_timer())
  local on = function(events, run)
    vim.api.nvim_create_autocmd(events, { group = group, buffer = bufnr, callback = run })
  end
  on({ 'TextChanged', 'TextChangedI' }, function()
    timer:start(AFTER_EDIT, 0, vim.schedule_wrap(function()
      if reviews[bufnr] == review then
        compare(bufnr, review)
      end
    end))
  end)
  -- There may be another commit.
  on({ 'BufEnter', 'BufWritePost', 'FocusGained' }, function()
    read_base(bufnr, review)
  end)
  on('BufWipeout', function()
    M.stop(bufnr)
  end)
  read_base(bufnr, review)
end

--- Says what happened to the rung at the cursor.
--- @param bufnr integer
function M.reason(bufnr)
  local review = reviews[bufnr] or error('":Ladder review" shows what changed first.', 0)
  local line = vim.api.nvim_win_get_cursor(0)[1] - 1
  local said = review.lines[line] or error('there is no sign in this line.', 0)
  vim.notify('ladder: ' .. table.concat(said, '\n'))
end

return M
