# shellcheck shell=bash
# whole PATH: a pattern for grep -E that finds it as a whole path: /p is in -I/p and in "/p/x", and not in -I/x/pushback.
whole() { printf '(^|[ "=]|-[IL])%s([/" ]|$)' "$(sed 's/[].[*^$+?(){}|\]/\\&/g' <<<"$1")"; }
