/// The command line of an experiment.
#include "pushback/common/experiment/experiment.h"
#include "pushback/common/experiment/film.h"
#include "pushback/common/experiment/program.h"

namespace pushback {

namespace {

void add_parameter(CommandLine& line, const ParameterWithDefault& added) {
  const Parameter& parameter = added.parameter;
  const std::string& symbol = parameter.symbol;
  const std::string& unit = parameter.unit;
  const std::string known_as = symbol.empty() || unit.empty() ? symbol + unit : symbol + ", " + unit;
  const std::string help = known_as.empty() ? parameter.what : parameter.what + " (" + known_as + ")";
  std::visit(
      [&](auto* value) {
        CommandLine::Option option = line.option(parameter.flag, *value, help);
        if (added.whole) option.between(static_cast<int>(parameter.least), static_cast<int>(parameter.most));
        else option.between(parameter.least, parameter.most);
        option.shows_default().under("This experiment");
        if constexpr (!std::is_arithmetic_v<std::decay_t<decltype(*value)>>) option.split_at_commas();
      },
      added.variable);
}

}  // namespace

std::optional<int> Experiment::read_command_line(int argc, const char* const* argv) {
  CommandLine line(question_, name_);
  const auto option = [&line](const std::string& flag, auto& value, const std::string& help) {
    return line.option(flag, value, help).under("Every experiment");
  };
  const auto flag = [&line](const std::string& name, bool& value, const std::string& help) {
    line.flag(name, value, help).under("Every experiment");
  };
  option("--out", out_, "Folder in which the folder of this experiment is made").shows_default();
  option("--size", size_, "Pixels of a frame, WIDTHxHEIGHT; the sheet's pictures have its shape").shows_default();
  option("--seconds", seconds_, "Simulated time of every variant; each scene's own unless given");
  option("--passes", passes_, "Passes that a picture of the sheet is averaged from: fewer are faster, and coarser")
      .shows_default()
      .between(1, 4096);
  const CommandLine::Option frames =
      option("--frames", frames_, "Frames of each variant to keep, evenly spread over its time")
          .shows_default()
          .between(0, 100000);
  option("--film", film_, "A film of each scene, its variants side by side: film.mp4, or of another ending")
      .meant_alone("mp4")
      .one_of(film_formats())
      .without(frames);
  option("--sweeps", sweeps_, "Sweeps over the rows in each step, also where a variant has a number of its own")
      .shows_default()
      .between(1, 1000000);
  option("--dt", dt_, "Time step, s").shows_default().between(1e-6, 1.0);
  option("--variants", only_, "Only these variants, by the names that --list prints, separated by commas")
      .split_at_commas();
  option("--mine", mine_, "A shared object with a solver, which plays each scene as one more variant, mine");
  flag("--no-images", no_images_, "Only the numbers: metrics.csv and numbers.md");
  flag("--first-scene", first_scene_, "Only the first of its scenes");
  flag("--no-study", no_study_, "Leave out what is worked out beside the scenes: their variants alone are run");
  flag("--list", list_, "List the scenes and variants, and do nothing");
  flag("--parameters", list_parameters_, "Print what may be set for this experiment, as JSON, and do nothing");
  for (const ParameterWithDefault& own : parameters_) add_parameter(line, own);
  std::string others;
  for (const Command& command : commands_)
    others += fmt::format("  {} ...  {}; {} --help says how\n", command.flag, command.what, command.flag);
  if (!others.empty()) line.ends_with("Instead, as the first word:\n" + others);
  if (const std::optional<int> status = line.read(argc, argv)) return status;
  told_ = line.given();
  if (!list_parameters_) return {};
  fmt::print("{}\n", in_json(parameters_));
  return 0;
}

}  // namespace pushback
