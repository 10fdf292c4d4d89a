/// Programs as they are called from a shell, and what they leave behind.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/catch.h"

namespace fs = std::filesystem;

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

/// How a program ended.
struct Ended {
  int status = -1;  ///< as the shell would show it; -1 if something killed the program
  std::string out, err;
};

/// Runs a program. `arguments` are a line of shell, so quote what needs it. Nothing here may take `seconds`.
inline Ended call_program(const fs::path& program, const std::string& arguments, int seconds = 20) {
  if (!fs::exists(program)) FAIL("there is no program " << program.string() << ": build it first");
  const Scratch scratch;
  const std::string command = "timeout " + std::to_string(seconds) + " '" + program.string() + "' " + arguments +
                              " >'" + (scratch / "out").string() + "' 2>'" + (scratch / "err").string() +
                              "' </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(scratch / "out"), text_of(scratch / "err")};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
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
