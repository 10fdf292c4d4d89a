/// Where what a student's file is compiled with is found: in the build, or in the folder that Pushback is installed in.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pushback {

struct Kit {
  std::filesystem::path folder;   ///< of headers.h, answer.cpp and the command lines
  std::filesystem::path headers;  ///< pushback/... is below it
  std::filesystem::path sources;  ///< chapters/03_baumgarte/exercise is below it
  std::filesystem::path prefix;   ///< the folder of the installation, or empty in a build
  /// A command line that is kept there, a word a line.
  std::vector<std::string> words_of(const std::string& file) const;
  /// The command that a student types.
  std::string call() const { return prefix.empty() ? "./course exercise" : "pushback-exercise"; }
};

const Kit& kit();

}  // namespace pushback
