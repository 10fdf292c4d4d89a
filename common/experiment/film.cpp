#include "pushback/common/experiment/film.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

struct Format {
  std::string name, last_filter;
  std::vector<std::string> options;
};

const std::vector<Format>& formats() {
  static const std::vector<Format> all{
      {"mp4",
       "pad=ceil(iw/2)*2:ceil(ih/2)*2",  // yuv420p, which plays everywhere, has one colour per 2x2 pixels
       {"-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart"}},
      {"webm",
       "pad=ceil(iw/2)*2:ceil(ih/2)*2",
       {"-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-pix_fmt", "yuv420p"}},
      {"webp", "fps=15", {"-c:v", "libwebp_anim", "-quality", "60", "-compression_level", "6", "-loop", "0"}},
      {"gif", "fps=15,split[s][t];[s]palettegen=max_colors=128[p];[t][p]paletteuse=dither=none", {"-loop", "0"}}};
  return all;
}

/// Holds each input at its last frame until the film ends, and puts the inputs in rows of three, or of two if there are four.
std::string side_by_side(std::size_t count, double seconds, const std::string& last_filter) {
  std::string filter, inputs;
  std::vector<std::string> places;
  for (std::size_t i = 0; i < count; ++i) {
    filter += fmt::format("[{0}:v]tpad=stop=-1:stop_mode=clone,trim=duration={1:.4f}[v{0}];", i, seconds);
    inputs += fmt::format("[v{}]", i);
    const std::size_t columns = count == 4 ? 2 : 3, column = i % columns, row = i / columns;
    const auto so_many = [](std::size_t times, const std::string& side) {
      return times == 0 ? "0" : times == 1 ? side : side + "+" + side;
    };
    places.push_back(so_many(column, "w0") + "_" + so_many(row, "h0"));
  }
  if (count == 1) return filter + inputs + last_filter + "[film]";
  return fmt::format("{}{}xstack=inputs={}:fill=white:layout={}[all];[all]{}[film]", filter, inputs, count,
                     fmt::join(places, "|"), last_filter);
}

}  // namespace

const std::vector<std::string>& film_formats() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> made;
    for (const Format& format : formats()) made.push_back(format.name);
    return made;
  }();
  return names;
}

void require_ffmpeg() {
  if (run_program({"ffmpeg", "-version"}, 20).status != 0)
    throw std::runtime_error("ffmpeg, which makes films, is not found: is the package ffmpeg installed?");
}

void write_film(const fs::path& file, const std::vector<fs::path>& folders, double seconds) {
  const std::string ending = file.extension().string().substr(1);
  const Format* format = nullptr;
  for (const Format& one : formats()) format = one.name == ending ? &one : format;
  if (format == nullptr)
    throw InvalidInput(fmt::format("film '{}': one of {} is needed", file.string(), fmt::join(film_formats(), ", ")));

  const fs::path unfinished = file.parent_path() / (".part." + ending);
  std::vector<std::string> command{"ffmpeg", "-v", "error", "-nostdin", "-y"};
  for (const fs::path& folder : folders)
    command.insert(command.end(),
                   {"-framerate", std::to_string(frames_per_second), "-i", (folder / "frame_%04d.png").string()});
  // Omits the time and the name of the program, so that the same frames give the same bytes.
  command.insert(command.end(), {"-filter_complex", side_by_side(folders.size(), seconds, format->last_filter), "-map",
                                 "[film]", "-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact"});
  command.insert(command.end(), format->options.begin(), format->options.end());
  command.push_back(unfinished.string());
  const Ended ffmpeg = run_program(command, 600);
  std::error_code error;
  if (ffmpeg.status != 0) {
    fs::remove(unfinished, error);
    throw std::runtime_error(fmt::format("ffmpeg could not make {}: {}", file.string(), ffmpeg.err));
  }
  fs::rename(unfinished, file, error);
  if (error) throw InvalidInput(fmt::format("film '{}' cannot be written: {}", file.string(), error.message()));
}

}  // namespace pushback
