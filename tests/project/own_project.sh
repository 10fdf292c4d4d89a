#!/usr/bin/env bash
# Programs of one's own, as README.md and docs/your_own_scene.md show them: another project that takes this one in, in each of three
# ways, compiles them with more warnings as errors than are on here. Nothing but the libraries may come along.
#   tests/project/own_project.sh BUILD [COMPILER [LAUNCHER]]     BUILD: where this project has been built
# Installed, component by component, programs are linked and run. Of the ways that compile the libraries anew only the program's own object is made:
# what they are built with is looked at instead.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/tests/support/whole_path.sh"
built=$(cd "$1" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
way=
wrong() { echo "own_project, by $way: $*"; exit 1; }

ln -s "$root" pushback
shown_in() { awk '/^```cpp$/ { shown = 1; next } /^```$/ { shown = 0 } shown' "pushback/$1"; }
shown_in docs/your_own_scene.md >main.cpp
simulation=$(shown_in README.md)
for program in "$(<main.cpp)" "$simulation"; do [[ $program == *$'\nint main'* ]] || wrong "README.md or docs/your_own_scene.md shows no program"; done
# ccache may take objects from an earlier run, whose folder had another name. Not by the names of headers: behind the link
# they stay the same while their contents change.
export CCACHE_BASEDIR=$scratch CCACHE_NOHASHDIR=1 CCACHE_NODIRECT=1

configure() {  # configure LINE...: the other project, with these lines of CMake
  mkdir -p "$way"
  [[ -e $way/main.cpp ]] || cp main.cpp "$way"
  cat >"$way/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(another LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
enable_testing()
add_compile_options(-Wall -Wextra -Werror -Wconversion -Wsign-conversion)
add_executable(my_program main.cpp)
$(printf '%s\n' "$@")
END
  cmake -S "$way" -B "$way/build" -G Ninja -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_PREFIX_PATH="$scratch/$way/prefix" "${options[@]}" \
    ${compiler:+-DCMAKE_CXX_COMPILER="$compiler"} ${launcher:+-DCMAKE_CXX_COMPILER_LAUNCHER="$launcher"} >log 2>&1 ||
    { cat log; wrong "it cannot be configured"; }
}
compiler=${2:-} launcher=${3:-} options=()

its_own_code() {  # its own warnings, no others, none of them taken back; and the one option that the same bits depend on
  local command flags
  command=$(grep '"command".*main.cpp' "$way/build/compile_commands.json")
  flags=$(grep -oE -- ' -W[^ ]*' <<<"$command" | tr -d '\n')
  [[ $flags == " -Wall -Wextra -Werror -Wconversion -Wsign-conversion" ]] || wrong "its code is compiled with$flags"
  [[ $command == *" -ffp-contract=off "* ]] || wrong "its code, which our templates are compiled in, lacks -ffp-contract=off: $command"
}

sources() {  # sources LINE...: the libraries come along, and no test, option or program of ours
  local targets
  configure "$@"
  targets=$(ninja -C "$way/build" -t targets all | sed -En 's%^([^ ]*): CXX_(STATIC_LIBRARY|EXECUTABLE)_LINKER.*%\1%p' | xargs -n 1 basename | sort | tr '\n' ' ')
  [[ $targets == "$libraries my_program " ]] ||
    wrong "the other project builds: $targets"
  ctest --test-dir "$way/build" -N | grep -q '^Total Tests: 0$' || wrong "the other project has tests of ours"
  ! grep -E '^PUSHBACK_(TESTS|BENCH|PEERS|WERROR)' "$way/build/CMakeCache.txt" || wrong "it is asked for what is built only here"
  its_own_code
  ninja -C "$way/build" CMakeFiles/my_program.dir/main.cpp.o >log 2>&1 || { cat log; wrong "its program cannot be compiled"; }
}

ways=$(sed -n '/^```cmake$/,/^```$/ { /^```/d; p }' pushback/docs/your_own_scene.md)  # a line each, then the one that links
link=$(tail -n 1 <<<"$ways")
[[ $(wc -l <<<"$ways") == 4 && $link == "target_link_libraries(my_program pushback::pushback pushback::engine pushback::choosing)" ]] ||
  wrong "docs/your_own_scene.md should show three lines of CMake and one that links, but these were found: $ways"

nothing_drawn=(-DCMAKE_DISABLE_FIND_PACKAGE_{CLI11,PkgConfig,OpenGL,Threads}"=ON")
libraries="libaccuracy_and_time.a libchoosing.a libdirect_contacts.a libengine.a libonly_what_is_needed.a libpushback.a libpushback_program.a libpushback_render.a libpushback_simulation.a libpushback_simulation_float.a libthread_pool.a libwhole_problem.a"
way=add_subdirectory
sources "$(grep -o '^add_subdirectory([^)]*)' <<<"$ways" | sed "s|pushback|$scratch/pushback pushback|")" "$link"
way=FetchContent
sources "include(FetchContent)" "FetchContent_Declare(pushback SOURCE_DIR $scratch/pushback)" \
  "$(grep -o '^FetchContent_MakeAvailable([^)]*)' <<<"$ways")" "$link"
way="add_subdirectory without pictures"
libraries="libaccuracy_and_time.a libdirect_contacts.a libengine.a libonly_what_is_needed.a libpushback_simulation.a libpushback_simulation_float.a libwhole_problem.a" options=("${nothing_drawn[@]}")
mkdir "$way"
echo "$simulation" >"$way/main.cpp"
sources "set(PUSHBACK_PICTURES OFF)" "add_subdirectory($scratch/pushback pushback)" \
  "target_link_libraries(my_program pushback::pushback_simulation pushback::engine)"

installed() {  # installed COMPONENT FIND LINE...: the component alone, in a prefix of its own, and a project that finds it
  way="component $1"
  mkdir -p "$way"
  cmake --install "$built" --component "$1" --prefix "$way/prefix" >log 2>&1 || { cat log; wrong "it cannot be installed"; }
  [[ ! -e $way/prefix/include/common ]] || wrong "headers are installed beside those of others"
  configure "${@:2}"
  its_own_code
  ! grep -qE -- "$(whole "$root")" "$way/build/compile_commands.json" || wrong "its program is compiled with what is not installed"
  cmake --build "$way/build" -j 2 >log 2>&1 || { cat log; wrong "it cannot be built"; }
}
refused() {  # refused WORDS FIND: no project finds that, and it is told so
  ! (configure "$2") >said || wrong "$2 is found"
  grep -qF -- "$1" said || { cat said; wrong "$2 is refused, but nobody says: $1"; }
}

mkdir "component simulation"
echo "$simulation" >"component simulation/main.cpp"
installed simulation "find_package(Pushback 0.1 REQUIRED COMPONENTS simulation)" \
  "target_link_libraries(my_program pushback::pushback_simulation pushback::engine)"
[[ $("$way/build/my_program") == "The top box is at 9.5000 m." ]] || wrong "a stack of ten does not stand"
! grep -rq . --include=judge.h --include=answer_program.h "$way/prefix" || wrong "exercises are installed with it"
refused "its component experiment is not installed" "find_package(Pushback REQUIRED COMPONENTS experiment)"
refused "its component pictures is not installed" "find_package(Pushback REQUIRED COMPONENTS pictures)"
refused "requested version" "find_package(Pushback 0.2 REQUIRED)"
options=()
installed experiment "$(grep -o '^find_package([^)]*)' <<<"$ways")" "$link"
"$way/build/my_program" --no-images --seconds 0.5 --out renders >log 2>&1 || { cat log; wrong "its program does not run"; }
"$way/build/my_program" --choose --error 1mm --seconds 0.2 --finer 2 --no-images >said 2>&1 || { cat said; wrong "its program cannot choose"; }
grep -q '^measured: ' said || wrong "its program says nothing of what it chose"
grep -q '^| .* recommended | ' renders/my_experiment/numbers.md || wrong "its program left no numbers behind"

mkdir "component chapters"
cat >"component chapters/main.cpp" <<END  # what the libraries of chapters 07, 16, 17, 20 and 23 have to say of a stack
#include "pushback/chapters/07_warm_start/flat.h"
#include "pushback/chapters/20_only_what_is_needed/dispatch.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/engine/direct/solve_best.h"
#include "pushback/engine/substeps/thread_pool.h"
#include "pushback/common/world/situations.h"
using namespace pushback;
int main() {
  ThreadPool pool(2);
  World world;
  stack(world, 3);
  flat_07::FlatSolver solver;
  for (int i = 0; i < 60; ++i) world.step(solver, Real(1) / 60);
  world.begin_step(Real(1) / 60);
  const auto residual = solve_best(problem_of(world)).residual;
  OnlyWhatIsNeeded needed(world, Solver<Clamping>{});
  needed.step(world, Real(1) / 60);
  return residual < 1e-9 && !needed.rows().empty() ? 0 : 1;
}
END
installed chapters "find_package(Pushback REQUIRED COMPONENTS chapters)" \
  "target_link_libraries(my_program pushback::flat_solver pushback::engine pushback::only_what_is_needed pushback::thread_pool)"
"$way/build/my_program" || wrong "a stack of three is not solved"
echo "all as expected"
