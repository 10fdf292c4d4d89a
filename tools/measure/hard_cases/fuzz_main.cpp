/// ./course fuzz: random scenes, or one of them step by step.
#include <map>
#include <set>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/shard.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/hard_cases/fuzz.h"
#include "pushback/tools/measure/results/csv.h"
#include "pushback/tools/measure/results/origin.h"

using namespace pushback;

namespace {

using Findings = std::map<std::pair<std::string, std::uint64_t>, FuzzResult>;  // by stage and seed

std::filesystem::path origin_of(const std::string& saved) {
  return saved + ".origin";
}

constexpr const char* heading = "stage,seed,step,broken";

/// What parts have saved.
Findings read_parts(const std::vector<std::string>& files) {
  std::vector<std::filesystem::path> origins;
  for (const std::string& file : files) origins.push_back(origin_of(file));
  require_one_origin(origins, Holds::numbers);
  Findings all;
  for (const std::string& file : files)
    read_csv_lines(read_text_file(file), heading, [&](const std::vector<std::string>& f) {
      all[{f[0], csv_number<std::uint64_t>(f[1])}] = {.broken = f[3], .step = csv_number<int>(f[2])};
    });
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line("Random scenes, watched: what must hold in any scene and under any solver", "fuzz");
  std::vector<std::string> only = fuzzed_stages();
  std::uint64_t first = 1, seed = 0;
  int scenes = 500;
  line.option("--stage", only, "Stages, separated by commas").split_at_commas().one_of(fuzzed_stages());
  line.option("--first", first, "The first seed").shows_default();
  line.option("--scenes", scenes, "How many seeds from there on").between(1, 1000000000).shows_default();
  std::set<std::uint64_t> known;
  line.option("--known", known, "Seeds that are known to fail; one that does not is a failure too").split_at_commas();
  std::string shard_text = "1/1", save;
  std::vector<std::string> parts;
  line.option("--shard", shard_text, "2/5: the second of five parts of these scenes, for a machine of its own");
  line.option("--save", save, "A file for what was found, to be joined; beside it, FILE.origin says of which code");
  line.option("--join", parts,
              "Nothing is played: what the parts have saved, said as of the whole, with the same options");
  const CommandLine::Option one = line.option("--seed", seed, "Only this scene, and print every step");
  return line.run(argc, argv, [&] {
    const Shard shard = shard_of(shard_text);
    if (!save.empty()) require_writable_file(save);
    const Findings known_parts = read_parts(parts);
    std::string saved = fmt::format("{}\n", heading);
    const bool replay = one.given();
    if (replay) {
      first = seed;
      scenes = 1;
    }
    std::uint64_t failed = 0, runs = 0;
    const auto finding_of = [&](const std::string& stage, std::uint64_t scene) {
      if (parts.empty()) return fuzz(random_scene(scene), stage, replay);
      const auto found = known_parts.find({stage, scene});
      if (found == known_parts.end()) throw InvalidInput(fmt::format("--join: no part has scene {}, {}", scene, stage));
      return found->second;
    };
    for (const std::string& stage : only) {
      for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(scenes); ++i) {
        if (!shard.has(i)) continue;
        ++runs;
        if (replay) fmt::print("scene {}, {}\n", first + i, stage);
        const FuzzResult finding = finding_of(stage, first + i);
        saved += fmt::format("{},{},{},{}\n", csv_field(stage), first + i, finding.step, csv_field(finding.broken));
        const bool broke = !finding.broken.empty(), expected = known.contains(first + i);
        if (broke != expected) ++failed;
        if (broke) {
          fmt::print("scene {}, {}, step {}: {}{}\n  ./course fuzz -- --seed {} --stage '{}'\n", first + i, stage,
                     finding.step, finding.broken, expected ? " (known)" : "", first + i, stage);
        } else if (expected) {
          fmt::print("scene {}, {}: known to fail, and did not\n", first + i, stage);
        }
      }
    }
    if (!save.empty()) {
      write_text_file(save, saved);
      write_text_file(origin_of(save), origin_text(origin_here()));
    }
    const std::string summary = fmt::format("{} of {} runs were not as expected", failed, runs);
    if (failed > 0) throw std::runtime_error(summary);
    fmt::print("{}\n", summary);
  });
}
