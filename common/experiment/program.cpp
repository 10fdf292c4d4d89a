#include "pushback/common/experiment/program.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <set>

#include "pushback/common/experiment/option_checks.h"

namespace pushback {

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
  if constexpr (std::is_arithmetic_v<Value>) option->transform(number_check<Value>());
  else if constexpr (std::is_same_v<Value, std::set<std::uint64_t>>) option->transform(number_check<std::uint64_t>());
  return Option(option);
}
template Option CommandLine::option(const std::string&, int&, const std::string&);
template Option CommandLine::option(const std::string&, double&, const std::string&);
template Option CommandLine::option(const std::string&, std::size_t&, const std::string&);
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

int CommandLine::run(int argc, const char* const* argv, const std::function<void()>& work) {
  try {
    refuse_empty_words(*app_, argc, argv);
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    return app_->exit(problem) == 0 ? 0 : 2;
  }
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
