#include "pushback/tools/classroom/mine/drawing.h"

#include <fmt/format.h>

#include "pushback/common/basics/process.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/mine/chapters.h"
#include "pushback/tools/classroom/mine/library.h"

namespace pushback {

namespace fs = std::filesystem;

std::string draw_mine(int chapter, const fs::path& library, const fs::path& to, ScenesDrawn drawn) {
  const std::string name = folder_of(chapter);
  const fs::path program = program_beside(name);
  if (!fs::exists(program)) return fmt::format("the program that draws it is not built: {}", program.string());
  const ScratchFolder scratch;
  // Of a picture that one waits for: what is worked out beside the scenes has no variant of the reader's, and soft shadows
  // need more passes than the eye needs to compare.
  std::vector<std::string> draw{program, "--mine", library, "--out", scratch.path, "--no-study", "--passes", "4"};
  if (drawn == ScenesDrawn::first_scene) draw.emplace_back("--first-scene");
  if (drawn == ScenesDrawn::films_too) draw.emplace_back("--film");
  const Ended ended = run_program(draw, 600);
  if (ended.status != 0) return fmt::format("{} came to no end with your solver: {}", name, last_line(ended.err));
  fs::remove_all(to);
  fs::copy(scratch.path / name, to, fs::copy_options::recursive);
  return "";
}

}  // namespace pushback
