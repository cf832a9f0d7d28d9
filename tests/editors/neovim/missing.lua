-- Where the language server is missing, or of another version.
return function(t)
  local program = require('ladder.program')
  local versions = require('ladder.version')

  t.step('the folder of Cargo comes after the PATH', function()
    local function find(path, there, here)
      return program.find('ladder', {
        path = path,
        windows = false,
        here = here or '/plant',
        cargo = '/home/me/.cargo/bin',
        is_program = function(file)
          return vim.list_contains(there, file)
        end,
      })
    end
    t.equal('Cargo', '/home/me/.cargo/bin/ladder', find('/bin', { '/home/me/.cargo/bin/ladder' }))
    t.equal('the PATH', '/bin/ladder', find('/bin', { '/bin/ladder', '/home/me/.cargo/bin/ladder' }))
    t.equal('in the current folder', nil, find('/bin', { '/home/me/.cargo/bin/ladder' }, '/home/me'))
  end)

  t.step('versions are compared as Cargo compares them', function()
    for _, case in ipairs({
      { '0.1.0', '0.1.0' },
      { '0.1.7', '0.1.0' },
      { '0.1.0', '0.1.2', 'the server' },
      { '0.2.0', '0.1.9', 'the plugin' },
      { '1.4.0', '1.2.3' },
      { '1.2.2', '1.2.3', 'the server' },
      { '2.0.0', '1.9.9', 'the plugin' },
      { '1.2.3-rc.1', '1.2.3' },
      { '0.0.2', '0.0.1', 'the plugin' },
    }) do
      local server, plugin, update = unpack(case)
      local misfit = versions.misfit(server, plugin)
      t.equal(server .. ' under ' .. plugin, update, misfit and misfit:match('until (.+) is updated'))
    end
    t.equal('no version', 'This is not the language server: its version is "snakes".', versions.misfit('snakes'))
    local manifest = table.concat(vim.fn.readfile(vim.env.LADDER_ROOT .. '/Cargo.toml'), '\n')
    t.equal("the plugin's own version", manifest:match('%[workspace%.package%]\nversion = "([^"]+)"'), versions.plugin)
  end)

  --- Starts another Neovim with an empty home, in which no `ladder` is found.
  local function open(home, setup)
    local file = home .. '/project/pump.clad'
    vim.fn.mkdir(home .. '/project', 'p')
    vim.fn.writefile({ '+--[ ]( start )--/' }, file)
    local plugin = 'set runtimepath^=' .. vim.env.LADDER_ROOT .. '/editors/neovim'
    -- What would have to be read with Enter is kept for the test.
    local notes = 'lua notes = {}; vim.notify = function(text) table.insert(notes, text) end'
    local command = { vim.v.progpath, '--clean', '--embed', '--cmd', plugin, '--cmd', notes, '-u', 'NORC', file }
    if setup then
      vim.list_extend(command, { '--cmd', setup })
    end
    local channel = vim.fn.jobstart(command, {
      rpc = true,
      cwd = home .. '/project',
      clear_env = true,
      env = { HOME = home, PATH = '/usr/bin:/bin', VIMRUNTIME = vim.env.VIMRUNTIME, TERM = 'dumb' },
    })
    assert(channel > 0, 'Neovim does not start')
    local function lua(code)
      return vim.rpcrequest(channel, 'nvim_exec_lua', code, {})
    end
    local function noted(text)
      return t.eventually('the message "' .. text .. '"', function()
        return table.concat(lua('return notes'), '\n'):find(text, 1, true)
      end)
    end
    vim.rpcrequest(channel, 'nvim_ui_attach', 120, 40, vim.empty_dict())
    return channel, lua, noted
  end

  local function report(lua)
    lua("vim.cmd('silent checkhealth ladder')")
    return table.concat(lua('return vim.api.nvim_buf_get_lines(0, 0, -1, false)'), '\n')
  end

  --- Puts a program into the folder of Cargo.
  local function put(home, lines)
    local folder = home .. '/.cargo/bin'
    vim.fn.mkdir(folder, 'p')
    vim.fn.writefile(lines, folder .. '/being-written')
    vim.fn.setfperm(folder .. '/being-written', 'rwxr-xr-x')
    assert(vim.uv.fs_rename(folder .. '/being-written', folder .. '/ladder'))
  end

  t.step('a missing server is said, and started when it is there', function()
    local home = vim.fn.tempname()
    local channel, lua, noted = open(home)
    noted('the language server was not found')
    lua("vim.cmd('split again.clad')")
    t.equal('how often it is said', 1, #lua('return notes'))
    local said = report(lua)
    assert(said:find('no program "ladder" was found', 1, true), said)
    assert(said:find('cargo install', 1, true), said)
    lua("vim.cmd('bwipeout')")
    put(home, { '#!/bin/sh', ('exec "%s" "$@"'):format(vim.env.LADDER_BIN) })
    noted('the language server is there now: ' .. home .. '/.cargo/bin/ladder')
    t.eventually('a finding in the program', function()
      return #lua("return vim.diagnostic.get(vim.fn.bufnr('pump.clad'))") > 0
    end)
    assert(report(lua):find('Language server: ladder', 1, true))
    vim.fn.jobstop(channel)
  end)

  t.step('a place of the user that leads nowhere is said', function()
    local home = vim.fn.tempname()
    local channel, lua, noted = open(home, "lua vim.lsp.config('ladder', { cmd = { '/nowhere/ladder', 'lsp' } })")
    noted('"/nowhere/ladder", which your configuration names, is not a program')
    assert(report(lua):find('"/nowhere/ladder" does not start', 1, true))
    vim.fn.jobstop(channel)
  end)

  t.step('a server of another version is said', function()
    local home = vim.fn.tempname()
    -- The answer to "initialize" has the version, too.
    put(home, {
      '#!/bin/sh',
      '[ "$1" = --version ] && echo "ladder 0.0.9" && exit',
      ([[exec "%s" "$@" | python3 -c 'import os]]):format(vim.env.LADDER_BIN),
      'while data := os.read(0, 65536):',
      ([[    os.write(1, data.replace(b"\"version\":\"%s\"", b"\"version\":\"0.0.9\""))']]):format(versions.plugin),
    })
    local channel, lua, noted = open(home)
    noted('The language server has version 0.0.9, this plugin')
    local said = report(lua)
    assert(said:find('The language server has version 0.0.9', 1, true), said)
    vim.fn.jobstop(channel)
  end)
end
