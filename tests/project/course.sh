#!/usr/bin/env bash
# Tests of ./course itself, in a scratch copy where the package manager, CMake and the chapters are stand-ins.
# shellcheck disable=SC2016  # the stand-ins' scripts are quoted as they are
set -uo pipefail
unset CI  # where this is run: a test that means CI says so
root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0 listed=""

mkdir -p "$scratch"/{bin,sub,home/build/release/programs,home/chapters/{03_three,04_four,10_ten}}
cp "$root/course" "$root/CMakePresets.json" "$scratch/home"
touch "$scratch/home/build/release/build.ninja"

# The only programs ./course gets to see: these of the system, and those that a test puts beside them.
for tool in bash cat dirname env find fold grep mkdir nproc readlink rm sed sleep sort tail touch true; do
  ln -s "$(type -P $tool)" "$scratch/bin/$tool"
done
stand_in() {  # removed first: writing through a link would change the system's own program
  rm -f "$scratch/bin/$1"
  printf '#!/bin/sh\n%s\n' "$2" >"$scratch/bin/$1" && chmod +x "$scratch/bin/$1"
}
printf '#!/bin/sh\necho "table: $*"\n' >"$scratch/home/build/release/programs/hard_cases_table"
chmod +x "$scratch"/home/build/release/programs/*
stand_in cmake 'echo "cmake $*"'
stand_in ctest 'echo "ctest $*"'
stand_in git 'echo "git $*"'

expect_not() { [[ $output != *"$1"* ]] || { echo "line ${BASH_LINENO[0]}: should not say: $1"; failures=$((failures + 1)); }; }
course() { output=$(cd "$scratch/sub" && PATH=$scratch/bin "$scratch/home/course" "$@" </dev/null 2>&1); status=$?; }
expect() {  # expect STATUS TEXT...: how the last call ended, and what it said
  local text wrong=""
  [[ $status == "$1" ]] || wrong="exit status $status instead of $1"
  for text in "${@:2}"; do [[ $output == *"$text"* ]] || wrong+="${wrong:+; }not said: $text"; done
  [[ $wrong ]] || return 0
  printf '%s\n' "line ${BASH_LINENO[0]}: $wrong; the output was:" "$output" "----"
  failures=$((failures + 1))
}

# Help names every command of the table, and everything that stands in it has its function.
course --help
expect 0 "render [CHAPTER...]"
mapfile -t names <<<"$(sed -n 's/^  "\([a-z-]*\)|.*/\1/p' "$root/course")"
for name in "${names[@]}"; do
  expect 0 "  $name "
  grep -q "^command_${name//-/_}()" "$root/course" || { echo "no function for $name"; failures=$((failures + 1)); }
done
expect 0 --yes --preset "chapters: 03_three 04_four 10_ten" release sanitize
course && expect 0 "usage: ./course"
course help && expect 0 "usage: ./course"

# What is unknown is refused by name, with what is allowed, before anything is installed or built.
refused() { local text; expect 2 "${@}"; for text in cmake ninja "packages are missing"; do expect_not "$text"; done; }
course rendr && refused "unknown command 'rendr'" "the commands are: render test mine exercise study hard-cases"
for gone in solve export growth figures prices adapter benchmark handout tidy; do course $gone && refused "unknown command '$gone'"; done
course render 09 && refused "unknown chapter '09'" "the chapters are: 03_three 04_four 10_ten"
course test 99 && refused "unknown chapter '99'" "the chapters are: 03_three 04_four 10_ten"
course run slove && refused "unknown program 'slove'" "the programs are: adapter benchmark export growth handout prices solve"
course run && refused "unknown program ''"
course run adapter --check && refused "adapter needs the FILE"
course test --lng && refused "unknown option '--lng'" "the options are: --yes --preset --help --long" "./course test -- --lng"
course render --beta 1 && refused "unknown option '--beta'" "./course render -- --beta"
course study --quik && refused "the options are: --yes --preset --help --quick --peers --keep --shards --slurm"
course hard-cases --peers --quick && refused "one of the two"
for many in 0 1 1000 x ""; do
  course fuzz --shards "$many" && refused "--shards is '$many': a number of parts, from 2 to 999, is needed"
done
course fuzz --shards && refused "--shards is ''"
course fuzz --shards 2 -- --seed=3 && refused "divide and join by themselves: no --seed=3"
course render --slurm && refused "unknown option '--slurm'"
course clean --all && refused "unknown option '--all'" && expect_not "handed on"
course test --preset relase && refused "unknown preset 'relase'" "the presets are: release debug sanitize threads ci clang odr"
course run solve --preset relase a.dat && refused "unknown preset 'relase'"
course clean up && refused "'clean' takes no words"
course study quick && refused "'study' takes no words"
course clean -- up && refused "'clean' hands no options on"
course --yes && refused "which command?"
course book --srve && refused "unknown option '--srve'" "the options are: --yes --preset --help --still --serve"
course book --yes -- --bogus && refused "unknown option '--bogus'" "--address URL, --repository URL"
course book --yes -- --address ftp://x && refused "--address is 'ftp://x'" "https://"

# A checkout in which nothing can be written.
mv "$scratch/home/build" "$scratch/home/built" && touch "$scratch/home/build"
course render && expect 2 "nothing can be written into $scratch/home" "git clone $scratch/home pushback" && expect_not "cmake"
course --help && expect 0
rm "$scratch/home/build" && mv "$scratch/home/built" "$scratch/home/build"

# Drawing is a part of the build: CMake and Ninja themselves, here with programs in the place of chapters.
for tool in awk cmake cut ninja sha256sum sh xargs; do ln -sf "$(type -P $tool)" "$scratch/bin/$tool"; done
stand_in nproc 'echo 2'
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
  printf '#!/bin/sh\n%s\necho "run %s: $*"\nmkdir -p renders/%s && cd renders/%s && touch sheet.png plot.png && echo "numbers of %s" >numbers.md\n' \
    "${2-}" $1 $1 $1 $1 >"$scratch/home/build/release/programs/$1"
  chmod +x "$scratch/home/build/release/programs/$1"
}
for name in 03_three 04_four 10_ten; do chapter $name; done
# Where there is no apt, it goes on without.
course render && expect 0 "the first sheet: renders/03_three/sheet.png (" "Drawing renders/10_ten/sheet.png" "3 of 3 drawn in "
expect 0 $'the sheets:\n  renders/03_three/sheet.png\n  renders/04_four/sheet.png\n  renders/10_ten/sheet.png'
expect_not "run 04_four" && expect_not "numbers of"
[[ $output =~ Drawing\ renders/03.*first\ sheet.*Drawing\ renders/04 ]] || { echo "not the first one first: $output"; failures=$((failures + 1)); }
course render && expect 0 "0 of 3 drawn in " "  renders/10_ten/sheet.png" && expect_not "Drawing" && expect_not "first sheet"
chapter 04_four
course render && expect 0 "Drawing renders/04_four/sheet.png" "1 of 3 drawn in " && expect_not "Drawing renders/03" && expect_not "first sheet"
for file in sheet.png plot.png numbers.md; do
  rm "$scratch/home/renders/10_ten/$file"
  course render && expect 0 "Drawing renders/10_ten/sheet.png" "1 of 3 drawn in "
done
course render 03 && expect 0 "numbers of 03_three" "0 of 1 drawn in " && expect_not "04_four"
# A chapter goes by its number, its name, both, or its directory.
course render 3 four chapters/10_ten/ && expect 0 "0 of 3 drawn in " "renders/04_four/sheet.png"
# Beside each other: neither of these ends before the other has begun.
meet='touch met.%s; i=0; until [ -e met.%s ]; do sleep 0.1; i=$((i + 1)); [ $i -lt 100 ] || exit 3; done'
chapter 04_four "$(printf "$meet" 4 10)"; chapter 10_ten "$(printf "$meet" 10 4)"
course render && expect 0 "2 of 3 drawn in "
# One that fails is named, with what it said, and is drawn again the next time.
chapter 04_four 'echo "04_four: no such speed" >&2; exit 2'
course render && expect 1 "FAILED: drawn/04_four" "04_four: no such speed" "what went wrong stands above" && expect_not "drawn in"
course render 04 && expect 1 "04_four: no such speed"
chapter 04_four
course render && expect 0 "1 of 3 drawn in "

# Options of a chapter go to the programs themselves; then it is drawn as it was.
stand_in cmake 'echo "cmake $*"'
rm -f "$scratch"/home/met.*
for name in 04_four 10_ten; do chapter $name; done
course render 03 -- --beta "1.4 x" --list && expect 0 "--target 03_three" "run 03_three: --beta 1.4 x --list" "rendered 03_three in "
expect_not 04_four
course render 03 --film -- --seconds 2 && expect 0 "run 03_three: --film --seconds 2"
chapter 04_four "echo unknown option --bogus >&2; exit 2"
course render 03 04 -- --bogus && expect 2 "run 03_three" "unknown option --bogus" "04_four failed with exit status 2" && expect_not "rendered"
chapter 04_four
rm "$scratch/bin/cmake" && ln -s "$(type -P cmake)" "$scratch/bin/cmake"
course render 03 10 && expect 0 "2 of 2 drawn in " "Drawing renders/03_three/sheet.png"
stand_in cmake 'echo "cmake $*"'
touch "$scratch/home/build/release/build.ninja"

# The hard cases: names and options go on to the program, and its exit status comes back.
course hard-cases && expect 0 "cmake --build --preset release" "--target hard_cases_table" "table: " "took "
course hard-cases stack-20 arch --quick -- --jobs 1 && expect 0 "table: --quick stack-20 arch --jobs 1"
course hard-cases --quik && expect 2 "unknown option '--quik'" "--quick"
printf '#!/bin/sh\nexit 2\n' >"$scratch/home/build/release/programs/hard_cases_table"
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
course test 99 && expect 2 "unknown chapter '99'" "the chapters are: 03_three 04_four 10_ten"
stand_in ctest 'case "$*" in *-N*nosuch*) echo "Total Tests: 0" ;; *-N*) echo "Total Tests: 3" ;; *) echo "ctest $*" ;; esac'
course test friction nosuchtest && expect 2 "no test has 'nosuchtest' in its name; --long adds the long ones" && expect_not "ctest --preset"
stand_in ctest 'exit 8'
course test && expect 8

# The presets are those of CMakePresets.json, but for that of the book, which has no programs for this machine.
for name in $(cd "$root" && cmake --list-presets | sed -n 's/^  "\([^"]*\)".*/\1/p'); do
  [[ $name != wasm ]] || continue
  listed+=" $name"
  course test --preset "$name" && expect_not "unknown preset"
done
course --help && expect 0 "another preset:$listed"$'\n'

# Packages: nothing to do, apt as root, sudo, and the command to type where neither works.
stand_in dpkg-query 'shift 3; for p; do [ "$p" = "$ABSENT" ] || printf " installed:%s " "$p"; done'
stand_in apt-get 'echo "apt-get $*" >>../apt.log; echo "apt-get $*"'
stand_in apt-cache 'echo "Package: $2"'
stand_in id 'echo 0'
export ABSENT=none
course render 03 && expect 0 && expect_not "packages"
export ABSENT=libfmt-dev
course render 03 && expect 0 "these packages are missing" "  libfmt-dev" "packages installed"
output=$(cat "$scratch/apt.log") status=0
expect 0 " update" " install --no-install-recommends libfmt-dev"
export ABSENT=ffmpeg  # needed for films alone
course render 03 && expect 0 && expect_not "packages"
course render 03 --film --yes && expect 0 "  ffmpeg" "packages installed"
export ABSENT=bubblewrap  # what tests and grading call; none of a chapter's own does
course test && [[ $output == *"  bubblewrap"* ]] || { echo "the tests do not get bubblewrap"; ((++failures)); }
course test 04 && expect_not "packages"
export ABSENT=libfmt-dev
stand_in id 'echo 1000'
command="apt-get update && apt-get install --no-install-recommends libfmt-dev"
course render 03 --yes && expect 1 "only root may install packages, and sudo does not help here" "$command"
stand_in sudo 'exit 1'
course render 03 --yes && expect 1 "only root may install packages, and sudo does not help here" "$command"
stand_in sudo '[ "$1" = -n ] && shift && exec "$@"'
course render 03 --yes && expect 0 "packages installed"
stand_in apt-get 'echo "E: no network"; exit 100'
course render 03 --yes && expect 1 "E: no network" "apt-get failed." "$command"

# Where the distribution has no OSMesa, EGL takes its place.
stand_in id 'echo 0'
stand_in apt-cache '[ "$2" = libosmesa6-dev ] || echo "Package: $2"'
stand_in apt-get 'echo "apt-get $*"'
stand_in dpkg-query 'shift 3; for p; do case $p in *mesa*|*gl*) ;; *) printf " installed:%s " "$p";; esac; done'
course render 03 --yes && expect 0 "  libegl-dev libgl-dev libegl-mesa0 libgl1-mesa-dri" && expect_not libosmesa6-dev

# The book: Node and its packages where they are missing, once; then it is built, shown, or refused.
mkdir -p "$scratch/home/tools/book"
touch "$scratch"/home/tools/book/{package.json,package-lock.json,.npmrc}
for tool in cmp cp ln realpath; do ln -sf "$(type -P $tool)" "$scratch/bin/$tool"; done
stand_in dpkg-query 'true'
course book --yes --still && expect 1 "  nodejs npm" "npm ci failed" && expect_not "g++"
stand_in npm 'echo "npm $*"'
stand_in node 'echo "node $*"'
course book --still && expect 0 "npm ci --prefix build/node" "node tools/book/build.js --still" "the book: build/book/index.html" && expect_not "packages are missing"
expect_not cmake
# Experiments run in it where em++ can be had; where it cannot, the pages keep their pictures, and that is said and is a failure.
course book --yes && expect 1 "  emscripten cmake" "no em++" "keep their still pictures" "node tools/book/build.js" "the book: build/book/index.html" "it has no experiments"
expect_not "cmake --build" && expect_not "nodejs"
course book --serve && expect 1 "it has no experiments" && expect_not "serve.js"
# A Node.js that is not Debian's brings npm along, and its package conflicts with Debian's: nothing of Debian's is asked for then.
stand_in apt-get 'case " $* " in
  *" npm "*) echo "E: nodejs conflicts with npm"; exit 100 ;;
  *" emscripten "*) printf "#!/bin/sh\n" >"${0%/*}/em++"; chmod +x "${0%/*}/em++" ;;
esac'
stand_in chmod 'exec /bin/chmod "$@"'
course book --yes && expect 0 "  emscripten cmake" "cmake --build --preset wasm" "node tools/book/build.js" && expect_not "conflicts"
rm -f "$scratch/bin/"{em++,chmod}
stand_in apt-get 'echo "apt-get $*"'
# Tests of it, of which one runs an experiment: compiled for it alone, unless all are; left out where there is no compiler, but not in CI.
mkdir -p "$scratch/home/tests/book"
touch "$scratch"/home/tests/book/{pages,live_page}.mjs
stand_in chromium 'true'
course test --book && expect 0 "no live page is tested" "1 tests/book/pages.mjs" && expect_not "live_page.mjs"
CI=true course test --book live_page && expect 1 "no live page can be tested"
stand_in em++ 'true'
course book --still -- --address https://x.org/book --repository=http://y.org && expect 0 "build.js --still --address https://x.org/book --repository=http://y.org"
course test --book && expect 0 "cmake --build --preset wasm" "--target 04_slop wide" "1 tests/book/live_page.mjs tests/book/pages.mjs"
course book && expect 0 "cmake --preset wasm" "cmake --build --preset wasm" "node tools/book/build.js" && expect_not "still pictures"
course book --still --serve && expect 0 "node tools/book/serve.js build/book" && expect_not "npm ci"
echo newer >"$scratch/home/tools/book/package-lock.json"
course book --still && expect 0 "npm ci --prefix build/node"
stand_in node '[ "$1" != tools/book/build.js ]'
course book --still && expect 1 "the book was not built"

stand_in dpkg-query 'shift 3; printf " installed:%s " "$@"'

# Random scenes.
printf '#!/bin/sh\necho "fuzz: $*"\nexit 1\n' >"$scratch/home/build/release/programs/hard_cases_fuzz"
chmod +x "$scratch/home/build/release/programs/hard_cases_fuzz"
course fuzz -- --seed 7 --stage "07 warm start" && expect 1 "--target hard_cases_fuzz" "fuzz: --seed 7 --stage 07 warm start"
for tool in seq xargs; do ln -sf "$(type -P $tool)" "$scratch/bin/$tool"; done
stand_in nproc 'echo 2'
course fuzz -- --scenes 9 && expect 1 "fuzz: --scenes 9 --join" && expect_not "--shard"
[[ $(cat "$scratch/home/build/release/fuzz/"*.said) == *"fuzz: --scenes 9 --shard 1/2 --save build/release/fuzz/1"*"--shard 2/2"* ]] || { echo "not a part for each core"; ((++failures)); }
printf '#!/bin/sh\necho "no such stage"\nexit 2\n' >"$scratch/home/build/release/programs/hard_cases_fuzz"
course fuzz -- --stage x && expect 2 "no such stage" && expect_not "--join"

# Programs of `run`: words and options go on as they are, and files are named as seen from where one stands.
for name in effects solve export_problem motion_adapter handout prices; do
  printf '#!/bin/sh\necho "%s: $* in $PWD, $PUSHBACK_ADAPTER"\nexit 2\n' $name >"$scratch/home/build/release/programs/$name"
  chmod +x "$scratch/home/build/release/programs/$name"
done
course effects 06-slope all && expect 2 "--target effects" "effects: 06-slope all"
course run solve a.dat --method best --sweeps 5 && expect 2 "--target solve" "solve: a.dat --method best --sweeps 5 in $scratch/sub"
course run export 07-pyramid --step 60 a.dat && expect 2 "--target export_problem" "export_problem: 07-pyramid --step 60 a.dat in $scratch/sub"
course run adapter mine.mjs && expect 2 "--target motion_adapter" "motion_adapter: --check in $scratch/sub, $scratch/sub/mine.mjs"
course run adapter mine.mjs bounce mine/16 && expect 2 "motion_adapter: bounce mine/16 in $scratch/sub, $scratch/sub/mine.mjs"
course run handout to --with 03 && expect 2 "--target handout" "handout: to --with 03 in $scratch/sub"
# Their --help is the program's own; everywhere else it is that of ./course.
course run solve --help && expect 2 "solve: --help in" && expect_not "usage: ./course"
for words in "run --help" "effects --help" "--help solve"; do course $words && expect 0 "usage: ./course"; done

# Exercises: what is handed on goes to the program, which is called from where one stands.
for name in exercise mine grade; do
  printf '#!/bin/sh\necho "%s: $* in $PWD"\nexit 1\n' $name >"$scratch/home/build/release/programs/$name"
  chmod +x "$scratch/home/build/release/programs/$name"
done
course exercise 15-transfer --hint && expect 1 "--target exercise" "exercise: 15-transfer --hint in $scratch/sub"
course exercise && expect 1 "exercise:  in $scratch/sub" && expect_not "only this once"
rm "$scratch/home/build/release/programs/exercise"
course exercise && expect 127 "is built first, only this once"
# The chapter whose picture is drawn is built, too, and what a solver is compared with.
course mine 03 --hint && expect 1 "--target mine 03_three" "mine: 03 --hint in $scratch/sub"
course mine three --seed 10 && expect 1 "--target mine 03_three" "mine: three --seed 10 in $scratch/sub" && expect_not "10_ten"
course mine --hint && expect 1 "--target mine" "mine: --hint in $scratch/sub"
course mine hard-cases slop && expect 1 "--target mine hard_cases_table" "mine: hard-cases slop in $scratch/sub" && expect_not "04_four"
course mine study rolling && expect 1 "--target mine study motion_mine" "mine: study rolling in $scratch/sub"
course grade a b --jobs 2 && expect 1 "--target grade" "grade: a b --jobs 2 in $scratch/sub"
course grade -- -rf a && expect 1 "--target grade" "grade: -- -rf a in $scratch/sub"

# The study of accuracy and time, and the other engines, which are built only when they are asked for.
for name in study frozen; do
  printf '#!/bin/sh\necho "%s: $*"\n' $name >"$scratch/home/build/release/programs/$name"
  chmod +x "$scratch/home/build/release/programs/$name"
done
course study --quick && expect 0 "--target study frozen" "study: --quick --out renders/here" "frozen: --quick --out renders/here"
expect_not "peers"
course study --quick -- --only bounce && expect 0 "study: --quick --only bounce --out renders/here" && expect_not "frozen:"
course study --peers --keep
expect 0 "-DPUSHBACK_PEERS=ON" "--target study frozen peers" "study: --peers --out renders" "frozen: --out renders"
printf '#!/bin/sh\necho "peers: $*"\n' >"$scratch/home/build/release/programs/hard_cases_peers"
chmod +x "$scratch/home/build/release/programs/hard_cases_peers"
course hard-cases slop --peers -- --jobs 1
expect 0 "-DPUSHBACK_PEERS=ON" "--target hard_cases_peers peers" "peers: slop --jobs 1" "took " && expect_not "table:"
touch "$scratch/sub/mine.mjs"
course hard-cases slop -- --adapter mine.mjs && expect 0 "--target hard_cases_peers hard_cases_adapter" "peers: slop --adapter $scratch/sub/mine.mjs"

course clean && expect 0 "git clean"
[[ ! -e $scratch/home/build ]] || { echo "clean left build/"; failures=$((failures + 1)); }

if ((failures)); then echo "$failures failures"; exit 1; fi
echo "all as expected"
