;;; test.el --- Emacs with the mode and the built server, step by step  -*- lexical-binding: t -*-

;; Called by tests/editors/emacs/run.

(require 'flymake)
(require 'ladder-mode)
(require 'ladder-simulation)

(defvar failed 0)

(defmacro step (name &rest body)
  "Run BODY; say whether what NAME says holds."
  (declare (indent 1))
  `(let ((started (float-time)))
     (condition-case problem
         (progn ,@body (princ (format "ok    emacs: %s (%.0f ms)\n" ,name (* 1000 (- (float-time) started)))))
       (error (setq failed (1+ failed))
              (princ (format "FAIL  emacs: %s\n      %s\n" ,name (error-message-string problem)))))))

(defun same (what wanted found)
  "Raise an error about WHAT unless WANTED and FOUND are equal."
  (unless (equal wanted found)
    (error "%s: %S expected, %S found" what wanted found)))

(defmacro eventually (what &rest body)
  "Wait until BODY gives something, and return that; WHAT is waited for."
  (declare (indent 1))
  `(let ((limit (+ (float-time) 10)) found)
     (while (not (setq found (progn ,@body)))
       (when (> (float-time) limit)
         (error "Waited 10 s in vain for %s" ,what))
       (accept-process-output nil 0.02))
     found))

(defvar opened 0)

(defun open (name &optional text)
  "Open a fresh copy of the fixture NAME, or TEXT under that name, in a folder of its own, with the server."
  (setq opened (1+ opened))
  (let ((folder (expand-file-name (number-to-string opened) (getenv "LADDER_SCRATCH"))))
    (make-directory folder t)
    (write-region "" nil (expand-file-name "ladder.toml" folder) nil 'quiet)
    (if text
        (write-region text nil (expand-file-name name folder) nil 'quiet)
      (copy-file (expand-file-name name (getenv "LADDER_FIXTURES")) (expand-file-name name folder)))
    (find-file (expand-file-name name folder))
    (unless (eglot-current-server)
      (apply #'eglot--connect (eglot--guess-contact)))
    (eventually "the language server to attach" (and (eglot-managed-p) (eglot-current-server)))))

(defun ask (method)
  "What the server says of the place of the cursor to METHOD."
  (eglot--signal-textDocument/didChange)
  (jsonrpc-request (eglot-current-server) method (eglot--TextDocumentPositionParams)))

(defun faced (face)
  "The text of the buffer, where what is not in FACE is blank; lines without blanks at their ends."
  (let ((shown ""))
    (dotimes (index (buffer-size))
      (let ((faces (ensure-list (get-char-property (1+ index) 'face)))
            (letter (char-after (1+ index))))
        (setq shown (concat shown (if (or (eq letter ?\n) (memq face faces)) (string letter) " ")))))
    (split-string (replace-regexp-in-string " +$" "" shown) "\n")))

(defun in-comments ()
  "The lines of the buffer, where what is not a comment is blank."
  (font-lock-ensure)
  (let ((faces '(font-lock-comment-face font-lock-comment-delimiter-face)) (shown ""))
    (dotimes (index (buffer-size))
      (let ((letter (char-after (1+ index))))
        (setq shown (concat shown (if (or (eq letter ?\n) (memq (get-text-property (1+ index) 'face) faces)) (string letter) " ")))))
    (split-string (replace-regexp-in-string " +$" "" shown) "\n")))

(step "a missing server is said, with what to do"
  (let ((ladder-server-program nil)
        (exec-path '("." "bin"))
        (process-environment (cons "CARGO_HOME=/nowhere" process-environment)))
    (same "the program" nil (ladder--find-program))
    (condition-case problem
        (progn (ladder--server) (error "Nothing was said"))
      (user-error (unless (string-search "cargo install" (error-message-string problem))
                    (error "%s" (error-message-string problem)))))))

(step "comments end at the next #, and a literal begins none"
  (with-temp-buffer
    (insert "# two\nlines #\n+--[TON]( t, T#5s )--( )( y )--+ # why #\nVAR\n  t : TIME := T#1s;  # how long #\nEND_VAR\nletter#a#\n")
    (ladder-mode)
    (same "the comments"
          '("# two" "lines #" "                                 # why #" "" "                     # how long #" "" "      #a#" "")
          (in-comments))))

(step "blocks, literals and sections have colours"
  (with-temp-buffer
    (insert "VAR RETAIN\n+--[TON]( t, T#5s )--( )( y )--+\n")
    (ladder-mode)
    (font-lock-ensure)
    (same "a section" '("VAR RETAIN" "" "") (faced 'font-lock-keyword-face))
    (same "a block" '("" "   [TON]" "") (faced 'font-lock-function-name-face))
    (same "a literal" '("" "             T#5s" "") (faced 'font-lock-constant-face))
    (same "a coil" '("" "                     ( )(" "") (faced 'font-lock-builtin-face))))

(step "types of one's own have colours"
  (with-temp-buffer
    (insert "TYPE\n  Motor : STRUCT\n    speed : Speed := 50; # rpm #\n  END_STRUCT;\nEND_TYPE\nVAR\n  m : ARRAY[1..2] OF $Motor; t : TIME := T#1s;\nEND_VAR\n")
    (ladder-mode)
    (font-lock-ensure)
    (same "the keywords"
          '("TYPE" "          STRUCT" "" "  END_STRUCT" "END_TYPE" "VAR" "                  OF" "END_VAR" "")
          (faced 'font-lock-keyword-face))
    (same "the types"
          '("" "" "            Speed" "" "" "" "      ARRAY          $Motor      TIME" "" "")
          (faced 'font-lock-type-face))
    (same "the comments" '("" "" "                         # rpm #" "" "" "" "" "" "") (in-comments))))

(step "each colour of the Tree-sitter grammar has a face"
  (let* ((ladder-treesit--colours (expand-file-name "editors/tree-sitter/queries/highlights.scm" (getenv "LADDER_ROOT")))
         (query (ladder-treesit--query)))
    ;; Versions of Emacs differ in how they are written.
    (same "predicates" nil (string-match "(#" query))
    (unless (string-match-p "\"END_VAR\"" query)
      (error "The query is empty"))))

(step "the server knows the language, and finds nothing wrong with a good program"
  (open "motor.clad")
  (same "the mode" 'ladder-mode major-mode)
  (same "'truncate-lines'" t truncate-lines))

(step "a connector without a partner is marked at its place"
  (open "unpaired.clad")
  (flymake-mode 1)
  (flymake-start)
  (let ((found (eventually "a finding" (flymake-diagnostics))))
    (unless (seq-find (lambda (one) (string-search "has no partner" (flymake-diagnostic-text one))) found)
      (error "%S" (mapcar #'flymake-diagnostic-text found)))))

(step "a block is explained"
  (open "motor.clad")
  (search-forward "[TO")
  (let ((hover (jsonrpc-request (eglot-current-server) :textDocument/hover (eglot--TextDocumentPositionParams))))
    (unless (string-search "TON" (format "%S" hover))
      (error "%S" hover))))

(step "aligning a crooked drawing, by command and on save"
  (open "crooked.clad")
  (ladder-format)
  (goto-char (point-min))
  (search-forward "stop")
  (same "the rung" "+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+"
        (buffer-substring-no-properties (line-beginning-position) (line-end-position)))
  (open "saved.clad" "+-[ ](a)-( )(b)-+\n")
  (let ((ladder-format-on-save t))
    (insert " ")
    (delete-char -1)
    (save-buffer))
  (same "the saved rung" "+--[ ]( a )----------------------------------------------------------( )( b )--+\n" (buffer-string)))

(step "comments are toggled, without what would end them"
  (open "motor.clad")
  (let ((before (buffer-string)))
    (search-forward "[TON]")
    (ladder-toggle-comment)
    (same "the line" "# +--[ ]( run )----------------------------[TON]( warmup, 20ms )--( )( lamp )--+ #"
          (buffer-substring-no-properties (line-beginning-position) (line-end-position)))
    (ladder-toggle-comment)
    (same "the text" (string-replace "T#20ms" "20ms" before) (buffer-string))))

(step "completion proposes the tags that fit"
  (open "typed.clad" "+--[ ]( start )--( )( st )--+\n")
  (goto-char (point-min))
  (search-forward "( )( st")
  (let* ((capf (eglot-completion-at-point))
         (names (all-completions "" (nth 2 capf))))
    (unless (seq-find (lambda (name) (string-prefix-p "start" name)) names)
      (error "%S" names))))

(step "a simulation draws its power, and a toggle changes it"
  (open "motor.clad")
  (ladder-start)
  (same "the mode" t ladder-simulation-mode)
  (goto-char (point-min))
  (search-forward "( start")
  (ladder-toggle (ladder--ask-tag "Toggle" #'identity))
  (ladder-step 3)
  (same "the header" " paused, scan 3, 30ms" (substring (ladder--header) 0 21))
  (same "what has power"
        '("" "+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+"
          "" "   /--[ ]( run )----/" ""
          "+--[ ]( run )----------------------------[TON]( warmup, T#20ms )--( )( lamp )--+" "")
        (eventually "the lamp to have power"
          (let ((shown (faced 'ladder-power-on)))
            (and (string-search "lamp" (nth 5 shown)) shown)))))

(step "the tags are listed, live"
  (ladder-tags)
  (let ((list (ladder--tags-buffer (current-buffer))))
    (with-current-buffer list
      (goto-char (point-min))
      (search-forward-regexp "^lamp +1 +BOOL +output"))
    (ladder-force "stop" "1")
    (ladder-step 1)
    (eventually "the lamp to go out"
      (with-current-buffer list
        (goto-char (point-min))
        (and (search-forward-regexp "^stop +1! +BOOL" nil t) (search-forward-regexp "^lamp +0" nil t))))
    (unless (string-search ", 1 forced" (ladder--header))
      (error "%s" (ladder--header)))
    (ladder-back 1)
    (same "the scan" 3 (plist-get ladder--state :scan))))

(step "an edit goes on with what runs"
  (goto-char (point-min))
  (insert "# more #\n")
  (eglot--signal-textDocument/didChange)
  (eventually "the power, a line below" (string-prefix-p "+--\\--[ ]( start" (nth 2 (faced 'ladder-power-on)))))

(step "stop takes everything away"
  ;; The list of tags has just heard of another program, and would ask for its tags while the stop is answered.
  (with-current-buffer (ladder--tags-buffer (current-buffer))
    (setq ladder--running nil))
  (ladder--receive ladder--state)
  (ladder-stop)
  (same "the power" nil (seq-find (lambda (line) (not (string= line ""))) (faced 'ladder-power-on)))
  (same "the header line" nil header-line-format))

(step "structures, arrays and long arrays open in the list of tags"
  (open "tree.clad" (concat "TYPE\n    Motor : STRUCT\n        speed : INT := 7;\n        on : BOOL;\n    END_STRUCT;\nEND_TYPE\n"
                            "VAR\n    lines : ARRAY[1..2] OF Motor;\n    table : ARRAY[1..1000] OF INT;\n    k : INT := 150;\nEND_VAR\n"
                            "+--[ADD]( lines[2].speed, lines[2].speed, 1 )--[MOV]( table[k], lines[2].speed )--+\n"))
  (eventually "the program to be known" (ignore-errors (ladder-start) t))
  (ladder-tags)
  (let ((list (ladder--tags-buffer (current-buffer))))
    (cl-flet ((row (text)
                (with-current-buffer list
                  (goto-char (point-min))
                  (unless (search-forward-regexp text nil t)
                    (error "No row %s in\n%s" text (buffer-string)))
                  (beginning-of-line)))
              (press () (with-current-buffer list (ladder-toggle-or-open))))
      (row "^\\+ lines ")
      (press)
      (row "^  \\+ lines\\[2\\] +speed=7 on=FALSE")
      (press)
      (row "^    lines\\[2\\]\\.speed +7 ")
      (row "^\\+ table ")
      (press)
      (row "^  \\+ table\\[101\\] \\.\\. table\\[200\\]")
      (press)
      (ladder-step 1)
      (sit-for 0.3)
      (row "^  - lines\\[2\\] +speed=8 on=FALSE")
      (row "^    table\\[150\\] +8 ")
      (row "^- table ")
      (press)
      (row "^\\+ table ")))
  (ladder-stop))

;; Scenarios and properties have no code of their own in Emacs: this is what Eglot makes of them.
(defvar shutter "VAR_INPUT go_up, go_down : BOOL; END_VAR\nVAR_OUTPUT up, down : BOOL; END_VAR
+--[ ]( go_up )----[/]( down )--( )( up )--+\n\n+--[ ]( go_down )--[/]( up )----( )( down )--+\n")

(defun open-properties (text)
  "Open TEXT as the file of properties of a program."
  (open "shutter.clad" shutter)
  (let ((folder default-directory))
    (write-region text nil (expand-file-name "shutter.ladder-test" folder) nil 'quiet)
    (find-file (expand-file-name "shutter.ladder-test" folder))
    (eventually "the language server to attach" (and (eglot-managed-p) (eglot-current-server)))))

(step "what is wrong in a property is marked at its place"
  (open-properties "program shutter.clad\n\nproperty \"not both\"\nnever up and dwn\n")
  (same "the mode" 'ladder-test-mode major-mode)
  (flymake-mode 1)
  (flymake-start)
  (let ((found (car (eventually "a finding" (flymake-diagnostics)))))
    (unless (string-search "dwn" (flymake-diagnostic-text found))
      (error "%S" (flymake-diagnostic-text found)))
    (same "the line" 4 (line-number-at-pos (flymake-diagnostic-beg found)))))

(step "completion proposes the forms of properties, and the tags of their program"
  (open-properties "program shutter.clad\n\nnever up and do\nwi\n")
  (cl-flet ((proposed ()
              (eglot--signal-textDocument/didChange)
              (all-completions "" (nth 2 (eglot-completion-at-point)))))
    (goto-char (point-min))
    (search-forward "and do")
    (unless (member "down" (mapcar #'string-trim (proposed)))
      (error "%S" (proposed)))
    (search-forward "wi")
    (unless (seq-find (lambda (name) (string-prefix-p "within" (string-trim name))) (proposed))
      (error "%S" (proposed)))))

(step "a property is explained"
  (open-properties "program shutter.clad\n\nnever up and down\n")
  (goto-char (point-min))
  (search-forward "nev")
  (let ((of-form (format "%S" (ask :textDocument/hover))))
    (search-forward "and do")
    (let ((of-tag (format "%S" (ask :textDocument/hover))))
      (unless (and (string-search "Violated in a scan after which the condition is TRUE" of-form) (string-search "BOOL" of-tag))
        (error "%s %s" of-form of-tag)))))

(step "a tag that is renamed in a property is renamed in the program"
  (open-properties "program shutter.clad\n\nnever up and down\n")
  (goto-char (point-min))
  (search-forward "and do")
  (let ((eglot-confirm-server-initiated-edits nil) (inhibit-message t))
    (eglot-rename "lowers"))
  (same "the property" "never up and lowers" (buffer-substring-no-properties (line-beginning-position) (line-end-position)))
  (with-current-buffer (find-buffer-visiting (expand-file-name "shutter.clad"))
    (unless (string-search "( )( lowers )" (buffer-string))
      (error "%s" (buffer-string)))))

;; Eglot makes no files: there must be one for the property.
(step "two outputs that lock each other propose a property"
  (open-properties "program shutter.clad\n")
  (find-file (expand-file-name "shutter.clad"))
  (goto-char (point-min))
  (search-forward "( )( u")
  (let* ((here (eglot--pos-to-lsp-position))
         (params (list :textDocument (eglot--TextDocumentIdentifier) :range (list :start here :end here)
                       :context (list :diagnostics [])))
         (offered (jsonrpc-request (eglot-current-server) :textDocument/codeAction params)))
    (unless (seq-find (lambda (one) (string-search "never up and down" (plist-get one :title))) offered)
      (error "%S" (mapcar (lambda (one) (plist-get one :title)) offered)))))

(step "the power of a running controller is shown in the text"
  (open "watched.clad")
  (write-region (format "[online]\nmodbus = \"%s\"\n" (getenv "LADDER_CONTROLLER")) nil
                (expand-file-name "ladder.toml" default-directory) nil 'quiet)
  (jsonrpc-notify (eglot-current-server) :workspace/didChangeWatchedFiles
                  (list :changes (vector (list :uri (eglot--path-to-uri (expand-file-name "ladder.toml")) :type 2))))
  (ladder-online)
  (eventually "the values" (string-search "READ ONLY; values" (or (plist-get ladder--state :text) "")))
  (eventually "the power" (seq-find (lambda (line) (string-search "( )( run )" line)) (faced 'ladder-power-on)))
  (eventually "what follows an edge is not known"
              (seq-find (lambda (line) (string-search "( )( begun )" line)) (faced 'ladder-power-unknown)))
  (condition-case problem
      (progn (ladder-set "start" "FALSE") (error "Nothing was refused"))
    (error (unless (string-search "only watched" (error-message-string problem))
             (error "%s" (error-message-string problem)))))
  (ladder-stop))

(kill-emacs (if (= failed 0) 0 1))
;;; test.el ends here
