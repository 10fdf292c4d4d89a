#include "pushback/common/experiment/kept_picture.h"

#include <exception>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/process.h"

namespace pushback {

namespace {

bool shows_already(const std::filesystem::path& file, const Image& image) {
  try {
    return shows_the_same(read_png(file), image);
  } catch (const std::exception&) {  // missing or unreadable
    return false;
  }
}

}  // namespace

bool shows_the_same(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return false;
  const Difference pixels = difference(a, b);
  return pixels.mean < 0.5 && pixels.share < 0.005 && difference(a, b, 2, 48).share == 0;
}

void keep_picture(const std::filesystem::path& file, const Image& image) {
  if (shows_already(file, image)) return;
  const std::string full = in_png(image);
  for (const char* colours : {"128", "256"}) {  // most pictures look the same with 128, in files a fifth smaller
    const Ended palette =
        run_program({"pngquant", colours, "--nofs", "--quality", "90-100", "--speed", "1", "--strip", "-"}, 0, full);
    if (palette.status != 0 || palette.out.size() >= full.size()) continue;
    if (shows_the_same(from_png(palette.out, file.string()), image)) return write_text_file(file, palette.out);
  }
  write_text_file(file, full);
}

}  // namespace pushback
