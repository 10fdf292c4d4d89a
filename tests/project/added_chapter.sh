#!/usr/bin/env bash
# To add a chapter, as docs/architecture.md describes it: its own folder and three edits elsewhere. In a copy of the project a
# small chapter is added so; it is built alone, runs, and its page passes the tests of pages.
#   tests/project/added_chapter.sh BUILD [COMPILER [LAUNCHER]]     BUILD: where this project and its tests have been built
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
built=$(cd "$1" && pwd)
compiler=${2:-} launcher=${3:-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
wrong() { echo "added_chapter: $*"; exit 1; }

mkdir "$scratch/copy"
tar -C "$root" --exclude=./.git --exclude=./build --exclude=./node_modules --exclude='./renders/*/*/*' -cf - . | tar -C "$scratch/copy" -xf -
cd "$scratch/copy"
all=(chapters/[0-9][0-9]_*/)
last=${all[-1]%/} last=${last#*/}
number=$(printf '%02d' $((10#${last%%_*} + 1))) name=${number}_trial
folder=chapters/$name

# ---- its own folder --------------------------------------------------------------------------------------------------
mkdir "$folder"
cat >"$folder/scenes.h" <<END
/// A ball that touches the ground.
#pragma once

#include "pushback/common/world/situations.h"

namespace pushback::trial_scenes {

inline void ball(World& world) {
  world.add(ground());
  world.add(sphere(Real(0.3), 5).at({0, Real(0.299), 0}));
}

}  // namespace pushback::trial_scenes
END
# The engine, which it includes, is linked by that alone.
cat >"$folder/main.cpp" <<END
#include "pushback/chapters/03_baumgarte/baumgarte.h"
#include "pushback/engine/islands/scene_questions.h"
#include "pushback/chapters/$name/scenes.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;

int main(int argc, char** argv) {
  Experiment e("$name", "How fast does the ball leave?");
  return e.run(argc, argv, [&] {
    e.scene({.name = "a ball", .fill = trial_scenes::ball, .seconds = 1});
    e.variant("held", Solver<Clamping>{});
    e.variant("pushed out", Solver<Clamping, Baumgarte>{});
    e.number("speed at the end", "m/s", [](const Run& run) { return run.world.bodies[1].velocity.norm(); });
    e.number("friction is called for", "", [](const Run& run) { return NeedsFriction::in(run.world).yes ? 1 : 0; });
  });
}
END
cat >"$folder/README.md" <<END
# $number · Trial

[Branch of 21](../../README.md#the-trunk)

![Sheet: a ball on the ground, and a ball that has left it](../../renders/$name/sheet.png)

<!-- numbers.md -->
<!-- end -->

[${last%%_*} before](../$last/README.md) · [Front page](../../README.md) · **[The trunk and its branches](../../README.md#the-trunk)**
END

# ---- three edits elsewhere -------------------------------------------------------------------------------------------
sed -i "\$s|\[Front page\](../../README.md)|[$number Trial](../$name/README.md)|" "chapters/$last/README.md"
sed -i -e "/^| \[!\[.*chapters\/$last\/README.md/a | **$number [Trial]($folder/README.md)** | | |" \
  -e "/^| 13 |/s#) |\$#), [$number]($folder/README.md) |#" README.md
sed -i -e "0,/^#include \"pushback\/chapters/s||#include \"pushback/$folder/scenes.h\"\n&|" \
  -e "/^  return {$/a\      {\"$number-ball\", trial_scenes::ball}," tools/catalogue/catalogue.cpp
edited=$(diff -rq "$root" . -x build -x .git -x node_modules -x renders -x "$name" | sort) || true
[[ $(wc -l <<<"$edited") == 3 && $edited != *"Only in"* ]] || wrong "more or less than three files elsewhere are edited:"$'\n'"$edited"

# ---- built alone, run, and held to the tests of pages ----------------------------------------------------------------
export CCACHE_BASEDIR=$scratch CCACHE_NOHASHDIR=1 CCACHE_NODIRECT=1  # see own_project.sh
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0 ${compiler:+-DCMAKE_CXX_COMPILER="$compiler"} \
  ${launcher:+-DCMAKE_CXX_COMPILER_LAUNCHER="$launcher"} >../log 2>&1 || { cat ../log; wrong "it cannot be configured"; }
grep -q "^build draw_$name:" build/build.ninja || wrong "the build does not draw it"
cmake --build build -j 2 --target "$name" catalogue >../log 2>&1 || { cat ../log; wrong "it cannot be built"; }
[[ $(cd build/programs && echo *) == "$name" ]] || wrong "it is not the only program that is built: $(ls build/programs)"
"build/programs/$name" --seconds 0.1 --frames 3 --size 176x99 >../log 2>&1 || { cat ../log; wrong "it does not run"; }
./course help | grep -q "$name" || wrong "./course does not know it"
bash tests/project/readme_numbers.sh --write >../log 2>&1 || { cat ../log; wrong "its page has no place for its numbers"; }
grep -q '^| .*pushed out' "$folder/README.md" || wrong "its numbers are not on its page"
"$built/tests/test_pages" >../log 2>&1 || { cat ../log; wrong "the tests of pages and links do not accept it"; }
echo "all as expected"
