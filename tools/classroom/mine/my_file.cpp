#include "pushback/tools/classroom/mine/my_file.h"

#include <fmt/format.h>

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

MyFolder::MyFolder(const fs::path& folder)
    : WorkFolder(fs::proximate(folder.empty() ? kit().sources / "mine" : folder)) {
  try {
    make_writable_folder(path());
  } catch (const InvalidInput&) {
    throw InvalidInput(
        fmt::format("--in: folder '{}' cannot be written to: a folder that can be created or written to is needed",
                    path().string()));
  }
}

void MyFolder::reset() {
  begin_anew(file(), begun_with);
  forget_all();
}

std::string MyFolder::text() const {
  std::string text = read_text_file(file());
  if (text.find("MySolver") == text.npos)
    throw InvalidInput(
        fmt::format("{} has no class MySolver, which is the class to check. --reset starts again, and keeps your file",
                    file().string()));
  return text;
}

}  // namespace pushback
