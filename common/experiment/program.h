/// Reads the command line of a program, and reports its errors.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "pushback/common/basics/input.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace pushback {

/// Wraps CLI11 so that it is compiled only once, because it takes longer to compile than most programs that use it.
class CommandLine {
 public:
  /// An option or a positional argument. Each setter returns the option itself.
  class Option {
   public:
    explicit Option(CLI::Option* option) : option_(option) {}
    Option& required();
    Option& shows_default();
    Option& between(int least, int most);
    Option& between(double least, double most);
    Option& one_of(const std::vector<std::string>& words);
    Option& split_at_commas();
    Option& at_most_once();
    Option& without(const Option& other);
    Option& from_environment(const std::string& variable);
    Option& under(const std::string& heading);      ///< in the help text
    Option& meant_alone(const std::string& value);  ///< its value if it is given without one
    bool given() const;

   private:
    CLI::Option* option_;
  };

  explicit CommandLine(const std::string& about, const std::string& called = "");
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Option flag(const std::string& name, bool& value, const std::string& help);
  /// `Value` is a number, a string, a path, or a container of them. program.cpp instantiates these types.
  template <class Value>
  Option option(const std::string& name, Value& value, const std::string& help);
  void version(const std::string& text, const std::string& help);
  void ends_with(const std::string& text);

  /// Reads the command line. Returns an exit status if the program has nothing more to do: 0 after the help text, 2 after an error.
  std::optional<int> read(int argc, const char* const* argv);
  /// The names of the options that were given.
  std::set<std::string> given() const;
  /// Reads the command line and calls `work`. Returns the program's exit status: 0; 2 after a message if a value or a file cannot be
  /// used; 1 after a message about any other error.
  int run(int argc, const char* const* argv, const std::function<void()>& work);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace pushback
