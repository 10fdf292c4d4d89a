/// ./course fuzz: random scenes, or one of them step by step.
#include <map>
#include <set>
#include <sstream>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/shard.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/measure/hard_cases/fuzz.h"
#include "pushback/tools/measure/results/origin.h"

using namespace pushback;

namespace {

void print_account(const std::string& stage, const Account& a) {
  const auto share = [&a](long count) {
    return 100 * static_cast<double>(count) / static_cast<double>(std::max(1L, a.solves));
  };
  fmt::print("{}: {} solves with contacts\n", stage, a.solves);
  fmt::print("  old impulses raised T in     {:>8} ({:.3g} %), by at most {:.3g} of T\n", a.started_above,
             share(a.started_above), a.most_started);
  fmt::print("  friction gave energy back in {:>8} ({:.3g} %), at most {:.3g} of T\n", a.returned, share(a.returned),
             a.most_returned);
  fmt::print("  ended above T + sum(-b l) in {:>8} ({:.3g} %), by at most {:.3g} of T\n", a.ended_above,
             share(a.ended_above), a.most_above);
}

using Findings = std::map<std::pair<std::string, std::uint64_t>, Finding>;  // by stage and seed

std::string line_of(const std::string& stage, std::uint64_t seed, const Finding& f) {
  const Account& a = f.account;
  return fmt::format("{}\t{} {} {} {} {} {} {} {} {}\t{}\n", stage, seed, f.step, a.solves, a.started_above,
                     a.most_started, a.returned, a.most_returned, a.ended_above, a.most_above, f.broken);
}

std::filesystem::path origin_of(const std::string& saved) {
  return saved + ".origin";
}

/// What parts have saved.
Findings read_parts(const std::vector<std::string>& files) {
  std::vector<std::filesystem::path> origins;
  for (const std::string& file : files) origins.push_back(origin_of(file));
  require_one_origin(origins, Holds::numbers);
  Findings all;
  for (const std::string& file : files) {
    std::istringstream in(read_text_file(file));
    for (std::string stage, numbers; std::getline(in, stage, '\t');) {
      Finding f;
      Account& a = f.account;
      std::uint64_t seed = 0;
      std::getline(in, numbers, '\t');
      std::getline(in, f.broken);
      std::istringstream words(numbers);
      if (!(words >> seed >> f.step >> a.solves >> a.started_above >> a.most_started >> a.returned >> a.most_returned >>
            a.ended_above >> a.most_above))
        throw InvalidInput(fmt::format("{} is not what --save wrote: '{}'", file, numbers));
      all[{stage, seed}] = f;
    }
  }
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
  bool no_room = false;
  line.flag("--no-room", no_room, "Half-spaces may leave no room for anything; this is expected to fail");
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
    std::string saved;
    const bool replay = one.given();
    if (replay) {
      first = seed;
      scenes = 1;
    }
    std::uint64_t failed = 0, runs = 0;
    const auto finding_of = [&](const std::string& stage, std::uint64_t scene) {
      if (parts.empty()) return fuzz(random_scene(scene, no_room), stage, replay);
      const auto found = known_parts.find({stage, scene});
      if (found == known_parts.end()) throw InvalidInput(fmt::format("--join: no part has scene {}, {}", scene, stage));
      return found->second;
    };
    for (const std::string& stage : only) {
      Account account;
      for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(scenes); ++i) {
        if (!shard.has(i)) continue;
        ++runs;
        if (replay) fmt::print("scene {}, {}\n", first + i, stage);
        const Finding finding = finding_of(stage, first + i);
        if (!save.empty()) saved += line_of(stage, first + i, finding);
        account.add(finding.account);
        const bool broke = !finding.broken.empty(), expected = known.contains(first + i);
        if (broke != expected) ++failed;
        if (broke) {
          fmt::print("scene {}, {}, step {}: {}{}\n  ./course fuzz -- --seed {} --stage '{}'\n", first + i, stage,
                     finding.step, finding.broken, expected ? " (known)" : "", first + i, stage);
        } else if (expected) {
          fmt::print("scene {}, {}: known to fail, and did not\n", first + i, stage);
        }
      }
      if (account.solves > 0) print_account(stage, account);
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
