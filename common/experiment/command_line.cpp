/// The command line of an experiment. Only this file, of what experiments are made of, knows CLI11.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/film.h"
#include "pushback/common/experiment/option_checks.h"

namespace pushback {

namespace {

void add_parameter(CLI::App& app, const ParameterWithDefault& added) {
  const Parameter& parameter = added.parameter;
  const std::string& symbol = parameter.symbol;
  const std::string& unit = parameter.unit;
  const std::string known_as = symbol.empty() || unit.empty() ? symbol + unit : symbol + ", " + unit;
  const std::string help = known_as.empty() ? parameter.what : parameter.what + " (" + known_as + ")";
  const auto number = [&parameter](auto zero) {
    using Number = decltype(zero);
    return number_check(static_cast<Number>(parameter.least), static_cast<Number>(parameter.most));
  };
  const CLI::Validator check = added.whole ? number(0) : number(0.0);
  std::visit(
      [&](auto* value) {
        CLI::Option* option = app.add_option(parameter.flag, *value, help);
        option->capture_default_str()->transform(check)->group("This experiment");
        if constexpr (!std::is_arithmetic_v<std::decay_t<decltype(*value)>>) option->delimiter(',');
      },
      added.variable);
}

}  // namespace

std::optional<int> Experiment::read_command_line(int argc, const char* const* argv) {
  CLI::App app(question_, name_);
  const auto common = [&app](const std::string& flag, auto& value, const std::string& help) {
    return app.add_option(flag, value, help)->capture_default_str()->group("Every experiment");
  };
  common("--out", out_, "Folder in which the folder of this experiment is made");
  common("--size", size_, "Pixels of a frame, WIDTHxHEIGHT; the sheet's pictures have its shape");
  app.add_option("--seconds", seconds_, "Simulated time of every variant; each scene's own unless given")
      ->transform(number_check<Real>())
      ->group("Every experiment");
  common("--passes", passes_, "Passes that a picture of the sheet is averaged from: fewer are faster, and coarser")
      ->transform(number_check(1, 4096));
  CLI::Option* frames = common("--frames", frames_, "Frames of each variant to keep, evenly spread over its time");
  frames->transform(number_check(0, 100000));
  app.add_option("--film", film_, "A film of each scene, its variants side by side: film.mp4, or of another ending")
      ->expected(0, 1)
      ->default_str("mp4")
      ->check(CLI::IsMember(film_formats()))
      ->excludes(frames)
      ->group("Every experiment");
  common("--sweeps", sweeps_, "Sweeps over the rows in each step, also where a variant has a number of its own")
      ->transform(number_check(1, 1000000));
  common("--dt", dt_, "Time step, s")->transform(number_check(Real(1e-6), Real(1)));
  app.add_option("--variants", only_, "Only these variants, by the names that --list prints, separated by commas")
      ->delimiter(',')
      ->group("Every experiment");
  app.add_option("--mine", mine_, "A shared object with a solver, which plays each scene as one more variant, mine")
      ->group("Every experiment");
  const auto flag = [&app](const std::string& name_of_it, bool& value, const std::string& help) {
    app.add_flag(name_of_it, value, help)->group("Every experiment");
  };
  flag("--no-images", no_images_, "Only the numbers: metrics.csv and numbers.md");
  flag("--first-scene", first_scene_, "Only the first of its scenes");
  flag("--no-study", no_study_, "Leave out what is worked out beside the scenes: their variants alone are run");
  flag("--list", list_, "List the scenes and variants, and do nothing");
  flag("--parameters", list_parameters_, "Print what may be set for this experiment, as JSON, and do nothing");
  for (const ParameterWithDefault& own : parameters_) add_parameter(app, own);
  std::string others;
  for (const Command& command : commands_)
    others += fmt::format("  {} ...  {}; {} --help says how\n", command.flag, command.what, command.flag);
  if (!others.empty()) app.footer("Instead, as the first word:\n" + others);
  try {
    refuse_empty_words(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& problem) {
    fmt::print(stderr, "{}: {}\n", name_, problem.what());
    return 2;
  }
  for (const CLI::Option* given : app.parse_order()) told_.insert(given->get_name());
  if (!list_parameters_) return {};
  fmt::print("{}\n", in_json(parameters_));
  return 0;
}

}  // namespace pushback
