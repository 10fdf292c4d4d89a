#include "pushback/common/experiment/program.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <type_traits>

namespace pushback {

namespace {

// CLI11 accepts values that no program can use: "-1" as 2^64 - 1, "nan" within any range, an empty word. These functions reject them.

template <class Number>
std::string range_text(Number least, Number most) {
  if constexpr (std::is_floating_point_v<Number>)
    if (least == std::numeric_limits<Number>::lowest() && most == std::numeric_limits<Number>::max())
      return "a finite number is needed";
  return fmt::format("a {}number from {} to {} is needed", std::is_integral_v<Number> ? "whole " : "", least, most);
}

/// A finite number from `least` to `most`, both allowed.
template <class Number>
CLI::Validator number_check(Number least, Number most) {
  const auto check = [least, most](std::string& word) -> std::string {
    Number number{};
    const char *const begin = word.data(), *const end = begin + word.size();
    bool read = false;
    if constexpr (std::is_integral_v<Number>) {
      const auto [stopped, error] = std::from_chars(begin, end, number);
      read = error == std::errc() && stopped == end;
    } else {
      char* stopped = nullptr;
      number = static_cast<Number>(std::strtod(begin, &stopped));
      read = !word.empty() && stopped == end;
    }
    if (!read || !(number >= least && number <= most))
      return fmt::format("'{}' is not allowed: {}", word, range_text(least, most));
    if constexpr (std::is_integral_v<Number>) word = fmt::format("{}", number);  // CLI11 reads 010 as eight
    return {};
  };
  const bool any = least == std::numeric_limits<Number>::lowest() && most == std::numeric_limits<Number>::max();
  return CLI::Validator(check, any ? "" : fmt::format("{}..{}", least, most), "number");
}

template <class Number>
CLI::Validator number_check() {
  return number_check(std::numeric_limits<Number>::lowest(), std::numeric_limits<Number>::max());
}

/// Throws CLI::ValidationError for an empty word or an empty element of a list, because CLI11 would skip both.
void refuse_empty_words(const CLI::App& app, int argc, const char* const* argv) {
  const CLI::Option* option = nullptr;  // the option that takes the next word
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    std::string value = word;
    if (word.starts_with('-')) {
      const std::size_t equals = word.find('=');
      if (const CLI::Option* const named = app.get_option_no_throw(word.substr(0, equals))) {
        option = named->get_items_expected_max() > 0 ? named : nullptr;
        if (equals == std::string::npos) continue;
        value = word.substr(equals + 1);
      }
    }
    const std::string name = option == nullptr ? "an argument" : option->get_name();
    if (value.empty()) throw CLI::ValidationError(name, "'' is not allowed: a value is needed");
    if (option == nullptr) continue;
    if (option->get_delimiter() == ',' &&
        (value.starts_with(',') || value.ends_with(',') || value.find(",,") != std::string::npos))
      throw CLI::ValidationError(name,
                                 fmt::format("'{}' is not allowed: a value between any two commas is needed", value));
    if (option->get_items_expected_max() == 1) option = nullptr;
  }
}

/// The type of the elements of a list, or the type itself.
template <class Value>
struct ElementOf {
  using Type = Value;
};
template <class Element>
struct ElementOf<std::vector<Element>> {
  using Type = Element;
};
template <class Element>
struct ElementOf<std::set<Element>> {
  using Type = Element;
};

}  // namespace

using Option = CommandLine::Option;

Option& Option::required() {
  option_->required();
  return *this;
}
Option& Option::shows_default() {
  option_->capture_default_str();
  return *this;
}
Option& Option::between(int least, int most) {
  *option_->get_validator("number") = number_check(least, most);
  return *this;
}
Option& Option::between(double least, double most) {
  *option_->get_validator("number") = number_check(least, most);
  return *this;
}
Option& Option::one_of(const std::vector<std::string>& words) {
  option_->check(CLI::IsMember(words));
  return *this;
}
Option& Option::split_at_commas() {
  option_->delimiter(',');
  return *this;
}
Option& Option::at_most_once() {
  option_->expected(0, 1);
  return *this;
}
Option& Option::without(const Option& other) {
  option_->excludes(other.option_);
  return *this;
}
Option& Option::from_environment(const std::string& variable) {
  option_->envname(variable);
  return *this;
}
Option& Option::under(const std::string& heading) {
  option_->group(heading);
  return *this;
}
Option& Option::meant_alone(const std::string& value) {
  option_->expected(0, 1)->default_str(value);
  return *this;
}
bool Option::given() const {
  return option_->count() > 0;
}

CommandLine::CommandLine(const std::string& about, const std::string& called)
    : app_(std::make_unique<CLI::App>(about, called)) {}
CommandLine::~CommandLine() = default;

Option CommandLine::flag(const std::string& name, bool& value, const std::string& help) {
  return Option(app_->add_flag(name, value, help));
}
template <class Value>
Option CommandLine::option(const std::string& name, Value& value, const std::string& help) {
  CLI::Option* const option = app_->add_option(name, value, help);
  using Element = typename ElementOf<Value>::Type;
  if constexpr (std::is_arithmetic_v<Element>) option->transform(number_check<Element>());
  return Option(option);
}
template Option CommandLine::option(const std::string&, int&, const std::string&);
template Option CommandLine::option(const std::string&, double&, const std::string&);
template Option CommandLine::option(const std::string&, float&, const std::string&);
template Option CommandLine::option(const std::string&, std::size_t&, const std::string&);
template Option CommandLine::option(const std::string&, std::vector<int>&, const std::string&);
template Option CommandLine::option(const std::string&, std::vector<double>&, const std::string&);
template Option CommandLine::option(const std::string&, std::vector<float>&, const std::string&);
template Option CommandLine::option(const std::string&, std::set<std::uint64_t>&, const std::string&);
template Option CommandLine::option(const std::string&, std::string&, const std::string&);
template Option CommandLine::option(const std::string&, std::filesystem::path&, const std::string&);
template Option CommandLine::option(const std::string&, std::vector<std::string>&, const std::string&);
template Option CommandLine::option(const std::string&, std::vector<std::filesystem::path>&, const std::string&);

void CommandLine::version(const std::string& text, const std::string& help) {
  app_->set_version_flag("--version", text, help);
}
void CommandLine::ends_with(const std::string& text) {
  app_->footer(text);
}

std::optional<int> CommandLine::read(int argc, const char* const* argv) {
  try {
    refuse_empty_words(*app_, argc, argv);
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app_->exit(problem) == 0 ? 0 : 2;
  }
  return {};
}
std::set<std::string> CommandLine::given() const {
  std::set<std::string> names;
  for (const CLI::Option* option : app_->parse_order()) names.insert(option->get_name());
  return names;
}

int CommandLine::run(int argc, const char* const* argv, const std::function<void()>& work) {
  if (const std::optional<int> status = read(argc, argv)) return *status;
  try {
    work();
  } catch (const InvalidInput& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 2;
  } catch (const std::filesystem::filesystem_error& problem) {
    fmt::print(stderr, "'{}': {}\n", problem.path1().string(), problem.code().message());
    return 2;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "{}\n", problem.what());
    return 1;
  }
  return 0;
}

}  // namespace pushback
