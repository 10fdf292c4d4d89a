// Films: as long as they should be, side by side, the same bytes again; nothing is left of their frames.
#include "pushback/common/experiment/film.h"

#include <fmt/format.h>

#include "pushback/common/experiment/experiment.h"
#include "tests/support/call.h"

using namespace pushback;

namespace {

bool can_be_made() {
  if (run_program({"ffmpeg", "-version"}, 20).status == 0 && run_program({"ffprobe", "-version"}, 20).status == 0)
    return true;
  WARN("ffmpeg is not here: no film was made");
  return false;
}

/// "width,height,frames" as another program counts them.
std::string measures(const fs::path& film) {
  const Ended probe = run_program({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                   "stream=width,height,nb_read_frames", "-of", "csv=p=0", film.string()},
                                  60);
  REQUIRE(probe.status == 0);
  return lines_of(probe.out).front();
}

void still_bodies(const fs::path& out, int variants, const char* ending, int expected) {
  const std::string folder = out.string();
  std::vector<const char*> arguments{"films",     "--out", folder.c_str(), "--size", "32x18",
                                     "--seconds", "0.5",   "--film",       ending};
  Experiment e("films", "How long?");
  const int status = e.run(static_cast<int>(arguments.size()), arguments.data(), [&] {
    e.scene({.name = "a ball", .fill = [](World& world) { world.add(sphere(1, 1).at({0, 1, 0})); }});
    for (int i = 0; i < variants; ++i)
      e.motion(fmt::format("take {}", i), [](World& world, Real dt, int) -> std::size_t {
        world.bodies.front().position.x() += dt;
        return 0;
      });
  });
  CHECK(status == expected);
}

}  // namespace

TEST_CASE("a film has thirty frames a second, its variants side by side, in rows of two where they are four") {
  if (!can_be_made()) return;
  for (const auto& [variants, size] :
       std::vector<std::pair<int, std::string>>{{1, "32,18"}, {4, "64,36"}, {5, "96,36"}}) {
    const Scratch scratch;
    still_bodies(scratch / "", variants, "mp4", 0);
    INFO(variants << " variants");
    CHECK(measures(scratch / "films/film.mp4") == size + ",15");
    for (const auto& entry : fs::directory_iterator(scratch / "films")) CHECK_FALSE(entry.is_directory());
  }
}

TEST_CASE("a format that is none is refused, and nothing is written") {
  const Scratch scratch;
  still_bodies(scratch / "", 1, "avi", 2);
  CHECK_FALSE(fs::exists(scratch / "films"));
}
