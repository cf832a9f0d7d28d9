;;; ladder-mode.el --- Ladder diagrams as plain text  -*- lexical-binding: t -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "28.1") (eglot "1.9"))
;; Keywords: languages, tools
;; SPDX-License-Identifier: MIT OR Apache-2.0

;;; Commentary:

;; The major mode for ladder diagrams (.clad) and their scenarios (.ladder-test).  The language server `ladder lsp'
;; comes through Eglot: errors, completion, explanations, references, renaming and alignment.  The simulation, with
;; the power flow drawn into the text, is in `ladder-simulation'; what works without a server, in `ladder-treesit'.
;;
;;   (add-to-list 'load-path "/path/to/ladder/editors/emacs")
;;   (require 'ladder-mode)
;;   (add-hook 'ladder-mode-hook #'eglot-ensure)

;;; Code:

(require 'eglot)
(require 'ladder-treesit)

(defgroup ladder nil
  "Ladder diagrams as plain text."
  :group 'languages
  :prefix "ladder-")

(defcustom ladder-server-program nil
  "The whole path of the program `ladder'.
Without it the program is looked for on `exec-path', and where
Cargo installs programs."
  :type '(choice (const :tag "Look for it" nil) file)
  ;; A file that a user sent must not choose what is run.
  :risky t)

(defcustom ladder-format-on-save nil
  "Whether a program is aligned when it is saved."
  :type 'boolean
  :safe #'booleanp)

;;; The server

(defun ladder--find-program ()
  "The whole path of the program `ladder', or nil.
Folders that are not given whole do not count: they would be seen
from the folder that is open."
  (or ladder-server-program
      (let ((cargo (expand-file-name "bin" (or (getenv "CARGO_HOME") "~/.cargo")))
            (exec-path (seq-filter (lambda (folder) (and folder (file-name-absolute-p folder))) exec-path)))
        (locate-file "ladder" (append exec-path (list cargo)) exec-suffixes #'file-executable-p))))

(defun ladder--server (&optional _interactive)
  "What Eglot starts."
  (let ((program (ladder--find-program)))
    (unless program
      (user-error "Ladder: the language server was not found: no program \"ladder\" on exec-path or in ~/.cargo/bin; \
install it (cargo install --path cli), or set `ladder-server-program'"))
    (list program "lsp")))

;; Eglot's own way to name a language that is not called as its mode.
(put 'ladder-mode 'eglot-language-id "clad")
(put 'ladder-test-mode 'eglot-language-id "ladder-test")
(put 'ladder-st-mode 'eglot-language-id "st")
(add-to-list 'eglot-server-programs '((ladder-mode ladder-test-mode ladder-st-mode) . ladder--server))

(defun ladder-format ()
  "Align the program, or the networks of the region."
  (interactive)
  (if (use-region-p)
      (eglot-format (region-beginning) (region-end))
    (eglot-format-buffer)))

(defun ladder-toggle-comment ()
  "Turn the line, or the lines of the region, into comments, or back.
A comment cannot hold a `#': what is to be written the server knows."
  (interactive)
  (let* ((start (if (use-region-p) (region-beginning) (point)))
         (end (if (use-region-p) (region-end) (point)))
         (first (1- (line-number-at-pos start t)))
         ;; A region that ends before a line's first character does not count that line.
         (last (- (line-number-at-pos end t) (if (and (> end start) (save-excursion (goto-char end) (bolp))) 2 1))))
    ;; What was typed just now is not sent yet.
    (eglot--signal-textDocument/didChange)
    (let ((answer (jsonrpc-request
                   (eglot--current-server-or-lose) :workspace/executeCommand
                   (list :command "ladder.comment"
                         :arguments (vector (list :uri (plist-get (eglot--TextDocumentIdentifier) :uri)
                                                  :lines (vector (list :first first :last last))))))))
      (eglot--apply-text-edits (plist-get answer :edits)))))

(defun ladder--format-before-save ()
  "Align the program if that is wanted and there is a server."
  (when (and ladder-format-on-save (eglot-current-server))
    (ladder-format)))

;;; Comments

(defvar ladder-mode-syntax-table
  (let ((table (make-syntax-table)))
    ;; Which `#' begins or ends a comment is found out by `ladder--propertize'.
    (modify-syntax-entry ?# "." table)
    (modify-syntax-entry ?' "." table)
    (modify-syntax-entry ?\" "." table)
    (modify-syntax-entry ?_ "_" table)
    (modify-syntax-entry ?$ "_" table)
    (modify-syntax-entry ?% "_" table)
    (modify-syntax-entry ?. "_" table)
    (dolist (drawn '(?+ ?- ?| ?/ ?\\ ?* ?= ?< ?>))
      (modify-syntax-entry drawn "." table))
    table)
  "Letters, tags and the characters of drawings.")

(defun ladder--in-declarations-p ()
  "Whether point is between VAR and END_VAR, or TYPE and END_TYPE."
  (save-excursion
    (let ((case-fold-search t))
      (and (re-search-backward "^[ \t]*\\(END_VAR\\|END_TYPE\\|TYPE\\|VAR\\(?:_[A-Z_]+\\)?\\)\\_>" nil t)
           (not (string-prefix-p "END_" (match-string-no-properties 1) t))))))

(defun ladder--same-word-p (one other)
  "Whether ONE and OTHER are the same but for capitals."
  (eq t (compare-strings one nil nil other nil nil t)))

(defconst ladder--before-hash
  (concat "\\(?:^\\|[^[:alnum:]_.]\\)\\(?:[0-9][0-9_]*\\|"
          (regexp-opt '("T" "TIME" "LTIME" "D" "DATE" "TOD" "TIME_OF_DAY" "DT" "DATE_AND_TIME" "BOOL" "BYTE" "WORD" "DWORD"
                        "LWORD" "SINT" "INT" "DINT" "LINT" "USINT" "UINT" "UDINT" "ULINT" "REAL" "LREAL" "STRING"))
          "\\)")
  "What is before the `#' of a literal: a whole number or the word of a type.")

(defun ladder--literal-p (position)
  "Whether the `#' at POSITION is part of a literal, as in T#5s.
That is so after a number or the word of a type, in parentheses and
in declarations."
  (save-excursion
    (goto-char position)
    (and (let ((case-fold-search t))
           (looking-back ladder--before-hash (line-beginning-position)))
         ;; A literal has one `#', and WORD#16#FF two.
         (save-excursion
           (skip-chars-backward "0-9_:+-")
           (or (not (eq (char-before) ?#))
               (looking-at "\\(?:2\\|8\\|16\\)#[[:xdigit:]]")))
         (or (> (car (parse-partial-sexp (line-beginning-position) position)) 0)
             (ladder--in-declarations-p)))))

(defun ladder--propertize (start end)
  "Mark every `#' between START and END that begins or ends a comment.
A comment ends at the very next one."
  (goto-char start)
  (let ((inside (nth 4 (syntax-ppss start))))
    (while (search-forward "#" end t)
      (let ((position (1- (point))))
        (when (or inside (not (ladder--literal-p position)))
          (put-text-property position (point) 'syntax-table (string-to-syntax "!"))
          (setq inside (not inside)))))))

;;; Colours

(defconst ladder--sections
  (concat "^[ \t]*\\("
          (regexp-opt '("VAR" "VAR_INPUT" "VAR_OUTPUT" "VAR_IN_OUT" "VAR_GLOBAL" "VAR_EXTERNAL" "END_VAR"
                        "TYPE" "END_TYPE" "END_STRUCT" "FUNCTION_BLOCK" "END_FUNCTION_BLOCK"))
          "\\)\\_>\\(?:[ \t]+\\(RETAIN\\|CONSTANT\\)\\_>\\)?")
  "What begins and ends sections.")

(defconst ladder--types
  (regexp-opt '("BOOL" "BYTE" "WORD" "DWORD" "LWORD" "SINT" "INT" "DINT" "LINT" "USINT" "UINT" "UDINT" "ULINT" "REAL" "LREAL"
                "TIME" "DATE" "TOD" "DT" "STRING" "ARRAY" "TON" "TOF" "TP" "RTO" "RTOF" "CTU" "CTD" "CTUD" "CTC" "SR" "RS")
              'symbols)
  "The names of types.")

(defconst ladder--keywords
  `((,ladder--sections (1 font-lock-keyword-face) (2 font-lock-keyword-face nil t))
    ;; A block, by its brackets: a condition or function, a coil, program flow.  Its operands follow.
    ("\\[[ \t]*\\(\\$?[[:alnum:]_/]*\\)[ \t]*\\]" . font-lock-function-name-face)
    ("([ \t]*\\(?:\\$?[[:alnum:]_]*\\|/\\)[ \t]*)\\(?:[ \t]*(\\)" 0 font-lock-builtin-face)
    ("<[ \t]*\\$?[[:alnum:]_]+[ \t]*>" . font-lock-keyword-face)
    ("\\_<\\(?:[[:alpha:]]+\\|[0-9]+\\)#-?[[:alnum:]_.:-]+" . font-lock-constant-face)
    ("\\_<[0-9][0-9_.]*\\(?:ms\\|us\\|ns\\|[dhms]\\)?[0-9dhmsun_.]*\\_>" . font-lock-constant-face)
    ("\\_<\\(?:TRUE\\|FALSE\\|PI\\)\\_>" . font-lock-constant-face)
    ("\\_<\\(?:AND\\|OR\\|XOR\\|NOT\\|MOD\\|SHL\\|SHR\\|AT\\|OF\\|STRUCT\\)\\_>" . font-lock-keyword-face)
    (,ladder--types . font-lock-type-face)
    ;; A type of one's own, after the colon and after OF.
    ("\\(?::\\|\\_<OF[ \t]\\)[ \t]*\\(\\$?[[:alpha:]_][[:alnum:]_]*\\)" 1 font-lock-type-face)
    ("\\_<\\([[:alpha:]_][[:alnum:]_]*\\)[ \t]*\\(?::=\\|=>\\)" 1 font-lock-variable-name-face)
    ("'\\(?:\\$.\\|[^'$\n]\\)*'" . font-lock-string-face)
    ("[\\/]" . font-lock-preprocessor-face))
  "Colours of ladder text without its language server.")

;;; The modes

(defvar ladder-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "C-c C-f") #'ladder-format)
    (define-key map (kbd "C-c C-c") #'ladder-start)
    (define-key map [remap comment-line] #'ladder-toggle-comment)
    map)
  "Keys of `ladder-mode'.")

(autoload 'ladder-start "ladder-simulation" "Start a simulation of the program in this buffer." t)
(autoload 'ladder-online "ladder-simulation" "Show what the controller is doing that ladder.toml names." t)

;;;###autoload
(define-derived-mode ladder-mode prog-mode "Ladder"
  "Ladder diagrams as plain text.

\\{ladder-mode-map}"
  (setq-local comment-start "# "
              comment-end " #"
              comment-start-skip "#+[ \t]*"
              comment-end-skip "[ \t]*#"
              syntax-propertize-function #'ladder--propertize
              font-lock-defaults '(ladder--keywords nil t)
              ;; A drawing: what would shift its columns is switched off.
              truncate-lines t
              word-wrap nil
              indent-tabs-mode nil
              tab-width 4
              indent-line-function #'indent-relative-first-indent-point
              electric-indent-inhibit t
              require-final-newline t)
  (auto-fill-mode -1)
  (add-hook 'before-save-hook #'ladder--format-before-save nil t)
  (ladder-treesit-setup))

(defconst ladder--test-keywords
  '(("^[ \t]*\\(scenario\\|program\\|plant\\|connect\\|step\\|interval\\|tolerance\\)\\_>" 1 font-lock-keyword-face)
    ("^[ \t]*\\(time\\)[ \t]+[^= \t]" 1 font-lock-keyword-face)
    ("^[ \t]*\\(property\\)[ \t]+\"" 1 font-lock-keyword-face)
    ;; A row of a tag that is called so has an arrow, or levels.
    ("^[ \t]*\\(assume\\|always\\|never\\|when\\|after\\|within\\|possible\\|no faults\\)\\_>\\(?:[ \t]+[^-=_. \t]\\|$\\)"
     1 font-lock-keyword-face)
    ("^[ \t]*\\(?:when\\|within\\)\\_>.*\\_<\\(until\\|of\\)\\_>" 1 font-lock-keyword-face)
    ("\\_<\\(rises\\|falls\\|was\\)(" 1 font-lock-function-name-face)
    ("\"[^\"\n]*\"" . font-lock-string-face)
    ("'\\(?:\\$.\\|[^'$\n]\\)*'" . font-lock-string-face)
    ("=>" . font-lock-keyword-face)
    ("^[ \t]*\\([^][ \t\n#\"'=]+\\)" 1 font-lock-variable-name-face))
  "Colours of scenarios.")

;;;###autoload
(define-derived-mode ladder-test-mode prog-mode "Ladder-Test"
  "Scenarios of ladder programs: their unit tests."
  (modify-syntax-entry ?# "<" ladder-test-mode-syntax-table)
  (modify-syntax-entry ?\n ">" ladder-test-mode-syntax-table)
  (setq-local comment-start "# "
              comment-end ""
              truncate-lines t
              indent-tabs-mode nil
              electric-indent-inhibit t
              font-lock-defaults '(ladder--test-keywords)))

(defvar ladder-st-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "C-c C-c") #'ladder-start)
    map)
  "Keys of `ladder-st-mode'.")

;;;###autoload
(define-derived-mode ladder-st-mode prog-mode "ST"
  "Structured Text next to ladder programs.

\\{ladder-st-mode-map}"
  (modify-syntax-entry ?\( "()1n" ladder-st-mode-syntax-table)
  (modify-syntax-entry ?* ". 23" ladder-st-mode-syntax-table)
  (modify-syntax-entry ?\) ")(4n" ladder-st-mode-syntax-table)
  (setq-local comment-start "(* "
              comment-end " *)"
              indent-tabs-mode nil
              tab-width 4))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.clad\\'" . ladder-mode))
;; The last one: other languages have files called so, too.
;;;###autoload
(add-to-list 'auto-mode-alist '("\\.st\\'" . ladder-st-mode) t)
;;;###autoload
(add-to-list 'auto-mode-alist '("\\.ladder-test\\'" . ladder-test-mode))

(provide 'ladder-mode)
;;; ladder-mode.el ends here
