" As Python.
runtime! indent/python.vim
