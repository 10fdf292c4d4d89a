/// ./course run export: writes the contacts of one step of a scene, as a problem in a file for ./course run solve.
#include "pushback/chapters/16_whole_problem/problem_file.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/named.h"
#include "pushback/common/experiment/program.h"
#include "pushback/engine/direct/row_matrix.h"
#include "pushback/tools/catalogue/catalogue.h"
#include "pushback/tools/catalogue/solvers.h"

using namespace pushback;

namespace {

constexpr Real dt = Real(1) / 60;

/// Takes `steps` steps with the effects that the scene needs, then finds the contacts of the next as its solver would.
ContactProblem problem_after(const NamedScene& scene, int steps, World& world) {
  scene.fill(world);
  OnlyWhatIsNeeded needed = solver_named("07 warm start").fitting(world, {});
  for (int step = 0; step < steps; ++step) needed.step(world, dt);
  world.begin_step(dt);
  if (world.contacts.empty())
    throw InvalidInput(
        fmt::format("{} has no contacts after {} steps: there is no problem to write", scene.name, steps));
  return problem_of(world);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<NamedScene> scenes = all_scenes();
  CommandLine line(
      "Writes the contacts of one step of a scene as a problem in the format of Siconos, for ./course run solve.");
  std::string name, file;
  int steps = 0;
  line.option("scene", name, "A scene by its name").required();
  line.option("file", file, "The file to write").required();
  line.option("--step", steps, "Number of steps of 1/60 s, with 10 sweeps each, before the one that is written")
      .between(0, 1000000)
      .shows_default();
  line.ends_with(fmt::format("The scenes: {}", fmt::join(names_of(scenes), ", ")));
  return line.run(argc, argv, [&] {
    require_writable_file(file);
    World world;
    const ContactProblem problem = problem_after(named("scene", scenes, name), steps, world);
    write_text_file(file, problem_text(problem));
    fmt::print("{}: {} contacts of {} after {} steps\n", file, problem.contacts(), name, steps);
    if (!world.joints.empty())
      fmt::print("its {} joints are not in it: the format knows contacts only\n", world.joints.size());
  });
}
