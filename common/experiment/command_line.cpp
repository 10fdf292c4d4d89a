#include "pushback/common/experiment/command_line.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "pushback/common/basics/files.h"

namespace pushback {

namespace {

template <class Number>
std::vector<double> as_list(const Number& value) {
  return {static_cast<double>(value)};
}
template <class Number>
std::vector<double> as_list(const std::vector<Number>& values) {
  return {values.begin(), values.end()};
}

}  // namespace

std::string in_json(const std::vector<ParameterWithDefault>& parameters) {
  std::vector<std::string> objects;
  for (const auto& [parameter, defaults, whole] : parameters) {
    objects.push_back(fmt::format(
        R"({{"flag": {}, "symbol": {}, "unit": {}, "what": {}, "default": [{}], "least": {}, "most": {}, "whole": {}}})",
        quoted(parameter.flag), quoted(parameter.symbol), quoted(parameter.unit), quoted(parameter.what),
        fmt::join(defaults, ", "), parameter.least, parameter.most, whole));
  }
  return fmt::format("[{}]", fmt::join(objects, ",\n "));
}

std::string spelled(double number) {
  static constexpr std::array below_twenty{
      "zero", "one",    "two",    "three",    "four",     "five",    "six",     "seven",     "eight",    "nine",
      "ten",  "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
  static constexpr std::array tens{"twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"};
  if (number == 100) return "a hundred";
  if (number == 1000) return "a thousand";
  if (number != std::floor(number) || number < 0 || number > 99) return fmt::format("{:g}", number);
  const auto whole = static_cast<std::size_t>(number);
  if (whole < 20) return below_twenty.at(whole);
  const std::string ten = tens.at(whole / 10 - 2);
  return whole % 10 == 0 ? ten : ten + "-" + below_twenty.at(whole % 10);
}

Experiment::Experiment(std::string name, std::string question)
    : name_(std::move(name)), question_(std::move(question)), line_(std::make_unique<CommandLine>()) {
  CLI::App& app = line_->app;
  app.name(name_);
  app.description(question_);
  const auto common = [&app](const std::string& flag, auto& value, const std::string& help) {
    return app.add_option(flag, value, help)->capture_default_str()->group("Every experiment");
  };
  common("--out", out_, "Folder in which the folder of this experiment is made");
  common("--size", size_, "Pixels of a frame, WIDTHxHEIGHT; the sheet's pictures have its shape");
  app.add_option("--seconds", seconds_, "Simulated time of every variant; each scene's own unless given")
      ->group("Every experiment");
  common("--frames", frames_, "Frames of each variant for a film, evenly spread over its time");
  common("--sweeps", sweeps_, "Sweeps over the rows in each step, also where a variant has a number of its own");
  common("--dt", dt_, "Time step, s");
  app.add_option("--variants", only_, "Only these variants, by the names that --list prints, separated by commas")
      ->delimiter(',')
      ->group("Every experiment");
  const auto flag = [&app](const std::string& name_of_it, bool& value, const std::string& help) {
    app.add_flag(name_of_it, value, help)->group("Every experiment");
  };
  flag("--no-images", no_images_, "Only the numbers: metrics.csv and numbers.md");
  flag("--no-study", no_study_, "Leave out what is worked out beside the scenes: their variants alone are run");
  flag("--list", list_, "List the scenes and variants, and do nothing");
  flag("--parameters", list_parameters_, "Print what may be set for this experiment, as JSON, and do nothing");
}

Experiment::~Experiment() = default;

void Experiment::parameter(const Parameter& parameter, ParameterVariable variable) {
  const std::string& symbol = parameter.symbol;
  const std::string& unit = parameter.unit;
  const std::string known_as = symbol.empty() || unit.empty() ? symbol + unit : symbol + ", " + unit;
  const std::string help = known_as.empty() ? parameter.what : parameter.what + " (" + known_as + ")";
  std::visit(
      [&](auto* value) {
        using Held = std::decay_t<decltype(*value)>;
        constexpr bool whole = std::is_same_v<Held, int> || std::is_same_v<Held, std::vector<int>>;
        const CLI::Validator check(
            [least = parameter.least, most = parameter.most](const std::string& word) -> std::string {
              double number = 0;
              if (CLI::detail::lexical_cast(word, number) && number >= least && number <= most &&
                  (!whole || number == std::floor(number)))
                return {};
              return fmt::format("'{}' is not allowed: a {} from {} to {} is needed", word,
                                 whole ? "whole number" : "number", least, most);
            },
            fmt::format("{}..{}", parameter.least, parameter.most));
        CLI::Option* added = line_->app.add_option(parameter.flag, *value, help);
        added->capture_default_str()->check(check)->group("This experiment");
        if constexpr (!std::is_arithmetic_v<Held>) added->delimiter(',');
        line_->parameters.push_back({parameter, as_list(*value), whole});
      },
      variable);
}

const std::vector<ParameterWithDefault>& Experiment::parameters() const {
  return line_->parameters;
}

bool Experiment::told(const std::string& flag) const {
  return line_->app.count(flag) > 0;
}

std::optional<int> Experiment::read_command_line(int argc, const char* const* argv) {
  try {
    line_->app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return line_->app.exit(help);
  } catch (const CLI::ParseError& problem) {
    fmt::print(stderr, "{}: {}\n", name_, problem.what());
    return 2;
  }
  if (!list_parameters_) return {};
  fmt::print("{}\n", in_json(line_->parameters));
  return 0;
}

}  // namespace pushback
