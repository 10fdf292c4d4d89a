/// Programs as they are called from a shell, and what they leave behind.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "pushback/common/basics/process.h"
#include "tests/support/catch.h"

namespace fs = std::filesystem;

/// The root of the sources and the chapters' programs, as seen from the working directory of the tests.
#ifndef SOURCE_DIR
#define SOURCE_DIR "."
#endif
#ifndef CHAPTER_DIR
#define CHAPTER_DIR "build/release/programs"
#endif

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder that is gone when the test is over.
class Scratch {
 public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "pushback_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder in " + name);
    folder_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  fs::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  fs::path folder_;
};

using pushback::Ended;
using pushback::lines_of;

/// Runs a program. `arguments` are divided at spaces; what stands in 'quotes' stays whole. Nothing here may take `seconds`.
inline Ended call_program(const fs::path& program, const std::string& arguments, int seconds = 20) {
  if (!fs::exists(program)) FAIL("there is no program " << program.string() << ": build it first");
  std::vector<std::string> command{program.string()};
  std::istringstream in(arguments);
  for (std::string word; in >> std::quoted(word, '\'');) command.push_back(word);
  return pushback::run_program(command, seconds);
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The fields of a line of CSV; names may be quoted, and hold commas then.
inline std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    else if (c == ',' && !quoted) fields.emplace_back();
    else fields.back() += c;
  }
  return fields;
}
