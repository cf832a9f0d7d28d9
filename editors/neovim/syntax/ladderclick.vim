" As Python.
runtime! syntax/python.vim
