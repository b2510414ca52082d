;;; plcxx.el --- PLC programs of machine tools with plcxx -*- lexical-binding: t -*-

;; Modes for the languages of plcxx, and its language server for Eglot (part of Emacs 29, a package before).
;; See docs/editors/emacs.md.

;;; Code:

(defgroup plcxx nil "PLC programs of machine tools." :group 'languages)

(defcustom plcxx-program "plcxx" "The program plcxx: a name that is looked for in PATH, or a path." :type 'string)

(defun plcxx--comments (start end)
  "Comments begin with START and end with END, which may be empty."
  (setq-local comment-start start)
  (setq-local comment-end end))

(defun plcxx--syntax (comment)
  "A syntax table in which COMMENT begins a comment up to the end of the line."
  (let ((table (make-syntax-table)))
    (modify-syntax-entry comment "<" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?\' "." table)
    table))

;; ".plc" belongs to three languages: the server chooses by plcxx.yaml, else by content.
(define-derived-mode plcxx-mode prog-mode "PLC"
  "PLC programs of machine tools."
  :syntax-table (plcxx--syntax ?\;)
  (plcxx--comments ";" ""))
(define-derived-mode plcxx-nc110-mode plcxx-mode "NC-110" "Programs of NC-110 to NC-400.")
(define-derived-mode plcxx-host50-mode plcxx-mode "HOST-50" "Programs of HOST 50.")
(define-derived-mode plcxx-prostep-mode plcxx-mode "PROSTEP" "Programs of PROSTEP.")
(define-derived-mode plcxx-technol-mode plcxx-mode "TECHNOL" "Programs of TECHNOL.")
(define-derived-mode plcxx-classicladder-mode plcxx-mode "CLASSICLADDER" "Projects of ClassicLadder.")
(define-derived-mode plcxx-hnc-mode c-mode "HNC" "Programs of Huazhong HNC." )

(dolist (row '(("\\.plc\\'" . plcxx-mode)
               ("\\.sym\\'" . plcxx-nc110-mode)
               ("\\.il\\'" . plcxx-host50-mode)
               ("\\.pst\\'" . plcxx-prostep-mode)
               ("\\.tch\\'" . plcxx-technol-mode)
               ("\\.clp\\'" . plcxx-classicladder-mode)
               ("\\.cld\\'" . plcxx-hnc-mode)))
  (add-to-list 'auto-mode-alist row))

(defvar eglot-server-programs)
(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs
               (cons '(plcxx-mode plcxx-nc110-mode plcxx-host50-mode plcxx-prostep-mode plcxx-technol-mode plcxx-classicladder-mode
                                plcxx-hnc-mode)
                     (lambda (&rest _) (list plcxx-program "lsp")))))

;; The folder of plcxx.yaml is the project.
(defun plcxx--project (folder)
  "The plcxx project that FOLDER is in."
  (let ((root (locate-dominating-file folder "plcxx.yaml")))
    (and root (cons 'plcxx root))))
(add-hook 'project-find-functions #'plcxx--project)
(with-eval-after-load 'project
  (cl-defmethod project-root ((project (head plcxx))) (cdr project)))

(provide 'plcxx)
;;; plcxx.el ends here
