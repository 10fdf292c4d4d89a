/// What the parts of an experiment hand to each other. Only common/experiment*.cpp need it.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>

#include "pushback/common/experiment/experiment.h"
#include "pushback/common/render/painter.h"

namespace pushback {

struct Experiment::Result {
  const Variant* variant = nullptr;
  std::vector<Sample> samples;
  std::map<std::string, std::vector<Real>> series;
  std::vector<Real> numbers;
  std::vector<Image> cells;
  std::vector<std::string> cell_notes;
  std::set<ContactState> states;  ///< of the contact points in the cells
  bool sleepers = false;          ///< whether a body in the cells is asleep
  std::string mishap;             ///< why it was not watched to the end; empty where it was
};

/// Where pictures and progress go.
class Experiment::Output {
 public:
  Output(std::filesystem::path folder, bool images, int width, int height, std::size_t variants);

  const std::filesystem::path& folder() const { return folder_; }
  bool images() const { return painter_.has_value(); }
  Painter& painter() { return *painter_; }
  void progress(const std::string& name, std::size_t index, const std::string& variant, std::size_t frame,
                std::size_t frames);
  void done() const;

 private:
  std::filesystem::path folder_;
  bool terminal_;
  std::size_t variants_;
  std::optional<Painter> painter_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// A name as part of a file's name and as a word on the command line: letters and digits stay, symbols are spelt out, a run
/// of anything else becomes one hyphen.
std::string slug(std::string name);

}  // namespace pushback
