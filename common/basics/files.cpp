#include "pushback/common/basics/files.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace fs = std::filesystem;

void make_writable_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  const fs::path probe = folder / ".probe";
  const bool writable = !error && std::ofstream(probe).put(' ').flush().good();
  fs::remove(probe, error);
  if (!writable)
    throw InvalidInput(fmt::format(
        "--out: folder '{}' cannot be written to: a folder that can be made or written to is needed", folder.string()));
}

void write_text_file(const fs::path& file, const std::string& text) {
  fs::path unfinished = file;
  unfinished += ".part";
  {
    std::ofstream out(unfinished, std::ios::binary);
    out << text;
    if (!out.flush()) throw InvalidInput(fmt::format("file '{}' cannot be written", file.string()));
  }
  std::error_code failure, ignored;
  fs::rename(unfinished, file, failure);
  if (!failure) return;
  fs::remove(unfinished, ignored);
  throw InvalidInput(fmt::format("file '{}' cannot be written: {}", file.string(), failure.message()));
}

std::string read_text_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in) throw InvalidInput(fmt::format("file '{}' cannot be read", file.string()));
  return text;
}

ScratchFolder::ScratchFolder()
    : path([] {
        std::string name = (fs::temp_directory_path() / "pushback_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder in " + name);
        return name;
      }()) {}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace pushback
