#!/usr/bin/env bash
# Tests of ./course itself, in a scratch copy where the package manager, CMake and the chapters are stand-ins.
# shellcheck disable=SC2016  # the stand-ins' scripts are quoted as they are
set -uo pipefail
unset CI  # where this is run: a test that means CI says so
root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

mkdir -p "$scratch"/{bin,sub,home/build/release/programs,home/chapters/{03_three,04_four,10_ten}}
cp "$root/course" "$root/CMakePresets.json" "$scratch/home"
touch "$scratch/home/build/release/build.ninja"

# The only programs ./course gets to see: these of the system, and those that a test puts beside them.
system() { for tool; do ln -sf "$(type -P "$tool")" "$scratch/bin/$tool"; done; }
system awk bash cat cmp cp cut dirname env find fold grep ln mkdir readlink realpath rm sed seq sh sha256sum sleep sort tail touch true xargs
script() {  # script FILE TEXT; removed first: writing through a link would change the system's own program
  rm -f "$1"
  printf '#!/bin/sh\n%s\n' "$2" >"$1" && chmod +x "$1"
}
stand_in() { script "$scratch/bin/$1" "$2"; }
program() { script "$scratch/home/build/release/programs/$1" "${2:-echo \"$1: \$* in \$PWD\"}"; }  # one that the build would make
stand_in cmake 'echo "cmake $*"'
stand_in ctest 'echo "ctest $*"'
stand_in git 'echo "git $*"'
stand_in nproc 'echo 2'

wrong() { printf '%s\n' "line ${BASH_LINENO[1]}: $1; the output was:" "$output" "----"; failures=$((failures + 1)); }
course() { output=$(cd "$scratch/sub" && PATH=$scratch/bin "$scratch/home/course" "$@" </dev/null 2>&1); status=$?; }
expect() {  # expect STATUS TEXT...: how the last call ended, and what it said
  local text
  [[ $status == "$1" ]] || wrong "exit status $status instead of $1"
  for text in "${@:2}"; do [[ $output == *"$text"* ]] || wrong "not said: $text"; done
}
expect_not() { local text; for text; do [[ $output != *"$text"* ]] || wrong "should not say: $text"; done; }

# Help names every command of the table, and everything that stands in it has its function.
course --help
expect 0 "render [CHAPTER...]"
mapfile -t names <<<"$(sed -n 's/^  "\([a-z-]*\)|.*/\1/p' "$root/course")"
for name in "${names[@]}"; do
  expect 0 "  $name "
  grep -q "^command_${name//-/_}()" "$root/course" || wrong "no function for $name"
done
expect 0 --yes --preset "chapters: 03_three 04_four 10_ten" release sanitize
course && expect 0 "usage: ./course"

# What is unknown is refused by name, with what is allowed, before anything is installed or built.
refused() { expect 2 "$@"; expect_not cmake ninja "packages are missing"; }
course rendr && refused "unknown command 'rendr'" "the commands are: render test mine exercise study hard-cases"
course render 09 && refused "unknown chapter '09'" "the chapters are: 03_three 04_four 10_ten"
course test --lng && refused "unknown option '--lng'" "the options are: --yes --preset --help --long" "./course test -- --lng"
course render --beta 1 && refused "unknown option '--beta'" "./course render -- --beta"
course hard-cases --peers --quick && refused "one of the two"
for many in 0 1 1000 x ""; do
  course grade --shards "$many" && refused "--shards is '$many': a number of parts, from 2 to 999, is needed"
done
course grade --shards 2 --shard=1/2 && refused "split and join the work themselves: --shard=1/2 is not allowed"
course run solve --preset relase a.dat && refused "unknown preset 'relase'" "the presets are: release debug sanitize tidy threads ci clang odr"
course clean up && refused "'clean' takes no words"
course --yes && refused "a command is needed"
course book --yes -- --address ftp://x && refused "--address is 'ftp://x'" "https://"

# A checkout in which nothing can be written.
mv "$scratch/home/build" "$scratch/home/built" && touch "$scratch/home/build"
course render && expect 2 "$scratch/home is not writable" "git clone $scratch/home pushback" && expect_not "cmake"
rm "$scratch/home/build" && mv "$scratch/home/built" "$scratch/home/build"

# Drawing is a part of the build: CMake and Ninja themselves, here with programs in the place of chapters.
system cmake ninja
cp "$root/chapters/draw.cmake" "$scratch/home/chapters"
cat >"$scratch/home/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(home LANGUAGES NONE)
include(chapters/draw.cmake)
foreach(name 03_three 04_four 10_ten)
  add_executable(${name} IMPORTED)
  set_target_properties(${name} PROPERTIES IMPORTED_LOCATION ${PROJECT_BINARY_DIR}/programs/${name})
  add_drawing(${name})
endforeach()
END
rm "$scratch/home/build/release/build.ninja"
chapter() {  # chapter NAME [FIRST]: what its program does
  program "$1" "${2-}
echo \"run $1: \$*\"
mkdir -p renders/$1 && cd renders/$1 && touch sheet.png plot.png && echo \"numbers of $1\" >numbers.md"
}
for name in 03_three 04_four 10_ten; do chapter $name; done
# Where there is no apt, it goes on without.
course render && expect 0 "the first sheet: renders/03_three/sheet.png (" "Drawing renders/10_ten/sheet.png" "3 of 3 drawn in "
expect 0 $'the sheets:\n  renders/03_three/sheet.png\n  renders/04_four/sheet.png\n  renders/10_ten/sheet.png'
expect_not "run 04_four" "numbers of"
[[ $output =~ Drawing\ renders/03.*first\ sheet.*Drawing\ renders/04 ]] || wrong "not the first one first"
course render && expect 0 "0 of 3 drawn in " "  renders/10_ten/sheet.png" && expect_not "Drawing" "first sheet"
chapter 04_four
rm "$scratch/home/renders/10_ten/plot.png"
course render && expect 0 "Drawing renders/04_four/sheet.png" "2 of 3 drawn in " && expect_not "Drawing renders/03" "first sheet"
course render 03 && expect 0 "numbers of 03_three" "0 of 1 drawn in " && expect_not "04_four"
# A chapter goes by its number, its name, both, or its directory.
course render 3 four chapters/10_ten/ && expect 0 "0 of 3 drawn in " "renders/04_four/sheet.png"
# One that fails is named, with what it said, and is drawn again the next time.
chapter 04_four 'echo "04_four: no such speed" >&2; exit 2'
course render && expect 1 "FAILED: drawn/04_four" "04_four: no such speed" "the error is shown above" && expect_not "drawn in"
chapter 04_four
course render && expect 0 "1 of 3 drawn in "

# Options of a chapter go to the programs themselves; then it is drawn as it was.
stand_in cmake 'echo "cmake $*"'
course render 03 -- --beta "1.4 x" --list && expect 0 "--target 03_three" "run 03_three: --beta 1.4 x --list" "rendered 03_three in "
expect_not 04_four
chapter 04_four "echo unknown option --bogus >&2; exit 2"
course render 03 04 -- --bogus && expect 2 "run 03_three" "unknown option --bogus" "04_four failed with exit status 2" && expect_not "rendered"
chapter 04_four
system cmake
course render 03 10 && expect 0 "1 of 2 drawn in " "Drawing renders/03_three/sheet.png"
stand_in cmake 'echo "cmake $*"'
touch "$scratch/home/build/release/build.ninja"

# The hard cases: names and options go on to the program, and its exit status comes back.
program hard_cases_table
course hard-cases stack-20 arch --quick -- --jobs 1 && expect 0 "cmake --build --preset release" "--target hard_cases_table" "table: --quick stack-20 arch --jobs 1" "took "
program hard_cases_table 'exit 2'
course hard-cases stak && expect 2 && expect_not "took"

# Tests: without the long ones unless asked for, by name, with more options for ctest.
course test && expect 0 "ctest --preset release -j" "-LE ^(long|checked)\$"
course test --long && expect 0 "ctest --preset release" && expect_not "-LE"
course test one two -- --verbose && expect 0 "-R one|two --verbose"
mkdir -p "$scratch/home/tests/04_four"
touch "$scratch/home/tests/04_four/"{four,not_built}.cpp
printf 'build tests/test_%s: link\n' 04_four four >"$scratch/home/build/release/build.ninja"
course test 04 && expect 0 "--target test_04_four test_four" "-R ^04_four:|^four:" && expect_not "not_built"
course test 03 && expect 2 "no tests belong to 03" && expect_not "ctest"
stand_in ctest 'case "$*" in *-N*nosuch*) echo "Total Tests: 0" ;; *-N*) echo "Total Tests: 3" ;; *) exit 8 ;; esac'
course test friction nosuchtest && expect 2 "no test has 'nosuchtest' in its name; --long adds the long ones" && expect_not "ctest --preset"
course test && expect 8

# Packages: nothing to do, apt as root, sudo, and the command to type where neither works.
stand_in dpkg-query 'shift 3; for p; do [ "$p" = "$ABSENT" ] || printf " installed:%s " "$p"; done'
stand_in apt-get 'echo "apt-get $*" >>../apt.log; echo "apt-get $*"'
stand_in apt-cache 'echo "Package: $2"'
stand_in id 'echo 0'
export ABSENT=none
course render 03 && expect 0 && expect_not "packages"
export ABSENT=libfmt-dev
course render 03 && expect 0 "these packages are missing" "  libfmt-dev" "packages installed"
output=$(cat "$scratch/apt.log") && expect 0 " update" " install --no-install-recommends libfmt-dev"
export ABSENT=ffmpeg  # needed for films alone
course render 03 && expect_not "packages"
course render 03 --film --yes && expect 0 "  ffmpeg" "packages installed"
export ABSENT=libfmt-dev
stand_in id 'echo 1000'
command="apt-get update && apt-get install --no-install-recommends libfmt-dev"
course render 03 --yes && expect 1 "only root may install packages, and sudo does not work here" "$command"
stand_in sudo '[ "$1" = -n ] && shift && exec "$@"'
course render 03 --yes && expect 0 "packages installed"
stand_in apt-get 'echo "E: no network"; exit 100'
course render 03 --yes && expect 1 "E: no network" "apt-get failed." "$command"
# The book: Node and its packages where they are missing, once; then it is built, shown, or refused.
mkdir -p "$scratch"/home/t{ool,est}s/book
touch "$scratch"/home/tools/book/{package.json,package-lock.json,.npmrc} "$scratch"/home/tests/book/{pages,live_page}.mjs
stand_in dpkg-query true
stand_in apt-get 'echo "apt-get $*"'
stand_in id 'echo 0'
course book --yes --still && expect 1 "  nodejs npm" "npm ci failed" && expect_not "g++"
stand_in npm 'echo "npm $*"'
stand_in node 'echo "node $*"'
course book --still && expect 0 "npm ci --prefix build/node" "node tools/book/build.js --still" "the book: build/book/index.html"
expect_not cmake "packages are missing"
# Experiments run in it where em++ can be had; where it cannot, the pages keep their pictures, and that is said and is a failure. Nothing
# is asked for of Debian's Node.js: another one brings npm along, and its package conflicts with Debian's.
course book --yes --serve && expect 1 "  emscripten cmake" "no em++" "keep their still pictures" "node tools/book/build.js" "it has no experiments"
expect_not "cmake --build" "nodejs" "serve.js"
# Tests of it, of which one runs an experiment: compiled for it alone, unless all are; left out where there is no compiler, but not in CI.
stand_in chromium true
course test --book && expect 0 "no live page is tested" "1 tests/book/pages.mjs" && expect_not "live_page.mjs"
stand_in em++ true
course test --book && expect 0 "cmake --build --preset wasm" "--target 04_slop engine" "1 tests/book/live_page.mjs tests/book/pages.mjs"
course book -- --address https://x.org/book --repository=http://y.org
expect 0 "cmake --build --preset wasm" "build.js --address https://x.org/book --repository=http://y.org" && expect_not "still pictures"
stand_in dpkg-query 'shift 3; printf " installed:%s " "$@"'

# Random scenes, with the program's exit status.
program hard_cases_fuzz 'echo "fuzz: $*"; exit 1'
course fuzz -- --seed 7 --stage "07 warm start" && expect 1 "--target hard_cases_fuzz" "fuzz: --seed 7 --stage 07 warm start"

# What is handed on goes to a program as it is, with its exit status; files are named as seen from where one stands.
for name in effects solve export_problem handout exercise mine grade; do program $name "echo \"$name: \$* in \$PWD\"; exit 3"; done
program motion_adapter 'echo "adapter: $* in $PWD, $PUSHBACK_ADAPTER"'
course run solve a.dat --method best --sweeps 5 && expect 3 "--target solve" "solve: a.dat --method best --sweeps 5 in $scratch/sub"
course run adapter mine.mjs bounce mine/16 && expect 0 "adapter: bounce mine/16 in $scratch/sub, $scratch/sub/mine.mjs"
course run solve --help && expect 3 "solve: --help in" && expect_not "usage: ./course"  # the program's own; elsewhere that of ./course
course exercise 15-transfer --hint && expect 3 "--target exercise" "exercise: 15-transfer --hint in $scratch/sub" && expect_not "only this once"
rm "$scratch/home/build/release/programs/exercise"
course exercise && expect 127 "is built first, only this once"
# The chapter whose picture is drawn is built, too, and what a solver is compared with.
course mine three --seed 10 && expect 3 "--target mine 03_three" "mine: three --seed 10 in $scratch/sub" && expect_not "10_ten"
course mine study rolling && expect 3 "--target mine study motion_float motion_mine" "mine: study rolling in $scratch/sub"
course grade -- -rf a && expect 3 "--target grade" "grade: -- -rf a in $scratch/sub"

# The study of accuracy and time, and the other engines, which are built only when they are asked for.
for name in study frozen hard_cases_peers; do program $name; done
touch "$scratch/sub/mine.mjs"
course study --quick && expect 0 "--target study frozen motion_float motion_methods" "study: --quick --out renders/here" "frozen: --quick --out renders/here" && expect_not "peers"
course study --peers --keep && expect 0 "-DPUSHBACK_PEERS=ON" "--target study frozen motion_float motion_methods peers" "study: --peers --out renders" "frozen: --out renders"
course hard-cases slop --peers -- --jobs 1
expect 0 "-DPUSHBACK_PEERS=ON" "--target hard_cases_peers peers" "peers: slop --jobs 1" "took " && expect_not "table:"
course hard-cases slop -- --adapter mine.mjs
expect 0 "--target hard_cases_peers motion_adapter" "peers: slop --adapter $scratch/sub/mine.mjs"

course clean && expect 0 "git clean"
[[ ! -e $scratch/home/build ]] || wrong "clean left build/"

if ((failures)); then echo "$failures failures"; exit 1; fi
echo "all as expected"
