#include "pushback/common/experiment/loaded_solver.h"

#include <dlfcn.h>

#include <filesystem>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace {

using Make = StepSolver* (*)(const StepSolver* like);

class LoadedSolver : public ForwardingSolver {
 public:
  explicit LoadedSolver(Make make) : make_(make), held_(make(nullptr)) {}
  LoadedSolver(const LoadedSolver& other)
      : ForwardingSolver(other), make_(other.make_), held_(make_(other.held_.get())) {}
  LoadedSolver(LoadedSolver&&) noexcept = default;
  LoadedSolver& operator=(LoadedSolver other) noexcept {
    std::swap(make_, other.make_);
    held_.swap(other.held_);
    return *this;
  }
  ~LoadedSolver() override = default;

 private:
  StepSolver& inner() override { return *held_; }
  const StepSolver& inner() const override { return *held_; }

  Make make_;
  std::unique_ptr<StepSolver> held_;
};

}  // namespace

AnySolver loaded_solver(const std::string& library) {
  // By its absolute path, because a bare name is searched for in the system's folders. Never closed, because its code is in use.
  void* const loaded = dlopen(std::filesystem::absolute(library).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!loaded) throw InvalidInput(fmt::format("--mine is '{}', which cannot be loaded: {}", library, dlerror()));
  void* const make = dlsym(loaded, "make_solver");
  if (!make) throw InvalidInput(fmt::format("--mine is '{}', which has no function make_solver", library));
  return LoadedSolver(reinterpret_cast<Make>(make));
}

}  // namespace pushback
