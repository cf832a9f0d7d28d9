;;; ladder-treesit.el --- Ladder diagrams by Tree-sitter, without a server  -*- lexical-binding: t -*-

;; SPDX-License-Identifier: MIT OR Apache-2.0

;;; Commentary:

;; Where Emacs has Tree-sitter (29 and later) and the grammar `clad' is installed, `ladder-mode' takes its colours and
;; indentation from there, moves by networks, and `outline-minor-mode' folds them.  editors/tree-sitter/install emacs builds
;; the grammar.

;;; Code:

(require 'treesit nil t)

(declare-function treesit-ready-p "treesit")
(declare-function treesit-font-lock-rules "treesit")
(declare-function treesit-major-mode-setup "treesit")
(declare-function treesit-parser-create "treesit.c")
(defvar treesit-font-lock-settings)
(defvar treesit-font-lock-feature-list)
(defvar treesit-simple-indent-rules)
(defvar treesit-defun-type-regexp)
(defvar treesit-thing-settings)
(defvar treesit-outline-predicate)

(defconst ladder-treesit--colours
  (expand-file-name "../tree-sitter/queries/highlights.scm" (file-name-directory (or load-file-name buffer-file-name "")))
  "The query that all editors take their colours from.")

(defconst ladder-treesit--faces
  '(("comment" . font-lock-comment-face)
    ("punctuation.bracket" . font-lock-bracket-face)
    ("punctuation.delimiter" . font-lock-delimiter-face)
    ("punctuation.special" . font-lock-misc-punctuation-face)
    ("function" . font-lock-function-name-face)
    ("function.builtin" . font-lock-builtin-face)
    ("label" . font-lock-constant-face)
    ("variable" . font-lock-variable-use-face)
    ("variable.builtin" . font-lock-builtin-face)
    ("variable.member" . font-lock-property-use-face)
    ("variable.parameter" . font-lock-variable-name-face)
    ("constant.builtin" . font-lock-constant-face)
    ("constant.builtin.boolean" . font-lock-constant-face)
    ("constant.numeric" . font-lock-number-face)
    ("string" . font-lock-string-face)
    ("string.escape" . font-lock-escape-face)
    ("operator" . font-lock-operator-face)
    ("keyword" . font-lock-keyword-face)
    ("keyword.operator" . font-lock-keyword-face)
    ("type" . font-lock-type-face)
    ("type.builtin" . font-lock-type-face))
  "The faces of the names in that query.")

(defun ladder-treesit--query ()
  "The query for colours, with Emacs's faces for its names."
  (with-temp-buffer
    (insert-file-contents ladder-treesit--colours)
    (while (re-search-forward "@\\([a-z.]+\\)" nil t)
      (let ((face (cdr (assoc (match-string 1) ladder-treesit--faces))))
        (unless face
          (error "There is no face for @%s" (match-string 1)))
        (replace-match (symbol-name face) t t nil 1)))
    (buffer-string)))

(defun ladder-treesit-setup ()
  "Let Tree-sitter colour, indent and move, if it has the grammar."
  (when (and (fboundp 'treesit-ready-p) (file-readable-p ladder-treesit--colours) (treesit-ready-p 'clad t))
    (treesit-parser-create 'clad)
    (setq-local treesit-font-lock-settings
                ;; An escape is inside of a string: the later one holds.
                (treesit-font-lock-rules :language 'clad :feature 'program :override t (ladder-treesit--query))
                treesit-font-lock-feature-list '((program))
                treesit-simple-indent-rules
                `((clad ((node-is "END_") parent-bol 0)
                        ((parent-is "\\`\\(?:var_section\\|type_section\\|structure\\)\\'") parent-bol 4)
                        ;; A drawing stays where it is.
                        (,(lambda (&rest _) t) ,(lambda (_node _parent start &rest _) start) 0)))
                treesit-defun-type-regexp "\\`\\(?:network\\|var_section\\|type_section\\)\\'"
                treesit-thing-settings '((clad (sentence "\\`\\(?:rung\\|declaration\\|type_declaration\\)\\'")))
                treesit-outline-predicate "\\`\\(?:network\\|var_section\\|type_section\\|block_definition\\)\\'")
    (treesit-major-mode-setup)))

(provide 'ladder-treesit)
;;; ladder-treesit.el ends here
