;;; ladder-simulation.el --- Ladder diagrams that run, in their text  -*- lexical-binding: t -*-

;; SPDX-License-Identifier: MIT OR Apache-2.0

;;; Commentary:

;; `ladder-start' simulates the program of the buffer: what has power is coloured, the header line says how the
;; simulation is, and `ladder-tags' lists the tags.  The language server simulates; this draws what it says.
;; It is a simulator, not a safety device.

;;; Code:

(require 'eglot)
(require 'ladder-mode)
(require 'tabulated-list)

(defface ladder-power-on '((((background dark)) :foreground "#4ade80" :weight bold) (t :foreground "#15803d" :weight bold))
  "What has power."
  :group 'ladder)

(defface ladder-power-off '((((background dark)) :foreground "#8b8b8b") (t :foreground "#6b6b6b"))
  "What has no power."
  :group 'ladder)

(defface ladder-power-unknown '((t :inherit ladder-power-off :slant italic))
  "Of which a controller does not say whether it has power."
  :group 'ladder)

(defface ladder-next '((t :inverse-video t))
  "The block that runs next, in the midst of a scan."
  :group 'ladder)

(defvar ladder--waiting nil "Whether an answer of the simulator is being waited for.")
(defvar-local ladder--state nil "The last state of the simulation of this buffer; nil without one.")
(defvar-local ladder--program nil "In a list of tags, the buffer of the program.")
(defvar-local ladder--running nil "In a list of tags, which session and which of its programs they are of.")
(defvar-local ladder--roots nil "In a list of tags, those of the program.")
(defvar-local ladder--opened nil "In a list of tags, an alist of names that are open and what they open into.")

(defvar ladder-simulation-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "<f5>") #'ladder-run)
    (define-key map (kbd "<f6>") #'ladder-pause)
    (define-key map (kbd "S-<f5>") #'ladder-stop)
    (define-key map (kbd "<f10>") #'ladder-step)
    (define-key map (kbd "<f8>") #'ladder-back)
    (define-key map (kbd "<f11>") #'ladder-step-block)
    (define-key map (kbd "<f4>") #'ladder-toggle)
    map)
  "Keys while a program is simulated.")

(define-minor-mode ladder-simulation-mode
  "The program of this buffer is simulated.

\\{ladder-simulation-mode-map}"
  :lighter " Sim"
  :interactive nil
  (setq header-line-format (and ladder-simulation-mode '(:eval (ladder--header)))))

;;; What is sent

(defun ladder--request (name &rest arguments)
  "Send the simulator's command NAME; return the answer.
ARGUMENTS is a property list."
  (let ((ladder--waiting t))
    (jsonrpc-request (eglot--current-server-or-lose) :workspace/executeCommand
                     (list :command (concat "ladder.simulate." name) :arguments (vector arguments)))))

(defun ladder--session ()
  "The session of this buffer, or an error for the user."
  (or (plist-get ladder--state :session)
      (user-error "No simulation: M-x ladder-start begins one")))

(defun ladder--command (name &rest arguments)
  "Send the command NAME of this buffer's session with ARGUMENTS.
The state that comes is drawn."
  (with-current-buffer (or ladder--program (current-buffer))
    (ladder--receive (apply #'ladder--request name :session (ladder--session) arguments))))

;;;###autoload
(defun ladder-start ()
  "Start a simulation of the program in this buffer."
  (interactive)
  (ladder--begin (make-hash-table)))

;;;###autoload
(defun ladder-online ()
  "Show what the controller is doing that ladder.toml names.
It is read, and never written."
  (interactive)
  (ladder--begin '(:online t)))

(defun ladder--begin (options)
  "Begin a session of the program in this buffer with OPTIONS."
  (unless (eglot-current-server)
    (user-error "Ladder: the language server does not run here; M-x eglot starts it"))
  (when ladder--state
    (ladder-stop))
  ;; What was typed just now is not sent yet.
  (eglot--signal-textDocument/didChange)
  (let* ((uri (plist-get (eglot--TextDocumentIdentifier) :uri))
         (started (ladder--request "start" :uri uri :options options)))
    (ladder-simulation-mode 1)
    (ladder--receive (plist-get started :state))
    (seq-doseq (note (plist-get started :notes))
      (message "Ladder: %s" note))))

(defun ladder-stop ()
  "End the simulation."
  (interactive)
  (ladder--request "stop" :session (ladder--session))
  (ladder--forget))

(defun ladder-step (scans)
  "Do one scan, or SCANS of them."
  (interactive "p")
  (ladder--command "step" :scans scans))

(defun ladder-back (scans)
  "Go back one scan, or SCANS of them."
  (interactive "p")
  (ladder--command "back" :scans scans))

(defun ladder-step-block ()
  "Go on to the next block."
  (interactive)
  (ladder--command "stepBlock"))

(defun ladder-run ()
  "Run in real time."
  (interactive)
  (ladder--command "run"))

(defun ladder-pause ()
  "Stop a run, to go on later."
  (interactive)
  (ladder--command "pause"))

(defun ladder-toggle (tag)
  "Invert TAG, which is of BOOL; the one at point, or one that is asked for."
  (interactive (list (ladder--ask-tag "Toggle" (lambda (tag) (equal (plist-get tag :type) "BOOL")))))
  (let ((known (ladder--tag tag)))
    (ladder--command (if (ladder--true-p known :forced) "force" "set")
                     :tag tag :value (if (ladder--true-p known :value) :json-false t))))

(defun ladder-set (tag value)
  "Give TAG a VALUE, written as the language writes it."
  (interactive (ladder--ask-value "Set"))
  (ladder--command "set" :tag tag :text value))

(defun ladder-force (tag value)
  "Hold TAG at VALUE until `ladder-release'."
  (interactive (ladder--ask-value "Force"))
  (ladder--command "force" :tag tag :text value))

(defun ladder-release (tag)
  "Release the force of TAG."
  (interactive (list (ladder--ask-tag "Release" (lambda (tag) (ladder--true-p tag :forced)))))
  (ladder--command "unforce" :tag tag))

;;; Tags

(defun ladder--true-p (plist key)
  "Whether PLIST has true at KEY: in JSON what is false is something."
  (not (memq (plist-get plist key) '(nil :json-false))))

(defun ladder--tags ()
  "The tags of the program as the server last said them."
  (with-current-buffer (or ladder--program (current-buffer))
    (append (plist-get ladder--state :tags) nil)))

(defun ladder--tag (name)
  "What is known of the tag NAME; capitals do not matter."
  (seq-find (lambda (tag) (ladder--same-word-p name (plist-get tag :name))) (ladder--tags)))

(defun ladder--ask-tag (verb wanted)
  "The name of the tag at point that is WANTED.
Without one a tag is asked for, with VERB."
  (let ((here (or (tabulated-list-get-id) (thing-at-point 'symbol t)))
        (names (mapcar (lambda (tag) (plist-get tag :name)) (seq-filter wanted (ladder--tags)))))
    (or (seq-find (lambda (name) (and here (ladder--same-word-p name here))) names)
        (completing-read (format "%s tag: " verb) names nil t))))

(defun ladder--ask-value (verb)
  "The name of a tag and a value for it, as VERB asks for them."
  (let ((tag (ladder--ask-tag verb (lambda (tag) (not (ladder--true-p tag :readOnly))))))
    (list tag (read-string (format "%s %s to: " verb tag)))))

(defun ladder--show-value (tag)
  "The value of TAG as text, with a mark if it is forced."
  (concat (plist-get tag :text) (if (ladder--true-p tag :forced) "!" "")))

(defvar ladder-tags-mode-map
  (let ((map (make-sparse-keymap)))
    (define-key map (kbd "RET") #'ladder-toggle-or-open)
    (define-key map (kbd "TAB") #'ladder-open-or-close)
    (define-key map "t" #'ladder-toggle)
    (define-key map "s" #'ladder-set)
    (define-key map "f" #'ladder-force)
    (define-key map "u" #'ladder-release)
    (define-key map (kbd "<f10>") #'ladder-step)
    map)
  "Keys in a list of tags.")

(define-derived-mode ladder-tags-mode tabulated-list-mode "Ladder-Tags"
  "The tags of a simulated program.

\\{ladder-tags-mode-map}"
  (setq tabulated-list-format [("Tag" 24 nil) ("Value" 14 nil) ("Type" 8 nil) ("Role" 8 nil)])
  (tabulated-list-init-header))

(defun ladder--search (&rest arguments)
  "The tags that the server lists for ARGUMENTS, a property list."
  (let ((found (with-current-buffer (or ladder--program (current-buffer))
                 (apply #'ladder--request "tags" :session (ladder--session) arguments))))
    (append (plist-get found :tags) nil)))

(defun ladder--rows (tags depth)
  "The rows of TAGS, in DEPTH others, with what those open into that are open."
  (seq-mapcat (lambda (tag)
                (let ((name (plist-get tag :name)))
                  (cons (cons depth tag)
                        (ladder--rows (cdr (assoc name ladder--opened)) (1+ depth)))))
              tags))

(defun ladder--row (row now)
  "ROW as the list shows it, with its value among the tags NOW."
  (let* ((name (plist-get (cdr row) :name))
         (tag (or (gethash (downcase name) now) (cdr row)))
         (sign (cond ((not (plist-get tag :parts)) "") ((assoc name ladder--opened) "- ") (t "+ "))))
    (list name (vector (concat (make-string (* 2 (car row)) ?\s) sign name)
                       (ladder--show-value tag) (plist-get tag :type) (plist-get tag :role)))))

(defun ladder--list-tags ()
  "Write the tags into this list of them."
  (let* ((state (buffer-local-value 'ladder--state ladder--program))
         (running (list (plist-get state :session) (plist-get state :program)))
         (now (make-hash-table :test 'equal)))
    (unless (equal running ladder--running)
      (setq ladder--running running ladder--opened nil ladder--roots (ladder--search :of "")))
    (let* ((rows (ladder--rows ladder--roots 0))
           (add (lambda (tag) (puthash (downcase (plist-get tag :name)) tag now)))
           (names (mapcar (lambda (row) (plist-get (cdr row) :name)) rows)))
      (mapc add (ladder--tags))
      ;; The state has what has a value, but no elements of long arrays.
      (when-let ((others (seq-remove (lambda (name) (gethash (downcase name) now)) names)))
        (mapc add (ladder--search :names (vconcat others))))
      (setq tabulated-list-entries (mapcar (lambda (row) (ladder--row row now)) rows))
      (tabulated-list-print t))))

(defun ladder-open-or-close ()
  "Open the structure, array or state of a block at point, or close it."
  (interactive)
  (let ((name (tabulated-list-get-id)))
    (if (assoc name ladder--opened)
        (setq ladder--opened (assoc-delete-all name ladder--opened))
      (when-let ((parts (and name (ladder--search :of name))))
        (push (cons name parts) ladder--opened)))
    (ladder--list-tags)))

(defun ladder-toggle-or-open ()
  "Invert the tag at point, or open or close it if it opens."
  (interactive)
  (let ((name (tabulated-list-get-id)))
    (if (seq-find (lambda (row) (and (equal (plist-get (cdr row) :name) name) (plist-get (cdr row) :parts)))
                  (ladder--rows ladder--roots 0))
        (ladder-open-or-close)
      (call-interactively #'ladder-toggle))))

(defun ladder--tags-buffer (program)
  "The buffer that lists the tags of the buffer PROGRAM, if there is one."
  (seq-find (lambda (buffer) (eq (buffer-local-value 'ladder--program buffer) program)) (buffer-list)))

(defun ladder-tags ()
  "List the tags of the program with their values, live."
  (interactive)
  (ladder--session)
  (let* ((program (current-buffer))
         (buffer (or (ladder--tags-buffer program)
                     (generate-new-buffer (format "*Ladder tags: %s*" (buffer-name program))))))
    (with-current-buffer buffer
      (ladder-tags-mode)
      (setq ladder--program program)
      (ladder--list-tags))
    (display-buffer buffer)))

;;; What is received

(defun ladder--region (range)
  "The beginning and end of RANGE, as the server says it, in this buffer."
  (if (fboundp 'eglot-range-region)
      (funcall 'eglot-range-region range)
    (funcall 'eglot--range-region range)))

(defun ladder--undraw ()
  "Take all that was drawn out of the text."
  (remove-overlays nil nil 'ladder t))

(defun ladder--overlay (range face)
  "Draw what lies in RANGE in FACE."
  (pcase-let* ((`(,start . ,end) (ladder--region range))
               (overlay (make-overlay start end)))
    (overlay-put overlay 'ladder t)
    (overlay-put overlay 'face face)
    (overlay-put overlay 'evaporate t)))

(defun ladder--power-face (element)
  "The face of an ELEMENT of the drawing."
  (cond ((ladder--true-p element :unknown) 'ladder-power-unknown)
        ((ladder--true-p element :on) 'ladder-power-on)
        (t 'ladder-power-off)))

(defun ladder--draw ()
  "Draw the state into the text."
  (ladder--undraw)
  (seq-doseq (element (plist-get ladder--state :power))
    (ladder--overlay (plist-get element :range) (ladder--power-face element)))
  (when-let ((next (plist-get ladder--state :next)))
    (ladder--overlay next 'ladder-next)))

(defun ladder--header ()
  "How the simulation is, for the header line."
  (let ((keys (if (plist-get ladder--state :controller)
                  "F6 hold  F5 go on"
                "F5 run  F6 pause  F10 step  F8 back  F4 toggle")))
    (format " %s   %s" (plist-get ladder--state :text) keys)))

(defun ladder--forget ()
  "There is no simulation of this buffer any more."
  (setq ladder--state nil)
  (ladder--undraw)
  (ladder-simulation-mode -1)
  (when-let ((list (ladder--tags-buffer (current-buffer))))
    (kill-buffer list)))

(defun ladder--receive (state)
  "Draw STATE, which is of this buffer's program."
  (setq ladder--state state)
  (save-excursion
    (save-restriction
      (widen)
      (ladder--draw)))
  (force-mode-line-update)
  (when-let ((list (ladder--tags-buffer (current-buffer))))
    ;; It may ask the server, which is not possible while that is being read.
    (run-at-time 0 nil #'ladder--list-tags-later list)))

(defun ladder--list-tags-later (list)
  "Write the tags into LIST as soon as no answer is waited for.
A request within the wait for another would leave what arrives with its
answer unread, and the other would wait for that until its time is out."
  (cond (ladder--waiting (run-at-time 0.02 nil #'ladder--list-tags-later list))
        ((and (buffer-live-p list) (buffer-local-value 'ladder--state (buffer-local-value 'ladder--program list)))
         (with-current-buffer list
           (ladder--list-tags)))))

(cl-defmethod eglot-handle-notification (_server (_method (eql ladder/simulationState)) &rest state)
  "Draw STATE into the program that it is of."
  (dolist (buffer (buffer-list))
    (when (equal (plist-get (buffer-local-value 'ladder--state buffer) :session) (plist-get state :session))
      (with-current-buffer buffer
        (if (equal (plist-get state :status) "ended")
            ;; The program came to its end, or the session did: the one can be inspected.
            (if (plist-get state :power) (ladder--receive state) (ladder--forget))
          (ladder--receive state))))))

(provide 'ladder-simulation)
;;; ladder-simulation.el ends here
