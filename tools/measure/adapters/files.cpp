/// ./course run benchmark FOLDER: motions with their truths, hard cases with what they ask for, as files for other programs.
#include <fmt/format.h>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/adapters/scene_json.h"
#include "pushback/tools/measure/hard_cases/hard_case.h"
#include "pushback/tools/measure/study/every_motion.h"

using namespace pushback;

namespace {

constexpr int version = 1;

/// A line a frame and body; the first frame is 1/60 s after the begin.
std::string truth_csv(const Motion& motion) {
  std::string text = "frame,body,x_m,y_m,z_m\n";
  const std::vector<Places> truth = motion.truth(motion.frames());
  for (std::size_t frame = 0; frame < truth.size(); ++frame)
    for (std::size_t body = 0; body < truth[frame].size(); ++body) {
      const Eigen::Vector3d& at = truth[frame][body];
      text += fmt::format("{},{},{},{},{}\n", frame + 1, body, at.x(), at.y(), at.z());
    }
  return text;
}

/// What is not possible in such a file is said in the place of the scene.
void add_scene(Json& json, const World& world) {
  try {
    json["scene"] = scene_json(world);
  } catch (const InvalidInput& problem) {
    json["lacks"] = problem.what();
  }
}

Json motion_json(const Motion& motion) {
  World world;
  motion.begin(world);
  Json json{{"pushback", "motion"},
            {"version", version},
            {"name", motion.name},
            {"title", motion.title},
            {"seconds", motion.seconds},
            {"frames_per_second", frames_per_second},
            {"truth", motion.name + ".truth.csv"}};
  add_scene(json, world);
  return json;
}

Json hard_case_json(const HardCase& hard_case) {
  Json criteria = Json::array();
  for (const Criterion& one : hard_case.criteria)
    criteria.push_back({{"what", one.what}, {"unit", one.unit}, {"at_most", one.limit}});
  Json json{{"pushback", "hard case"},
            {"version", version},
            {"name", hard_case.name},
            {"title", hard_case.title},
            {"hard_for", hard_case.stresses},
            {"starts", hard_case.starts},
            {"criteria", criteria}};
  World world;
  hard_case.scene.fill(world);
  add_scene(json, world);
  return json;
}

void write(const std::filesystem::path& file, const Json& json) {
  write_text_file(file, json.dump(1) + "\n");
}

}  // namespace

int main(int argc, char** argv) {
  std::string out;
  CommandLine line("Motions with their truths, and hard cases with what they ask for, as files.");
  line.option("FOLDER", out, "Where they go: into its folders motions and hard_cases").required();
  return line.run(argc, argv, [&] {
    const std::filesystem::path folder = out;
    make_writable_folder(folder / "motions");
    make_writable_folder(folder / "hard_cases");
    for (const Motion& motion : every_motion()) {
      write(folder / "motions" / (motion.name + ".json"), motion_json(motion));
      write_text_file(folder / "motions" / (motion.name + ".truth.csv"), truth_csv(motion));
    }
    for (const HardCase& hard_case : hard_cases())
      write(folder / "hard_cases" / (hard_case.name + ".json"), hard_case_json(hard_case));
    fmt::print("{} motions and {} hard cases in {}\n", every_motion().size(), hard_cases().size(), folder.string());
  });
}
