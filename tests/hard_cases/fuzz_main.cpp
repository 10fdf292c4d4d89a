/// ./course fuzz: random scenes, or one of them step by step.
#include <set>

#include "pushback/common/experiment/program.h"
#include "tests/hard_cases/fuzz.h"

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

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Random scenes, watched: what must hold in any scene and under any solver", "fuzz");
  std::vector<std::string> only = fuzzed_stages();
  std::uint64_t first = 1, scenes = 500, seed = 0;
  app.add_option("--stage", only, "Stages, separated by commas")->delimiter(',')->check(CLI::IsMember(fuzzed_stages()));
  app.add_option("--first", first, "The first seed")->capture_default_str();
  app.add_option("--scenes", scenes, "How many seeds from there on")->capture_default_str();
  std::set<std::uint64_t> known;
  app.add_option("--known", known, "Seeds that are known to fail; one that does not is a failure too")->delimiter(',');
  bool no_room = false;
  app.add_flag("--no-room", no_room, "Half-spaces may leave no room for anything; this is expected to fail");
  CLI::Option* one = app.add_option("--seed", seed, "Only this scene, and print every step");
  return run_program(app, argc, argv, [&] {
    const bool replay = one->count() > 0;
    if (replay) {
      first = seed;
      scenes = 1;
    }
    std::uint64_t failed = 0;
    for (const std::string& stage : only) {
      Account account;
      for (std::uint64_t i = 0; i < scenes; ++i) {
        if (replay) fmt::print("scene {}, {}\n", first + i, stage);
        const Finding finding = fuzz(random_scene(first + i, no_room), stage, replay);
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
      print_account(stage, account);
    }
    const std::string summary = fmt::format("{} of {} runs were not as expected", failed, scenes * only.size());
    if (failed > 0) throw std::runtime_error(summary);
    fmt::print("{}\n", summary);
  });
}
