/// Runs an experiment as a program, according to its command line.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/experiment_parts.h"
#include "pushback/common/experiment/film.h"
#include "pushback/common/experiment/loaded_solver.h"

namespace pushback {

namespace fs = std::filesystem;

void Experiment::choose_variants() {
  if (first_scene_) std::erase_if(variants_, [](const Variant& v) { return v.scene != 0; });
  if (only_.empty()) return;
  const auto is_meant = [this](const Variant& variant, const std::string& word) {
    return slug(word) == slug(variant.name) ||
           word == slug(scene_records_[variant.scene].scene.name) + "_" + slug(variant.name);
  };
  for (const std::string& word : only_) {
    if (std::none_of(variants_.begin(), variants_.end(), [&](const Variant& v) { return is_meant(v, word); })) {
      std::string known;
      for (const Variant& v : variants_) known += (known.empty() ? "" : ", ") + slug(v.name);
      throw InvalidInput(fmt::format("--variants names '{}': one or more of {} are needed", word, known));
    }
  }
  std::erase_if(variants_, [&](const Variant& v) {
    return std::none_of(only_.begin(), only_.end(), [&](const std::string& word) { return is_meant(v, word); });
  });
}

void Experiment::list() const {
  for (std::size_t a = 0; a < scene_records_.size(); ++a) {
    fmt::print("{} ({:.3g} s, {})\n", scene_records_[a].scene.name, scene_records_[a].scene.seconds,
               scene_records_[a].scene.pictures ? sheet_file(a) : "no pictures");
    for (const Variant& variant : variants_) {
      if (variant.scene == a) fmt::print("  {:<32} {}\n", slug(variant.name), variant.name);
    }
  }
}

void Experiment::play() {
  const fs::path folder = fs::path(out_) / name_;
  make_writable_folder(folder);
  Output output(folder, !no_images_, {width_, height_}, variants_.size());
  std::vector<Result> results;
  for (std::size_t i = 0; i < variants_.size(); ++i) results.push_back(play(i, output));
  output.done();
  if (!no_study_) {
    for (const auto& work : studies_) work();
  }
  report(results, folder);
}

std::optional<int> Experiment::run_command(int argc, const char* const* argv, const std::function<void()>& define) {
  const auto asked = std::find_if(commands_.begin(), commands_.end(),
                                  [&](const Command& command) { return argc > 1 && argv[1] == command.flag; });
  if (asked == commands_.end()) return {};
  describe(define);
  std::vector<Scene> scenes;
  for (const SceneRecord& record : scene_records_) scenes.push_back(record.scene);
  const std::string called = name_ + " " + asked->flag;
  std::vector<const char*> words(argv + 1, argv + argc);
  words[0] = called.c_str();
  return asked->act(scenes, argc - 1, words.data());
}

int Experiment::run(int argc, const char* const* argv, const std::function<void()>& define) {
  try {
    if (const std::optional<int> status = run_command(argc, argv, define)) return *status;
    if (const std::optional<int> status = read_command_line(argc, argv)) return *status;
    const char* const end = size_.data() + size_.size();
    const auto [cross, bad_width] = std::from_chars(size_.data(), end, width_);
    const auto [rest, bad_height] = std::from_chars(cross == end ? end : cross + 1, end, height_);
    if (bad_width != std::errc() || bad_height != std::errc() || *cross != 'x' || rest != end || width_ < 16 ||
        height_ < 16 || width_ > 8192 || height_ > 8192) {
      throw InvalidInput(fmt::format("--size is '{}': WIDTHxHEIGHT is needed, each from 16 to 8192", size_));
    }
    if (told_.contains("--seconds")) require_positive("--seconds", seconds_);
    if (seconds_ / dt_ > 1e7)
      throw InvalidInput(fmt::format("--seconds is {}: at most {:.4g}, ten million steps of {} s, is needed", seconds_,
                                     1e7 * dt_, dt_));
    if (!film_.empty() && no_images_) throw InvalidInput("--film and --no-images exclude each other");
    if (!film_.empty()) require_ffmpeg();
    const std::optional<AnySolver> mine = mine_.empty() ? std::optional<AnySolver>() : loaded_solver(mine_);
    describe(define, mine ? &*mine : nullptr);
    if (list_) {
      list();
      return 0;
    }
    choose_variants();
    check();
    play();
    return 0;
  } catch (const InvalidInput& problem) {
    fmt::print(stderr, "{}: {}\n", name_, problem.what());
    return 2;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}: {}\n", name_, problem.what());
    return 1;
  }
}

}  // namespace pushback
