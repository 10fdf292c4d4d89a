/// ./course fuzz: random scenes, or one of them step by step.
#include <set>
#include <thread>

#include "pushback/common/experiment/program.h"
#include "pushback/engine/substeps/thread_pool.h"
#include "pushback/tools/measure/hard_cases/fuzz.h"

using namespace pushback;

int main(int argc, char** argv) {
  CommandLine line("Random scenes, watched: what must hold in any scene and under any solver", "fuzz");
  std::vector<std::string> only = fuzzed_stages();
  std::uint64_t first = 1, seed = 0;
  int scenes = 500;
  line.option("--stage", only, "Stages, separated by commas").split_at_commas().one_of(fuzzed_stages());
  line.option("--first", first, "The first seed").shows_default();
  line.option("--scenes", scenes, "Number of seeds, from the first one on").between(1, 1000000).shows_default();
  std::set<std::uint64_t> known;
  line.option("--known", known, "Seeds that are known to fail; if one of them passes, this counts as a failure too")
      .split_at_commas();
  int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  line.option("--jobs", jobs, "Number of threads; the results do not depend on it")
      .between(1, ThreadPool::most_threads)
      .shows_default();
  const CommandLine::Option one = line.option("--seed", seed, "Play only this scene, and print every step");
  return line.run(argc, argv, [&] {
    const bool replay = one.given();
    if (replay) {
      first = seed;
      scenes = jobs = 1;
    }
    const auto count = static_cast<std::size_t>(scenes);
    std::vector<FuzzResult> findings(only.size() * count);
    ThreadPool pool(jobs, true);
    pool.each(findings.size(), 1, [&](Part part) {
      for (std::size_t i = part.begin; i < part.end; ++i) {
        if (replay) fmt::print("scene {}, {}\n", first, only[i / count]);
        findings[i] = fuzz(random_scene(first + i % count), only[i / count], replay);
      }
    });
    std::size_t failed = 0;
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const std::string& stage = only[i / count];
      const std::uint64_t scene = first + i % count;
      const bool broke = !findings[i].broken.empty(), expected = known.contains(scene);
      if (broke != expected) ++failed;
      if (broke) {
        fmt::print("scene {}, {}, step {}: {}{}\n  ./course fuzz -- --seed {} --stage '{}'\n", scene, stage,
                   findings[i].step, findings[i].broken, expected ? " (known)" : "", scene, stage);
      } else if (expected) {
        fmt::print("scene {}, {}: known to fail, and did not\n", scene, stage);
      }
    }
    const std::string summary = fmt::format("{} of {} runs were not as expected", failed, findings.size());
    if (failed > 0) throw std::runtime_error(summary);
    fmt::print("{}\n", summary);
  });
}
