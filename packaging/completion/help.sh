# Completion of the program's command line: verbs, options and their choices as `pinball --help` and `pinball VERB --help`
# list them, and scenes and their keys as the program knows them.
# shellcheck shell=bash

# What the help of a verb, or of the program without one, says; lines of text that is too long for one are left out.
_pinball_help() {
  "$program" ${1:+"$1"} --help 2> /dev/null
}

_pinball_verbs() {
  _pinball_help '' | sed -n '/^Subcommands:/,$s/^  \([a-z][a-z-]*\) .*/\1/p'
}

_pinball_options() {
  _pinball_help "$1" | sed -n 's/^  \(-[a-zA-Z], \{0,1\}\)\{0,1\}\(--[a-z-]*\).*/\2/p'
}

# The choices of an option, from `--precision TEXT:{float,double}` or without the colon; nothing where it takes others.
_pinball_choices() {
  _pinball_help "$1" | sed -n "s/^  $2 [A-Z]*:\{0,1\}{\([^}]*\)}.*/\1/p" | tr ',' '\n'
}

# Whether an option is followed by a value: `--out TEXT ...`.
_pinball_takes_value() {
  _pinball_help "$1" | grep -q "^  $2 [A-Z][A-Z]*"
}

_pinball_takes_scenes() {
  _pinball_help "$1" | grep -q '^  SCENE'
}

# The program names its scenes where it is asked for one that is none.
_pinball_scenes() {
  "$program" info ' ' 2>&1 | sed -n 's/.*known scenes: //p' | tr -d ' ' | tr ',' '\n'
}

_pinball_keys() {
  "$program" schema --keys 2> /dev/null
}
