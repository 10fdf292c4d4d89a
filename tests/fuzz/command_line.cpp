/// What is parsed from text: the command line of an experiment. The bytes are its words, one a line. Whatever they are, the
/// program ends with status 0 or 2, quickly, and without help from the sanitizers.
///
/// Nothing is simulated beyond the rehearsal's one step, and nothing is written: --out stands first in each line and names a
/// file, so `play` has no folder to write to.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/common/experiment/experiment.h"

using namespace pushback;

namespace {

int run(const std::vector<std::string>& words) {
  std::vector<const char*> argv{"fuzzed"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  Experiment e("fuzzed", "What does it make of this?");
  Real beta = Real(0.2), mass = 1;
  std::vector<Real> masses{1, 2};
  e.parameter({"--beta", "β", "", "0 or more", 0, 1e300}, &beta);
  e.parameter({"--mass", "m", "kg", "above 0", 1e-300, 1e300}, &mass);
  e.parameter({"--masses", "", "kg", "a list", 1e-300, 1e300}, &masses);
  return e.run(static_cast<int>(argv.size()), argv.data(), [&] {
    e.scene({.name = "none", .fill = [mass](World& world) { stack(world, 1, 0, mass); }, .seconds = Real(0.01)});
    for (const Real each : masses) {
      FullSolver solver;
      solver.beta = beta * each;
      e.variant(fmt::format("{:g}", each), solver);
    }
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // CLI11 reads files for one option only, --config, which no experiment has; and where it should write is not its choice.
  static const bool quiet = std::freopen("/dev/null", "w", stdout) != nullptr;
  if (!quiet) std::abort();
  std::vector<std::string> words;
  std::string word;
  for (std::size_t i = 0; i < size; ++i) {
    if (data[i] == '\n') words.push_back(std::exchange(word, {}));
    else if (data[i] != 0) word += static_cast<char>(data[i]);
  }
  words.push_back(word);
  for (const std::string& each : words) {
    if (each.rfind("--o", 0) == 0) return -1;  // no folders wherever it likes
  }
  words.insert(words.end(), {"--no-images", "--out=/dev/null"});
  const int status = run(words);
  if (status != 0 && status != 2) {
    fmt::print(stderr, "status {}\n", status);
    std::abort();
  }
  return 0;
}
