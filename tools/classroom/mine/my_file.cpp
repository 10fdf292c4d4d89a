#include "pushback/tools/classroom/mine/my_file.h"

#include <fmt/format.h>

#include <sstream>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/kit.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

constexpr const char* begun_with = R"(#pragma once

#include <vector>

#include "pushback/common/world/step_solver.h"

namespace mine {

using namespace pushback;

// Yours, from chapters/00_naive_impulses/README.md on. Check it with: ./course mine 00
//   world.contacts             what touches now: point, normal (from A to B), depth, friction, restitution, id, impulse
//   world.bodies_of(contact)   auto [a, b] = ...: references to the two bodies (common/bodies/body.h)
//   world.contacts_before      from chapter 07 on: the contacts of the step before, with their impulses
class MySolver : public StepSolver {
 public:
  void solve(World& /*world*/, Real /*dt*/, int /*sweeps*/) override {}
};

}  // namespace mine
)";

}  // namespace

MyFolder::MyFolder(const fs::path& folder) : folder_(fs::proximate(folder.empty() ? kit().sources / "mine" : folder)) {
  try {
    make_writable_folder(folder_);
  } catch (const InvalidInput&) {
    throw InvalidInput(fmt::format(
        "--in: folder '{}' cannot be written to: a folder that can be made or written to is needed", folder_.string()));
  }
  const fs::path file = folder_ / ".remembered";
  if (!fs::exists(file)) return;
  std::istringstream lines(read_text_file(file));
  bool passed = false;
  std::size_t hints = 0;
  for (int chapter = 0; lines >> chapter >> passed >> hints;) remembered_[chapter] = {passed, hints};
}

void MyFolder::reset() {
  if (begun()) {
    fs::path old = file().string() + ".old";
    for (int i = 2; fs::exists(old); ++i) old.replace_extension(fmt::format(".old{}", i));
    fs::rename(file(), old);
  }
  write_text_file(file(), begun_with);
  remembered_.clear();
  write();
}

std::string MyFolder::text() const {
  std::string text = read_text_file(file());
  if (text.find("MySolver") == text.npos)
    throw InvalidInput(
        fmt::format("{} has no class MySolver, which is what is checked. --reset begins anew, and keeps your file",
                    file().string()));
  return text;
}

fs::file_time_type MyFolder::written() const {
  fs::file_time_type last{};
  for (const auto& entry : fs::directory_iterator(folder_)) {
    std::error_code gone;  // between the two: an editor may write beside the file, and rename
    const fs::file_time_type its = entry.path().extension() == ".h" ? entry.last_write_time(gone) : last;
    if (!gone) last = std::max(last, its);
  }
  return last;
}

bool MyFolder::passed(int chapter) const {
  const auto found = remembered_.find(chapter);
  return found != remembered_.end() && found->second.passed;
}
void MyFolder::set_passed(int chapter, bool passed) {
  remembered_[chapter].passed = passed;
  write();
}
std::size_t MyFolder::hints(int chapter) const {
  const auto found = remembered_.find(chapter);
  return found == remembered_.end() ? 0 : found->second.hints;
}
void MyFolder::set_hints(int chapter, std::size_t count) {
  remembered_[chapter].hints = count;
  write();
}

void MyFolder::write() const {
  std::string text;
  for (const auto& [chapter, remembered] : remembered_)
    text += fmt::format("{} {} {}\n", chapter, remembered.passed ? 1 : 0, remembered.hints);
  write_text_file(folder_ / ".remembered", text);
}

}  // namespace pushback
