#include "pushback/common/basics/files.h"

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "pushback/common/basics/input.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

/// The reason for the latest failure of a system call.
std::string reason() {
  return errno == 0 ? "of a reason that the system does not give" : std::generic_category().message(errno);
}

/// Whether the whole text has reached the file. If not, errno holds the reason.
bool write_whole(const fs::path& file, const std::string& text) {
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  return out.good();
}

}  // namespace

void make_writable_folder(const fs::path& folder) {
  std::error_code error, ignored;
  fs::create_directories(folder, error);
  const fs::path probe = folder / ".probe";
  const std::string why = error ? error.message() : write_whole(probe, " ") ? "" : reason();
  fs::remove(probe, ignored);
  if (!why.empty())
    throw InvalidInput(
        fmt::format("--out: folder '{}' cannot be written to ({}): a folder that can be made or written to is needed",
                    folder.string(), why));
}

namespace {

/// A temporary file for a text. The destructor removes it unless `keep` has given it its final name.
class Draft {
 public:
  explicit Draft(const fs::path& file) : file_(file), draft_(file) { draft_ += ".part"; }
  ~Draft() {
    std::error_code ignored;
    if (!kept_) fs::remove(draft_, ignored);
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  void write(const std::string& text) const {
    std::error_code ignored;
    if (fs::is_directory(file_, ignored)) refuse("it is a folder");
    if (!write_whole(draft_, text)) refuse(reason());
  }
  void keep() {
    std::error_code failure;
    fs::rename(draft_, file_, failure);
    if (failure) refuse(failure.message());
    kept_ = true;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InvalidInput(fmt::format("file '{}' cannot be written: {}", file_.string(), why));
  }

  fs::path file_, draft_;
  bool kept_ = false;
};

}  // namespace

void write_text_file(const fs::path& file, const std::string& text) {
  Draft draft(file);
  draft.write(text);
  draft.keep();
}

void require_writable_file(const fs::path& file) {
  Draft(file).write("");
}

std::string read_text_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored))
    throw InvalidInput(fmt::format("'{}' is a folder: a file is needed", file.string()));
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in) throw InvalidInput(fmt::format("file '{}' cannot be read: {}", file.string(), reason()));
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
