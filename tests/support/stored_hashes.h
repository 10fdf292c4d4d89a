/// Hashes that stand in a file, to be the same in every build.
#pragma once

#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

#include "tests/support/catch.h"

namespace pushback {

/// By what was hashed. PUSHBACK_STORE_HASHES=1 in the environment writes the file first.
inline void check_stored(const std::string& file, const std::map<std::string, std::string>& hashes) {
  if (std::getenv("PUSHBACK_STORE_HASHES") != nullptr) {
    std::ofstream out(file);
    for (const auto& [what, hash] : hashes) out << hash << "  " << what << '\n';
  }
  std::map<std::string, std::string> stored;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t gap = line.find("  ");
    REQUIRE(gap != std::string::npos);
    stored[line.substr(gap + 2)] = line.substr(0, gap);
  }
  REQUIRE(stored.size() == hashes.size());
  for (const auto& [what, hash] : hashes) {
    INFO(what);
    CHECK(stored[what] == hash);
  }
}

}  // namespace pushback
