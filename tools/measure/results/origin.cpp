#include "pushback/tools/measure/results/origin.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/common/basics/process.h"
#include "pushback/common/basics/shard.h"
#include "pushback/tools/measure/results/built_by.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

std::string commit_here() {
  if (const char* const built = std::getenv("PUSHBACK_COMMIT")) return built;
  const std::string folder = fs::canonical("/proc/self/exe").parent_path().string();
  const Ended commit = run_program({"git", "-C", folder, "rev-parse", "--short=12", "HEAD"});
  const std::vector<std::string> lines = lines_of(commit.out);
  if (commit.status != 0 || lines.empty()) return "unknown";
  const Ended changed =
      run_program({"git", "-C", folder, "diff", "--quiet", "HEAD", "--", ":/common", ":/chapters", ":/tools"});
  return lines[0] + (changed.status == 0 ? "" : "+");
}

void require_same(const char* what, const std::string& one, const fs::path& in, const std::string& other,
                  const fs::path& but_in) {
  if (one != other)
    throw InvalidInput(fmt::format("--join: parts of one {} are needed: it is '{}' in {} and '{}' in {}", what, one,
                                   in.string(), other, but_in.string()));
}

}  // namespace

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  std::string name = "unknown";
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    name = line.substr(std::min(line.size(), line.find(": ") + 2));
    break;
  }
  return fmt::format("{}, {} cores", name, std::thread::hardware_concurrency());
}

std::string load_now() {
  std::ifstream file("/proc/loadavg");
  std::string one, five, fifteen;
  return file >> one >> five >> fifteen ? fmt::format("{}, {}, {}", one, five, fifteen) : "unknown";
}

Origin origin_here() {
  return {processor(), built_by(), commit_here()};
}

std::string origin_text(const Origin& origin) {
  return fmt::format("machine: {}\ncompiler: {}\ncommit: {}\n", origin.machine, origin.compiler, origin.commit);
}

Origin read_origin(const fs::path& file) {
  const std::vector<std::string> lines = lines_of(read_text_file(file));
  const std::vector<std::string> heads{"machine: ", "compiler: ", "commit: "};
  for (std::size_t i = 0; i < heads.size(); ++i)
    if (lines.size() != heads.size() || !lines[i].starts_with(heads[i]))
      throw InvalidInput(
          fmt::format("{} does not say of which machine, compiler and commit the part is", file.string()));
  return {lines[0].substr(heads[0].size()), lines[1].substr(heads[1].size()), lines[2].substr(heads[2].size())};
}

void require_one_origin(const std::vector<fs::path>& files, Holds holds) {
  if (files.empty()) return;
  const Origin first = read_origin(files[0]);
  for (const fs::path& file : files) {
    const Origin origin = read_origin(file);
    require_same("compiler", first.compiler, files[0], origin.compiler, file);
    require_same("commit", first.commit, files[0], origin.commit, file);
    if (holds == Holds::times) require_same("machine", first.machine, files[0], origin.machine, file);
  }
}

std::vector<fs::path> folders_of_parts(const fs::path& folder, std::size_t parts, const std::string& origin,
                                       Holds holds) {
  std::vector<fs::path> folders, origins;
  for (std::size_t i = 1; i <= parts; ++i) {
    folders.push_back(folder / Shard{i, parts}.folder());
    origins.push_back(folders.back() / origin);
  }
  require_one_origin(origins, holds);
  return folders;
}

std::vector<std::string> texts_of_parts(const std::vector<fs::path>& folders, const std::string& file) {
  std::vector<std::string> texts;
  for (const fs::path& folder : folders) texts.push_back(read_text_file(folder / file));
  return texts;
}

}  // namespace pushback
