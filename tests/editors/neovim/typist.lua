-- The programs of the book, typed. Run along with test.lua, since it takes as long as that.
package.path = vim.env.LADDER_ROOT .. '/tests/editors/neovim/?.lua;' .. package.path
local t = require('harness')

require('book')(t)

t.run()
