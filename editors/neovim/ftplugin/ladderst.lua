-- Structured Text: what of it Neovim is to know.
vim.bo.commentstring = '(* %s *)'
vim.bo.comments = 's1:(*,mb:*,ex:*),://'
